#include "formats/svg_read/piece.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/bridge.h"
#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/piece.h"
#include "formats/dxf_aama/unfold.h"
#include "formats/svg_read/darts.h"
#include "formats/svg_read/details.h"
#include "formats/svg_read/findings.h"
#include "formats/svg_read/fold.h"
#include "formats/svg_read/grain.h"
#include "formats/svg_read/inset.h"
#include "formats/svg_read/symmetry.h"
#include "garment/units.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

// The outlines of a piece as far as the drawing tells them apart.
struct Outlines {
  std::optional<Ring> sew, cut;
  std::string source;        // of the sew line; empty: geometry decides
  std::vector<Ring> others;  // inside
};

class Builder {
 public:
  Builder(const Drawing& drawing, std::vector<Role> roles, const PieceParts& parts, const Label& label,
          const Producer& producer, Report& report)
      : drawing_(drawing), roles_(std::move(roles)), parts_(parts), label_(label), producer_(producer), report_(report) {}

  std::optional<ReadPiece> build(const std::string& piece_name, const std::optional<AllowanceText>& everywhere,
                                 const std::string& file) {
    drawn_.name = piece_name;
    drawn_.file = file;
    drawn_.line = parts_.rings.front().line;
    choose_outlines();
    take_allowance(label_.allowance ? label_.allowance : everywhere);
    join_cut_parts();
    const Ring& outline = lines_.sew ? *lines_.sew : *lines_.cut;
    take_fold(outline);
    find_grain(drawing_, parts_, label_, roles_);
    std::optional<Points<2>> cut;
    if (lines_.cut && lines_.sew) cut = lines_.cut->points;
    std::optional<std::pair<Vector2d, Vector2d>> fold;
    if (fold_) fold = {fold_->from, fold_->to};
    sort_details(drawing_, roles_, parts_, outline.points, cut, fold, drawn_);
    for (const auto* ring : {&lines_.sew, &lines_.cut})
      if (*ring) mark_corners(**ring);
    if (lines_.sew) drawn_.sew.push_back({lines_.sew->points, true, lines_.sew->line});
    if (lines_.cut) drawn_.cut.push_back({lines_.cut->points, true, lines_.cut->line});
    for (const Ring& ring : lines_.others) {
      if (!lines_.sew) mark_corners(ring);
      drawn_.internal_lines.push_back({ring.points, true, ring.line});
    }
    set_texts();
    Report found;
    std::optional<aama::MadePiece> made = aama::make_piece(std::move(drawn_), found);
    append_in_svg_words(found, report_);
    if (!made) return {};
    ReadPiece read{std::move(made->piece), std::move(made->facts)};
    set_source(read.facts, found);
    read.facts.unfolded = made->fold.has_value();
    pair_copies(read);
    name_darts(read.piece, place(), report_);
    return read;
  }

 private:
  std::string place() const { return file_place_.empty() ? drawn_.place() : file_place_; }

  void choose_outlines() {
    file_place_ = drawn_.place();
    const std::vector<Ring>& rings = parts_.rings;
    const Ring *sew = nullptr, *cut = nullptr;
    for (const Ring& ring : rings) {
      if (ring.role == Role::sew && !sew) sew = &ring;
      if (ring.role == Role::cut && !cut) cut = &ring;
    }
    if (sew && !cut && &rings.front() != sew && rings.front().role == Role::unknown) cut = &rings.front();
    if (!sew && !cut) cut = &rings.front();
    if (!sew && cut) sew = inside_by_style(*cut);
    if (sew && cut && sew->area > cut->area) cut = nullptr;
    if (sew) lines_.source = told_by(*sew);
    if (sew) lines_.sew = *sew;
    if (cut) lines_.cut = *cut;
    if (!sew && producer_.dialect == "GarmentCode") {
      lines_.sew = std::move(lines_.cut);
      lines_.cut.reset();
      lines_.source = "GarmentCode draws net lines";
    }
    for (const Ring& ring : rings)
      if (&ring != sew && &ring != cut) lines_.others.push_back(ring);
  }

  // The one dashed ring that goes nearly all round inside a solid one, or the other way round.
  const Ring* inside_by_style(const Ring& outer) const {
    const Ring* found = nullptr;
    for (const Ring& ring : parts_.rings)
      if (&ring != &outer && ring.role == Role::unknown && ring.dashed != outer.dashed && ring.area > .5 * outer.area) {
        if (found) return nullptr;
        found = &ring;
      }
    return found;
  }

  std::string told_by(const Ring& sew) const {
    if (sew.role != Role::sew) return "line style";
    const Names& names = drawing_.lines[sew.lines.front()].names;
    if (!names.datum("type").empty() || !names.datum("role").empty()) return "data-type";
    if (producer_.dialect == "FreeSewing") return "class fabric";
    for (const std::string& name : {names.label, names.id})
      if (role_in_words(name) == Role::sew) return "name '" + name + "'";
    return "name of its class or layer";
  }

  void take_allowance(const std::optional<AllowanceText>& said) {
    if (lines_.sew || !lines_.cut || !lines_.others.empty() || !said) return;
    if (!said->included) {
      lines_.sew = std::move(lines_.cut);
      lines_.cut.reset();
      lines_.source = "a text says that there is no allowance";
      return;
    }
    if (said->width <= 0) return;
    lines_.sew = inset(*lines_.cut, said->width);
    if (lines_.sew) {
      lines_.source = "cut line less " + in_mm(said->width);
      report_.note(
          "svg.net-line", place(),
          "the sew line is the drawn line moved in by " + in_mm(said->width) + ", the allowance that is written there");
    } else {
      report_.warn("svg.net-line", place(),
                   "the drawn line cannot be moved in by the allowance of " + in_mm(said->width) + " without crossing itself",
                   "draw the sew line");
    }
  }

  // A cut line drawn in parts, with nothing where there is no allowance.
  void join_cut_parts() {
    if (!lines_.sew || lines_.cut) return;
    std::vector<aama::Run> runs;
    std::vector<std::size_t> taken;
    for (const std::size_t i : parts_.lines)
      if (roles_[i] == Role::cut) {
        runs.push_back({drawing_.lines[i].shape.points, drawing_.lines[i].shape.closed, drawing_.lines[i].names.line});
        taken.push_back(i);
      }
    if (runs.empty()) return;
    const std::optional<Points<2>> ring = aama::bridged(aama::chains(runs), lines_.sew->points);
    if (!ring || ring->size() < 3) {
      report_.note("svg.cut-line-open", place(),
                   "the cut line is drawn in parts that do not join the sew line; kept as internal lines, the allowance is not "
                   "measured");
      for (const std::size_t i : taken) roles_[i] = Role::internal;
      return;
    }
    Ring cut;
    cut.points = *ring;
    cut.bends.assign(ring->size(), Bend::unknown);
    cut.line = runs.front().line;
    lines_.cut = std::move(cut);
    for (const std::size_t i : taken) roles_[i] = Role::text;  // used
  }

  bool unfolds(const Points<2>& ring, const Fold& fold) const {
    aama::Chain chain;
    chain.points = ring;
    chain.closed = true;
    return aama::unfolded(chain, {fold.from, (fold.to - fold.from).normalized()}).has_value();
  }

  void take_fold(const Ring& outline) {
    std::vector<const DrawnLine*> marks;
    for (const std::size_t i : parts_.lines)
      if (roles_[i] == Role::fold) marks.push_back(&drawing_.lines[i]);
    fold_ = drawn_fold(outline, marks);
    if (!fold_ && !marks.empty())
      report_.warn("svg.fold-line", place(), "the fold line lies along no straight edge of the piece; it is read as drawn",
                   "draw the fold line along its edge");
    if (!fold_ && marks.empty() && label_.cut.on_fold && label_.cut.mirrored) {
      report_.warn("svg.fold-contradiction", place(),
                   "it says both mirrored and on the fold, and no fold is drawn; the piece is read as drawn",
                   "draw the fold line when it is a half");
    } else if (!fold_ && marks.empty() && label_.cut.on_fold) {
      std::optional<Points<2>> cut;
      if (lines_.sew && lines_.cut) cut = lines_.cut->points;
      fold_ = told_fold(outline, cut, label_.fold_at);
      if (fold_)
        report_.note(
            "svg.fold-by-text", place(),
            "it is cut on the fold; taken for that is its straight edge of " + in_mm((fold_->to - fold_->from).norm(), 0));
      else
        report_.warn("svg.fold-unknown", place(),
                     "it is cut on the fold, but which edge that is cannot be told; the piece is read as drawn",
                     "draw the fold line along its edge");
    }
    if (!fold_) return;
    if (lines_.cut && lines_.sew && !unfolds(lines_.cut->points, *fold_)) {
      report_.note("svg.cut-line-fold", place(), "the cut line does not end on the fold; the allowance is not measured");
      lines_.cut.reset();
    }
    drawn_.mirror.push_back({{fold_->from, fold_->to}, false, outline.line});
    // A mark of fold and grain in one.
    for (const DrawnLine* mark : marks)
      if (speaks_of(mark->names.datum("text"), Role::grain) || speaks_of(mark->names.label, Role::grain))
        drawn_.grain.push_back({{fold_->from, fold_->to}, false, mark->names.line});
  }

  void mark_corners(const Ring& ring) {
    const std::vector<bool> corner = corners_of(ring);
    for (std::size_t i = 0; i < ring.points.size(); ++i) drawn_.points.push_back({ring.points[i], corner[i]});
  }

  void set_texts() {
    drawn_.texts.name = drawn_.name;
    drawn_.texts.material = label_.cut.material;
    if (drawn_.texts.material.empty() && producer_.dialect == "FreeSewing" && lines_.sew)
      for (const char* material : {"fabric", "lining", "interfacing", "canvas"})
        if (drawing_.lines[lines_.sew->lines.front()].names.has_class(material)) drawn_.texts.material = material;
    drawn_.texts.annotations = label_.annotations;
    const int mirrored = label_.cut.mirrored && !fold_ ? label_.cut.copies / 2 : 0;
    drawn_.texts.quantity = label_.cut.copies - mirrored;
    drawn_.texts.mirrored = mirrored;
  }

  void set_source(PieceFacts& facts, const Report& found) {
    if (!lines_.source.empty()) {
      facts.sew_line_source = lines_.source;
      facts.has_sew_line = true;
    } else {
      const auto has = [&](const char* code) {
        return std::any_of(found.findings.begin(), found.findings.end(),
                           [&](const Finding& finding) { return finding.code == code; });
      };
      facts.sew_line_source = has("aama.sew-line-on-8") ? "inner line" : "only line";
      facts.has_sew_line = has("aama.sew-line-on-8");
    }
    if (facts.sew_line_source == "class fabric" && !lines_.cut) facts.sew_line_source = "class fabric, no cut line drawn";
  }

  // "Cut 2" of a piece that is not its own mirror image means a left and a right one.
  void pair_copies(ReadPiece& read) {
    Piece& piece = read.piece;
    if (!label_.says_cut || producer_.dialect == "FreeSewing" || label_.cut.mirrored || read.facts.unfolded ||
        piece.quantity < 2 || piece.quantity % 2 != 0)
      return;
    if (is_symmetric(piece)) return;
    piece.mirrored_quantity = piece.quantity = piece.quantity / 2;
    report_.note("svg.pair", place(),
                 "cut " + std::to_string(2 * piece.quantity) + " of a piece with no symmetry is read as left and right ones");
  }

  const Drawing& drawing_;
  std::vector<Role> roles_;
  const PieceParts& parts_;
  const Label& label_;
  const Producer& producer_;
  Report& report_;
  aama::DrawnPiece drawn_;
  Outlines lines_;
  std::optional<Fold> fold_;
  std::string file_place_;
};

}  // namespace

std::optional<ReadPiece> read_piece(const Drawing& drawing, std::vector<Role> roles, const PieceParts& parts,
                                    const Label& label, const std::string& piece_name, const Producer& producer,
                                    const std::optional<AllowanceText>& everywhere, const std::string& name, Report& report) {
  return Builder(drawing, std::move(roles), parts, label, producer, report).build(piece_name, everywhere, name);
}

}  // namespace toile::svg
