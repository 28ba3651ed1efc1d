#pragma once
// What a stage has to say about its input: findings with stable codes, and a value that may come with them.

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace toile {

enum class Severity { note, warning, error };

// What kind of trouble an error is; decides the exit code of the program (cli/exit_codes.h).
enum class Fault { bad_input, missing, ambiguous, cannot_create, checks_failed, not_converged };

// One finding. `code` is stable and dotted ("aama.notch-off-outline"); `place` is where ("front.dxf:412, piece 'sleeve'");
// `text` says what is wrong; `remedy` says what to do about it.
struct Finding {
  std::string code;
  Severity severity = Severity::error;
  std::string place;
  std::string text;
  std::string remedy;
  Fault fault = Fault::bad_input;
  bool operator==(const Finding&) const = default;
};

struct Report {
  std::vector<Finding> findings;

  bool ok() const;  // no finding is an error
  void note(std::string code, std::string place, std::string text, std::string remedy = {});
  void warn(std::string code, std::string place, std::string text, std::string remedy = {});
  void error(std::string code, std::string place, std::string text, std::string remedy, Fault = Fault::bad_input);
  void append(const Report& other);
};

// "front.dxf:412: error[aama.open-outline] text. remedy"
std::string in_words(const Finding&);

// Thrown inside a reader or a stage when nothing useful can be returned; readers turn it into Loaded<T>, the program into an
// exit code. Broken preconditions of the code itself are std::invalid_argument instead.
class BadInput : public std::runtime_error {
 public:
  explicit BadInput(Finding finding) : std::runtime_error(in_words(finding)), finding_(std::move(finding)) {}
  const Finding& finding() const { return finding_; }

 private:
  Finding finding_;
};

template <class T>
struct Loaded {
  std::optional<T> value;  // absent exactly when report.ok() is false
  Report report;
};

// The value of `loaded`; throws BadInput with its first error when there is none.
template <class T>
T value_or_throw(Loaded<T> loaded) {
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity == Severity::error) throw BadInput(finding);
  return std::move(loaded.value).value();
}

}  // namespace toile
