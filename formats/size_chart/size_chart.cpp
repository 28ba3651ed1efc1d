// Size charts, templates/mannequins/NAME.csv; the README there has the columns. Centimetres in the file.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "formats/formats.h"
#include "garment/units.h"

namespace toile {
namespace {

struct Line {
  int number = 0;
  std::vector<std::string> cells;
};

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells;
  for (;;) {
    const std::size_t cut = line.find(separator);
    cells.emplace_back(trimmed(line.substr(0, cut)));
    if (cut == std::string_view::npos) return cells;
    line.remove_prefix(cut + 1);
  }
}

// The header decides the separator: spreadsheets of many countries write semicolons (and decimal commas).
std::vector<Line> lines_of(std::string_view text) {
  if (text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
  std::vector<Line> lines;
  char separator = 0;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t cut = text.find('\n');
    const std::string_view line = trimmed(text.substr(0, cut));
    text.remove_prefix(cut == std::string_view::npos ? text.size() : cut + 1);
    if (line.empty() || line.front() == '#') continue;
    if (separator == 0) separator = line.find(';') != std::string_view::npos ? ';' : ',';
    lines.push_back({number, cells_of(line, separator)});
  }
  return lines;
}

std::optional<double> centimetres(std::string cell) {
  std::replace(cell.begin(), cell.end(), ',', '.');
  double value = 0;
  const auto [end, trouble] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (trouble != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value) || value <= 0) return {};
  return value / cm_per_m;
}

constexpr const char* needed[] = {"size", "sex", "height", "bust", "waist", "hip"};

}  // namespace

Loaded<SizeChartRow> read_size_chart_row(const std::filesystem::path& file, const std::string& size) {
  Loaded<SizeChartRow> result;
  const Loaded<std::string> bytes = read_whole_file(file);
  result.report = bytes.report;
  if (!bytes.value) return result;
  const std::vector<Line> lines = lines_of(*bytes.value);
  const auto place = [&](const Line& line) { return file.string() + ":" + std::to_string(line.number); };
  if (lines.empty()) {
    result.report.error("chart.empty", file.string(), "there is no header line", "Begin with size,sex,height,bust,waist,hip");
    return result;
  }
  const Line& header = lines.front();
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(header.cells.begin(), header.cells.end(), name) - header.cells.begin());
  };
  for (const char* name : needed)
    if (column(name) == header.cells.size())
      result.report.error("chart.missing-column", place(header), "there is no column '" + std::string(name) + "'",
                          "Columns needed: size, sex, height, bust, waist, hip");
  if (!result.report.ok()) return result;

  const auto cell = [](const Line& line, std::size_t index) {
    return index < line.cells.size() ? line.cells[index] : std::string();
  };
  const auto row =
      std::find_if(lines.begin() + 1, lines.end(), [&](const Line& line) { return cell(line, column("size")) == size; });
  if (row == lines.end()) {
    std::string sizes;
    for (auto line = lines.begin() + 1; line != lines.end(); ++line)
      sizes += (sizes.empty() ? "" : ", ") + cell(*line, column("size"));
    result.report.error("chart.unknown-size", file.string(), "the chart has no size '" + size + "'",
                        "Sizes there are: " + (sizes.empty() ? "none" : sizes), Fault::missing);
    return result;
  }

  SizeChartRow found;
  found.chart = file.stem().string();
  found.size = size;
  const std::string sex = cell(*row, column("sex"));
  if (sex != "F" && sex != "M")
    result.report.error("chart.bad-sex", place(*row), "column 'sex' says '" + sex + "'", "Write F or M");
  found.female = sex == "F";
  for (std::size_t i = 0; i < header.cells.size(); ++i) {
    const std::string& name = header.cells[i];
    if (name.empty() || name == "size" || name == "sex") continue;
    const std::string text = cell(*row, i);
    double* field = name == "height"  ? &found.height
                    : name == "bust"  ? &found.bust
                    : name == "waist" ? &found.waist
                    : name == "hip"   ? &found.hip
                                      : nullptr;
    if (text.empty() && !field) continue;  // follows from the others
    if (const std::optional<double> value = centimetres(text))
      (field ? *field : found.others[name]) = *value;
    else
      result.report.error("chart.bad-number", place(*row), "column '" + name + "' says '" + text + "', which is no length",
                          "Write centimetres, like 88 or 88.5");
  }
  if (result.report.ok()) result.value = std::move(found);
  return result;
}

}  // namespace toile
