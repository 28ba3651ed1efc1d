#include "cli/graded_files.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formats/dxf_aama/ascii.h"
#include "formats/dxf_aama/profiles.h"
#include "formats/formats.h"
#include "garment/units.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr double reread_limit = 0.05e-3;  // m

std::string one_word(const std::string& size) {
  std::string word = aama::ascii(size);
  std::replace(word.begin(), word.end(), ' ', '_');
  return word;
}

// On a page as wide as the widest piece needs: nobody plots these files.
CutSheet sheet_of(const Pattern& pattern, SheetRules rules) {
  for (const Piece& piece : pattern.pieces) {
    Eigen::AlignedBox2d box;
    double allowance = std::max(rules.allowances.allowance, rules.allowances.hem);
    for (const Edge& edge : piece.outline) {
      allowance = std::max(allowance, edge.seam_allowance.value_or(0));
      for (const OutlinePoint& point : edge.points) box.extend(point.at);
    }
    const double tips = 2 * std::max(1., rules.allowances.mitre_limit) * allowance;
    rules.width = std::max(rules.width, box.diagonal().norm() + tips + 2 * rules.margin);
  }
  CutSheet sheet = lay_out(pattern, rules);
  if (sheet.title.empty()) sheet.title = pattern.name;
  return with_notches_as_drawn(std::move(sheet));
}

[[noreturn]] void refuse(const std::string& file, const std::string& what) {
  throw BadInput({"export.changed", Severity::error, file, "the written file reads back differently: " + what,
                  "Do not cut from these files; please report this as a fault of the program", Fault::checks_failed});
}

struct Ring {
  Points<2> line;  // closed
  Points<2> corners;
};

Ring ring_of(const Piece& piece) {
  Ring ring;
  for (const Edge& edge : piece.outline) {
    ring.corners.push_back(edge.points.front().at);
    for (const OutlinePoint& point : edge.points) ring.line.push_back(point.at);
  }
  return ring;
}

double farthest(const Points<2>& from, const Points<2>& line) {
  double far = 0;
  for (const Eigen::Vector2d& point : from) far = std::max(far, nearest_on<2>(line, point).distance);
  return far;
}

double farthest_of_corners(const Points<2>& from, const Points<2>& to) {
  double far = 0;
  for (const Eigen::Vector2d& point : from) {
    double near = INFINITY;
    for (const Eigen::Vector2d& other : to) near = std::min(near, (other - point).norm());
    far = std::max(far, near);
  }
  return far;
}

void check_piece(const Piece& written, const Piece& read, const std::string& size, const std::string& file) {
  const std::string which = "piece '" + written.name + "' of size " + size;
  const Ring a = ring_of(written), b = ring_of(read);
  const double off = std::max({farthest(a.line, b.line), farthest(b.line, a.line), farthest_of_corners(a.corners, b.corners),
                               farthest_of_corners(b.corners, a.corners)});
  if (!(off <= reread_limit)) refuse(file, which + " is " + in_mm(off, 3) + " off");
  if (written.notches.size() != read.notches.size())
    refuse(file, which + " has " + std::to_string(read.notches.size()) + " notches instead of " +
                     std::to_string(written.notches.size()));
}

// Sizes and pieces by the names the files have, one word of ASCII for a size. Each is laid out by itself: that what is one
// piece has one name in all sizes is settled here.
PatternFile as_in_dxf(PatternFile graded) {
  CutSheet names;
  for (const Piece& piece : graded.pattern.pieces) {
    names.placed.emplace_back();
    names.placed.back().cut.piece = piece;
  }
  for (std::size_t s = 0; s < graded.sizes.size(); ++s) {
    const bool sample = graded.sizes[s] == graded.pattern.sample_size;
    graded.sizes[s] = one_word(graded.sizes[s]);
    graded.graded.at(s) = as_named_in_dxf(std::move(graded.graded.at(s)), names);
    graded.graded[s].sample_size = graded.sizes[s];
    if (sample) graded.sample_size = graded.sizes[s];
  }
  const auto sample = std::find(graded.sizes.begin(), graded.sizes.end(), graded.sample_size);
  if (sample == graded.sizes.end()) throw std::invalid_argument("graded files: the pattern is of none of its sizes");
  graded.pattern = graded.graded[static_cast<std::size_t>(sample - graded.sizes.begin())];
  return graded;
}

}  // namespace

GradedFiles graded_files(const PatternFile& graded, const std::string& name, const SheetRules& rules) {
  const DxfProfile& profile = *find_dxf_profile("aama");
  const PatternFile named = as_in_dxf(graded);
  const RuledPattern ruled = with_rules(named, name, profile);
  const CutSheet base = sheet_of(ruled.pattern, rules);
  CutSheet nest = sheet_of(named.pattern, rules);
  for (std::size_t s = 0; s < named.sizes.size(); ++s) {
    if (named.sizes[s] == named.pattern.sample_size) continue;
    const CutSheet other = sheet_of(named.graded[s], rules);
    nest.placed.insert(nest.placed.end(), other.placed.begin(), other.placed.end());
  }
  return {dxf_bytes(nest, profile), dxf_bytes(base, profile, name), ruled.table};
}

void check_graded(const PatternFile& graded, const PatternFile& read, const std::string& file) {
  const PatternFile written = as_in_dxf(graded);
  if (read.sizes.size() != written.sizes.size() || read.graded.size() != written.sizes.size())
    refuse(file, std::to_string(read.graded.size()) + " sizes instead of " + std::to_string(written.sizes.size()));
  for (std::size_t s = 0; s < written.sizes.size(); ++s) {
    const std::string& size = written.sizes[s];
    const auto found = std::find(read.sizes.begin(), read.sizes.end(), size);
    if (found == read.sizes.end()) refuse(file, "size " + size + " is missing");
    const Pattern& same = read.graded[static_cast<std::size_t>(found - read.sizes.begin())];
    if (same.pieces.size() != written.graded[s].pieces.size())
      refuse(file, std::to_string(same.pieces.size()) + " pieces in size " + size + " instead of " +
                       std::to_string(written.graded[s].pieces.size()));
    for (const Piece& piece : written.graded[s].pieces) {
      const Piece* back = find_piece(same, piece.name);
      if (!back) refuse(file, "piece '" + piece.name + "' is missing");
      check_piece(piece, *back, size, file);
    }
  }
}

}  // namespace toile
