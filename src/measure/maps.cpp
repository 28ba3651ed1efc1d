#include "measure/maps.h"

#include "measure/ease.h"
#include "measure/pressure.h"
#include "measure/stretch.h"

namespace toile {

std::vector<GarmentMap> drape_maps(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Body& body,
                                   const Fabric& fabric) {
  GrainStretch stretch = grain_stretch(garment, positions);
  std::vector<GarmentMap> maps;
  maps.push_back({"stretch_warp", "stretch along the warp", "%", .01, true, MapOf::triangle, std::move(stretch.warp)});
  maps.push_back({"stretch_weft", "stretch along the weft", "%", .01, true, MapOf::triangle, std::move(stretch.weft)});
  maps.push_back({"stretch_bias", "stretch on the bias", "%", .01, true, MapOf::triangle, std::move(stretch.bias)});
  maps.push_back({"ease", "ease: distance to the body", "mm", 1e-3, false, MapOf::vertex, air_to_body(positions, body)});
  maps.push_back(
      {"pressure", "pressure on the body", "kPa", 1e3, false, MapOf::vertex, body_pressure(garment, positions, body, fabric)});
  return maps;
}

}  // namespace toile
