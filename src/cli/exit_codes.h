#pragma once
// What the program's exit code says; sysexits where there is one.

#include "garment/report.h"

namespace toile {

enum ExitCode {
  exit_ok = 0,
  exit_internal = 1,
  exit_checks_failed = 10,  // written, but a check failed: see the report
  exit_not_converged = 11,  // the best state is written, or nothing could be
  exit_ambiguous = 12,      // units or dialect: the program asks instead of guessing
  exit_usage = 64,
  exit_bad_input = 65,
  exit_missing = 66,
  exit_bug = 70,
  exit_cannot_create = 73,
  exit_interrupted = 75,
};

constexpr ExitCode exit_code(Fault fault) {
  switch (fault) {
    case Fault::bad_input:
      return exit_bad_input;
    case Fault::missing:
      return exit_missing;
    case Fault::ambiguous:
      return exit_ambiguous;
    case Fault::cannot_create:
      return exit_cannot_create;
    case Fault::checks_failed:
      return exit_checks_failed;
    case Fault::not_converged:
      return exit_not_converged;
  }
  return exit_bug;
}

}  // namespace toile
