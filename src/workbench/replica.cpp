#include "workbench/replica.h"

#include <algorithm>
#include <cstdio>

#include "garment/units.h"

namespace toile {

Pattern scaled(Pattern pattern, double factor) {
  for (Piece& piece : pattern.pieces) {
    for (Edge& edge : piece.outline) {
      for (OutlinePoint& point : edge.points) point.at *= factor;
      if (edge.seam_allowance) *edge.seam_allowance *= factor;
    }
    for (Notch& notch : piece.notches) notch.depth *= factor, notch.width *= factor;
    for (InternalLine& line : piece.internal_lines)
      for (Eigen::Vector2d& point : line.points) point *= factor;
    for (DrillHole& hole : piece.drill_holes) hole.at *= factor, hole.diameter *= factor;
    if (piece.grainline) piece.grainline->from *= factor, piece.grainline->to *= factor;
    for (auto& placement : piece.placement)
      if (placement) placement->translation *= factor;
    for (auto& part : piece.body_part)
      if (part) part->drop *= factor;
  }
  return pattern;
}

Mannequin scaled(Mannequin form, double factor) {
  form.positions *= factor;
  for (Bone& bone : form.bones) bone.from *= factor, bone.to *= factor;
  for (auto& [name, height] : form.landmarks) height *= factor;
  for (auto& [name, measure] : form.measures) measure *= factor;
  form.height *= factor;
  return form;
}

double replica_allowance(double allowance, double factor) {
  constexpr double sewable = 4e-3;
  return std::max(factor * allowance, std::min(allowance, sewable));
}

Target replica(const Target& target, const Pattern& pattern, const Body& body, double height) {
  const double factor = height / body.form.height;
  if (!(factor >= 0.05 && factor <= 2))
    throw BadInput({"replica.bad-height", Severity::error, "replica",
                    "a body of " + in_mm(body.form.height, 0) + " cannot have a replica of " + in_mm(height, 0),
                    "Give a height from a twentieth to twice the body's"});
  Target small = target;
  RestShape rest = rest_shape(target.garment);
  for (Eigen::Matrix2Xd& panel : rest) panel *= factor;
  small.garment = with_rest(target.garment, rest);
  small.source *= factor;
  small.positions *= factor;
  Mannequin form = scaled(body.form, factor);
  char name[32];
  std::snprintf(name, sizeof name, ", 1 : %.2f", 1 / factor);
  form.name += name;
  small.body = std::make_shared<const Body>(make_body(std::move(form)));
  Pattern pieces = scaled(pattern, factor);
  for (std::size_t p = 0; p < pieces.pieces.size(); ++p)
    for (std::size_t e = 0; e < pieces.pieces[p].outline.size(); ++e)
      if (const auto& full = pattern.pieces[p].outline[e].seam_allowance)
        pieces.pieces[p].outline[e].seam_allowance = replica_allowance(*full, factor);
  small.pattern = std::make_shared<const Pattern>(std::move(pieces));
  small.report.note(
      "replica.scale", "replica",
      "everything " + std::string(name + 2) + ", for a body " + in_mm(height, 0) + " tall; the cloth stays as thick as it is");
  return small;
}

}  // namespace toile
