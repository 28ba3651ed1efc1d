#include "edit/length/length.h"

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "edit/account.h"
#include "edit/arguments.h"
#include "edit/in_turn.h"
#include "edit/length/handle.h"
#include "edit/length/refusals.h"
#include "edit/length/slide.h"
#include "edit/loops.h"
#include "garment/units.h"

namespace toile {
namespace {

const std::vector<Parameter>& length_parameters() {
  static const std::vector<Parameter> parameters{
      {"loop",
       "loop",
       "the loop to move: \"hem\", \"waist\", edges such as \"gore.hem\", a level such as \"hip\" or \"thigh.L:0.5\"; several "
       "with commas",
       {},
       {},
       "hem"},
      {"by", "m", "how far along the body, positive = longer, away from the anchor", -1.5, 1.5, {}},
      {"anchor",
       "loop",
       "the loop or level beyond which nothing changes; \"auto\": the edge of the part that lies on the body",
       {},
       {},
       "auto"},
      {"release", "m", "how near the loop the garment need not keep its distance to the body", 0.0, 1.5, "15 cm"},
      {"stay", "loop", "loops beyond the moved one that keep their height on the body; \"none\"", {}, {}, "none"},
  };
  return parameters;
}

void describe(Report& report, const EditInput& input, const std::string& loop, double by, const std::vector<Handle>& handles,
              const Slide& slide) {
  const std::string place = "edit 'length'";
  report.note("edit.moved", place,
              "'" + loop + "' moved " + in_mm(by) + " along the body" +
                  (handles.size() > 1 ? " (" + std::to_string(handles.size()) + " loops)" : ""));
  for (const Handle& handle : handles)
    report.note("edit.anchor", place,
                "nothing changes beyond the anchor at height " + in_mm(loop_centre(input.drape, handle.anchor.front()).y(), 0) +
                    ", " + in_mm(handle.level - handle.anchor_level, 0) + " from the loop");
  describe_style(report, place, slide.deviation);
  describe_end(report, place, slide.deepest, slide.settled);
}

Target apply_length(const EditInput& input, const EditArguments& arguments) {
  check_source(input, "length");
  const ReadArguments read = read_arguments("length", length_parameters(), arguments);
  const double by = read.numbers.at("by");
  const std::string& name = read.names.at("loop");
  if (const auto names = names_apart(input, name); names.size() > 1)
    return apply_in_turn(input, arguments, names, apply_length);
  EditMemory own;
  EditMemory& memory = input.memory ? *input.memory : own;
  const ContactRegion& contact = source_contact(input, memory);
  const std::vector<Handle> handles = make_handles(input, name, read.names.at("anchor"), by, memory);
  const Eigen::VectorXd areas = vertex_areas(source_shape(input, memory), input.drape.cols());
  refuse_impossible(input, handles, contact, areas, by);

  SlideOptions options{by, read.numbers.at("release"), {}};
  if (read.names.at("stay") != "none") options.stays = resolve_loops(input, read.names.at("stay"), "edit 'length', stay").loops;
  Slide slide = slide_and_freeze(input, handles, options, memory);
  if (!slide.deviation.flipped.empty())
    throw BadInput(
        {"edit.flipped", Severity::error, "edit 'length', by",
         "the garment would have to turn over on itself in " + std::to_string(slide.deviation.flipped.size()) + " triangles",
         "move the loop by less, or name an anchor farther from it"});
  const double floor = std::min(0.0, input.drape.row(1).minCoeff()) - 1e-3;
  if (slide.positions.row(1).minCoeff() < floor)
    throw BadInput({"edit.below-floor", Severity::error, "edit 'length', by",
                    "the garment would reach " + in_mm(-slide.positions.row(1).minCoeff(), 0) + " below the floor",
                    "lengthen by less"});

  Target target;
  target.garment = input.garment;
  target.source = input.drape;
  target.positions = std::move(slide.positions);
  std::set<int> held, anchor;
  for (const Handle& handle : handles) {
    held.insert(handle.loop.begin(), handle.loop.end());
    for (const VertexLoop& ring : handle.anchor) anchor.insert(ring.begin(), ring.end());
  }
  target.held.assign(held.begin(), held.end());
  target.anchor.assign(anchor.begin(), anchor.end());
  target.before = slide.before;
  target.after = slide.after;
  target.normal_deviation_mean = slide.deviation.mean;
  target.normal_deviation_max = slide.deviation.most;
  describe(target.report, input, name, by, handles, slide);
  return target;
}

}  // namespace

EditOperation length_operation() {
  return {"length", "moves a loop of the garment along the body: longer or shorter, the style kept", length_parameters(),
          apply_length};
}

}  // namespace toile
