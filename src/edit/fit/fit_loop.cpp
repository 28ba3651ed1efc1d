#include "edit/fit/fit_loop.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "edit/edge_chain.h"
#include "edit/fit/room.h"
#include "edit/in_turn.h"
#include "edit/reach.h"
#include "style/soft_terms.h"

namespace toile {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double widest_taper = turn / 12;  // of a range, at either end

// Angle of `way` round `axis`: 0 = front, 90 degrees = the wearer's left.
double angle_round(const Eigen::Vector3d& axis, const Eigen::Vector3d& way) {
  Eigen::Vector3d front = Eigen::Vector3d::UnitZ() - axis.z() * axis;
  if (front.norm() < 1e-3) front = Eigen::Vector3d::UnitY() - axis.y() * axis;
  front.normalize();
  return std::atan2(front.cross(axis).dot(way), front.dot(way));
}

// 1 well inside the range, 0 at its ends and outside.
double share_at(const FitRange& range, double angle) {
  if (range.whole()) return 1;
  const double taper = std::min(widest_taper, (range.to - range.from) / 3);
  const double into = std::fmod(std::fmod(angle - range.from, turn) + turn, turn);
  return smoothstep(into, 0, taper) * (1 - smoothstep(into, range.to - range.from - taper, range.to - range.from));
}

// The trunk for loops round it or round both legs, else the limb that most of the loop belongs to.
int limb_inside(const EditInput& input, const std::vector<LimbAxis>& axes, const std::vector<RelativePlace>& places,
                const VertexLoop& loop) {
  if (round_trunk(threading(skeleton_chains(input.body.form), input.drape, loop)) && axes.front().by_level) return 0;
  std::map<int, int> votes;
  for (const int v : loop) ++votes[places[static_cast<std::size_t>(v)].limb];
  return std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
}

void aim_outwards(const EditInput& input, const std::vector<RelativePlace>& places, const FitRange& range, FitLoop& fit,
                  Eigen::VectorXd& reach) {
  const auto axes = limb_axes(input.body.form);
  const int limb = limb_inside(input, axes, places, fit.loop);
  if (axes[static_cast<std::size_t>(limb)].by_level) fit.axis = -Eigen::Vector3d::UnitY();
  const auto count = static_cast<Eigen::Index>(fit.loop.size());
  fit.outward.resize(3, count);
  fit.share.resize(count);
  reach.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int v = fit.loop[static_cast<std::size_t>(i)];
    RelativePlace place = places[static_cast<std::size_t>(v)];
    if (place.limb != limb) place = relative_place(input.body, axes[static_cast<std::size_t>(limb)], limb, input.drape.col(v));
    const Eigen::Vector3d arm = input.drape.col(v) - place.on_axis;
    const Eigen::Vector3d across = arm - fit.axis.dot(arm) * fit.axis;  // past the end of a limb the ray leans
    reach(i) = across.norm();
    fit.outward.col(i) = reach(i) > 1e-6 ? Eigen::Vector3d(across / reach(i)) : place.outward;
    fit.share(i) = share_at(range, angle_round(fit.axis, fit.outward.col(i)));
  }
}

// On one side of the loop, along `way`.
VertexLoop automatic_ring(const EditInput& input, const LevelMesh& mesh, const ContactRegion& contact, const VertexLoop& loop,
                          const Eigen::Vector3d& way, double level, const std::vector<bool>& connected, double release,
                          bool limb_ends) {
  constexpr double step = 0.01;
  constexpr int most_missing = 5;  // a gap of that many steps is the end of the limb
  const auto chains = skeleton_chains(input.body.form);
  const Threading own = threading(chains, input.drape, loop);
  const Eigen::VectorXd field = (way.transpose() * input.drape).transpose();
  const std::set<int> of_loop(loop.begin(), loop.end());
  VertexLoop last;
  int missing = 0;
  for (double off = 2 * step; missing < most_missing; off += step) {
    ++missing;
    for (VertexLoop& ring : level_loops(mesh, field, level + off, LevelSide::after).closed) {
      const Threading here = threading(chains, input.drape, ring);
      if (!connected[static_cast<std::size_t>(ring[0])] || !same_limb(own, here)) continue;
      missing = 0;
      if (off < release || std::any_of(ring.begin(), ring.end(), [&](int v) { return of_loop.count(v) > 0; })) break;
      if (tight_share(contact, input.drape, ring) >= 0.5) return std::move(ring);
      if (here.chains == own.chains) last = std::move(ring);
      break;
    }
  }
  return limb_ends && !own.nothing() && !round_trunk(own) ? last : VertexLoop{};
}

}  // namespace

bool FitRange::whole() const { return to - from >= turn - 1e-9; }

Eigen::VectorXd FitLoop::offsets(double by) const { return (by * share).cwiseMax(-room); }

Eigen::Matrix3Xd FitLoop::moved(const Eigen::Matrix3Xd& positions, const Eigen::VectorXd& offsets) const {
  return Eigen::Matrix3Xd(positions(Eigen::all, loop)) + outward * offsets.asDiagonal();
}

std::vector<VertexLoop> anchors_named(const EditInput& input, const std::string& names, const VertexLoop& loop) {
  const std::string place = "edit 'fit', anchor";
  std::vector<VertexLoop> found;
  for (const std::string& name : names_apart(input, names)) {
    NamedLoops named = resolve_loops(input, name, place);
    if (named.level && !loop.empty())
      named =
          resolve_loops(input, name, place,
                        named.level->signedDistance(loop_centre(input.drape, loop)) > 0 ? LevelSide::before : LevelSide::after);
    found.insert(found.end(), named.loops.begin(), named.loops.end());
  }
  return found;
}

std::vector<FitLoop> fit_loops(const EditInput& input, const std::string& loop_name, const std::vector<RelativePlace>& places,
                               const ContactRegion& contact, const Eigen::VectorXd& least, const std::string& anchor,
                               double release, const FitRange& range) {
  const LevelMesh mesh = level_mesh(input.garment.triangles);
  const VertexNeighbours neighbours = neighbours_of(mesh, input.drape.cols());
  const NamedLoops named = resolve_loops(input, loop_name, "edit 'fit', loop");
  const std::set<int> seams = layered_seams(mesh);
  std::vector<FitLoop> fits;
  for (const VertexLoop& loop : named.loops) {
    FitLoop fit;
    fit.loop = loop;
    fit.axis = limb_direction(places, loop);
    Eigen::VectorXd reach;
    aim_outwards(input, places, range, fit, reach);
    if (!(fit.share.maxCoeff() > 0))
      throw BadInput({"edit.nothing-in-range", Severity::error, "edit 'fit', from",
                      "no point of '" + loop_name + "' is between these angles", "widen the range"});
    fit.room = room_inwards(input.body, input.drape, loop, fit.axis, fit.outward, reach, least);

    std::vector<bool> connected(neighbours.size(), false);
    const std::vector<int> part = layer_of(neighbours, loop, anchor == "auto" ? seams : std::set<int>{});
    for (const int v : part) connected[static_cast<std::size_t>(v)] = true;
    std::vector<VertexLoop> anchors;
    if (anchor == "auto") {
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector3d way = sign * fit.axis;
        VertexLoop ring = automatic_ring(input, mesh, contact, loop, way, level_of(named, input.drape, loop, way), connected,
                                         release, sign < 0);
        if (!ring.empty()) anchors.push_back(std::move(ring));
      }
      // An overskirt is altered by itself: as far as the seam it hangs from.
      const std::vector<int> seam = edge_of_layer(neighbours, part, seams);
      if (!seam.empty()) anchors.push_back(seam);
    } else if (anchor != "none") {
      anchors = anchors_named(input, anchor, loop);
    }
    std::set<int> blocked;
    for (const VertexLoop& ring : anchors) blocked.insert(ring.begin(), ring.end());
    if (std::any_of(loop.begin(), loop.end(), [&](int v) { return blocked.count(v) > 0; }))
      throw BadInput({"edit.anchor-elsewhere", Severity::error, "edit 'fit', anchor",
                      "the anchor shares points with '" + loop_name + "', which is to move",
                      "name an anchor away from the loop"});
    fit.moving = reached(neighbours, loop, blocked);
    for (const VertexLoop& ring : anchors)
      if (touches(neighbours, ring, fit.moving)) fit.anchor.push_back(ring);
    if (!anchors.empty() && fit.anchor.empty() && anchor != "auto")
      throw BadInput({"edit.anchor-elsewhere", Severity::error, "edit 'fit', anchor",
                      "'" + anchor + "' is not on the part of the garment that the loop would move",
                      "name an anchor on the same part of the garment, or none"});
    fits.push_back(std::move(fit));
  }
  return fits;
}

}  // namespace toile
