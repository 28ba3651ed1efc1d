#include "garment/adjustment.h"

namespace toile {

std::string in_words(AdjustStop stop) {
  switch (stop) {
    case AdjustStop::agreed: return "agreed";
    case AdjustStop::stalled: return "stalled";
    case AdjustStop::step_limit: return "step limit";
    case AdjustStop::slipped: return "slipped";
    case AdjustStop::not_developable: return "not developable";
  }
  return "unknown";
}

}  // namespace toile
