#include "edit/mix/stretch_fates.h"

#include <cstdio>

#include "edit/account.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr double grain_differs = 3 * units::degree;

std::string figure(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

void describe_stretches(const std::vector<JudgedStretch>& stretches, const std::string& place, Report& report) {
  for (const JudgedStretch& s : stretches) {
    const std::string both = s.names[0] + " and " + s.names[1];
    const std::string figures = "along " + in_cm(s.joint.length) + " their edges turn apart by " +
                                in_degrees(s.joint.turns_apart) + " degrees (Gaussian curvature " +
                                figure("%+.3f", s.joint.curvature) + ")";
    if (s.fate == JointFate::united) {
      report.note("edit.united", place, both + " are one piece: " + figures + ", flat to within " + in_degrees(flat_enough));
      if (s.grain_turn > grain_differs)
        report.note("edit.grain-differs", place,
                    "the grain of " + both + " differs by " + figure("%.0f", s.grain_turn / units::degree) +
                        " degrees; the one piece keeps that of the larger part",
                    "look whether the other part may hang on that grain, or keep the seam (unite = \"never\")");
      continue;
    }
    const char* why = "";
    switch (s.fate) {
      case JointFate::united:
        break;
      case JointFate::keeps_edge:
        why = "an edge of a pattern meets there";
        break;
      case JointFate::not_opposite:
        why = "they do not meet from end to end, seams of one come to the middle of the other";
        break;
      case JointFate::never:
        why = "as asked";
        break;
      case JointFate::curved:
        why = "the garment is not flat there";
        break;
      case JointFate::not_flat:
        why = "together they cannot be laid flat";
        break;
      case JointFate::overlaps:
        why = "in one plane they would lie on each other";
        break;
      case JointFate::same_piece:
        why = "they are one piece already";
        break;
    }
    std::string text = both + " keep a seam (" + why + "): " + figures;
    if (s.fate == JointFate::curved) text += ", more than the " + in_degrees(flat_enough) + " that cloth takes up";
    if (s.fate == JointFate::not_flat) text += ", distorted by " + figure("%.1f %%", 100 * s.distortion);
    report.note("edit.seam-kept", place, text);
  }
}

}  // namespace toile
