#include "measure/maps.h"

#include <utility>

#include "measure/ease.h"
#include "measure/pressure.h"
#include "measure/stretch.h"

namespace toile {

std::vector<GarmentMap> drape_maps(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Body& body,
                                   const Fabric& fabric) {
  GrainStretch stretch = grain_stretch(garment, positions);
  std::vector<GarmentMap> maps;
  const auto add_stretch = [&](const char* name, const char* title, Eigen::VectorXd values) {
    maps.push_back({.name = name,
                    .title = title,
                    .unit = "%",
                    .unit_size = .01,
                    .is_signed = true,
                    .of = MapOf::triangle,
                    .least_top = .01,
                    .values = std::move(values)});
  };
  add_stretch("stretch_warp", "stretch along the warp", std::move(stretch.warp));
  add_stretch("stretch_weft", "stretch along the weft", std::move(stretch.weft));
  add_stretch("stretch_bias", "stretch on the bias", std::move(stretch.bias));
  maps.push_back({.name = "ease",
                  .title = "ease: distance to the body",
                  .unit = "mm",
                  .unit_size = 1e-3,
                  .least_top = 5e-3,
                  .most_top = 60e-3,  // fit is within a few centimetres; how far a flared hem is off is no matter of it
                  .values = air_to_body(positions, body)});
  maps.push_back({.name = "pressure",
                  .title = "pressure on the body",
                  .unit = "kPa",
                  .unit_size = 1e3,
                  .least_top = 100,
                  .values = body_pressure(garment, positions, body, fabric)});
  return maps;
}

}  // namespace toile
