#pragma once
// Maps of a drape as pictures with a legend: one colour for how much, two colours for more and less.

#include <vector>

#include "garment/garment_map.h"
#include "picture/pictures.h"

namespace toile {

// One round scale for all of `maps` (of one unit), covering 98 % of their values within their least and most top: 0 .. high,
// or -high .. high when one of them is signed.
MapScale map_scale(const std::vector<GarmentMap>& maps);

// Signed maps (scale.low < 0) diverge from white: blue below 0, red above.
ColouredMap coloured(GarmentMap map, const MapScale& scale);

// Front, side and back of the drape in the colours of `map`, and its legend; `width` at least 480 pixels.
// `positions`: one column per garment vertex, m. Throws std::invalid_argument when the numbers do not agree.
Image map_picture(const Showing& showing, const Eigen::Matrix3Xd& positions, const ColouredMap& map, const std::string& title,
                  int width = 1200);

}  // namespace toile
