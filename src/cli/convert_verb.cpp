#include "cli/convert_verb.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "cli/exit_codes.h"
#include "cut/cut.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/profiles.h"
#include "formats/formats.h"
#include "formats/garmentcode/garmentcode.h"
#include "formats/pdf/write_pdf.h"
#include "formats/seams/seams.h"
#include "formats/svg/write_svg.h"
#include "garment/units.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const char* code, const std::string& place, const std::string& text, const std::string& remedy,
                         Fault fault = Fault::bad_input) {
  throw BadInput({code, Severity::error, place, text, remedy, fault});
}

double length_of(const std::string& option, const std::string& text) {
  if (text.empty()) return 0;
  const auto length = parse_length(text);
  if (!length || *length < 0)
    refuse("option.no-length", option, "'" + text + "' is not a length with its unit", "Write it like \"12 mm\" or \"5/8 in\"");
  return *length;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// A file to be written.
struct Output {
  fs::path file;
  std::string bytes;
};

class Conversion {
 public:
  Conversion(const ConvertOptions& options, PatternFile file, Report& report)
      : options_(options), file_(std::move(file)), report_(report) {
    rules_.allowances.allowance = length_of("--allowance", options.allowance);
    rules_.allowances.hem = length_of("--hem", options.hem);
    rules_.width = options.width.empty() ? 1.5 : length_of("--width", options.width);
    printing_ = {options.paper, length_of("--margin", options.margin), length_of("--overlap", options.overlap)};
    if (auto fault = fault_of(printing_)) refuse(fault->code.c_str(), "--" + fault->place, fault->text, fault->remedy);
  }

  std::vector<Output> outputs() {
    const std::string extension = lower_case(options_.out.extension().string());
    say_what_is_read();
    if (extension == ".dxf") return dxf();
    if (!file_.graded.empty() && options_.size.empty())
      report_.warn("convert.one-size", options_.out.filename().string(),
                   "the pattern has " + std::to_string(file_.sizes.size()) + " sizes; this format holds one, size " +
                       file_.pattern.sample_size,
                   "Convert once for each --size, or to DXF");
    if (extension == ".svg") return svg();
    if (extension == ".pdf") return pdf();
    if (extension == ".json") {
      auto [text, losses] = garmentcode_text(file_.pattern);
      report_.append(losses);
      return {{options_.out, text}};
    }
    return {};
  }

  const PatternFile& file() const { return file_; }

  // Straight to the file: the writer of OBJ does so.
  void write_drape() {
    report_.warn("convert.obj-marks", options_.out.filename().string(),
                 "the format has no notches, holes, grain lines, texts, allowances or rules",
                 "Keep the pattern as DXF or SVG too");
    if (!file_.drape.empty()) return write_obj(options_.out, file_.drape.front().garment, file_.drape.front().positions);
    report_.warn("convert.not-draped", options_.out.filename().string(),
                 "the pattern came without a drape: its pieces hang flat where they are placed, and are not sewn",
                 "toile drape writes the garment as it hangs");
    write_obj(options_.out, flat(), flat_positions_);
  }

 private:
  void say_what_is_read() {
    std::string folded;
    for (const PieceFacts& facts : file_.facts)
      if (facts.unfolded) folded += (folded.empty() ? "'" : ", '") + facts.piece + "'";
    if (!folded.empty() && !options_.unfold)
      report_.warn("convert.unfolded", "pieces " + folded, "drawn as halves on a fold; they are written whole",
                   "Give --unfold if that is meant");
  }

  CutSheet sheet_of(const Pattern& pattern) const {
    SheetRules rules = rules_;
    for (const Piece& piece : pattern.pieces) {
      if (!options_.width.empty()) break;
      Eigen::AlignedBox2d box;
      for (const Edge& edge : piece.outline)
        for (const OutlinePoint& point : edge.points) box.extend(point.at);
      const double allowances = 4 * std::max({rules.allowances.allowance, rules.allowances.hem, .1});
      rules.width = std::max(rules.width, box.diagonal().norm() + allowances + 2 * rules.margin);
    }
    CutSheet sheet = lay_out(pattern, rules);
    if (sheet.title.empty()) sheet.title = file_.pattern.name;
    return sheet;
  }

  std::vector<Output> dxf() {
    const DxfProfile* profile = find_dxf_profile(options_.profile);
    if (!profile) {
      std::string names;
      for (const DxfProfile& each : dxf_profiles) names += (names.empty() ? "" : ", ") + std::string(each.name);
      refuse("convert.no-such-profile", "--profile", "there is no profile '" + options_.profile + "'", "They are " + names);
    }
    const bool graded = !file_.graded.empty() && options_.size.empty() && options_.grading != "none";
    std::vector<Output> files;
    CutSheet sheet;
    if (graded && options_.grading == "rules") {
      const std::string name = options_.out.stem().string();
      RuledPattern ruled = with_rules(file_, name, *profile);
      sheet = with_notches_as_drawn(sheet_of(ruled.pattern));
      files = {{options_.out, dxf_bytes(sheet, *profile, name)},
               {fs::path(options_.out).replace_extension(".rul"), ruled.table}};
    } else {
      sheet = sheet_of(file_.pattern);
      if (graded)
        for (std::size_t s = 0; s < file_.graded.size(); ++s) {
          if (file_.sizes[s] == file_.pattern.sample_size) continue;
          const CutSheet other = sheet_of(file_.graded[s]);
          sheet.placed.insert(sheet.placed.end(), other.placed.begin(), other.placed.end());
        }
      sheet = with_notches_as_drawn(std::move(sheet));
      files = {{options_.out, dxf_bytes(sheet, *profile)}};
    }
    report_.append(dxf_losses(sheet, *profile));
    const fs::path sidecar = fs::path(options_.out).replace_extension(".seams.toml");
    if (!file_.pattern.seams.empty()) {
      report_.note("convert.seams-beside", sidecar.filename().string(), "DXF has no seams; they are in this file beside it");
      files.push_back({sidecar, seams_text(as_named_in_dxf(file_.pattern, sheet))});
    }
    return files;
  }

  std::vector<Output> svg() {
    for (const Piece& piece : file_.pattern.pieces)
      if (std::any_of(piece.placement.begin(), piece.placement.end(), [](const auto& at) { return at.has_value(); })) {
        report_.warn("convert.svg-places", options_.out.filename().string(),
                     "the format does not say where pieces hang round the body in 3D", "Keep the file it came from too");
        break;
      }
    const auto partly = [](const Seam& seam) {
      const auto part = [](const EdgeSpan& span) { return std::abs(span.end - span.begin) < 1 - 1e-9; };
      return part(seam.a) || part(seam.b) || seam.a.copy > 1 || seam.b.copy > 1;
    };
    if (std::any_of(file_.pattern.seams.begin(), file_.pattern.seams.end(), partly))
      report_.warn("convert.svg-seams", options_.out.filename().string(),
                   "the sheet says which edges are sewn, not which part of an edge or which copy",
                   "Convert to DXF too: its seams file has them");
    CutSheet sheet = sheet_of(file_.pattern);
    return {{options_.out, svg_text(sheet)}};
  }

  // Paper is not laid out for what lies beside the pieces.
  std::vector<Output> pdf() {
    CutSheet sheet = sheet_of(file_.pattern);
    if (options_.width.empty()) {
      sheet.page_width = .25;  // m: room for notes and test squares
      for (const PlacedPiece& placed : sheet.placed)
        for (const OutlinePoint& point : placed.cut.cut_line)
          sheet.page_width =
              std::max(sheet.page_width, (Eigen::Rotation2Dd(placed.turn) * point.at + placed.shift).x() + rules_.margin);
    }
    return {{options_.out, pdf_bytes(sheet, {}, printing_)}};
  }

  GarmentMesh flat() {
    GarmentMesh garment;
    garment.panels = triangulate(file_.pattern);
    std::vector<Eigen::Vector3d> at;
    std::vector<Eigen::Vector3i> triangles;
    double x = 0;
    for (const PanelMesh& panel : garment.panels) {
      const Piece& piece = file_.pattern.pieces[static_cast<std::size_t>(panel.piece)];
      const auto copy = static_cast<std::size_t>(panel.copy - 1);
      Placement placement;
      if (copy < piece.placement.size() && piece.placement[copy]) {
        placement = *piece.placement[copy];
      } else {
        placement.translation = Eigen::Vector3d(x - panel.rest.row(0).minCoeff(), -panel.rest.row(1).minCoeff(), 0);
        x += panel.rest.row(0).maxCoeff() - panel.rest.row(0).minCoeff() + .05;
      }
      const int first = static_cast<int>(at.size());
      for (Eigen::Index v = 0; v < panel.rest.cols(); ++v)
        at.emplace_back(placement.rotation * Eigen::Vector3d(panel.rest(0, v), panel.rest(1, v), 0) + placement.translation);
      garment.welded.push_back(Eigen::VectorXi::LinSpaced(panel.rest.cols(), first, static_cast<int>(at.size()) - 1));
      for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) triangles.emplace_back(panel.triangles.col(t).array() + first);
    }
    garment.vertex_count = static_cast<int>(at.size());
    garment.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t) garment.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    flat_positions_.resize(3, garment.vertex_count);
    for (std::size_t v = 0; v < at.size(); ++v) flat_positions_.col(static_cast<Eigen::Index>(v)) = at[v];
    return garment;
  }

  const ConvertOptions& options_;
  PatternFile file_;
  Report& report_;
  SheetRules rules_;
  PrintOptions printing_;
  Eigen::Matrix3Xd flat_positions_;
};

}  // namespace

int convert_pattern(const ConvertOptions& options) {
  const std::string extension = lower_case(options.out.extension().string());
  if (extension != ".dxf" && extension != ".svg" && extension != ".pdf" && extension != ".json" && extension != ".obj")
    refuse("convert.no-such-format", options.out.string(), "'" + extension + "' is no format Toile writes",
           "Name it .dxf, .svg, .pdf, .json or .obj", Fault::cannot_create);
  PatternReadOptions reading{{}, options.seams, options.size};
  if (!options.units.empty()) reading.unit_in_metres = length_of("--units", "1" + options.units);
  Loaded<PatternFile> read = read_pattern_file(options.in, reading);
  Report report = read.report;
  Conversion conversion(options, value_or_throw(std::move(read)), report);
  const std::vector<Output> outputs = conversion.outputs();
  std::vector<fs::path> files;
  for (const Output& output : outputs) files.push_back(output.file);
  if (outputs.empty()) files.push_back(options.out);
  std::error_code ignored;
  for (const fs::path& file : files)
    if (!options.force && fs::exists(file, ignored))
      refuse("output.exists", file.string(), "there is a file of that name", "Choose another, or give --force to replace it",
             Fault::cannot_create);
  for (const Output& output : outputs) write_whole_file(output.file, output.bytes);
  if (outputs.empty()) conversion.write_drape();

  for (const Finding& finding : report.findings)
    if (finding.severity == Severity::error || !options.quiet) std::fprintf(stderr, "toile: %s\n", in_words(finding).c_str());
  const auto losses = std::count_if(report.findings.begin(), report.findings.end(),
                                    [](const Finding& finding) { return finding.severity == Severity::warning; });
  std::string names;
  for (const fs::path& file : files) names += (names.empty() ? "" : ", ") + file.string();
  std::printf("%zu pieces, %zu seams; %td warnings; written to %s\n", conversion.file().pattern.pieces.size(),
              conversion.file().pattern.seams.size(), static_cast<std::ptrdiff_t>(losses), names.c_str());
  return exit_ok;
}

}  // namespace toile
