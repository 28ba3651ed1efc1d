#include "cli/stuck.h"

#include <algorithm>
#include <cstdio>

#include "formats/formats.h"
#include "picture/stuck.h"

namespace toile {
namespace {

constexpr const char* picture_file = "stuck.png";
constexpr const char* panels_file = "stuck.obj";
constexpr const char* body_file = "body.obj";

}  // namespace

DrapeControl with_stuck_picture(DrapeControl control, Job& job, const OutputFolder& out) {
  control.stuck = [&job, &out](const GarmentMesh& garment, const Stuck& stuck) {
    const LooseGarment loose = loose_garment(garment, stuck.panels);
    write_obj(out.path(panels_file), loose.mesh, loose.positions);
    write_obj(out.path(body_file), job.scene.body.form);
    job.stuck.errors = stuck.errors;
    job.stuck.png = png_bytes(
        stuck_picture(job.scene.body.form, garment, stuck.panels, stuck.where, job.recipe.name + ": where dressing got stuck"));
    write_whole_file(out.path(picture_file), job.stuck.png);
  };
  return control;
}

void name_stuck_picture(const StuckDressing& stuck, std::vector<Finding>& findings) {
  for (Finding& finding : findings)
    if (std::find(stuck.errors.begin(), stuck.errors.end(), finding) != stuck.errors.end())
      finding.remedy += (finding.remedy.empty() ? "Where: " : ". Where: ") + std::string(picture_file);
}

void keep_stuck_picture(const Job& job, OutputFolder& out) {
  if (job.stuck.png.empty()) return;
  out.keep({picture_file, panels_file, body_file});
  std::vector<Finding> errors = job.stuck.errors;
  name_stuck_picture(job.stuck, errors);
  for (const Finding& error : errors) std::fprintf(stderr, "toile: %s\n", in_words(error).c_str());
}

}  // namespace toile
