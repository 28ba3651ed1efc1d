#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "formats/dxf_aama/piece_names.h"
#include "formats/formats.h"
#include "formats/svg_read/own_piece.h"
#include "formats/svg_read/piece.h"
#include "formats/svg_read/svg_read.h"
#include "garment/units.h"

namespace toile {
namespace {

using namespace svg;

std::string stem_of(const std::string& name) { return name.substr(0, name.find_last_of('.')); }

double largest_side(const Grouping& grouping) {
  double largest = 0;
  for (const PieceParts& piece : grouping.pieces) {
    Eigen::Vector2d low = piece.rings.front().points.front(), high = low;
    for (const Eigen::Vector2d& p : piece.rings.front().points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    largest = std::max(largest, (high - low).maxCoeff());
  }
  return largest;
}

// Everything drawn that is in no piece, counted.
void report_outside(const Drawing& drawing, const std::vector<Role>& roles, const Grouping& grouping, const std::string& name,
                    Report& report) {
  std::map<std::string, std::pair<int, int>> kinds;  // how many, first line
  const auto count = [&](const std::string& kind, int line) {
    auto& [many, first] = kinds.emplace(kind, std::pair(0, line)).first->second;
    ++many;
    first = std::min(first, line);
  };
  for (const std::size_t i : grouping.lines) {
    const Role role = roles[i];
    count(role == Role::test_square                  ? "test squares"
          : role == Role::text || role == Role::page ? "frames and headings"
                                                     : "lines",
          drawing.lines[i].names.line);
  }
  for (const std::size_t i : grouping.texts) count("texts", drawing.texts[i].names.line);
  for (const std::size_t i : grouping.marks) count("marks", drawing.marks[i].names.line);
  for (const auto& [kind, found] : kinds) {
    const std::string text = "in no piece and left out: " + std::to_string(found.first) + " " + kind;
    const std::string place = name + ":" + std::to_string(found.second);
    if (kind == "lines" || kind == "marks")
      report.warn("svg.outside", place, text, "put them inside an outline, or group them with it");
    else
      report.note("svg.outside", place, text);
  }
  for (const auto& [kind, many] : drawing.left_out) {
    const std::string text = "left out: " + std::to_string(many) + " " + kind;
    if (kind == "pictures" || kind == "foreign objects" || kind == "uses of what is not in the file")
      report.warn("svg.left-out", name, text, "draw what they show as lines");
    else
      report.note("svg.left-out", name, text);
  }
}

struct Reading {
  Producer producer;
  Page page;
  Drawing drawing;
  std::vector<Role> roles;
  Grouping grouping;
};

// Draws, and draws again where a test square says that all is larger or smaller.
std::optional<Reading> drawn(const Element& root, std::string_view bytes, std::optional<double> unit, const std::string& name,
                             Report& report) {
  Reading reading;
  reading.producer = producer_of(root, bytes);
  reading.page = page_of(root, reading.producer, unit, name, report);
  for (int round = 0; round < 2; ++round) {
    Report found;
    reading.drawing = drawing_of(root, reading.page.to_metres(), name, found);
    const double scale = round == 0 && found.ok() ? scale_by_test_squares(reading.drawing, reading.page, name, report) : 1;
    if (scale == 1) {
      report.append(found);
      break;
    }
    reading.page.unit *= scale;
    reading.page.size *= scale;
    reading.page.units.in_metres *= scale;
    reading.page.units.name = in_mm(reading.page.units.in_metres, 4);
    reading.page.units.decided_by = "test square";
  }
  if (!report.ok()) return {};
  reading.roles = line_roles(reading.drawing, reading.producer);
  reading.grouping = grouped(reading.drawing, reading.roles, reading.producer, reading.page, name, report);
  return reading;
}

class SvgPieces {
 public:
  SvgPieces(const Reading& reading, const std::string& name, const std::string& size, PatternFile& file, Report& report)
      : reading_(reading), name_(name), wanted_(size), file_(file), report_(report) {}

  void read() {
    std::optional<AllowanceText> everywhere;
    for (const std::size_t i : reading_.grouping.texts)
      if (!everywhere || everywhere->width == 0)
        if (const auto said = allowance_text(reading_.drawing.texts[i].words)) everywhere = said;
    list_sizes();
    std::vector<std::string> taken;
    std::vector<int> done;
    for (const PieceParts& parts : reading_.grouping.pieces) {
      if (reading_.producer.dialect == "Toile" && parts.group >= 0) {
        if (std::find(done.begin(), done.end(), parts.group) != done.end()) continue;
        done.push_back(parts.group);
      }
      if (!of_size(parts.group)) continue;
      Label label = label_of(reading_.drawing, parts, reading_.producer);
      if (parts.group >= 0) take_data(parts.group, label);
      if (label.name.empty()) label.name = "piece " + std::to_string(file_.pattern.pieces.size() + 1);
      if (placed_before(parts.group, label.name)) continue;
      const std::string unique = aama::unique_name(label.name, taken, 80);
      std::optional<ReadPiece> piece;
      if (reading_.producer.dialect == "Toile" && parts.group >= 0)
        piece = own_piece(reading_.drawing, parts.group, reading_.page.size.y());
      if (piece)
        piece->piece.name = piece->facts.piece = unique;
      else
        piece =
            read_piece(reading_.drawing, reading_.roles, parts, label, unique, reading_.producer, everywhere, name_, report_);
      if (!piece) continue;
      file_.pattern.pieces.push_back(std::move(piece->piece));
      file_.facts.push_back(std::move(piece->facts));
    }
  }

 private:
  std::string datum(int group, const std::string& key) const {
    return group < 0 ? std::string() : reading_.drawing.groups[static_cast<std::size_t>(group)].names.datum(key);
  }

  void list_sizes() {
    for (const PieceParts& parts : reading_.grouping.pieces)
      if (const std::string size = datum(parts.group, "size");
          !size.empty() && std::find(file_.sizes.begin(), file_.sizes.end(), size) == file_.sizes.end())
        file_.sizes.push_back(size);
    if (file_.sizes.empty()) return;
    file_.pattern.sample_size = wanted_.empty() ? file_.sizes.front() : wanted_;
    if (std::find(file_.sizes.begin(), file_.sizes.end(), file_.pattern.sample_size) == file_.sizes.end())
      report_.error("svg.no-size", name_, "the drawing has no size '" + wanted_ + "'", "ask for one that it has");
    if (file_.sizes.size() > 1)
      report_.note("svg.sizes", name_,
                   std::to_string(file_.sizes.size()) + " sizes are drawn; '" + file_.pattern.sample_size + "' is read");
  }
  bool of_size(int group) const {
    const std::string size = datum(group, "size");
    return size.empty() || size == file_.pattern.sample_size;
  }
  // The same piece placed several times is one piece.
  bool placed_before(int group, const std::string& piece) const {
    return reading_.producer.dialect == "Toile" && group >= 0 &&
           std::any_of(file_.pattern.pieces.begin(), file_.pattern.pieces.end(),
                       [&](const Piece& other) { return other.name == piece; });
  }
  void take_data(int group, Label& label) const {
    const auto number = [&](const char* key) -> std::optional<int> {
      const std::vector<double> numbers = numbers_in(datum(group, key));
      if (numbers.size() != 1 || numbers[0] < 0 || numbers[0] > 1000) return {};
      return static_cast<int>(numbers[0]);
    };
    if (const std::string material = datum(group, "material"); !material.empty()) label.cut.material = material;
    if (const std::optional<int> quantity = number("quantity")) {
      label.cut.copies = std::max(1, *quantity + number("mirrored").value_or(0));
      label.cut.mirrored = number("mirrored").value_or(0) > 0;
      label.says_cut = true;
    }
  }

  const Reading& reading_;
  const std::string& name_;
  const std::string& wanted_;
  PatternFile& file_;
  Report& report_;
};

}  // namespace

bool looks_like_svg(std::string_view bytes) {
  return bytes.substr(0, 4096).find("<svg") != std::string_view::npos ||
         bytes.substr(0, 4096).find(":svg") != std::string_view::npos;
}

Loaded<PatternFile> read_svg_bytes(std::string_view bytes, const std::string& name, std::optional<double> unit,
                                   const std::string& size) {
  if (unit && !(std::isfinite(*unit) && *unit > 0))
    throw std::invalid_argument("read_svg: the unit must be a positive number of metres");
  Loaded<Element> root = read_elements(bytes, name);
  Loaded<PatternFile> loaded{std::nullopt, std::move(root.report)};
  Report& report = loaded.report;
  if (!root.value) return loaded;
  const std::optional<Reading> reading = drawn(*root.value, bytes, unit, name, report);
  if (!reading || !report.ok()) return loaded;
  if (reading->grouping.pieces.empty()) {
    report.error("svg.no-piece", name, "no closed outline of a piece is drawn",
                 "close the outlines; give the unit with --units when they are drawn small");
    return loaded;
  }
  check_size(largest_side(reading->grouping), reading->page, name, report);
  if (!report.ok()) return loaded;
  PatternFile file;
  file.format = "SVG";
  file.dialect = reading->producer.dialect;
  file.author = reading->producer.author;
  file.units = reading->page.units;
  file.pattern.name = stem_of(name);
  SvgPieces(*reading, name, size, file, report).read();
  report_outside(reading->drawing, reading->roles, reading->grouping, name, report);
  if (report.ok()) loaded.value = std::move(file);
  return loaded;
}

Loaded<PatternFile> read_svg(const std::filesystem::path& file, std::optional<double> unit, const std::string& size) {
  Loaded<std::string> bytes = read_whole_file(file);
  if (!bytes.value) return {std::nullopt, std::move(bytes.report)};
  Loaded<PatternFile> loaded = read_svg_bytes(*bytes.value, file.filename().string(), unit, size);
  Report report = std::move(bytes.report);
  report.append(loaded.report);
  return {std::move(loaded.value), std::move(report)};
}

}  // namespace toile
