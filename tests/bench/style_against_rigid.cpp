// The edits of the paper's Table 1, one by one, against deformations that keep the surface as rigid as possible with the same
// vertices held: the handle's, those of openings and those that lie on the body, each where the edit put it.

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

#include "cli/job.h"
#include "cli/recipe_file.h"
#include "cli/table1_file.h"
#include "edit/against_rigid.h"
#include "edit/contact_region.h"
#include "edit/mix/mix.h"
#include "geometry/topology.h"

namespace toile {
namespace {

std::vector<int> held_by(const EditInput& source, const std::vector<int>& handle) {
  std::set<int> held(handle.begin(), handle.end());
  for (const auto& edge : boundary_loops(source.garment.triangles)) held.insert(edge.begin(), edge.end());
  const ContactRegion contact = contact_region(source);
  for (std::size_t v = 0; v < contact.tight.size(); ++v)
    if (contact.tight[v]) held.insert(static_cast<int>(v));
  return {held.begin(), held.end()};
}

testing::AgainstRigid compared(const EditInput& input, const Edit& edit, const Target& target) {
  if (edit.operation != "mix")
    return testing::against_rigid(input.drape, input.garment.triangles, target.positions, held_by(input, target.held));
  const Meeting meeting = meet(input, edit.arguments);
  const SideBySide both = side_by_side(meeting.hung);
  GarmentMesh apart = meeting.hung.garment;
  apart.triangles = both.triangles;
  apart.vertex_count = static_cast<int>(both.welded.size());
  return testing::against_rigid(both.positions, both.triangles, meeting.shape.styled.positions,
                                held_by({input.pattern, apart, both.positions, input.body}, {}));
}

void print(const std::string& row, const std::string& edit, const testing::AgainstRigid& c) {
  constexpr double degrees = 57.29577951308232;
  const auto beaten = [](double ours, double theirs) { return ours < theirs ? ' ' : '!'; };
  std::printf("%-19s %-7s %6.2f %6.2f %c %7.2f %7.2f %c %7.2f %7.2f %c %7.2f %7.2f %c\n", row.c_str(), edit.c_str(),
              degrees * c.style.turned, degrees * c.rigid.turned, beaten(c.style.turned, c.rigid.turned), c.style.curved,
              c.rigid.curved, beaten(c.style.curved, c.rigid.curved), c.style.added, c.rigid.added,
              beaten(c.style.added, c.rigid.added), c.style.total, c.rigid.total, beaten(c.style.total, c.rigid.total));
  std::fflush(stdout);
}

void compare_row(const TableRow& row) {
  Progress progress(ProgressStyle::none);
  Job job;
  job.recipe_file = row.recipe;
  job.recipe = value_or_throw(read_recipe(row.recipe));
  load(job, progress);
  drape(job, progress, {});
  Target before = edit(job.worn, job.scene, {});
  for (std::size_t i = 0; i < job.recipe.edits.size(); ++i) {
    const std::vector<Edit> so_far(job.recipe.edits.begin(), job.recipe.edits.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    Target after = edit(job.worn, job.scene, so_far);
    const Body& body = before.body ? *before.body : job.scene.body;
    print(row.name, so_far.back().operation,
          compared({edited_pattern(job.worn, before), before.garment, before.positions, body, job.scene.find_body,
                    job.scene.find_garment},
                   so_far.back(), after));
    before = std::move(after);
  }
}

int run(const std::string& only) {
  const std::filesystem::path root = TOILE_SOURCE_DIR;
  std::printf("%-19s %-7s %15s %17s %17s %17s\n", "style, rigid", "", "normals, deg", "curved, rad", "added, rad",
              "total, rad");
  for (const TableRow& row : value_or_throw(read_table1(root / "templates/table1/table1.toml"))) {
    if (!only.empty() && row.name != only) continue;
    try {
      compare_row(row);
    } catch (const std::exception& error) {
      std::printf("%-19s %s\n", row.name.c_str(), error.what());
    }
  }
  return 0;
}

}  // namespace
}  // namespace toile

int main(int count, char** words) { return toile::run(count > 1 ? words[1] : ""); }
