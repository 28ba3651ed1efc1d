#include "pairing/evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "garment/units.h"

namespace toile {
namespace {

const PanelEdge& at(const PanelEdges& all, int edge) { return all.edges[static_cast<std::size_t>(edge)]; }

struct Step {
  double log_ratio, value;
};

double by_length(double a, double b) {
  const double longer = std::max(a, b), shorter = std::min(a, b);
  if (shorter <= 0) return impossible;
  if (longer > most_gather * shorter && longer - shorter > 2e-3) return impossible;
  const double q = longer - shorter < .7e-3 ? 0 : std::log(longer / shorter);
  constexpr std::array<Step, 8> steps{
      {{0, 2.4}, {.004, 2.1}, {.02, 1.3}, {.05, .7}, {.12, .2}, {.3, -.7}, {.6, -1.6}, {.9, -2.2}}};
  for (std::size_t i = 1; i < steps.size(); ++i)
    if (q <= steps[i].log_ratio) {
      const double share = (q - steps[i - 1].log_ratio) / (steps[i].log_ratio - steps[i - 1].log_ratio);
      return (1 - share) * steps[i - 1].value + share * steps[i].value;
    }
  return steps.back().value;
}

// Mean departure of b's headings, walked the other way, from a's: alike as mirror images (side seams) or as mates that lie flat
// against each other (princess lines, caps in armholes).
struct ShapeDifference {
  double mirrored = 0, mated = 0;
};

ShapeDifference shape_difference(const PanelEdge& a, const PanelEdge& b) {
  ShapeDifference out;
  const std::size_t n = a.heading.size();
  for (std::size_t k = 0; k < n; ++k) {
    out.mirrored += std::abs(a.heading[k] + b.heading[n - 1 - k]) / static_cast<double>(n);
    out.mated += std::abs(a.heading[k] - b.heading[n - 1 - k]) / static_cast<double>(n);
  }
  return out;
}

double bend(const PanelEdge& edge) {
  double sum = 0;
  for (const double h : edge.heading) sum += std::abs(h);
  return sum / static_cast<double>(edge.heading.size());
}

// Mean inward bend, radians; negative for edges that bulge outwards.
double hollow(const PanelEdge& edge) {
  double sum = 0;
  const std::size_t n = edge.heading.size();
  for (std::size_t k = 0; k < n; ++k) sum += (k < n / 2 ? 1 : -1) * edge.heading[k];
  return sum / static_cast<double>(n);
}

double by_shape(const PanelEdge& a, const PanelEdge& b) {
  const ShapeDifference d = shape_difference(a, b);
  const double apart = std::min(d.mirrored, d.mated) / .16;
  const double curved = std::min(1.0, std::min(bend(a), bend(b)) / .15);  // curves that agree say more than straight lines
  return std::max(-1.5, .5 + .5 * curved - apart * apart * .6);
}

double by_upright(const PanelEdge& a, const PanelEdge& b) {
  const double facing = a.along.dot(b.along);
  const bool shoulders = a.outward.y() > .5 && b.outward.y() > .5;
  const double sure = std::min(a.sure, b.sure);
  if (shoulders && facing > 0) return .1 * sure;
  return -facing * (facing > 0 ? 1.4 : 1.0) * sure;
}

double by_notches(const PanelEdge& a, const PanelEdge& b) {
  if (a.notches.empty() && b.notches.empty()) return 0;
  if (a.notches.empty() || b.notches.empty()) return -.3;
  double met = 0;
  for (const double notch : a.notches) {
    double nearest = 1e9;
    for (const double other : b.notches)
      nearest = std::min(
          {nearest, std::abs(notch * a.length - (1 - other) * b.length), std::abs((1 - notch) * a.length - other * b.length)});
    if (nearest < 4e-3) ++met;
  }
  const double share = met / static_cast<double>(std::max(a.notches.size(), b.notches.size()));
  return 2.2 * share - .6 * (1 - share);
}

bool looks(const PanelEdges& all, const PanelEdge& edge, const std::string& side) {
  constexpr double steep = .5;
  if (side == "top") return edge.outward.y() > steep;
  if (side == "bottom") return edge.outward.y() < -steep;
  if (side == "side") return std::abs(edge.outward.x()) > steep;
  if (side == "crotch")  // curved inwards, or up to the waist
    return hollow(edge) > .06 || at(all, edge.next).outward.y() > .7 || at(all, edge.previous).outward.y() > .7;
  if (side == "upright") return std::abs(edge.outward.x()) > .96;
  return true;
}

bool kin(Kinship kinship, const std::string& a, const std::string& b) {
  if (kinship == Kinship::any || a.empty() || b.empty() || a == "side" || b == "side") return true;
  return (kinship == Kinship::same) == (a == b);
}

// Numbered panels go round to the wearer's left, beginning in front. Only settles what is otherwise equal.
double by_number(const PanelEdge& a, const PanelEdge& b, const PieceName& na, const PieceName& nb) {
  if (na.number < 0 && nb.number < 0) return 0;
  if (na.role == nb.role) {
    const int step = nb.number - na.number;
    if (std::abs(step) != 1) return 0;
    return .3 + (a.outward.x() * step > b.outward.x() * step ? .1 : 0);
  }
  const double number = std::max(na.number, nb.number);
  const std::string& face = na.face.empty() ? nb.face : na.face;
  return face == "front" ? -.01 * number : face == "back" ? .01 * number : 0;
}

bool on_limb(const PieceRole& role) {
  return std::any_of(role.places.begin(), role.places.end(),
                     [](const RolePlace& place) { return place.at.part == "arm" || place.at.part == "leg"; });
}

double by_names(const PanelEdges& all, int a, int b, const std::vector<PieceName>& names, const GarmentTemplate& garment,
                int& spoken) {
  const PanelEdge& ea = at(all, a);
  const PanelEdge& eb = at(all, b);
  const Panel& pa = all.panels[static_cast<std::size_t>(ea.panel)];
  const Panel& pb = all.panels[static_cast<std::size_t>(eb.panel)];
  const PieceName& na = names[static_cast<std::size_t>(pa.piece)];
  const PieceName& nb = names[static_cast<std::size_t>(pb.piece)];
  if (na.role < 0 || nb.role < 0) return 0;
  const PieceRole& ra = garment.roles[static_cast<std::size_t>(na.role)];
  const PieceRole& rb = garment.roles[static_cast<std::size_t>(nb.role)];
  for (const auto& [edge, role] : {std::pair(&ea, &ra), std::pair(&eb, &rb)})
    for (const std::string& open : role->open)
      if (looks(all, *edge, open) && std::abs(edge->outward.y()) > .9 && ea.panel != eb.panel) return -1.5;
  const bool dart_from_below = (ea.next == b && ea.along.y() > .7) || (eb.next == a && eb.along.y() > .7);
  const bool free_below = std::find(ra.open.begin(), ra.open.end(), "bottom") != ra.open.end();
  if (ea.panel == eb.panel && dart_from_below && free_below) return -5;  // a slit in a hem
  const bool one_panel = ea.panel == eb.panel;
  const bool neighbours = one_panel && (ea.next == b || eb.next == a);
  if (neighbours) return 0;
  if (one_panel && !na.face.empty()) return -4;  // a front is not sewn to itself
  const bool a_pair = !na.face.empty() || on_limb(ra);
  bool roles_meet = false;
  for (const SeamRule& rule : garment.seams) {
    const bool straight = rule.role_a == ra.role && rule.role_b == rb.role;
    const bool crossed = rule.role_a == rb.role && rule.role_b == ra.role;
    if (!straight && !crossed) continue;
    roles_meet = true;
    if (!one_panel && (!kin(rule.face, na.face, nb.face) || !kin(rule.hand, na.hand, nb.hand))) continue;
    // Two copies of one piece are of one face and, as a pair, of two hands.
    if (!one_panel && pa.piece == pb.piece && a_pair && (rule.face == Kinship::other || rule.hand == Kinship::same)) continue;
    if ((straight && looks(all, ea, rule.side_a) && looks(all, eb, rule.side_b)) ||
        (crossed && looks(all, ea, rule.side_b) && looks(all, eb, rule.side_a))) {
      spoken = static_cast<int>(&rule - garment.seams.data());
      return 1.2 + by_number(ea, eb, na, nb);
    }
  }
  if (ea.panel == eb.panel) return roles_meet ? -2 : -.3;
  return roles_meet ? -2.5 : -4;
}

// Neighbours on one panel can only be the two sides of a dart or a corner closed into a point.
double by_layout(const PanelEdges& all, int a, int b) {
  const PanelEdge& ea = at(all, a);
  const PanelEdge& eb = at(all, b);
  if (ea.panel != eb.panel) return 0;
  const bool before = ea.next == b, after = eb.next == a;
  if (!before && !after) return -.6;
  const double apex = before && after ? std::min(ea.angle, eb.angle) : before ? eb.angle : ea.angle;
  // Inside angle of the panel at the point of the dart.
  if (apex > 1.5 * std::numbers::pi) return 2.0;
  return apex > 1.3 * std::numbers::pi ? 0 : -5;
}

std::string percent(double share) {
  const int tenths = static_cast<int>(std::lround(share * 1000));
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " %";
}

}  // namespace

Evidence evidence(const PanelEdges& all, int a, int b, bool twins, const std::vector<PieceName>& names,
                  const GarmentTemplate& garment) {
  const PanelEdge& ea = at(all, a);
  const PanelEdge& eb = at(all, b);
  Evidence out;
  out.lengths = by_length(ea.length, eb.length);
  if (a == b || out.lengths <= impossible) {
    out.lengths = impossible;
    return out;
  }
  out.shape = by_shape(ea, eb);
  out.layout = by_layout(all, a, b);
  out.upright = out.layout > 0 ? 0 : by_upright(ea, eb);
  out.notches = by_notches(ea, eb);
  out.names = by_names(all, a, b, names, garment, out.rule);
  if (twins) {
    const bool crotch = out.rule >= 0 && garment.seams[static_cast<std::size_t>(out.rule)].side_a == "crotch";
    out.lengths = std::min(out.lengths, .4);
    // Two armholes, two halves of a neck: alike because they are mirror images. Only legs meet so, at the crotch.
    out.shape = std::min(hollow(ea), hollow(eb)) > .12 && !crotch ? -1.2 : std::min(out.shape, .2);
  }
  return out;
}

std::vector<std::string> reasons(const PanelEdges& all, int a, int b, const Evidence& found, const GarmentTemplate& garment) {
  const PanelEdge& ea = at(all, a);
  const PanelEdge& eb = at(all, b);
  std::vector<std::string> out;
  const double longer = std::max(ea.length, eb.length), shorter = std::min(ea.length, eb.length);
  if (longer - shorter <= 1e-3)
    out.push_back("lengths agree within " + in_mm(longer - shorter));
  else
    out.push_back(std::string(longer < 1.15 * shorter ? "eased by " : "gathered by ") + in_mm(longer - shorter) + ", " +
                  percent(longer / shorter - 1));
  if (found.layout > 0) out.push_back("the two sides of a dart");
  if (std::min(bend(ea), bend(eb)) > .03 && found.shape > .4) {
    const ShapeDifference d = shape_difference(ea, eb);
    out.push_back(d.mirrored <= d.mated ? "curves are alike" : "curves mate");
  }
  if (found.notches > 0) out.push_back("notches meet");
  if (found.notches < 0) out.push_back("notches do not meet");
  if (found.rule >= 0) out.push_back("names: " + garment.seams[static_cast<std::size_t>(found.rule)].name);
  if (found.shape < -.5) out.push_back("curves differ");
  return out;
}

}  // namespace toile
