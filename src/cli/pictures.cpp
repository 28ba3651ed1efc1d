#include "cli/pictures.h"

#include "formats/formats.h"
#include "geometry/surface_distance.h"
#include "picture/pictures.h"

namespace toile {

std::vector<Picture> write_pictures(const Job& job, const OutputFolder& out) {
  const GarmentMesh& garment = job.worn.garment;
  const Eigen::Matrix3Xd& target = job.target.positions;
  const auto to_target = [&](const Eigen::Matrix3Xd& positions) -> Eigen::VectorXd {
    return surface_distance({positions, garment.triangles}, {target, garment.triangles}).a_vertices;
  };
  const Eigen::VectorXd adjusted = to_target(job.verified.drape.positions);
  const Eigen::VectorXd flattened = to_target(job.adjustment.flattened_drape.positions);
  // One frame for all, so that they can be laid over each other.
  const Showing showing{job.scene.body.form, garment, job.worn.drape.positions};

  std::vector<Picture> pictures;
  const auto write = [&](const std::string& file, const std::string& caption, const Image& image) {
    pictures.push_back({file, caption, png_bytes(image)});
    write_whole_file(out.path(file), pictures.back().png);
  };
  write("source.png", "The pattern as it was read, draped.", drape_picture(showing, job.worn.drape.positions, "source"));
  write("target.png", "The target: what the edit asks for.", drape_picture(showing, target, "target"));
  write("redrape.png", "The adjusted pattern draped anew, coloured by its distance to the target.",
        distance_picture(showing, {job.verified.drape.positions, adjusted, "re-drape of the adjusted pattern"},
                         scale_top({adjusted})));
  write("compared.png", "Plain flattening and adjusted pattern on one scale.",
        compared_picture(showing, {job.adjustment.flattened_drape.positions, flattened, "plain flattening"},
                         {job.verified.drape.positions, adjusted, "adjusted"}, scale_top({flattened, adjusted})));
  write("panels.png", "Outlines: original green, plain flattening red, adjusted blue.",
        panels_overlay(panel_outlines(garment, job.adjustment.flattened, job.verified.rest), job.recipe.name));
  return pictures;
}

}  // namespace toile
