#include "formats/dxf/explode.h"

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>

namespace toile::dxf {
namespace {

constexpr int deepest = 16;
constexpr std::size_t most_entities = 1'000'000;

// What `placed` makes of an entity that is no INSERT.
Entity moved(Entity entity, const Affine& placed) {
  const double area = placed.linear.determinant(), scale = std::sqrt(std::abs(area));
  const Eigen::Matrix2d gram = placed.linear.transpose() * placed.linear;
  const bool alike = std::abs(gram(0, 0) - gram(1, 1)) + std::abs(gram(0, 1)) <= 1e-9 * gram.trace();
  if (!alike && !entity.bulges.empty()) {  // arcs would become ellipses
    Eigen::Vector2d low = entity.points.front(), high = low;
    for (const Eigen::Vector2d& p : entity.points) low = low.cwiseMin(p), high = high.cwiseMax(p);
    entity.points = flattened(entity, 1e-4 * (high - low).norm());
    entity.bulges.clear();
  }
  for (Eigen::Vector2d& p : entity.points) p = placed(p);
  if (area < 0)
    for (double& bulge : entity.bulges) bulge = -bulge;
  for (std::optional<double>* length : {&entity.z, &entity.thickness})
    if (*length) **length *= scale;
  if (entity.angle && entity.kind == Kind::point) {
    const double angle = *entity.angle * std::numbers::pi / 180;
    const Eigen::Vector2d direction = placed.linear * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    entity.angle = std::atan2(direction.y(), direction.x()) * 180 / std::numbers::pi;
  }
  return entity;
}

class Exploder {
 public:
  Exploder(const Drawing& drawing, const std::string& name, Report& report, const std::function<bool(const Block&)>& keep)
      : name_(name), report_(report), keep_(keep) {
    for (const Block& block : drawing.blocks) blocks_.emplace(block.name, &block);
  }

  void add(const std::vector<Entity>& members, const Affine& placed, const std::string& layer, int depth) {
    for (const Entity& member : members) {
      if (++seen_ > most_entities) {
        if (seen_ == most_entities + 1)
          report_.error("dxf.too-large", name_, "with its blocks put in, the drawing has more than a million entities",
                        "export the pieces alone");
        return;
      }
      const std::string& own = depth > 0 && member.layer == "0" ? layer : member.layer;
      if (member.kind == Kind::insert) {
        const auto block = blocks_.find(member.text);
        const bool stays = depth >= deepest || block == blocks_.end() || (keep_ && keep_(*block->second));
        if (!stays) {
          const Affine inner = placed_by(member, *block->second);
          add(block->second->entities, {placed.linear * inner.linear, placed(inner.shift)}, own, depth + 1);
          continue;
        }
      }
      entities.push_back(depth > 0 && member.kind != Kind::insert ? moved(member, placed) : member);
      entities.back().layer = own;
    }
  }

  std::vector<Entity> entities;

 private:
  std::map<std::string, const Block*> blocks_;  // the first of a name
  const std::string& name_;
  Report& report_;
  const std::function<bool(const Block&)>& keep_;
  std::size_t seen_ = 0;
};

}  // namespace

Affine placed_by(const Entity& insert, const Block& block) {
  const double angle = insert.angle.value_or(0) * std::numbers::pi / 180;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Eigen::Vector2d scale(insert.scale.x() != 0 ? insert.scale.x() : 1.0, insert.scale.y() != 0 ? insert.scale.y() : 1.0);
  Affine placed;
  placed.linear = turn * scale.asDiagonal();
  placed.shift = insert.points.front() - placed.linear * block.base;
  return placed;
}

std::vector<Entity> exploded(const std::vector<Entity>& members, const Drawing& drawing, const std::string& name,
                             Report& report, const std::function<bool(const Block&)>& keep) {
  Exploder exploder(drawing, name, report, keep);
  exploder.add(members, {}, {}, 0);
  return std::move(exploder.entities);
}

}  // namespace toile::dxf
