#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "cut/cut.h"
#include "cut/piece_marks.h"
#include "cut/polygon.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double column = 1e-3;  // m, width of the strips in which free room is counted

// A piece turned as it will lie, its lower left corner at 0, 0, with its lowest and highest point in every column it touches.
struct Lying {
  double turn = 0;
  Vector2d low;  // lower left corner of the turned piece
  double width = 0, height = 0;
  std::vector<double> lowest, highest;
};

Vector2d turned(const Vector2d& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

Lying lie(const CutPiece& piece, double turn) {
  Polygon points;
  for (const OutlinePoint& point : piece.cut_line) points.push_back(turned(point.at, turn));
  Lying lying;
  lying.turn = turn;
  Vector2d high = points.front();
  lying.low = points.front();
  for (const Vector2d& p : points) {
    lying.low = lying.low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  lying.width = high.x() - lying.low.x();
  lying.height = high.y() - lying.low.y();
  const auto columns = static_cast<std::size_t>(std::ceil(lying.width / column)) + 1;
  lying.lowest.assign(columns, std::numeric_limits<double>::infinity());
  lying.highest.assign(columns, -std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector2d a = points[i] - lying.low;
    const Vector2d b = points[(i + 1) % points.size()] - lying.low;
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(std::min(a.x(), b.x()) / column)));
    const auto last = std::min(columns - 1, static_cast<std::size_t>(std::floor(std::max(a.x(), b.x()) / column)));
    for (std::size_t k = first; k <= last; ++k) {
      const auto height_at = [&](double x) {
        const double t = b.x() == a.x() ? 0 : std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0);
        return a.y() + t * (b.y() - a.y());
      };
      const double left = static_cast<double>(k) * column;
      const bool upright = std::abs(b.x() - a.x()) < 1e-12;
      const double one = upright ? a.y() : height_at(left);
      const double other = upright ? b.y() : height_at(left + column);
      lying.lowest[k] = std::min({lying.lowest[k], one, other});
      lying.highest[k] = std::max({lying.highest[k], one, other});
    }
  }
  return lying;
}

double turn_to_page(const Piece& piece) {
  const Vector2d grain = piece.grainline->to - piece.grainline->from;
  return std::remainder(std::numbers::pi / 2 - std::atan2(grain.y(), grain.x()), 2 * std::numbers::pi);
}

Grainline upright_grain(const Polygon& line) {
  Vector2d low = line.front(), high = line.front();
  for (const Vector2d& p : line) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double x = (low.x() + high.x()) / 2;
  const double fifth = (high.y() - low.y()) / 5;
  return {.from = {x, low.y() + fifth}, .to = {x, high.y() - fifth}};
}

// The page's columns filled so far, each up to the height given.
class Skyline {
 public:
  Skyline(double width, double gap)
      : filled_(static_cast<std::size_t>(std::floor(width / column + 1e-6)), 0.0),
        gap_(gap),
        reach_(static_cast<std::size_t>(std::ceil(gap / column))) {}

  // The lowest place with the piece's left side at column `at`; empty when it sticks out of the page.
  std::optional<double> rest_on(const Lying& piece, std::size_t at) const {
    if (static_cast<double>(at) * column + piece.width > static_cast<double>(filled_.size()) * column + 1e-9)
      return std::nullopt;
    double y = 0;
    for (std::size_t k = 0; k < piece.lowest.size() && at + k < filled_.size(); ++k) {
      const std::size_t from = at + k > reach_ ? at + k - reach_ : 0;
      const std::size_t to = std::min(filled_.size(), at + k + reach_ + 1);
      for (std::size_t c = from; c < to; ++c)
        if (filled_[c] > 0) y = std::max(y, filled_[c] + gap_ - piece.lowest[k]);
    }
    return y;
  }

  void put(const Lying& piece, std::size_t at, double y) {
    for (std::size_t k = 0; k < piece.highest.size() && at + k < filled_.size(); ++k)
      filled_[at + k] = std::max(filled_[at + k], y + piece.highest[k]);
  }

  std::size_t columns() const { return filled_.size(); }

 private:
  std::vector<double> filled_;
  double gap_;
  std::size_t reach_;
};

struct Spot {
  const Lying* lying = nullptr;
  std::size_t at = 0;
  double y = 0;
};

std::optional<Spot> lowest_spot(const Skyline& skyline, const std::vector<Lying>& ways) {
  std::optional<Spot> best;
  const std::size_t stride = 5;
  for (const Lying& lying : ways)
    for (std::size_t at = 0; at < skyline.columns(); at += stride) {
      const auto y = skyline.rest_on(lying, at);
      if (!y) break;
      if (!best || *y + lying.height < best->y + best->lying->height - 1e-9) best = Spot{&lying, at, *y};
    }
  return best;
}

// `words` with the size, unless they end in it already.
std::string with_size(const std::string& words, const std::string& size) {
  const std::string ending = "size " + size;
  const bool said = words.size() >= ending.size() && words.compare(words.size() - ending.size(), ending.size(), ending) == 0;
  return size.empty() || said ? words : words + (words.empty() ? "" : ", ") + ending;
}

CutPiece cut_piece(const Pattern& pattern, Piece piece, const AllowanceRules& rules) {
  const bool grain_given = piece.grainline.has_value();
  AllowanceRules own = rules;
  const auto is_sewn = [&](const std::string& edge) {
    return std::any_of(pattern.seams.begin(), pattern.seams.end(), [&](const Seam& seam) {
      return (seam.a.piece == piece.name && seam.a.edge == edge) || (seam.b.piece == piece.name && seam.b.edge == edge);
    });
  };
  for (Edge& edge : piece.outline) edge.hem = edge.hem && !is_sewn(edge.id);
  own.hem_edges.erase(std::remove_if(own.hem_edges.begin(), own.hem_edges.end(), is_sewn), own.hem_edges.end());
  if (!grain_given) {
    Polygon net;
    for (const Edge& edge : piece.outline)
      for (const OutlinePoint& point : edge.points) net.push_back(point.at);
    if (!net.empty()) piece.grainline = upright_grain(net);
  }
  CutPiece cut = add_allowance(piece, own);
  cut.size = pattern.sample_size;
  std::vector<std::string> heading;
  if (!pattern.style.empty() || !pattern.name.empty()) heading.push_back(pattern.style.empty() ? pattern.name : pattern.style);
  cut.labels.front() = with_size(cut.labels.front(), cut.size);
  cut.labels.insert(cut.labels.begin(), heading.begin(), heading.end());
  if (piece.material.empty() && !pattern.fabric.empty()) cut.labels.push_back("Fabric: " + pattern.fabric);
  cut.labels.push_back(grain_given ? "Grain along the arrow" : "Grain along the arrow (none was given: taken upright)");
  return cut;
}

}  // namespace

CutSheet lay_out(const Pattern& pattern, const SheetRules& rules) {
  if (!(rules.width > 2 * rules.margin) || !(rules.gap >= 0) || !(rules.margin >= 0))
    throw std::invalid_argument("lay_out: page rules");
  CutSheet sheet;
  sheet.title = with_size(pattern.style.empty() ? pattern.name : pattern.style, pattern.sample_size);
  sheet.page_width = rules.width;
  sheet.seams = pattern.seams;
  std::vector<CutPiece> cuts;
  for (const Piece& piece : pattern.pieces) cuts.push_back(cut_piece(pattern, piece, rules.allowances));
  std::vector<std::vector<Lying>> ways;
  for (const CutPiece& cut : cuts) {
    const double turn = turn_to_page(cut.piece);
    ways.push_back({lie(cut, turn)});
    if (!rules.one_way) ways.back().push_back(lie(cut, turn + std::numbers::pi));
  }
  std::vector<std::size_t> order(cuts.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ways[a].front().height > ways[b].front().height + 1e-9; });

  Skyline skyline(rules.width - 2 * rules.margin, rules.gap);
  double top = 0;
  for (const std::size_t i : order) {
    const auto spot = lowest_spot(skyline, ways[i]);
    if (!spot)
      throw BadInput({.code = "cut.page-too-narrow",
                      .place = "piece '" + cuts[i].piece.name + "'",
                      .text = "with its allowance it is " + in_both_units(ways[i].front().width) +
                              " wide across the grain, the page " + in_both_units(rules.width),
                      .remedy = "use a wider page or cloth"});
    skyline.put(*spot->lying, spot->at, spot->y);
    top = std::max(top, spot->y + spot->lying->height);
    const Vector2d corner(rules.margin + static_cast<double>(spot->at) * column, rules.margin + spot->y);
    sheet.placed.push_back({.cut = std::move(cuts[i]), .shift = corner - spot->lying->low, .turn = spot->lying->turn});
  }
  sheet.page_length = top + 2 * rules.margin;
  return sheet;
}

}  // namespace toile
