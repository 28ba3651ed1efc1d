#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formats/dxf/tag_writer.h"
#include "formats/dxf_aama/ascii.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/layers.h"
#include "formats/dxf_aama/piece_names.h"
#include "formats/dxf_aama/profiles.h"
#include "formats/formats.h"
#include "garment/units.h"

namespace toile {
namespace {

using aama::number_of;
using aama::Role;
using Vertices = std::vector<Eigen::Vector2d>;

constexpr double text_height = 5;    // mm
constexpr double one_point = 0.03;   // mm; readers match points within 0.02 mm
constexpr double text_spacing = 10;  // mm

Eigen::Vector2d mm(const Eigen::Vector2d& metres) { return metres * mm_per_m; }

// One vertex of a line to be written, and the layer of the point that marks it.
struct Marked {
  Eigen::Vector2d at;
  bool turn = false;
  std::optional<int> grade_rule;
};

std::vector<Marked> cut_line(const CutPiece& cut) {
  std::vector<Marked> points;
  for (const OutlinePoint& point : cut.cut_line) points.push_back({mm(point.at), point.turn, point.grade_rule});
  return points;
}

// The ring begins with the first point of the first edge; what begins an edge is a turn point, nothing else is.
std::vector<Marked> sew_line(const CutPiece& cut) {
  std::vector<Marked> points;
  for (const Edge& edge : cut.piece.outline)
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i)
      points.push_back({mm(edge.points[i].at), i == 0, edge.points[i].grade_rule});
  return points;
}

class PieceWriter {
 public:
  PieceWriter(std::string& out, const CutPiece& cut, const DxfProfile& profile) : out_(out), cut_(cut), profile_(profile) {}

  void write(const std::string& name, const std::string& block) {
    const Piece& piece = cut_.piece;
    dxf::put(out_, 0, "BLOCK");
    dxf::put(out_, 8, "0");
    dxf::put(out_, 2, block);
    dxf::put(out_, 70, 64);
    dxf::put_xy(out_, 10, Eigen::Vector2d::Zero());

    const std::vector<Marked> sew = sew_line(cut_);
    const std::vector<Marked> cut = cut_line(cut_);
    text_at_ = middle(sew);
    text("Piece Name", name);
    if (!cut_.size.empty()) text("Size", cut_.size);
    const bool pair = profile_.pair_quantity || piece.mirrored_quantity > 0;
    text("Quantity", std::to_string(piece.quantity) + (pair ? "," + std::to_string(piece.mirrored_quantity) : ""));
    if (!piece.material.empty()) text("Material", piece.material);
    for (const std::string& annotation : piece.annotations) text("Annotation", annotation);
    if (profile_.plotted_text)
      for (const std::string& annotation : piece.annotations)
        dxf::put_text(out_, number_of(Role::plotted_text), text_at_, text_height, aama::ascii(annotation));

    ring(number_of(Role::cut_line), cut);
    // Where the cut line runs on the sew line, the sew line's points say what is a corner.
    marks(cut, [&](const Marked& point) {
      return std::none_of(sew.begin(), sew.end(),
                          [&](const Marked& other) { return (other.at - point.at).norm() <= one_point; });
    });
    ring(number_of(Role::sew_line), sew);
    marks(sew, [](const Marked&) { return true; });
    for (const CutNotch& notch : cut_.notches) write(notch);
    if (piece.grainline) {
      if (profile_.grade_reference)
        dxf::put_line(out_, number_of(Role::grade_reference), mm(piece.grainline->from), mm(piece.grainline->to));
      dxf::put_line(out_, number_of(Role::grain_line), mm(piece.grainline->from), mm(piece.grainline->to));
    }
    for (const InternalLine& line : piece.internal_lines)
      write(line, number_of(line.cut_out ? Role::cut_out : Role::internal_line));
    if (profile_.dense) {
      ring(number_of(Role::dense_cut_line), cut);
      for (const InternalLine& line : piece.internal_lines)
        write(line, number_of(line.cut_out ? Role::dense_cut_out : Role::dense_internal_line));
      ring(number_of(Role::dense_sew_line), sew);
    }
    for (const DrillHole& hole : piece.drill_holes) {
      point(number_of(Role::drill_hole), mm(hole.at));
      if (hole.diameter > 0) dxf::put_number(out_, 30, hole.diameter * mm_per_m);
    }
    dxf::put(out_, 0, "ENDBLK");
    dxf::put(out_, 8, "0");
  }

 private:
  static Eigen::Vector2d middle(const std::vector<Marked>& ring) {
    Eigen::AlignedBox2d box;
    for (const Marked& point : ring) box.extend(point.at);
    return box.center();
  }

  void text(const char* key, const std::string& value) {
    dxf::put_text(out_, number_of(Role::cut_line), text_at_, text_height, std::string(key) + ": " + aama::ascii(value));
    text_at_.y() -= text_spacing;
  }

  void ring(std::string_view layer, const std::vector<Marked>& points) {
    Vertices vertices;
    for (const Marked& marked : points) vertices.push_back(marked.at);
    dxf::put_polyline(out_, layer, vertices, true);
  }

  void point(std::string_view layer, const Eigen::Vector2d& at) {
    dxf::put(out_, 0, "POINT");
    dxf::put(out_, 8, layer);
    dxf::put_xy(out_, 10, at);
  }

  void marks(const std::vector<Marked>& points, const auto& wanted) {
    for (const Marked& marked : points) {
      if (!wanted(marked)) continue;
      const std::string_view layer = number_of(marked.turn ? Role::turn_point : Role::curve_point);
      point(layer, marked.at);
      if (marked.grade_rule) dxf::put_text(out_, layer, marked.at, text_height, "# " + std::to_string(*marked.grade_rule));
    }
  }

  void write(const CutNotch& notch) {
    point(aama::notch_layer(profile_.plain_notches ? NotchKind::slit : notch.notch.kind), mm(notch.at));
    dxf::put_number(out_, 30, notch.notch.depth * mm_per_m);
    if (notch.notch.width > 0) dxf::put_number(out_, 39, notch.notch.width * mm_per_m);
    double degrees = std::atan2(notch.direction.y(), notch.direction.x()) / units::degree;
    if (degrees < 0) degrees += 360;
    dxf::put_number(out_, 50, degrees);
  }

  void write(const InternalLine& line, std::string_view layer) {
    if (line.points.size() < 2) return;
    const bool closed = line.points.size() > 3 && line.points.front() == line.points.back();
    Vertices vertices;
    for (const Eigen::Vector2d& p : line.points) vertices.push_back(mm(p));
    if (closed) vertices.pop_back();
    if (vertices.size() == 2)
      dxf::put_line(out_, layer, vertices.front(), vertices.back());
    else
      dxf::put_polyline(out_, layer, vertices, closed);
  }

  std::string& out_;
  const CutPiece& cut_;
  const DxfProfile& profile_;
  Eigen::Vector2d text_at_ = Eigen::Vector2d::Zero();
};

void check(const CutPiece& cut) {
  const auto refuse = [&](const char* what) {
    throw std::invalid_argument("write_dxf_aama: piece '" + cut.piece.name + "' " + what);
  };
  if (cut.piece.outline.empty()) refuse("has no outline");
  for (const Edge& edge : cut.piece.outline)
    if (edge.points.size() < 2) refuse("has an edge with fewer than two points");
  if (cut.cut_line.size() < 3) refuse("has no cut line");
}

}  // namespace

std::string dxf_bytes(const CutSheet& sheet, const DxfProfile& profile, const std::string& rules) {
  std::string out;
  dxf::put_section(out, "HEADER");
  if (!profile.version.empty()) {
    dxf::put(out, 9, "$ACADVER");
    dxf::put(out, 1, profile.version);
  }
  dxf::put_section_end(out);

  const std::vector<aama::NamedPiece> pieces = aama::named_pieces(sheet);
  std::vector<std::string> blocks, taken;
  dxf::put_section(out, "BLOCKS");
  for (const auto& [piece, name] : pieces) {
    check(*piece);
    const std::string full = piece->size.empty() ? name : name + "_" + piece->size;
    blocks.push_back(aama::unique_name(aama::block_name(full), taken, 31));
    PieceWriter(out, *piece, profile).write(name, blocks.back());
  }
  dxf::put_section_end(out);

  dxf::put_section(out, "ENTITIES");
  Eigen::Vector2d at(0, 0);
  const auto style_text = [&](const char* key, const std::string& value) {
    dxf::put_text(out, number_of(Role::cut_line), at, text_height, std::string(key) + ": " + aama::ascii(value));
    at.y() -= text_spacing;
  };
  style_text("Style Name", sheet.title);
  if (profile.astm) {
    style_text("ASTM/D13Proposal 1 Version", "D6673-10");
    style_text("Author", "Toile ; TOILE ; 1");
    style_text("Curve Tolerance", "0.05");
  } else {
    style_text("Author", "Toile");
  }
  style_text("Product", "TOILE");
  if (!pieces.empty() && !pieces.front().piece->size.empty()) style_text("Sample Size", pieces.front().piece->size);
  if (!rules.empty()) style_text("Grade Rule Table", rules);
  style_text("Units", "METRIC");
  for (const std::string& note : sheet.notes) style_text("Annotation", note);
  for (const std::string& block : blocks) dxf::put_insert(out, number_of(Role::cut_line), block);
  dxf::put_section_end(out);
  dxf::put(out, 0, "EOF");
  return out;
}

std::string dxf_aama_bytes(const CutSheet& sheet) { return dxf_bytes(sheet, dxf_profiles[0]); }

void write_dxf_aama(const std::filesystem::path& file, const CutSheet& sheet) { write_whole_file(file, dxf_aama_bytes(sheet)); }

}  // namespace toile
