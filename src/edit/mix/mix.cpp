#include "edit/mix/mix.h"

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "edit/account.h"
#include "edit/arguments.h"
#include "edit/mix/blend.h"
#include "edit/mix/join_style.h"
#include "edit/mix/joined.h"
#include "edit/mix/mix_loops.h"
#include "edit/mix/parting.h"
#include "edit/mix/recut.h"
#include "edit/mix/uniting.h"
#include "garment/units.h"

namespace toile {
namespace {

const char* const place_of_edit = "edit 'mix'";

const std::vector<Parameter>& mix_parameters() {
  static const std::vector<Parameter> parameters{
      {"with", "file", "the pattern of the other garment, beside the recipe; it is worn as this one is", {}, {}, {}},
      {"loop",
       "loop",
       "where they meet, on this garment: a seam or edge such as \"waist\" or \"armhole\", or a level such as \"hip\"",
       {},
       {},
       {}},
      {"region",
       "loop",
       "where they may meet: two loops or levels, \"waist..hip\"; the best place between them is found",
       {},
       {},
       {},
       "loop"},
      {"other_loop",
       "loop",
       "the loop of the other garment; \"auto\": where this garment's loop is on the body",
       {},
       {},
       "auto"},
      {"keep",
       "loop",
       "what is kept of this garment: \"before\" the loop, as limbs run (above it, or the trunk's side), or \"beyond\" it",
       {},
       {},
       "before"},
      {"unite",
       "loop",
       "where a cut runs across panels of both garments: \"auto\", they become one piece where the garment is flat there; "
       "\"never\", they keep a seam",
       {},
       {},
       "auto"},
  };
  return parameters;
}

bool keeps_beyond(const std::string& written) {
  if (written != "before" && written != "beyond")
    throw BadInput({"edit.bad-side", Severity::error, "edit 'mix', keep", "'" + written + "' is no side of a loop",
                    "write \"before\" (above it, or towards the trunk) or \"beyond\""});
  return written == "beyond";
}

bool never_unites(const std::string& written) {
  if (written != "auto" && written != "never")
    throw BadInput({"edit.bad-choice", Severity::error, "edit 'mix', unite", "'" + written + "' is not known here",
                    "write \"auto\" or \"never\""});
  return written == "never";
}

std::shared_ptr<const WornGarment> other_garment(const EditInput& input, const std::string& file) {
  const std::string place = "edit 'mix', with";
  if (!input.find_garment)
    throw BadInput({"edit.no-garments", Severity::error, place, "there is nothing here that could wear another garment",
                    "mix in a recipe"});
  return input.find_garment(file, input.body, place);
}

MixLoops loops_named(const EditInput& first, const EditInput& second, const ReadArguments& read) {
  const std::string& other = read.names.at("other_loop");
  if (!read.names.count("region")) return mix_loops(first, second, read.names.at("loop"), other);
  if (other != "auto")
    throw BadInput({"edit.two-parameters", Severity::error, place_of_edit, "has both region and other_loop",
                    "a region decides for both garments: leave other_loop out"});
  return mix_loops_in(first, second, read.names.at("region"));
}

void refuse_slivers(const EditInput& input, const std::string& garment, const std::vector<CutLoop>& loops) {
  for (const CutLoop& loop : loops)
    if (const auto panel = sliver(input, loop, place_of_edit))
      throw BadInput({"edit.sliver", Severity::error, place_of_edit,
                      "the cut touches a seam of '" + garment + "' and would leave a sliver of panel '" + *panel + "'",
                      "name that seam as the loop, or move the loop or the ends of the region 3 cm away from it"});
}

void describe(Report& report, const EditInput& input, const WornGarment& other, const Pattern& pattern, const MixedShape& shape,
              double mismatch) {
  report.note("edit.moved", place_of_edit,
              std::to_string(pattern.pieces.size()) + " pieces, of '" + input.pattern.name + "' and '" + other.pattern.name +
                  "'; their edges were " + in_mm(shape.gap_mean) + " apart in the mean, " + in_mm(shape.gap_max) +
                  " at most, and meet in the middle");
  char words[96];
  std::snprintf(words, sizeof words, "the edges that meet differed in length by up to %.1f %%", 100 * mismatch);
  report.note("edit.joint", place_of_edit, words);
  describe_style(report, place_of_edit, shape.styled.deviation);
  describe_end(report, place_of_edit, shape.styled.deepest, shape.styled.settled);
}

Target apply_mix(const EditInput& input, const EditArguments& arguments) {
  constexpr double alike = 2e-3;  // share: edges of a joint that differ by less are sewn as they are
  const bool never_unite = never_unites(read_arguments("mix", mix_parameters(), arguments).names.at("unite"));
  Meeting meeting = meet(input, arguments);
  auto& [other, joined, hung, shape, found] = meeting;
  if (!shape.styled.deviation.flipped.empty())
    throw BadInput({"edit.flipped", Severity::error, place_of_edit,
                    "the garments would have to turn over on themselves in " +
                        std::to_string(shape.styled.deviation.flipped.size()) + " triangles to meet",
                    "choose loops of the two garments that are nearer to each other"});
  const double mismatch = joint_mismatch(joined);

  Recut cut{joined.pattern, hung.garment};
  if (mismatch > alike) {
    cut = recut(joined, hung, shape.positions);
    shape.source = shape.positions;
  }
  Uniting united = unite_where_flat(joined, cut.pattern, cut.garment, shape.positions, blend_share * input.body.form.height,
                                    never_unite, place_of_edit);

  Target target;
  const auto count = static_cast<Eigen::Index>(united.vertex.size());
  target.source.resize(3, count);
  target.positions.resize(3, count);
  const std::set<int> joint(hung.joint.begin(), hung.joint.end());
  for (Eigen::Index v = 0; v < count; ++v) {
    const int before = united.vertex[static_cast<std::size_t>(v)];
    target.source.col(v) = shape.source.col(before);
    target.positions.col(v) = shape.positions.col(before);
    if (joint.count(before)) target.held.push_back(static_cast<int>(v));
  }
  target.garment = std::move(united.garment);
  target.before = shape.styled.before;
  target.after = shape.styled.after;
  target.normal_deviation_mean = shape.styled.deviation.mean;
  target.normal_deviation_max = shape.styled.deviation.most;
  target.report.append(other->report);
  target.report.append(found);
  describe(target.report, input, *other, united.pattern, shape, mismatch);
  target.report.append(united.report);
  target.pattern = std::make_shared<const Pattern>(std::move(united.pattern));
  return target;
}

}  // namespace

Meeting meet(const EditInput& input, const EditArguments& arguments) {
  check_source(input, "mix");
  const ReadArguments read = read_arguments("mix", mix_parameters(), arguments);
  const bool keep_beyond = keeps_beyond(read.names.at("keep"));
  Meeting meeting;
  meeting.other = other_garment(input, read.names.at("with"));
  const EditInput second{meeting.other->pattern, meeting.other->garment, meeting.other->drape, input.body};
  check_source(second, "mix");
  MixLoops loops = loops_named(input, second, read);
  refuse_slivers(input, input.pattern.name, loops.first);
  refuse_slivers(second, second.pattern.name, loops.second);
  meeting.report = std::move(loops.report);
  const MixSide a{input,
                  take_part(input, part_garment(input, loops.first, "edit 'mix', loop"), keep_beyond, "edit 'mix', keep")};
  const MixSide b{second, take_part(second, part_garment(second, loops.second, "edit 'mix', other_loop"), !keep_beyond,
                                    "edit 'mix', other_loop")};
  meeting.joined = join(a, b, "edit 'mix', loop");
  meeting.hung = hang(meeting.joined, a, b, meeting.other->edge_length);
  meeting.shape = join_style(input.body, meeting.hung, input, second);
  return meeting;
}

EditOperation mix_operation() { return {"mix", "part of this garment joined to part of another", mix_parameters(), apply_mix}; }

}  // namespace toile
