#include "edit/account.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "garment/units.h"

namespace toile {
namespace {

std::string percent(double share) { return std::to_string(static_cast<int>(std::lround(100 * share))) + " %"; }

std::string plain(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

void check_source(const EditInput& input, const std::string& operation) {
  if (input.drape.cols() != input.garment.vertex_count)
    throw std::invalid_argument(operation + ": the drape has another number of vertices than the garment");
  if (!input.drape.allFinite()) throw std::invalid_argument(operation + ": the drape is not finite");
}

std::string in_cm(double metres) { return plain("%.1f cm", metres * units::cm_per_m); }

std::string in_degrees(double radians) { return plain("%.2f", radians / units::degree); }

void describe_style(Report& report, const std::string& place, const NormalDeviation& deviation) {
  report.note("edit.normals", place,
              "normals turn by " + in_degrees(deviation.mean) + " degrees in the mean, " + in_degrees(deviation.most) +
                  " at most; the fabric is stretched to between " + percent(deviation.least_stretch) + " and " +
                  percent(deviation.most_stretch));
  if (deviation.mean > 3 * units::degree || deviation.most > 45 * units::degree)
    report.warn("edit.style-changed", place, "the garment's folds or flare could not be kept everywhere",
                "look at the target; a smaller move or an anchor farther from the loop keeps more");
  if (deviation.least_stretch < 0.4 || deviation.most_stretch > 2.5)
    report.warn("edit.uneven", place, "the change is spread over little fabric", "name an anchor farther from the loop");
}

void describe_end(Report& report, const std::string& place, double deepest, bool settled) {
  if (deepest > 1e-3)
    report.warn("edit.touches-body", place, "the target is " + in_mm(deepest) + " inside the body somewhere",
                "the drape will push it out; expect a difference there");
  if (!settled) report.note("edit.not-settled", place, "the target was still moving by more than 0.1 mm at the end");
}

}  // namespace toile
