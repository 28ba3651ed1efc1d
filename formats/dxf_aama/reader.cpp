#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formats/dxf/drawing.h"
#include "formats/dxf/explode.h"
#include "formats/dxf/tags.h"
#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/dialect.h"
#include "formats/dxf_aama/drawn_piece.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/flat.h"
#include "formats/dxf_aama/graded_piece.h"
#include "formats/dxf_aama/nest.h"
#include "formats/dxf_aama/piece.h"
#include "formats/dxf_aama/units.h"
#include "formats/formats.h"
#include "garment/units.h"

namespace toile {
namespace {

using aama::DrawnPiece;
using aama::PieceBlock;
using aama::PieceGroup;

constexpr double chord = 0.05e-3;  // m, how far curves may be from their chords

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

class Reader {
 public:
  Reader(const std::string& name, const PatternReadOptions& options, const FindRules& find_rules)
      : name_(name), options_(options), find_rules_(find_rules) {}

  Loaded<PatternFile> read(std::string_view bytes) {
    Loaded<dxf::Drawing> drawing = dxf::read_drawing(bytes, name_);
    report_ = std::move(drawing.report);
    if (drawing.value) {
      drawing_ = std::move(*drawing.value);
      if (find_pieces() && decide_units() && make_pieces()) grade();
    }
    Loaded<PatternFile> loaded;
    loaded.report = std::move(report_);
    if (loaded.report.ok()) loaded.value = std::move(file_);
    return loaded;
  }

 private:
  bool find_pieces() {
    style_ = aama::style_texts(drawing_.entities);
    for (const dxf::Block& block : drawing_.blocks) {
      if (!aama::has_outline(block)) continue;
      blocks_.push_back(block);
      blocks_.back().entities = dxf::exploded(block.entities, drawing_, name_, report_);
    }
    flat_ = blocks_.empty();
    if (flat_ && report_.ok()) {
      const std::vector<dxf::Entity> all = dxf::exploded(drawing_.entities, drawing_, name_, report_);
      blocks_ = aama::pieces_by_containment(all, name_, report_);
      style_ = aama::style_texts(all);
      for (const dxf::Block& block : blocks_)  // what a piece took is not the style's
        for (const dxf::Entity& entity : block.entities)
          if (entity.kind == dxf::Kind::text) std::erase(style_.others, entity.text);
    }
    groups_ = aama::piece_groups(blocks_, style_, name_, report_);
    if (groups_.empty() && report_.ok())
      report_.error("aama.no-piece", name_, "the file has no pattern piece: no closed line on layer 1 or elsewhere",
                    "export as DXF-AAMA or DXF-ASTM (one block per piece, boundary on layer 1)");
    if (!report_.ok()) return false;
    const aama::Dialect dialect = aama::dialect_of(style_, blocks_, flat_);
    file_.format = "DXF";
    file_.dialect = dialect.name;
    file_.author = style_.author;
    file_.sizes = aama::sizes_of(groups_);
    file_.sample_size = style_.sample_size.empty() ? groups_.front().sample_block().texts.size : style_.sample_size;
    for (const std::string& size : file_.sizes)
      if (dxf::same_word(size, file_.sample_size)) file_.sample_size = size;
    report_.note("aama.dialect", name_, dialect.name + ": " + dialect.because);
    return true;
  }

  DrawnPiece drawn(const PieceGroup& group, const PieceBlock& block, double unit, aama::Sorted& sorted) const {
    const std::vector<dxf::Entity> none;
    const aama::Transform transform =
        aama::transform_of(*block.block, flat_ ? none : drawing_.entities, unit, unit == 1 ? .02 : chord / unit);
    DrawnPiece piece = aama::sort_by_layer(*block.block, block.block->entities, transform, sorted);
    piece.name = group.name;
    piece.file = name_;
    piece.texts = block.texts;
    return piece;
  }

  bool decide_units() {
    aama::UnitEvidence evidence;
    evidence.style = style_;
    evidence.header = drawing_.header;
    aama::Sorted counted_later;
    for (const PieceGroup& group : groups_) aama::add_evidence(evidence, drawn(group, group.sample_block(), 1, counted_later));
    const std::optional<FileUnits> units = aama::decide_unit(evidence, options_.unit_in_metres, name_, report_);
    if (units) file_.units = *units;
    return units.has_value();
  }

  bool make_pieces() {
    Pattern& pattern = file_.pattern;
    pattern.name = style_.style.empty() ? name_.substr(0, name_.find_last_of('.')) : style_.style;
    pattern.style = style_.style;
    pattern.sample_size = file_.sample_size;
    aama::Sorted sorted;
    for (const PieceGroup& group : groups_) {
      samples_.push_back(drawn(group, group.sample_block(), file_.units.in_metres, sorted));
      if (const char* much = aama::too_much_in(samples_.back())) {
        report_.error("dxf.too-large", samples_.back().place(), std::string("it has ") + much, "export it with fewer points");
        return false;
      }
      std::optional<aama::MadePiece> made = aama::make_piece(samples_.back(), report_);
      if (!made) continue;
      pattern.pieces.push_back(std::move(made->piece));
      file_.facts.push_back(std::move(made->facts));
      folds_.push_back(made->fold);
    }
    aama::report_left_out(sorted, name_, report_);
    for (const std::string& text : style_.others) report_.note("aama.style-text", name_, "'" + text + "' is not read");
    if (!style_.dates.empty())
      report_.note("aama.style-date", name_, "'" + listed(style_.dates) + "': read, but a pattern has no place for it");
    return report_.ok();
  }

  void grade() {
    const bool nest = std::any_of(groups_.begin(), groups_.end(), [](const PieceGroup& g) { return g.sizes.size() > 1; });
    const bool ruled =
        std::any_of(samples_.begin(), samples_.end(), [](const DrawnPiece& p) { return !p.grade_rules.empty(); });
    if (!nest && ruled && find_rules_) rules_ = find_rules_(style_.rule_table, report_);
    if (nest)
      grade_by_nest();
    else if (rules_)
      grade_by_rules();
    else if (ruled)
      report_.note("aama.no-rule-table", name_,
                   "points have grade rule numbers, but no rule table (.rul) is beside the file; the sample size alone is read",
                   "put the rule table beside the DXF under the same name");
    choose_size();
  }

  void begin_grading(const char* by) {
    file_.graded_by = by;
    file_.graded.assign(file_.sizes.size(), file_.pattern);
    for (std::size_t s = 0; s < file_.sizes.size(); ++s) {
      file_.graded[s].sample_size = file_.sizes[s];
      file_.graded[s].pieces.clear();
    }
  }

  void add_graded(std::size_t piece, const aama::GradedLines& lines) {
    std::vector<Piece> sizes = aama::graded_pieces(file_.pattern.pieces[piece], folds_[piece], lines, file_.sizes.size());
    for (std::size_t s = 0; s < sizes.size(); ++s) {
      if (!(signed_area(sizes[s]) > 0))
        report_.warn("aama.graded-inside-out", samples_[piece].place(),
                     "graded to size " + file_.sizes[s] + " its outline turns inside out", "check its grading");
      file_.graded[s].pieces.push_back(std::move(sizes[s]));
    }
  }

  void grade_by_nest() {
    begin_grading("nest");
    std::vector<std::string> alike;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const PieceGroup& group = groups_[i];
      if (group.sizes.size() == 1) alike.push_back(group.name);
      std::vector<DrawnPiece> others;
      others.reserve(group.sizes.size());
      std::vector<const DrawnPiece*> sizes;
      std::vector<std::string> lacking;
      aama::Sorted ignored;
      for (const std::string& size : file_.sizes) {
        const auto block =
            std::find_if(group.sizes.begin(), group.sizes.end(), [&](const PieceBlock& b) { return b.texts.size == size; });
        if (block == group.sizes.end() || &*block == &group.sample_block()) {
          if (block == group.sizes.end() && group.sizes.size() > 1) lacking.push_back(size);
          sizes.push_back(&samples_[i]);
        } else {
          others.push_back(drawn(group, *block, file_.units.in_metres, ignored));
          if (const char* much = aama::too_much_in(others.back())) {
            report_.error("dxf.too-large", others.back().place(), std::string("in size ") + size + " it has " + much,
                          "export it with fewer points");
            return;
          }
          sizes.push_back(&others.back());
        }
      }
      if (!lacking.empty())
        report_.warn("aama.size-missing", samples_[i].place(),
                     "not drawn in size " + listed(lacking) + "; it has the sample size's shape there",
                     "export the piece in every size");
      add_graded(i, aama::nest_lines(samples_[i], sizes, file_.sizes, report_));
    }
    report_.note("aama.nest", name_,
                 "a nest of sizes " + listed(file_.sizes) + "; size '" + file_.sample_size + "' is the sample size" +
                     (alike.empty() ? "" : "; the same in all sizes: " + listed(alike)));
  }

  void grade_by_rules() {
    const auto unit = unit_of_rules();
    file_.sizes = rules_->sizes;
    file_.sample_size = rules_->sample_size;
    file_.pattern.sample_size = rules_->sample_size;
    begin_grading("rules");
    std::vector<std::string> alike;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const aama::GradedLines lines = aama::ruled_lines(samples_[i], *rules_, unit, report_);
      if (lines.lines.empty()) alike.push_back(groups_[i].name);
      add_graded(i, lines);
    }
    report_.note("aama.graded-by-rules", name_,
                 "graded by rule table '" + rules_->name + "' (" + std::to_string(rules_->rules.size()) + " rules) to sizes " +
                     listed(file_.sizes) + "; sample size '" + file_.sample_size + "'" +
                     (alike.empty() ? "" : "; without rules and the same in all sizes: " + listed(alike)));
    if (!style_.sample_size.empty() && !dxf::same_word(style_.sample_size, rules_->sample_size))
      report_.warn("aama.sample-size", name_,
                   "the DXF's sample size is '" + style_.sample_size + "', that of its rule table '" + rules_->sample_size +
                       "'; the table's is taken",
                   "export piece and rule table together");
  }

  // Metres per unit of the rule table: the DXF's, unless it says another system of units.
  double unit_of_rules() {
    const auto english = [](const std::string& said) {
      return dxf::same_word(said, "ENGLISH") || dxf::same_word(said, "IMPERIAL") || dxf::same_word(said, "INCH");
    };
    const bool table = english(rules_->units), file = file_.units.name == "inch" || file_.units.name == "foot";
    if (rules_->units.empty() || table == file) return file_.units.in_metres;
    report_.warn("aama.rule-units", name_,
                 "the DXF is read in " + file_.units.name + ", its rule table says " + rules_->units +
                     "; the rules are taken as " + (table ? "inches" : "mm"),
                 "export piece and rule table in the same units");
    return table ? 0.0254 : 1e-3;
  }

  void choose_size() {
    const std::string& wanted = options_.size;
    if (wanted.empty() || dxf::same_word(wanted, file_.sample_size)) return;
    for (std::size_t s = 0; s < file_.graded.size(); ++s)
      if (dxf::same_word(file_.sizes[s], wanted)) {
        file_.pattern = file_.graded[s];
        return;
      }
    report_.error("aama.size-unknown", name_,
                  file_.sizes.empty() ? "the file names no sizes; '" + wanted + "' cannot be chosen"
                                      : "the file has no size '" + wanted + "', only " + listed(file_.sizes),
                  "choose one of its sizes");
  }

  const std::string& name_;
  const PatternReadOptions& options_;
  const FindRules& find_rules_;
  std::optional<GradeTable> rules_;
  Report report_;
  dxf::Drawing drawing_;
  aama::StyleTexts style_;
  bool flat_ = false;
  std::vector<dxf::Block> blocks_;  // with an outline, nested blocks put in
  std::vector<PieceGroup> groups_;
  std::vector<DrawnPiece> samples_;  // one for each group
  std::vector<std::optional<aama::Axis>> folds_;
  PatternFile file_;
};

}  // namespace

Loaded<PatternFile> read_dxf_pattern_bytes(std::string_view bytes, const std::string& name, const PatternReadOptions& options,
                                           const FindRules& find_rules) {
  if (options.unit_in_metres && !(std::isfinite(*options.unit_in_metres) && *options.unit_in_metres > 0))
    throw std::invalid_argument("read_dxf_pattern: the unit must be a positive number of metres");
  return Reader(name, options, find_rules).read(bytes);
}

}  // namespace toile
