#pragma once
// Progress on standard error: a bar on a terminal, a line per stage elsewhere, or one JSON object per line.

#include <string>

namespace toile {

enum class ProgressStyle { automatic, plain, json, none };

// Thrown by Progress once SIGINT, SIGTERM or SIGHUP has come, so that what is half made is removed on the way out.
struct Interrupted {};
void interrupt_by_signals();
bool interrupted();

class Progress {
 public:
  explicit Progress(ProgressStyle style);
  ~Progress();

  void begin(const std::string& stage);
  // `done` in 0..1 of the stage; `detail` is free text ("residual 3.1e-04").
  void update(double done, const std::string& detail);
  void end(const std::string& result);

 private:
  void draw(double done, const std::string& detail);

  ProgressStyle style_;
  bool terminal_ = false;
  bool bar_open_ = false;
  int last_percent_ = -1;
  std::string stage_;
};

}  // namespace toile
