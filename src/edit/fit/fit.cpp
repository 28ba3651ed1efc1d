#include "edit/fit/fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "edit/account.h"
#include "edit/arguments.h"
#include "edit/fit/girth.h"
#include "edit/fit/loosen.h"
#include "edit/fit/offset.h"
#include "edit/in_turn.h"
#include "edit/loop_ease.h"
#include "edit/loops.h"
#include "edit/reach.h"
#include "garment/units.h"

namespace toile {
namespace {

const char* const place = "edit 'fit'";

const std::vector<Parameter>& fit_parameters() {
  constexpr double turn = 2 * std::numbers::pi;
  static const std::vector<Parameter> parameters{
      {"loop",
       "loop",
       "the loop to loosen or tighten: \"hem\", \"waist\", edges such as \"gore.hem\", a level such as \"hip\" or "
       "\"upperarm.L:0.5\"; \"all\": the whole garment",
       {},
       {},
       "hem"},
      {"by", "m", "how far every point of it goes away from the body; minus is nearer", -0.5, 0.5, {}},
      {"girth", "m", "by how much the loop gets longer; minus is shorter", -3.0, 3.0, {}, "by"},
      {"from", "deg", "where round the limb the change begins: 0 deg = front, 90 deg = the wearer's left", -turn, turn,
       "-180 deg"},
      {"to", "deg", "where it ends", -turn, turn, "180 deg"},
      {"release", "m", "how near the loop the garment need not keep its distance to the body", 0.0, 1.5, "15 cm"},
      {"anchor",
       "loop",
       "loops or levels beyond which nothing changes, separated by commas; \"auto\": where the garment lies on the body beyond "
       "release; \"none\"",
       {},
       {},
       "auto"},
  };
  return parameters;
}

FitRange range_of(const ReadArguments& read) {
  const FitRange range{read.numbers.at("from"), read.numbers.at("to")};
  if (!(range.to - range.from > 5 * units::degree) || range.to - range.from > 2 * std::numbers::pi + 1e-9)
    throw BadInput({"edit.bad-range", Severity::error, place + std::string(", to"),
                    "the range is not between 5 and 360 degrees wide", "write the larger angle under \"to\""});
  return range;
}

// Share of the area the garment hangs by that the target lifts off the body.
double lifted_share(const EditInput& input, EditMemory& memory, const Eigen::Matrix3Xd& positions) {
  const ContactRegion& contact = source_contact(input, memory);
  const Eigen::VectorXd areas = vertex_areas(source_shape(input, memory), positions.cols());
  double lifted = 0, all = 0;
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    if (!contact.bearing[static_cast<std::size_t>(v)]) continue;
    all += areas(v);
    if (input.body.distance.distance(positions.col(v)) > std::max(0.0, contact.gap(v)) + 3e-3) lifted += areas(v);
  }
  return all > 0 ? lifted / all : 0;
}

void describe_ease(Report& report, const std::string& name, const LoopEase& before, const LoopEase& after) {
  std::string text =
      "'" + name + "' measures " + in_cm(before.along) + " before, " + in_cm(after.along) + " after, along the cloth";
  if (before.body > 0 && after.body > 0)
    text += "; a taut tape round it " + in_cm(before.tape) + " and " + in_cm(after.tape) + ", the body inside " +
            in_cm(before.body) + ": ease " + in_cm(before.ease()) + " before, " + in_cm(after.ease()) + " after";
  report.note("edit.ease", place, text);
}

Target target_of(const EditInput& input, EditMemory& memory, Styled&& styled, Report&& report) {
  if (!styled.deviation.flipped.empty())
    throw BadInput(
        {"edit.flipped", Severity::error, place,
         "the garment would have to turn over on itself in " + std::to_string(styled.deviation.flipped.size()) + " triangles",
         "ask for less, or name an anchor farther from the loop"});
  Target target;
  target.report = std::move(report);
  describe_style(target.report, place, styled.deviation);
  describe_end(target.report, place, styled.deepest, styled.settled);
  if (lifted_share(input, memory, styled.positions) > 0.5)
    target.report.warn("edit.may-slip", place, "most of what the garment hangs by no longer lies on the body",
                       "loosen another part, or name an anchor where it hangs, such as \"waist\"");
  target.garment = input.garment;
  target.source = input.drape;
  target.positions = std::move(styled.positions);
  target.before = styled.before;
  target.after = styled.after;
  target.normal_deviation_mean = styled.deviation.mean;
  target.normal_deviation_max = styled.deviation.most;
  return target;
}

// Says what stopped `offsets` short of `by`; throws when they are nothing.
void describe_offsets(Report& report, const std::string& name, const FitLoop& fit, const Eigen::VectorXd& offsets, double by) {
  double moved = 0, count = 0;
  int stopped = 0;
  for (Eigen::Index i = 0; i < offsets.size(); ++i) {
    if (!(fit.share(i) > 0.99)) continue;
    moved += offsets(i);
    ++count;
    if (offsets(i) > by * fit.share(i) + 1e-5) ++stopped;
  }
  moved /= std::max(1.0, count);
  if (by < -1e-3 && moved > -0.5e-3)
    throw BadInput({"edit.no-room", Severity::error, place, "'" + name + "' lies on the body already",
                    "choose a loop that is off the body; cloth that is to press on it is a matter of the pattern"});
  report.note("edit.moved", place,
              "'" + name + "' moved " + in_mm(std::abs(moved)) + (moved < 0 ? " towards" : " away from") + " the body");
  if (stopped > 0)
    report.warn("edit.stopped-at-body", place,
                std::to_string(static_cast<int>(std::lround(100 * stopped / count))) + " % of '" + name +
                    "' stopped at the body; " + in_mm(std::abs(by)) + " were asked for",
                "see the ease that is left, or ask for less");
}

// All arguments but the amount.
std::string apart_from_amount(const ReadArguments& read) {
  std::string name = "fit";
  for (const auto& [parameter, value] : read.names) name += ", " + parameter + " " + value;
  for (const char* parameter : {"from", "to", "release"}) {
    char text[48];
    std::snprintf(text, sizeof text, ", %s %.17g", parameter, read.numbers.at(parameter));
    name += text;
  }
  return name;
}

Target fit_all(const EditInput& input, const ReadArguments& read, EditMemory& memory) {
  const std::vector<RelativePlace>& places = source_places(input, memory);
  const auto girth = read.numbers.find("girth");
  const double by = girth == read.numbers.end() ? read.numbers.at("by") : girth->second / (2 * std::numbers::pi);
  if (!range_of(read).whole())
    throw BadInput({"edit.bad-range", Severity::error, place, "the whole garment cannot be changed over a range of angles",
                    "leave \"from\" and \"to\" out, or name a loop"});
  const std::string& anchor = read.names.at("anchor");
  std::vector<VertexLoop> stays;
  if (anchor != "auto" && anchor != "none") stays = anchors_named(input, anchor, {});
  Loosened loosened = loosen(input, by, read.numbers.at("release"), stays, memory, apart_from_amount(read));
  Report report;
  double moved = 0;
  for (const int v : loosened.moving)
    moved += (loosened.styled.positions.col(v) - input.drape.col(v)).dot(places[static_cast<std::size_t>(v)].outward) /
             static_cast<double>(loosened.moving.size());
  report.note("edit.moved", place,
              "the garment moved " + in_mm(std::abs(moved)) + (moved < 0 ? " towards" : " away from") +
                  " the body in the mean; " + in_mm(std::abs(by)) + " were asked for");
  for (const VertexLoop& edge : garment_boundary(input, memory)) {
    const Eigen::Vector3d axis = limb_direction(places, edge);
    describe_ease(report, "opening at " + in_cm(loop_centre(input.drape, edge).y()),
                  loop_ease(input.body.form, input.drape, edge, axis),
                  loop_ease(input.body.form, loosened.styled.positions, edge, axis));
  }
  std::set<int> anchors;
  for (const VertexLoop& loop : stays) anchors.insert(loop.begin(), loop.end());
  Target target = target_of(input, memory, std::move(loosened.styled), std::move(report));
  target.anchor.assign(anchors.begin(), anchors.end());
  return target;
}

Target apply_fit(const EditInput& input, const EditArguments& arguments) {
  check_source(input, "fit");
  const ReadArguments read = read_arguments("fit", fit_parameters(), arguments);
  const FitRange range = range_of(read);
  const std::string& name = read.names.at("loop");
  if (const auto names = names_apart(input, name); names.size() > 1) return apply_in_turn(input, arguments, names, apply_fit);
  EditMemory own;
  EditMemory& memory = input.memory ? *input.memory : own;
  if (name == "all") return fit_all(input, read, memory);
  const ContactRegion& contact = source_contact(input, memory);

  const double release = read.numbers.at("release");
  const std::string what = apart_from_amount(read);
  const std::vector<FitLoop>& fits = memory.once(what + ", loops", [&] {
    const Eigen::VectorXd least = contact.gap.cwiseMin(contact_distance(contact.gap));
    return fit_loops(input, name, source_places(input, memory), contact, least, read.names.at("anchor"), release, range);
  });
  Report report;
  std::vector<Eigen::VectorXd> offsets;
  std::set<int> held, anchor;
  for (const FitLoop& fit : fits) {
    const auto girth = read.numbers.find("girth");
    const double by =
        girth == read.numbers.end() ? read.numbers.at("by") : offset_for_girth(fit, input.drape, girth->second, report);
    offsets.push_back(fit.offsets(by));
    describe_offsets(report, name, fit, offsets.back(), by);
    held.insert(fit.loop.begin(), fit.loop.end());
    for (const VertexLoop& ring : fit.anchor) {
      anchor.insert(ring.begin(), ring.end());
      report.note("edit.anchor", place,
                  "nothing changes beyond the anchor at height " + in_mm(loop_centre(input.drape, ring).y(), 0));
    }
  }
  Styled styled = offset_loops(input, fits, offsets, release, memory, what);
  for (const FitLoop& fit : fits)
    describe_ease(report, name, loop_ease(input.body.form, input.drape, fit.loop, fit.axis),
                  loop_ease(input.body.form, styled.positions, fit.loop, fit.axis));
  Target target = target_of(input, memory, std::move(styled), std::move(report));
  target.held.assign(held.begin(), held.end());
  target.anchor.assign(anchor.begin(), anchor.end());
  return target;
}

}  // namespace

EditOperation fit_operation() {
  return {"fit", "moves a loop of the garment, or all of it, away from the body or towards it, the style kept",
          fit_parameters(), apply_fit};
}

}  // namespace toile
