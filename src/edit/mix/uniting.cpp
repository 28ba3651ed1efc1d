#include "edit/mix/uniting.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include "draft/alike.h"
#include "draft/redraw.h"
#include "edit/mix/recut.h"
#include "edit/mix/run_on.h"
#include "edit/mix/stretch_fates.h"
#include "edit/mix/unite.h"
#include "garment/report.h"
#include "geometry/embed.h"
#include "geometry/self_crossing.h"
#include "triangulate/mating.h"

namespace toile {
namespace {

std::string panel_name(const Pattern& pattern, const EdgeSpan& span) {
  return copies(*find_piece(pattern, span.piece)) == 1 ? span.piece : span.piece + ":" + std::to_string(span.copy);
}

std::vector<JudgedStretch> stretches(const JoinedPattern& joined, const Pattern& pattern, const GarmentMesh& garment,
                                     const Eigen::Matrix3Xd& positions, double reach, bool never) {
  const Likeness likeness = find_likeness(pattern, 1e-4);
  std::vector<JudgedStretch> found;
  for (int s = joined.first_joint; s < static_cast<int>(pattern.seams.size()); ++s) {
    const Seam& seam = pattern.seams[static_cast<std::size_t>(s)];
    JudgedStretch stretch;
    stretch.joint = joint_stretch(pattern, garment, positions, s, reach);
    stretch.names[0] = panel_name(pattern, seam.a);
    stretch.names[1] = panel_name(pattern, seam.b);
    const auto join = whole_edges(pattern, s);
    if (join) {
      const auto shape = [&](int piece) { return likeness.lays[static_cast<std::size_t>(piece)].shape; };
      stretch.kind = std::minmax(shape(join->base), shape(join->other));
    }
    stretch.fate = !joined.across[static_cast<std::size_t>(s - joined.first_joint)] ? JointFate::keeps_edge
                   : !join                                                          ? JointFate::not_opposite
                   : never                                                          ? JointFate::never
                   : stretch.joint.turns_apart > flat_enough                        ? JointFate::curved
                                                                                    : JointFate::united;
    found.push_back(std::move(stretch));
  }
  return found;
}

// What keeps one of them from being united keeps all that are alike from it.
void share_fates(std::vector<JudgedStretch>& stretches) {
  std::map<std::pair<int, int>, JointFate> worst;
  for (const JudgedStretch& s : stretches)
    if (s.kind.first >= 0 && s.fate != JointFate::united) worst[s.kind] = s.fate;
  for (JudgedStretch& s : stretches)
    if (const auto found = worst.find(s.kind); s.fate == JointFate::united && found != worst.end()) s.fate = found->second;
}

struct Whole {
  Pattern pattern;
  GarmentMesh garment;
  std::vector<Eigen::Matrix2d> shapes;
  std::vector<int> vertex, seam;      // of those before
  std::vector<std::set<int>> joints;  // [piece]: stretches inside it, by index
};

std::vector<int> after(const std::vector<int>& first, const std::vector<int>& then) {
  std::vector<int> result;
  for (const int i : then) result.push_back(first[static_cast<std::size_t>(i)]);
  return result;
}

std::vector<int> counted(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

// One piece after the other; all copies of a pair of pieces at once.
Whole all_united(const Pattern& pattern, const GarmentMesh& garment, std::vector<JudgedStretch>& stretches) {
  Whole whole{pattern,
              garment,
              rest_triangles(garment),
              counted(static_cast<std::size_t>(garment.vertex_count)),
              counted(pattern.seams.size()),
              {}};
  std::map<std::string, std::set<int>> joints;  // by name of the piece
  std::set<int> pending;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (stretches[i].fate == JointFate::united) pending.insert(static_cast<int>(i));
  while (!pending.empty()) {
    const auto now = [&](int stretch) {
      const auto found =
          std::find(whole.seam.begin(), whole.seam.end(), stretches[static_cast<std::size_t>(stretch)].joint.seam);
      return whole_edges(whole.pattern, static_cast<int>(found - whole.seam.begin()));
    };
    auto join = now(*pending.begin());
    if (!join) {
      stretches[static_cast<std::size_t>(*pending.begin())].fate = JointFate::same_piece;
      pending.erase(pending.begin());
      continue;
    }
    std::set<int> together;
    std::vector<std::pair<int, int>> copies;
    for (const int i : pending)
      if (const auto other = now(i); other && other->base == join->base && other->other == join->other &&
                                     other->base_edge == join->base_edge && other->other_edge == join->other_edge &&
                                     other->reflected == join->reflected) {
        together.insert(i);
        copies.push_back(other->copies.front());
      }
    std::sort(copies.begin(), copies.end());
    join->copies = std::move(copies);
    for (const int piece : {join->base, join->other})
      together.merge(std::set<int>(joints[whole.pattern.pieces[static_cast<std::size_t>(piece)].name]));
    United united = unite(whole.pattern, whole.garment, whole.shapes, *join);
    for (const int i : together)
      if (pending.erase(i)) stretches[static_cast<std::size_t>(i)].grain_turn = united.grain_turn;
    joints[united.pattern.pieces[static_cast<std::size_t>(united.piece)].name] = std::move(together);
    whole.vertex = after(whole.vertex, united.vertex);
    whole.seam = after(whole.seam, united.seam);
    whole.pattern = std::move(united.pattern);
    whole.garment = std::move(united.garment);
    whole.shapes = std::move(united.shapes);
  }
  for (const Piece& piece : whole.pattern.pieces) whole.joints.push_back(joints[piece.name]);
  return whole;
}

// Edges that are sewn together, with the ratios of lengths they had before their ends were drawn together.
std::vector<MatingEdges> mating_as_before(const Whole& whole) {
  std::map<std::array<int, 3>, double> length;  // panel, vertices
  const std::vector<int> offsets = triangle_offsets(whole.garment);
  const auto key = [](int panel, int a, int b) { return std::array{panel, std::min(a, b), std::max(a, b)}; };
  for (std::size_t p = 0; p < whole.garment.panels.size(); ++p)
    for (int t = offsets[p]; t < offsets[p + 1]; ++t) {
      const Eigen::Vector3i corner = whole.garment.panels[p].triangles.col(t - offsets[p]);
      const Eigen::Matrix2d& shape = whole.shapes[static_cast<std::size_t>(t)];
      const auto panel = static_cast<int>(p);
      length[key(panel, corner(0), corner(1))] = shape.col(0).norm();
      length[key(panel, corner(0), corner(2))] = shape.col(1).norm();
      length[key(panel, corner(1), corner(2))] = (shape.col(1) - shape.col(0)).norm();
    }
  std::vector<MatingEdges> mating = mating_edges(whole.pattern, whole.garment);
  for (MatingEdges& m : mating)
    m.ratio = length.at(key(m.panel_a, m.a_from, m.a_to)) / length.at(key(m.panel_b, m.b_from, m.b_to));
  return mating;
}

// Where the joints that are gone came to the outlines.
std::vector<PieceCorner> corners_of(const Whole& whole, const std::vector<JudgedStretch>& stretches) {
  std::vector<PieceCorner> corners;
  for (std::size_t p = 0; p < whole.garment.panels.size(); ++p) {
    const PanelMesh& panel = whole.garment.panels[p];
    if (panel.copy != 1) continue;
    for (const BoundaryVertex& v : panel.boundary)
      for (const int i : whole.joints[static_cast<std::size_t>(panel.piece)])
        if (v.at == 0 && stretches[static_cast<std::size_t>(i)].vertices.count(
                             whole.vertex[static_cast<std::size_t>(whole.garment.welded[p](v.vertex))])) {
          corners.push_back({panel.piece, v.edge});
          break;
        }
  }
  return corners;
}

constexpr int rounds = 3;  // of laying flat; each leaves about a tenth of what seams are off

// Mean distortion of the flat cloth as near to every stretch as its curvature is felt.
void measure_distortion(const Whole& whole, const RestShape& flat, const std::vector<double>& distortion,
                        std::vector<JudgedStretch>& stretches) {
  for (JudgedStretch& s : stretches)
    if (s.fate == JointFate::united) s.distortion = 0;
  const std::vector<int> offsets = triangle_offsets(whole.garment);
  for (std::size_t p = 0; p < whole.garment.panels.size(); ++p) {
    const PanelMesh& panel = whole.garment.panels[p];
    for (const int i : whole.joints[static_cast<std::size_t>(panel.piece)]) {
      JudgedStretch& stretch = stretches[static_cast<std::size_t>(i)];
      std::vector<Eigen::Vector2d> line;
      for (Eigen::Index v = 0; v < panel.rest.cols(); ++v)
        if (stretch.vertices.count(whole.vertex[static_cast<std::size_t>(whole.garment.welded[p](v))]))
          line.push_back(flat[p].col(v));
      double sum = 0, area = 0;
      for (Eigen::Index t = 0; t < panel.triangles.cols() && !line.empty(); ++t) {
        const Eigen::Vector2d centre =
            (flat[p].col(panel.triangles(0, t)) + flat[p].col(panel.triangles(1, t)) + flat[p].col(panel.triangles(2, t))) / 3;
        const double far = (*std::min_element(line.begin(), line.end(),
                                              [&](const auto& a, const auto& b) {
                                                return (a - centre).squaredNorm() < (b - centre).squaredNorm();
                                              }) -
                            centre)
                               .norm();
        if (far > stretch.joint.length / std::numbers::pi) continue;
        const auto at = static_cast<std::size_t>(offsets[p] + t);
        const double size = std::abs(whole.shapes[at].determinant());
        sum += size * distortion[at];
        area += size;
      }
      if (area > 0) stretch.distortion = std::max(stretch.distortion, sum / area);
    }
  }
}

// Stretches inside pieces whose outlines cross themselves.
std::set<int> overlapping(const Whole& whole, const Pattern& drawn) {
  std::set<int> found;
  for (std::size_t p = 0; p < drawn.pieces.size(); ++p) {
    if (whole.joints[p].empty()) continue;
    std::vector<Eigen::Vector2d> loop;
    for (const Edge& edge : drawn.pieces[p].outline)
      for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) loop.push_back(edge.points[i].at);
    if (first_self_crossing(loop)) found.insert(whole.joints[p].begin(), whole.joints[p].end());
  }
  return found;
}

bool any_united(const std::vector<JudgedStretch>& stretches) {
  return std::any_of(stretches.begin(), stretches.end(), [](const JudgedStretch& s) { return s.fate == JointFate::united; });
}

// What is to be united, united and laid flat; absent when some of it cannot be, and then has another fate.
std::optional<Uniting> laid_flat(const Pattern& pattern, const GarmentMesh& garment, std::vector<JudgedStretch>& all) {
  Whole whole = all_united(pattern, garment, all);
  if (!any_united(all)) return std::nullopt;
  run_on(whole.pattern, whole.garment, corners_of(whole, all));
  whole.garment = with_rest(whole.garment, rest_on_outlines(whole.pattern, whole.garment, rest_shape(whole.garment)));
  std::vector<FlatMesh> panels;
  for (const PanelMesh& panel : whole.garment.panels) panels.push_back({panel.rest.cols(), panel.triangles});
  const Embedder embedder(std::move(panels), mating_as_before(whole), whole.shapes);
  Embedding flat = embedder.embed(whole.shapes, rest_shape(whole.garment));
  measure_distortion(whole, flat.panels, flat.distortion, all);
  bool can_be = true;
  for (JudgedStretch& s : all)
    if (s.fate == JointFate::united && s.distortion > developable_limit) {
      s.fate = JointFate::not_flat;
      can_be = false;
    }
  if (!can_be) return std::nullopt;
  for (int round = 1; round < rounds; ++round)
    flat = embedder.embed(rest_triangles(with_rest(whole.garment, flat.panels)), flat.panels);
  Recut drawn = drawn_through(whole.pattern, whole.garment, flat.panels);
  const std::set<int> crossed = overlapping(whole, drawn.pattern);
  for (const int i : crossed) all[static_cast<std::size_t>(i)].fate = JointFate::overlaps;
  if (!crossed.empty()) return std::nullopt;
  return Uniting{std::move(drawn.pattern), std::move(drawn.garment), std::move(whole.vertex), {}};
}

}  // namespace

Uniting unite_where_flat(const JoinedPattern& joined, const Pattern& pattern, const GarmentMesh& garment,
                         const Eigen::Matrix3Xd& positions, double reach, bool never, const std::string& place) {
  std::vector<JudgedStretch> all = stretches(joined, pattern, garment, positions, reach, never);
  for (JudgedStretch& s : all) s.vertices = vertices_of_seam(pattern, garment, s.joint.seam);
  std::optional<Uniting> united;
  for (share_fates(all); !united && any_united(all); share_fates(all)) {
    try {
      united = laid_flat(pattern, garment, all);
    } catch (const BadInput&) {  // the pieces fold over in their outlines
      for (JudgedStretch& s : all)
        if (s.fate == JointFate::united) s.fate = JointFate::overlaps;
    }
  }
  if (!united) united = {pattern, garment, counted(static_cast<std::size_t>(garment.vertex_count)), {}};
  describe_stretches(all, place, united->report);
  return std::move(*united);
}

}  // namespace toile
