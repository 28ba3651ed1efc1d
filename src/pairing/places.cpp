#include "pairing/places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "garment/units.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

std::size_t u(int i) { return static_cast<std::size_t>(i); }

enum class Hand { unknown, left, right };

Hand other(Hand hand) { return hand == Hand::left ? Hand::right : hand == Hand::right ? Hand::left : Hand::unknown; }

const PieceName& name_of(const Attempt& attempt, int panel) { return attempt.names[u(attempt.all.panels[u(panel)].piece)]; }

// Which side of the wearer an edge of a piece of this face looks to, seen from outside.
Hand looks_to(const std::string& face, double outward_x) {
  if (std::abs(outward_x) < .2 || (face != "front" && face != "back")) return Hand::unknown;
  return (face == "front") == (outward_x > 0) ? Hand::left : Hand::right;
}

std::vector<Hand> hands_of(const Attempt& attempt) {
  const PanelEdges& all = attempt.all;
  const Mates& mates = attempt.found.mates;
  std::vector<Hand> hands(all.panels.size(), Hand::unknown);
  const int count = static_cast<int>(all.panels.size());
  for (int p = 0; p < count; ++p) {
    const std::string& said = name_of(attempt, p).hand;
    if (!said.empty()) hands[u(p)] = said == "left" ? Hand::left : Hand::right;
  }
  // Halves: the seam to the mirror image runs down the middle.
  for (int a = 0; a < static_cast<int>(mates.size()); ++a) {
    const int b = mates[u(a)];
    const int panel = all.edges[u(a)].panel;
    if (b < 0 || attempt.problem.image[u(a)] != b || all.edges[u(b)].panel == panel || hands[u(panel)] != Hand::unknown)
      continue;
    hands[u(panel)] = other(looks_to(name_of(attempt, panel).face, all.edges[u(a)].outward.x()));
  }
  // Sleeves, cuffs and legs are of the side they are sewn to.
  for (int round = 0; round < count; ++round)
    for (int p = 0; p < count; ++p) {
      if (hands[u(p)] != Hand::unknown) continue;
      double left = 0, right = 0;
      bool whole = false;
      for (int a = 0; a < static_cast<int>(mates.size()); ++a) {
        const int b = mates[u(a)];
        if (b < 0 || all.edges[u(a)].panel != p || all.edges[u(b)].panel == p) continue;
        const int q = all.edges[u(b)].panel;
        Hand hand = hands[u(q)];
        if (hand == Hand::unknown && name_of(attempt, q).role != name_of(attempt, p).role)
          hand = looks_to(name_of(attempt, q).face, all.edges[u(b)].outward.x());
        if (hand == Hand::unknown) whole = true;
        (hand == Hand::left ? left : right) += hand == Hand::unknown ? 0 : all.edges[u(a)].length;
      }
      const bool own_image = attempt.problem.image[u(all.panels[u(p)].first)] >= 0 &&
                             all.edges[u(attempt.problem.image[u(all.panels[u(p)].first)])].panel == p;
      if (own_image || (whole && left + right == 0)) continue;
      if (left > 2 * right) hands[u(p)] = Hand::left;
      if (right > 2 * left) hands[u(p)] = Hand::right;
    }
  return hands;
}

// Panels of one role that go round the body without front or back, each sewn to the next on its wearer's left (seen from
// outside: on its right), beginning with the lowest number.
std::vector<int> ring_of(const Attempt& attempt, int role) {
  const PanelEdges& all = attempt.all;
  std::vector<int> ring, members;
  for (int p = 0; p < static_cast<int>(all.panels.size()); ++p)
    if (name_of(attempt, p).role == role && name_of(attempt, p).face.empty()) members.push_back(p);
  std::stable_sort(members.begin(), members.end(),
                   [&](int a, int b) { return name_of(attempt, a).number < name_of(attempt, b).number; });
  int at = members.empty() ? -1 : members.front();
  while (at >= 0 && std::find(ring.begin(), ring.end(), at) == ring.end()) {
    ring.push_back(at);
    int next = -1;
    double longest = 0;
    for (int a = 0; a < static_cast<int>(all.edges.size()); ++a) {
      const int b = attempt.found.mates[u(a)];
      if (all.edges[u(a)].panel != at || b < 0 || all.edges[u(a)].outward.x() < .5 || all.edges[u(a)].length < longest)
        continue;
      if (std::find(members.begin(), members.end(), all.edges[u(b)].panel) == members.end()) continue;
      longest = all.edges[u(a)].length;
      next = all.edges[u(b)].panel;
    }
    at = next;
  }
  return ring.size() == members.size() ? ring : std::vector<int>{};
}

double within_turn(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

// Bands lie round the body; their grain runs along them or across.
bool grain_lies(const Piece& piece, const Panel& cut) {
  const Eigen::Vector2d drawn =
      piece.grainline ? Eigen::Vector2d(piece.grainline->to - piece.grainline->from) : Eigen::Vector2d(0, 1);
  const Eigen::Vector2d worn = cut.turn * drawn;
  return std::abs(worn.x()) > std::abs(worn.y());
}

// Height of the bands that the templates' places are meant for: a higher one begins higher, to end at the same height.
constexpr double usual_band = .04;  // m

std::optional<BodyPart> part_of_body(const Attempt& attempt, const Pattern& pattern, int panel, Hand hand) {
  const PieceName& name = name_of(attempt, panel);
  if (name.role < 0) return std::nullopt;
  const PieceRole& role = attempt.garment->roles[u(name.role)];
  const auto fits = [&](const std::string& face) {
    return std::find_if(role.places.begin(), role.places.end(), [&](const RolePlace& place) { return place.face == face; });
  };
  auto place = fits(name.face);
  if (place == role.places.end()) place = fits("");
  if (place == role.places.end()) return std::nullopt;
  BodyPart at = place->at;
  const Panel& cut = attempt.all.panels[u(panel)];
  if (at.grain_round) {
    at.grain_round = grain_lies(pattern.pieces[u(cut.piece)], cut);
    at.drop -= std::max(0.0, cut.height - usual_band);
  }
  const bool limb = at.part == "arm" || at.part == "leg";
  if (hand == Hand::unknown) return limb ? std::nullopt : std::optional(at);
  at.angle += place->half;
  if (hand == Hand::right) at.angle = -at.angle;
  at.angle = within_turn(at.angle);
  if (limb && place->half == 0) at.part += hand == Hand::left ? ".L" : ".R";
  if (limb && place->half != 0) at.part = "trunk";  // begins above the crotch: beside the other leg's
  return at;
}

std::optional<BodyPart>& place_of(const Attempt& attempt, Pattern& pattern, int panel) {
  const Panel& cut = attempt.all.panels[u(panel)];
  return pattern.pieces[u(cut.piece)].body_part[u(cut.copy - 1)];
}

// The angle round the body at which the middle of an edge lies, when the panels of its role together go round it once.
std::optional<double> angle_of(const Attempt& attempt, Pattern& pattern, int index) {
  const PanelEdge& run = attempt.all.edges[u(index)];
  const Panel& cut = attempt.all.panels[u(run.panel)];
  const auto& at = place_of(attempt, pattern, run.panel);
  if (!at || at->part != "trunk") return std::nullopt;
  double round = 0;
  for (int p = 0; p < static_cast<int>(attempt.all.panels.size()); ++p)
    if (name_of(attempt, p).role == name_of(attempt, run.panel).role) round += attempt.all.panels[u(p)].width;
  const Piece& piece = pattern.pieces[u(cut.piece)];
  double left = INFINITY, right = -INFINITY;
  for (const Edge& edge : piece.outline)
    for (const OutlinePoint& point : edge.points) {
      const double x = (cut.turn * point.at).x();
      left = std::min(left, x), right = std::max(right, x);
    }
  const Eigen::Vector2d middle = point_at<2>(positions(piece.outline[u(run.edge)]), (run.begin + run.end) / 2);
  return at->angle + 2 * std::numbers::pi * ((cut.turn * middle).x() - (left + right) / 2) / round;
}

// Puts a ring's panels side by side, turned as a whole so that they hang below what they are sewn to; without that the first
// begins at the wearer's right side.
void place_ring(const Attempt& attempt, const std::vector<int>& ring, Pattern& pattern) {
  if (ring.size() < 2) return;
  const double step = 2 * std::numbers::pi / static_cast<double>(ring.size());
  const auto angle = [&](std::size_t k) { return -std::numbers::pi / 2 + (static_cast<double>(k) + .5) * step; };
  Eigen::Vector2d turn = Eigen::Vector2d::Zero();
  for (int a = 0; a < static_cast<int>(attempt.found.mates.size()); ++a) {
    const int b = attempt.found.mates[u(a)];
    const auto member = std::find(ring.begin(), ring.end(), attempt.all.edges[u(a)].panel);
    if (b < 0 || member == ring.end() || name_of(attempt, attempt.all.edges[u(b)].panel).role == name_of(attempt, *member).role)
      continue;
    if (const auto meets = angle_of(attempt, pattern, b)) {
      const double by = *meets - angle(static_cast<std::size_t>(member - ring.begin()));
      turn += attempt.all.edges[u(a)].length * Eigen::Vector2d(std::cos(by), std::sin(by));
    }
  }
  const double by = turn.norm() > 1e-6 ? std::atan2(turn.y(), turn.x()) : 0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    if (auto& at = place_of(attempt, pattern, ring[k]); at && at->part == "trunk") at->angle = within_turn(angle(k) + by);
}

}  // namespace

std::vector<std::string> place_on_body(const Attempt& attempt, Pattern& pattern) {
  const std::vector<Hand> hands = hands_of(attempt);
  for (int p = 0; p < static_cast<int>(attempt.all.panels.size()); ++p) {
    const Panel& panel = attempt.all.panels[u(p)];
    Piece& piece = pattern.pieces[u(panel.piece)];
    piece.body_part.resize(u(copies(piece)));
    piece.body_part[u(panel.copy - 1)] = part_of_body(attempt, pattern, p, hands[u(p)]);
  }
  for (int r = 0; r < static_cast<int>(attempt.garment->roles.size()); ++r) place_ring(attempt, ring_of(attempt, r), pattern);
  std::vector<std::string> unplaced;
  for (const Piece& piece : pattern.pieces) {
    const auto known =
        std::count_if(piece.body_part.begin(), piece.body_part.end(), [](const auto& at) { return at.has_value(); });
    const bool in_space = !piece.placement.empty() && std::all_of(piece.placement.begin(), piece.placement.end(),
                                                                  [](const auto& at) { return at.has_value(); });
    if (!in_space && known < copies(piece)) unplaced.push_back(piece.name);
  }
  return unplaced;
}

}  // namespace toile
