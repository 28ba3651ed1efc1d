#include "formats/dxf_aama/units.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "formats/dxf/tags.h"
#include "garment/units.h"

namespace toile::aama {
namespace {

Eigen::AlignedBox2d box_of(const std::vector<Run>& runs) {
  Eigen::AlignedBox2d box;
  for (const Run& run : runs)
    for (const Eigen::Vector2d& p : run.points) box.extend(p);
  return box;
}

struct Unit {
  const char* name;
  double metres;
};
constexpr Unit millimetre{"mm", 1e-3}, centimetre{"cm", 1e-2}, metre{"m", 1.0}, inch{"inch", 0.0254}, foot{"foot", 0.3048},
    decimetre{"dm", 0.1};

// What the file says: the units it may mean, the likeliest first; `said` is empty when it says nothing.
struct Statement {
  std::string said;
  std::vector<Unit> meanings;
  const char* by = "";  // FileUnits::decided_by
  bool sure = false;    // a writer known to mean the first
};

struct Range {
  double low, high;
  bool holds(double value) const { return value >= low && value <= high; }
};
constexpr Range usual_piece{0.150, 2.5}, possible_piece{0.020, 6.0};
constexpr Range usual_notch{0.9e-3, 15e-3}, usual_allowance{1.9e-3, 80e-3};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool has_details(const UnitEvidence& e) { return !e.notch_depths.empty() || !e.allowances.empty(); }

bool details_fit(const UnitEvidence& e, const Unit& unit) {
  return (e.notch_depths.empty() || usual_notch.holds(median(e.notch_depths) * unit.metres)) &&
         (e.allowances.empty() || usual_allowance.holds(median(e.allowances) * unit.metres));
}

Statement statement(const UnitEvidence& e) {
  const std::string& text = e.style.units;
  const auto says = [&](std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(), [&](const char* word) { return dxf::same_word(text, word); });
  };
  const std::string quoted = "the text 'Units: " + text + "'";
  if (says({"METRIC"})) return {quoted, {millimetre, centimetre, metre}, "text", dxf::same_word(e.style.product, "TOILE")};
  if (says({"ENGLISH", "IMPERIAL", "INCH", "INCHES", "IN"})) return {quoted, {inch}, "text"};
  if (says({"MM", "MILLIMETER", "MILLIMETERS", "MILLIMETRE", "MILLIMETRES", "METRIC MM"}))
    return {quoted, {millimetre}, "text"};
  if (says({"CM", "CENTIMETER", "CENTIMETERS", "CENTIMETRE", "CENTIMETRES", "METRIC CM"}))
    return {quoted, {centimetre}, "text"};

  const auto header = [&](const char* key) {
    const auto found = e.header.find(key);
    return found == e.header.end() ? std::nullopt : dxf::whole_number(found->second);
  };
  switch (header("$INSUNITS").value_or(0)) {
    case 1:
      return {"$INSUNITS = 1", {inch}, "$INSUNITS"};
    case 2:
      return {"$INSUNITS = 2", {foot}, "$INSUNITS"};
    case 4:
      return {"$INSUNITS = 4", {millimetre}, "$INSUNITS"};
    case 5:
      return {"$INSUNITS = 5", {centimetre}, "$INSUNITS"};
    case 6:
      return {"$INSUNITS = 6", {metre}, "$INSUNITS"};
    case 14:
      return {"$INSUNITS = 14", {decimetre}, "$INSUNITS"};
    default:
      break;
  }
  // $MEASUREMENT = 0 is what writers leave there that never thought about it.
  if (header("$MEASUREMENT") == 1) return {"$MEASUREMENT = 1 (metric)", {millimetre, centimetre, metre}, "$MEASUREMENT"};
  return {};
}

const Unit* first_that(const std::vector<Unit>& units, const auto& fits) {
  const auto found = std::find_if(units.begin(), units.end(), fits);
  return found == units.end() ? nullptr : &*found;
}

// The meaning of a statement that agrees best with the sizes; nullptr when they contradict it.
const Unit* meaning(const Statement& s, const UnitEvidence& e) {
  const auto usual = [&](const Unit& u) { return usual_piece.holds(e.largest * u.metres); };
  const auto possible = [&](const Unit& u) { return possible_piece.holds(e.largest * u.metres); };
  if (s.sure) return &s.meanings.front();
  if (const Unit* unit = first_that(s.meanings, [&](const Unit& u) { return usual(u) && details_fit(e, u); })) return unit;
  if (has_details(e))
    if (const Unit* unit = first_that(s.meanings, [&](const Unit& u) { return possible(u) && details_fit(e, u); })) return unit;
  if (const Unit* unit = first_that(s.meanings, usual)) return unit;
  return possible(s.meanings.front()) ? &s.meanings.front() : nullptr;
}

std::string size_in(const UnitEvidence& e, const Unit& unit) {
  return in_mm(e.largest * unit.metres, 0) + " if in " + unit.name;
}

std::optional<FileUnits> ask(const UnitEvidence& e, const std::string& why, const std::string& name, Report& report) {
  report.error("aama.units-ambiguous", name,
               why + "; is the file in mm, cm or inches? Its largest piece is " + size_in(e, millimetre) + ", " +
                   size_in(e, centimetre) + ", " + size_in(e, inch),
               "say so: --units mm, cm or in; in a recipe units = \"mm\", \"cm\" or \"in\"", Fault::ambiguous);
  return {};
}

FileUnits as_told(double metres) {
  for (const Unit& unit : {millimetre, centimetre, metre, inch, foot, decimetre})
    if (std::abs(metres - unit.metres) <= 1e-9 * metres) return {unit.name, metres, "override"};
  return {in_mm(metres, 4), metres, "override"};
}

}  // namespace

void add_evidence(UnitEvidence& evidence, const DrawnPiece& piece) {
  Eigen::AlignedBox2d all, cut = box_of(piece.cut), sew = box_of(piece.sew);
  for (const auto* runs : {&piece.cut, &piece.sew, &piece.dense_cut, &piece.dense_sew}) all.extend(box_of(*runs));
  if (!all.isEmpty()) evidence.largest = std::max(evidence.largest, all.sizes().maxCoeff());
  for (const DrawnNotch& notch : piece.notches)
    if (notch.depth > 0) evidence.notch_depths.push_back(notch.depth);
  if (cut.isEmpty() || sew.isEmpty()) return;
  for (const double gap : {sew.min().x() - cut.min().x(), sew.min().y() - cut.min().y(), cut.max().x() - sew.max().x(),
                           cut.max().y() - sew.max().y()})
    if (gap > 1e-6 * all.sizes().maxCoeff()) evidence.allowances.push_back(gap);
}

std::optional<FileUnits> decide_unit(const UnitEvidence& e, std::optional<double> override_unit, const std::string& name,
                                     Report& report) {
  if (override_unit) {
    report.note("aama.units", name,
                "1 file unit = " + in_mm(*override_unit, 4) + ", as asked; the largest piece is " +
                    in_mm(e.largest * *override_unit, 0));
    return as_told(*override_unit);
  }
  const Statement said = statement(e);
  const std::string place = e.style.units_line > 0 ? name + ":" + std::to_string(e.style.units_line) : name;
  if (!said.said.empty()) {
    const Unit* unit = meaning(said, e);
    if (!unit) return ask(e, said.said + " does not fit the sizes", place, report);
    const std::string size = "; the largest piece is " + in_mm(e.largest * unit->metres, 0);
    if (unit == &said.meanings.front())
      report.note("aama.units", place, std::string("read as ") + unit->name + " by " + said.said + size);
    else
      report.warn("aama.units", place,
                  std::string("read as ") + unit->name + ": " + said.said +
                      " should mean mm, but then the largest piece would be only " +
                      in_mm(e.largest * said.meanings.front().metres, 1) + size,
                  "if that is wrong, give the unit (--units; `units` in a recipe)");
    return FileUnits{unit->name, unit->metres, unit == &said.meanings.front() ? said.by : "plausibility"};
  }
  const Unit* found = nullptr;
  int fitting = 0;
  for (const Unit* unit : {&millimetre, &centimetre, &inch})
    if (usual_piece.holds(e.largest * unit->metres) && details_fit(e, *unit)) {
      found = unit;
      ++fitting;
    }
  const char* by = "plausibility";
  const auto measurement = e.header.find("$MEASUREMENT");
  const bool english = measurement != e.header.end() && dxf::whole_number(measurement->second) == 0;
  if (fitting > 1 && english && usual_piece.holds(e.largest * inch.metres) && details_fit(e, inch)) {
    found = &inch;
    fitting = 1;
    by = "$MEASUREMENT";
  }
  if (fitting != 1) {
    const std::string unknown =
        e.style.units.empty() ? "the file does not say its unit" : "the unit '" + e.style.units + "' is unknown";
    return ask(e, unknown, place, report);
  }
  report.note("aama.units", place,
              std::string("the file does not say its unit; read as ") + found->name +
                  (found == &inch && english ? " ($MEASUREMENT = 0), in which its pieces have a garment's size; the largest is "
                                             : ", the only one in which its pieces have a garment's size; the largest is ") +
                  in_mm(e.largest * found->metres, 0),
              "if that is wrong, give the unit (--units; `units` in a recipe)");
  return FileUnits{found->name, found->metres, by};
}

}  // namespace toile::aama
