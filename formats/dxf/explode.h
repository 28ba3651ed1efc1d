#pragma once
// Blocks put into a drawing by INSERT, as the entities they stand for.

#include <functional>
#include <string>
#include <vector>

#include "formats/dxf/drawing.h"

namespace toile::dxf {

struct Affine {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return linear * p + shift; }
};

// Where `insert` puts what is drawn in `block`: moved from its base point, scaled, rotated, moved to the place.
Affine placed_by(const Entity& insert, const Block& block);

// `members` with every INSERT replaced by what its block holds, nested ones too; what lies on layer 0 of a block takes the
// layer of the INSERT. An INSERT stays what it is where `keep` says so, where no block has its name and where blocks contain
// themselves or each other more than 16 deep. Error "dxf.too-large" beyond a million entities.
std::vector<Entity> exploded(const std::vector<Entity>& members, const Drawing& drawing, const std::string& name,
                             Report& report, const std::function<bool(const Block&)>& keep = {});

}  // namespace toile::dxf
