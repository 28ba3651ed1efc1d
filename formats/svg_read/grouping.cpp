#include "formats/svg_read/grouping.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "formats/dxf_aama/chains.h"
#include "formats/svg_read/rings.h"
#include "garment/units.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

constexpr double least_piece = 3e-4;  // m^2
constexpr double largest = 20;        // m
constexpr double beside = 15e-3;      // m, how far outside its piece a mark may stand
constexpr std::size_t most_to_join = 2000, most_rings = 4000, most_vertices = 10000;

bool is_outline_role(Role role) { return role == Role::unknown || role == Role::cut || role == Role::sew; }

// The bends of a chain's points as they were in the lines it is made of; unknown where two of them join.
std::vector<Bend> bends_of(const Points<2>& points, const std::vector<const DrawnLine*>& lines) {
  std::map<std::pair<double, double>, Bend> known;
  for (const DrawnLine* line : lines)
    for (std::size_t i = 0; i < line->shape.points.size(); ++i)
      known[{line->shape.points[i].x(), line->shape.points[i].y()}] = line->shape.bends[i];
  std::vector<Bend> bends;
  for (const Vector2d& p : points) {
    const auto found = known.find({p.x(), p.y()});
    bends.push_back(found == known.end() ? Bend::unknown : found->second);
  }
  return bends;
}

class Grouper {
 public:
  Grouper(const Drawing& drawing, const std::vector<Role>& roles, const Producer& producer, const Page& page,
          const std::string& name, Report& report)
      : drawing_(drawing),
        roles_(roles),
        producer_(producer),
        page_(page),
        name_(name),
        report_(report),
        used_(drawing.lines.size(), false) {}

  Grouping group() {
    std::map<int, std::vector<std::size_t>> by_group;
    for (std::size_t i = 0; i < drawing_.lines.size(); ++i)
      by_group[piece_group(drawing_, drawing_.lines[i].group, producer_)].push_back(i);
    for (const auto& [group, lines] : by_group) add_pieces(group, lines);
    std::stable_sort(grouping_.pieces.begin(), grouping_.pieces.end(),
                     [&](const PieceParts& a, const PieceParts& b) { return first_line(a) < first_line(b); });
    for (std::size_t i = 0; i < drawing_.lines.size(); ++i)
      if (!used_[i]) {
        const DrawnLine& line = drawing_.lines[i];
        const bool no_part = roles_[i] == Role::test_square || roles_[i] == Role::page;
        assign(no_part ? -1 : owner(line.shape.points, piece_group(drawing_, line.group, producer_)), &PieceParts::lines,
               grouping_.lines, i);
      }
    for (std::size_t i = 0; i < drawing_.texts.size(); ++i)
      assign(owner({drawing_.texts[i].at}, piece_group(drawing_, drawing_.texts[i].group, producer_)), &PieceParts::texts,
             grouping_.texts, i);
    for (std::size_t i = 0; i < drawing_.marks.size(); ++i)
      assign(owner({drawing_.marks[i].at}, piece_group(drawing_, drawing_.marks[i].group, producer_)), &PieceParts::marks,
             grouping_.marks, i);
    return std::move(grouping_);
  }

 private:
  // As drawn, also where a file is all on one line.
  static std::size_t first_line(const PieceParts& piece) {
    std::size_t first = SIZE_MAX;
    for (const Ring& ring : piece.rings)
      for (const std::size_t line : ring.lines) first = std::min(first, line);
    return first;
  }

  void assign(int owner, std::vector<std::size_t> PieceParts::*member, std::vector<std::size_t>& rest, std::size_t index) {
    (owner < 0 ? rest : grouping_.pieces[static_cast<std::size_t>(owner)].*member).push_back(index);
  }

  // The piece `points` belong to: the only one of their group, else the smallest they lie in, else the nearest beside them.
  int owner(const Points<2>& points, int group) const {
    const Vector2d middle = points.size() > 1 ? point_at<2>(points, .5) : points.front();
    int inside = -1, near = -1, of_group = -1, count = 0;
    double least_area = INFINITY, nearest = beside;
    for (std::size_t i = 0; i < grouping_.pieces.size(); ++i) {
      const PieceParts& piece = grouping_.pieces[i];
      if (group >= 0 && piece.group != group) continue;
      of_group = static_cast<int>(i);
      ++count;
      const Ring& outer = piece.rings.front();
      if (contains(outer.points, middle) && outer.area < least_area) {
        least_area = outer.area;
        inside = static_cast<int>(i);
      } else if (const double distance = aama::distance_to_ring(outer.points, middle); distance < nearest) {
        nearest = distance;
        near = static_cast<int>(i);
      }
    }
    if (group >= 0 && count == 1) return of_group;
    return inside >= 0 ? inside : near;
  }

  void add_ring(std::vector<Ring>& rings, Ring ring) {
    const Box box(ring.points);
    if ((box.high - box.low).maxCoeff() > largest) {
      report_.warn("svg.far-out", name_ + ":" + std::to_string(ring.line),
                   "a closed line of " + in_mm((box.high - box.low).maxCoeff(), 0) + " is left out: nobody cuts that",
                   "correct the seam allowance of this piece in the program it comes from");
      for (const std::size_t i : ring.lines) used_[i] = true;
      return;
    }
    if (ring.points.size() > most_vertices || rings.size() >= most_rings) {
      if (report_.ok())
        report_.error("svg.too-many-points", name_ + ":" + std::to_string(ring.line),
                      rings.size() >= most_rings ? "more than 4000 closed lines" : "a closed line of more than 10000 points",
                      "take decoration out of the drawing, or simplify the line");
      return;
    }
    orient(ring);
    if (ring.area < least_piece && ring.role == Role::unknown) return;
    if (ring.area < 1e-6 || ring.points.size() < 3) return;
    rings.push_back(std::move(ring));
  }

  std::vector<Ring> rings_of(const std::vector<std::size_t>& lines) {
    std::vector<Ring> rings;
    std::map<std::tuple<Role, std::string, bool>, std::vector<std::size_t>> open;
    for (const std::size_t i : lines) {
      const DrawnLine& line = drawing_.lines[i];
      if (!is_outline_role(roles_[i])) continue;
      if (line.shape.closed)
        add_ring(rings, {line.shape.points, line.shape.bends, roles_[i], line.dashed, {i}, line.names.line});
      else
        open[{roles_[i], line.stroke, line.dashed}].push_back(i);
    }
    for (const auto& [key, some] : open)
      if (some.size() <= most_to_join) join(std::get<0>(key), std::get<2>(key), some, rings);
    std::stable_sort(rings.begin(), rings.end(), [](const Ring& a, const Ring& b) { return a.area > b.area; });
    return rings;
  }

  void join(Role role, bool dashed, const std::vector<std::size_t>& some, std::vector<Ring>& rings) {
    std::vector<aama::Run> runs;
    for (const std::size_t i : some) runs.push_back({drawing_.lines[i].shape.points, false, static_cast<int>(i)});
    for (aama::Chain& chain : aama::chains(runs)) {
      if (!chain.closed || chain.points.size() < 3) continue;
      Ring ring{chain.points, {}, role, dashed, {}, 0};
      std::vector<const DrawnLine*> parts;
      const Points<2> loop = aama::closed_polyline(chain.points);
      for (const std::size_t i : some) {
        const Points<2>& points = drawing_.lines[i].shape.points;
        const bool on_it = std::all_of(points.begin(), points.end(),
                                       [&](const Vector2d& p) { return nearest_on<2>(loop, p).distance <= touching; });
        if (!on_it) continue;
        ring.lines.push_back(i);
        parts.push_back(&drawing_.lines[i]);
      }
      ring.line = drawing_.lines[static_cast<std::size_t>(chain.line)].names.line;
      ring.bends = bends_of(ring.points, parts);
      add_ring(rings, std::move(ring));
    }
  }

  // A frame goes round several pieces, or is the page.
  bool is_frame(const Ring& ring, const std::vector<Ring>& rings) const {
    if (ring.role == Role::sew || !is_upright_rectangle(ring)) return false;
    const Box box(ring.points);
    const Vector2d size = box.high - box.low;
    std::vector<const Ring*> inside;
    double area = 0;
    for (const Ring& other : rings)
      if (&other != &ring && other.area < ring.area && is_within(other, ring) &&
          std::none_of(inside.begin(), inside.end(), [&](const Ring* outer) { return is_within(other, *outer); })) {
        inside.push_back(&other);
        area += other.area;
      }
    const bool is_page = page_.size.minCoeff() > 0 && ((size - page_.size).cwiseAbs().array() < .02 * page_.size.array()).all();
    if (is_page) return !inside.empty();
    const auto holds_others = [&](const Ring* piece) {
      return std::any_of(rings.begin(), rings.end(),
                         [&](const Ring& r) { return &r != piece && r.area < piece->area && is_within(r, *piece); });
    };
    const auto texts_in = [&](const Ring* piece) {
      return std::count_if(drawing_.texts.begin(), drawing_.texts.end(), [&](const DrawnText& text) {
        return name_worth(text.words) > 1 && contains(piece->points, text.at);
      });
    };
    const auto like_pieces = std::count_if(inside.begin(), inside.end(), [&](const Ring* r) {
      return r->area > 3 * least_piece && (holds_others(r) || texts_in(r) > 0);
    });
    return like_pieces > 1 || (inside.size() > 1 && area > .35 * ring.area);
  }

  // An open outline both of whose ends lie on a fold line.
  std::optional<Ring> half_on_fold(const std::vector<std::size_t>& lines) const {
    std::vector<aama::Run> runs;
    for (const std::size_t i : lines)
      if (is_outline_role(roles_[i]) && roles_[i] != Role::cut)
        runs.push_back({drawing_.lines[i].shape.points, drawing_.lines[i].shape.closed, static_cast<int>(i)});
    if (runs.size() > most_to_join) return {};
    const std::vector<aama::Chain> chains = aama::chains(runs);
    for (const std::size_t i : lines) {
      if (roles_[i] != Role::fold) continue;
      const Points<2>& fold = drawing_.lines[i].shape.points;
      const Vector2d along = (fold.back() - fold.front()).normalized();
      const auto off = [&](const Vector2d& p) {
        return std::abs(along.x() * (p - fold.front()).y() - along.y() * (p - fold.front()).x());
      };
      for (const aama::Chain& chain : chains) {
        if (chain.points.size() < 3 || off(chain.points.front()) > 2 * touching || off(chain.points.back()) > 2 * touching)
          continue;
        Ring ring{chain.points,
                  {},
                  Role::sew,
                  false,
                  {static_cast<std::size_t>(chain.line)},
                  drawing_.lines[static_cast<std::size_t>(chain.line)].names.line};
        ring.bends = bends_of(ring.points, {&drawing_.lines[static_cast<std::size_t>(chain.line)]});
        orient(ring);
        if (ring.area > least_piece) return ring;
      }
    }
    return {};
  }

  void add_pieces(int group, const std::vector<std::size_t>& lines) {
    std::vector<Ring> rings = rings_of(lines);
    for (std::size_t i = 0; i < rings.size();) {
      if (group < 0 && is_frame(rings[i], rings)) {
        for (const std::size_t line : rings[i].lines) used_[line] = true;
        rings.erase(rings.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
    std::vector<PieceParts> found;
    for (Ring& ring : rings) {
      PieceParts* home = nullptr;
      for (PieceParts& piece : found)
        if (is_within(ring, piece.rings.front()) && (!home || piece.rings.front().area < home->rings.front().area))
          home = &piece;
      for (const std::size_t line : ring.lines) used_[line] = true;
      if (!home) {
        found.emplace_back();
        found.back().group = group;
        home = &found.back();
      }
      home->rings.push_back(std::move(ring));
    }
    if (found.empty())
      if (std::optional<Ring> half = half_on_fold(lines)) {
        for (const std::size_t line : half->lines) used_[line] = true;
        found.push_back({group, {std::move(*half)}, {}, {}, {}});
      }
    if (found.empty() && group >= 0)
      report_.warn(
          "svg.no-outline", name_ + ":" + std::to_string(drawing_.groups[static_cast<std::size_t>(group)].names.line),
          "the group '" + drawing_.groups[static_cast<std::size_t>(group)].names.id + "' has no closed outline and is left out",
          "close its outline if it is a piece");
    for (PieceParts& piece : found) grouping_.pieces.push_back(std::move(piece));
  }

  const Drawing& drawing_;
  const std::vector<Role>& roles_;
  const Producer& producer_;
  const Page& page_;
  const std::string& name_;
  Report& report_;
  std::vector<bool> used_;
  Grouping grouping_;
};

}  // namespace

Grouping grouped(const Drawing& drawing, const std::vector<Role>& roles, const Producer& producer, const Page& page,
                 const std::string& name, Report& report) {
  return Grouper(drawing, roles, producer, page, name, report).group();
}

}  // namespace toile::svg
