#include "edit/mix/joined.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

#include "edit/mix/hanging.h"
#include "edit/mix/limb_curve.h"
#include "edit/mix/ring.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

constexpr double seams_meet = 30e-3;  // m

void add_part(JoinedPattern& joined, Part& part, int side) {
  for (std::size_t p = 0; p < part.pattern.pieces.size(); ++p) {
    Piece piece = part.pattern.pieces[p];
    const std::string own = piece.name;
    const auto taken = [&] {
      return find_piece(joined.pattern, piece.name) || (piece.name != own && find_piece(part.pattern, piece.name));
    };
    for (int i = 2; taken(); ++i) piece.name = own + "_" + std::to_string(i);
    const auto rename = [&](EdgeSpan& span) {
      if (span.piece == own) span.piece = piece.name;
    };
    if (piece.name != own) {
      for (Seam& seam : part.pattern.seams) {
        rename(seam.a);
        rename(seam.b);
      }
      for (auto& ring : part.rings)
        for (EdgeSpan& span : ring) rename(span);
      part.pattern.pieces[p].name = piece.name;
    }
    std::vector<PanelOrigin> origin;
    for (const int panel : part.panels[p]) origin.push_back({side, panel});
    joined.origin.push_back(std::move(origin));
    joined.pattern.pieces.push_back(std::move(piece));
  }
  for (const Seam& seam : part.pattern.seams) joined.pattern.seams.push_back(seam);
}

}  // namespace

JoinedPattern join(const MixSide& first, const MixSide& second, const std::string& place) {
  Part a = first.part, b = second.part;
  JoinedPattern joined;
  joined.pattern = first.input.pattern;
  joined.pattern.pieces.clear();
  joined.pattern.seams.clear();
  add_part(joined, a, 0);
  add_part(joined, b, 1);
  joined.first_joint = static_cast<int>(joined.pattern.seams.size());
  const auto axes = trunk_and_limbs(first.input.body.form);
  for (std::size_t loop = 0; loop < a.rings.size(); ++loop) {
    const int limb = first.part.limbs[loop];
    const Ring of_a = make_ring(first.input, a, loop, limb, place), of_b = make_ring(second.input, b, loop, limb, place);
    int number = 0;
    for (const RingMatch& m : match(of_a, of_b, seams_meet)) {
      joined.across.push_back(a.across[loop] && b.across[loop]);
      joined.pattern.seams.push_back({"mix " + std::to_string(loop + 1) + "." + std::to_string(++number),
                                      span_of(of_a, m.a_begin, m.a_end), span_of(of_b, m.b_begin, m.b_end), false});
    }
  }
  return joined;
}

JoinedGarment hang(const JoinedPattern& joined, const MixSide& first, const MixSide& second, double edge_length) {
  JoinedGarment result;
  result.garment = sew(joined.pattern, triangulate(joined.pattern, {.edge_length = edge_length}));
  const GarmentMesh& garment = result.garment;
  Eigen::VectorXd count[2];
  for (int side = 0; side < 2; ++side) {
    result.hanging[side] = Eigen::Matrix3Xd::Zero(3, garment.vertex_count);
    count[side] = Eigen::VectorXd::Zero(garment.vertex_count);
  }
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const PanelOrigin origin = joined.origin[static_cast<std::size_t>(panel.piece)][static_cast<std::size_t>(panel.copy - 1)];
    const EditInput& input = (origin.side == 0 ? first : second).input;
    const auto of = static_cast<std::size_t>(origin.panel);
    const HangingPanel hanging(input.garment.panels[of], input.garment.welded[of], input.drape);
    result.side.push_back(origin.side);
    for (Eigen::Index v = 0; v < panel.rest.cols(); ++v) {
      const int w = garment.welded[p](v);
      result.hanging[origin.side].col(w) += hanging.at(panel.rest.col(v));
      count[origin.side](w) += 1;
    }
  }
  for (int w = 0; w < garment.vertex_count; ++w) {
    for (int side = 0; side < 2; ++side)
      result.hanging[side].col(w) /= count[side](w) > 0 ? count[side](w) : std::numeric_limits<double>::quiet_NaN();
    if (count[0](w) > 0 && count[1](w) > 0) result.joint.push_back(w);
  }
  return result;
}

}  // namespace toile
