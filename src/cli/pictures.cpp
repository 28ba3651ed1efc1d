#include "cli/pictures.h"

#include <cctype>

#include "formats/formats.h"
#include "geometry/surface_distance.h"
#include "measure/maps.h"
#include "picture/maps.h"
#include "picture/pictures.h"

namespace toile {
namespace {

Picture written(const OutputFolder& out, const std::string& file, const std::string& caption, const Image& image) {
  Picture picture{file, caption, png_bytes(image)};
  write_whole_file(out.path(file), picture.png);
  return picture;
}

// What a map shows, for people who see one for the first time.
std::string caption_of(const GarmentMap& map) {
  const std::string turn = " To turn round: " + map.name + ".glb.";
  if (map.name == "ease") return "Ease: air between cloth and body." + turn;
  if (map.name == "pressure") return "Pressure of the cloth on the body." + turn;
  std::string title = map.title;
  title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  return title + ": red is longer than cut, blue is pushed together." + turn;
}

// Stretch on one scale for warp, weft and bias; ease and pressure each on their own. As pictures and, to turn round, as GLB.
std::vector<Picture> write_maps(const Job& job, const Showing& showing, const Eigen::Matrix3Xd& positions,
                                const std::string& title, const OutputFolder& out) {
  const std::vector<GarmentMap> maps = drape_maps(showing.garment, positions, job.scene.body, job.scene.fabric);
  std::vector<Picture> pictures;
  for (const GarmentMap& map : maps) {
    std::vector<GarmentMap> alike;
    for (const GarmentMap& other : maps)
      if (other.unit == map.unit) alike.push_back(other);
    const ColouredMap drawn = coloured(map, map_scale(alike));
    pictures.push_back(
        written(out, map.name + ".png", caption_of(map), map_picture(showing, positions, drawn, title + map.title)));
    write_glb(out.path(map.name + ".glb"), job.scene.body.form, showing.garment, positions, &drawn);
  }
  return pictures;
}

// Whether source and target are the same garment on the same body.
bool as_it_was(const Job& job) { return !job.source_body && !job.target.pattern; }

// One frame for all, so that they can be laid over each other: what is longer afterwards is seen whole.
Eigen::Matrix3Xd frame_of(const Job& job) {
  if (!as_it_was(job)) return job.target.positions;
  const Eigen::Matrix3Xd &source = job.worn.drape.positions, &target = job.target.positions;
  Eigen::Matrix3Xd both(3, source.cols() + target.cols());
  both << source, target;
  return both;
}

const Mannequin& source_form(const Job& job) { return job.source_body ? job.source_body->form : job.scene.body.form; }

Image source_picture(const Job& job) {
  const Eigen::Matrix3Xd& source = job.worn.drape.positions;
  return drape_picture({source_form(job), job.worn.garment, as_it_was(job) ? frame_of(job) : source}, source, "source");
}

}  // namespace

ShownPictures write_run_pictures(const Job& job, const OutputFolder& out) {
  const GarmentMesh& garment = job.target.garment;
  const Eigen::Matrix3Xd& target = job.target.positions;
  const auto to_target = [&](const Eigen::Matrix3Xd& positions) -> Eigen::VectorXd {
    return surface_distance({positions, garment.triangles}, {target, garment.triangles}).a_vertices;
  };
  const Eigen::VectorXd adjusted = to_target(job.verified.drape.positions);
  const Eigen::VectorXd flattened = to_target(job.adjustment.flattened_drape.positions);
  const Showing showing{job.scene.body.form, garment, frame_of(job)};

  ShownPictures pictures;
  const auto write = [&](const std::string& file, const std::string& caption, const Image& image) {
    pictures.views.push_back(written(out, file, caption, image));
  };
  write("source.png", "The pattern as it was read, draped.", source_picture(job));
  write("target.png", "The target: what the edit asks for.", drape_picture(showing, target, "target"));
  write("redrape.png", "The adjusted pattern draped anew, coloured by its distance to the target.",
        distance_picture(showing, {job.verified.drape.positions, adjusted, "re-drape of the adjusted pattern"},
                         scale_top({adjusted})));
  write("compared.png", "Plain flattening and adjusted pattern on one scale.",
        compared_picture(showing, {job.adjustment.flattened_drape.positions, flattened, "plain flattening"},
                         {job.verified.drape.positions, adjusted, "adjusted"}, scale_top({flattened, adjusted})));
  write("panels.png", "Outlines: original green, plain flattening red, adjusted blue.",
        panels_overlay(panel_outlines(garment, job.adjustment.flattened, job.verified.rest), job.recipe.name));
  const GarmentMesh redrawn = with_rest(garment, job.verified.rest);
  pictures.maps = write_maps(job, {job.scene.body.form, redrawn, target}, job.verified.drape.positions,
                             "re-drape of the adjusted pattern: ", out);
  return pictures;
}

ShownPictures write_edit_pictures(const Job& job, const OutputFolder& out) {
  const GarmentMesh& garment = job.target.garment;
  const Eigen::Matrix3Xd& target = job.target.positions;
  const Showing showing{job.scene.body.form, garment, frame_of(job)};
  ShownPictures pictures;
  pictures.views.push_back(written(out, "source.png", "The pattern as it was read, draped.", source_picture(job)));
  pictures.views.push_back(
      written(out, "target.png", "The target: what the edit asks for.", drape_picture(showing, target, "target")));
  return pictures;
}

ShownPictures write_drape_pictures(const Job& job, const OutputFolder& out) {
  const Eigen::Matrix3Xd& positions = job.worn.drape.positions;
  const Showing showing{job.scene.body.form, job.worn.garment, positions};
  ShownPictures pictures;
  pictures.views.push_back(
      written(out, "drape.png", "The pattern as it hangs.", drape_picture(showing, positions, job.recipe.name)));
  pictures.maps = write_maps(job, showing, positions, job.recipe.name + ": ", out);
  return pictures;
}

}  // namespace toile
