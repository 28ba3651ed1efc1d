#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace toile {
namespace {

constexpr int bar_width = 24;

void json_line(const nlohmann::ordered_json& event) {
  const std::string line = event.dump() + "\n";
  std::fputs(line.c_str(), stderr);
  std::fflush(stderr);
}

volatile std::sig_atomic_t signalled = 0;

void stop_if_interrupted() {
  if (signalled) throw Interrupted{};
}

}  // namespace

void interrupt_by_signals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) std::signal(number, [](int) { signalled = 1; });
}

bool interrupted() { return signalled != 0; }

Progress::Progress(ProgressStyle style) : style_(style), terminal_(isatty(STDERR_FILENO) != 0) {
  if (style_ == ProgressStyle::automatic)
    style_ = ProgressStyle::plain;
  else
    terminal_ = false;
}

Progress::~Progress() {
  if (bar_open_) std::fputc('\n', stderr);
}

void Progress::begin(const std::string& stage) {
  stop_if_interrupted();
  stage_ = stage;
  last_percent_ = -1;
  if (style_ == ProgressStyle::json) json_line({{"event", "begin"}, {"stage", stage}});
  if (style_ == ProgressStyle::plain && terminal_) draw(0, "");
}

void Progress::update(double done, const std::string& detail) {
  stop_if_interrupted();
  const int percent = static_cast<int>(100 * std::clamp(done, 0.0, 1.0));
  if (style_ == ProgressStyle::json) {
    json_line({{"event", "progress"}, {"stage", stage_}, {"percent", percent}, {"detail", detail}});
  } else if (style_ == ProgressStyle::plain && terminal_ && percent != last_percent_) {
    draw(done, detail);
  }
  last_percent_ = percent;
}

void Progress::end(const std::string& result) {
  if (style_ == ProgressStyle::json) {
    json_line({{"event", "end"}, {"stage", stage_}, {"result", result}});
  } else if (style_ == ProgressStyle::plain) {
    std::fprintf(stderr, "%s%-10s %s\n", bar_open_ ? "\r\033[K" : "", stage_.c_str(), result.c_str());
    bar_open_ = false;
  }
}

void Progress::draw(double done, const std::string& detail) {
  const int filled = static_cast<int>(bar_width * std::clamp(done, 0.0, 1.0));
  const std::string bar =
      std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(bar_width - filled), '.');
  std::fprintf(stderr, "\r\033[K%-10s [%s] %s", stage_.c_str(), bar.c_str(), detail.c_str());
  std::fflush(stderr);
  bar_open_ = true;
}

}  // namespace toile
