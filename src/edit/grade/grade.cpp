#include "edit/grade/grade.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "edit/account.h"
#include "edit/arguments.h"
#include "edit/contact_region.h"
#include "edit/grade/transfer.h"
#include "edit/loop_ease.h"
#include "edit/loops.h"
#include "edit/reach.h"
#include "edit/styled.h"
#include "garment/units.h"

namespace toile {
namespace {

// What is carried over is even already; a weaker pull lets cloth slide in its own surface until triangles are three times as
// long and others a third.
constexpr double even_pull = 0.6;

const char* const place_of_edit = "edit 'grade'";

const std::vector<Parameter>& grade_parameters() {
  static const std::vector<Parameter> parameters{
      {"size", "size", "the size of the same chart that the garment is to fit", {}, {}, {}},
      {"body", "file", "an OBJ body that it is to fit, with a skeleton of the same names", {}, {}, {}, "size"},
      {"skeleton", "file", "that body's skeleton; \"beside\": the file named like the body", {}, {}, "beside"},
  };
  return parameters;
}

std::shared_ptr<const Body> body_named(const EditInput& input, const ReadArguments& read) {
  const BodyName name = body_name("grade", read).value();
  const std::string place = std::string(place_of_edit) + (name.file.empty() ? ", size" : ", body");
  if (!input.find_body)
    throw BadInput(
        {"edit.no-bodies", Severity::error, place, "there is nothing here that could make another body", "grade in a recipe"});
  return input.find_body(name, place);
}

// The source's triangles with their planes turned as the limbs are posed on the other body.
std::vector<SourceTriangle> posed(const EditInput& input, const std::vector<Eigen::Matrix3d>& turn) {
  std::vector<SourceTriangle> triangles = source_triangles(input.drape, input.garment.triangles);
  for (SourceTriangle& triangle : triangles) {
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    for (int corner = 0; corner < 3; ++corner) {
      const Eigen::AngleAxisd one(turn[static_cast<std::size_t>(triangle.corners(corner))]);
      way += one.angle() * one.axis() / 3;
    }
    if (way.norm() > 1e-12)
      triangle.plane = Eigen::AngleAxisd(way.norm(), way.normalized()).toRotationMatrix() * triangle.plane;
  }
  return triangles;
}

BodyTerms body_terms(const EditInput& input, const Body& to, const LimbMap& map, const Transferred& start,
                     const std::vector<RelativePlace>& places, const ContactRegion& contact, const Eigen::VectorXd& areas) {
  constexpr double loose_fit = 0.01;  // of what tight cloth is asked; it only keeps a garment that is loose all over in place
  constexpr double loose_proportion = 0.02;  // likewise: so that it does not creep along its own surface
  constexpr double staying = 5e-3;           // of the weight of fit; it only decides what nothing else does
  const Eigen::Index count = input.drape.cols();
  const StyleWeights weights = style_weights(to.form.height);
  std::vector<bool> on_edge(static_cast<std::size_t>(count), false);
  for (const VertexLoop& edge : boundary_loops(input.garment.triangles))
    for (const int v : edge) on_edge[static_cast<std::size_t>(v)] = true;
  BodyWishes wishes;
  wishes.moves.assign(static_cast<std::size_t>(count), true);
  wishes.least = contact.gap.cwiseMin(contact_distance(contact.gap));
  wishes.release = wishes.offset = Eigen::VectorXd::Zero(count);
  for (Eigen::Index v = 0; v < count; ++v) {
    const auto at = static_cast<std::size_t>(v);
    wishes.limb.push_back(map.limb(places[at].limb));
    wishes.offset(v) = places[at].offset;
    if (places[at].through_skin)
      wishes.release(v) = contact.tight[at] ? 1 : loose_fit * (1 - smoothstep(places[at].offset, 0.05, 0.20));
    const double share = contact.tight[at] || on_edge[at] ? 1 : loose_proportion;
    wishes.proportion.push_back(
        proportion_term(static_cast<int>(v), start.axis.col(v), start.level(v), share * areas(v), weights));
    for (int i = 0; i < 3; ++i)
      wishes.proportion.push_back({static_cast<int>(v), Eigen::Vector3d::Unit(i), start.positions(i, v),
                                   staying * weights.fit * areas(v) / (weights.length * weights.length)});
  }
  return {to, areas, std::move(wishes)};
}

void describe_ease(const EditInput& input, const Body& to, const Eigen::Matrix3Xd& positions, Report& report) {
  const auto say = [&](const std::string& name, const VertexLoop& loop, const Eigen::Vector3d& axis) {
    const LoopEase before = loop_ease(input.body.form, input.drape, loop, axis);
    const LoopEase after = loop_ease(to.form, positions, loop, axis);
    std::string text = name + ": " + in_cm(before.along) + " before, " + in_cm(after.along) + " after, along the cloth";
    if (before.body > 0 && after.body > 0)
      text += "; ease to the body " + in_cm(before.ease()) + " before, " + in_cm(after.ease()) + " after";
    report.note("edit.ease", place_of_edit, text);
  };
  const auto places = relative_places(input.body, input.drape, input.garment.triangles);
  for (const char* level : {"bust", "waist", "hip"}) {
    const auto height = input.body.form.landmarks.find(level);
    if (height == input.body.form.landmarks.end()) continue;
    const Eigen::VectorXd field = input.drape.row(1).transpose();
    const auto chains = skeleton_chains(input.body.form);
    for (const VertexLoop& loop : level_loops(level_mesh(input.garment.triangles), field, height->second).closed)
      if (threading(chains, input.drape, loop).round_trunk_or_leg()) say(level, loop, -Eigen::Vector3d::UnitY());
  }
  for (const VertexLoop& edge : boundary_loops(input.garment.triangles))
    say("opening at " + in_cm(loop_centre(input.drape, edge).y()), edge, limb_direction(places, edge));
}

// How well the part that lies on the body keeps its distance to it.
void describe_fit(const Body& to, const LimbMap& map, const std::vector<RelativePlace>& places, const ContactRegion& contact,
                  const Eigen::Matrix3Xd& positions, Report& report) {
  const auto axes = limb_axes(to.form);
  double mean = 0, most = 0;
  int count = 0;
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    const RelativePlace& source = places[static_cast<std::size_t>(v)];
    if (!contact.tight[static_cast<std::size_t>(v)] || !source.through_skin) continue;
    const int limb = map.limb(source.limb);
    const RelativePlace now = relative_place(to, axes[static_cast<std::size_t>(limb)], limb, positions.col(v));
    if (!now.through_skin) continue;
    const double off = std::abs(now.offset - source.offset);
    mean += off;
    most = std::max(most, off);
    ++count;
  }
  if (count > 0)
    report.note("edit.fit", place_of_edit,
                "where the garment lies on the body it keeps its distance within " + in_mm(mean / count) + " in the mean, " +
                    in_mm(most) + " at most");
}

Target apply_grade(const EditInput& input, const EditArguments& arguments) {
  check_source(input, "grade");
  const ReadArguments read = read_arguments("grade", grade_parameters(), arguments);
  const std::shared_ptr<const Body> to = body_named(input, read);
  const LimbMap map(input.body.form, to->form);
  const ContactRegion contact = contact_region(input);
  const auto places = relative_places(input.body, input.drape, input.garment.triangles);
  const Transferred start = transfer(input, places, *to, map);
  const std::vector<SourceTriangle> reference = posed(input, start.turn);
  const BodyTerms terms = body_terms(input, *to, map, start, places, contact, vertex_areas(reference, input.drape.cols()));
  Styled styled_garment = with_weakest_pull(
      [&](const StyleOptions& style) {
        BodyTerms again = terms;
        const StyleSolution solution = solve_style(start.positions, reference, {}, again.all(), style);
        return styled(*to, again, reference, input.drape, contact.gap, solution.initial, solution);
      },
      even_pull);
  mend(styled_garment, *to, reference, input.drape, contact.gap, {});
  if (!styled_garment.deviation.flipped.empty())
    throw BadInput({"edit.flipped", Severity::error, place_of_edit,
                    "the garment would have to turn over on itself in " +
                        std::to_string(styled_garment.deviation.flipped.size()) + " triangles",
                    "grade in smaller steps, or to a body in the same pose"});

  Target target;
  target.garment = input.garment;
  target.source = input.drape;
  target.positions = std::move(styled_garment.positions);
  target.body = to;
  target.before = styled_garment.before;
  target.after = styled_garment.after;
  target.normal_deviation_mean = styled_garment.deviation.mean;
  target.normal_deviation_max = styled_garment.deviation.most;
  double moved = 0;
  for (Eigen::Index v = 0; v < input.drape.cols(); ++v)
    moved += (target.positions.col(v) - target.source.col(v)).norm() / static_cast<double>(input.drape.cols());
  target.report.note("edit.moved", place_of_edit,
                     "from '" + input.body.form.name + "' to '" + to->form.name + "', points " +
                         (same_topology(input.body.form, to->form) ? "of the skin matched one to one"
                                                                   : "matched by their place along and round the limbs") +
                         "; the garment moved " + in_mm(moved) + " in the mean");
  describe_fit(*to, map, places, contact, target.positions, target.report);
  describe_ease(input, *to, target.positions, target.report);
  describe_style(target.report, place_of_edit, styled_garment.deviation);
  if (map.largest_turn() > 15 * units::degree)
    target.report.warn("edit.other-pose", place_of_edit,
                       "the bodies are posed differently, by " + in_degrees(map.largest_turn()) + " degrees at most",
                       "grade to a body in the same pose if you can");
  describe_end(target.report, place_of_edit, styled_garment.deepest, styled_garment.settled);
  return target;
}

}  // namespace

EditOperation grade_operation() {
  return {"grade", "the garment on another body: its ease, proportions and style kept", grade_parameters(), apply_grade};
}

}  // namespace toile
