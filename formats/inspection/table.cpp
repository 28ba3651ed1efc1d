#include <algorithm>
#include <cstdio>

#include "formats/inspection/inspection.h"

namespace toile {
namespace {

// Letters, not bytes: UTF-8 continuation bytes take no room.
std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
}

std::string figure(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

using Rows = std::vector<std::vector<std::string>>;

// Columns as wide as their widest word, numbers to the right; `left` says which columns hold words.
std::string columns(const Rows& rows, const std::vector<bool>& left) {
  std::vector<std::size_t> widths(left.size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], letters(row[i]));
  std::string text;
  for (const auto& row : rows) {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string room(widths[i] - letters(row[i]), ' ');
      line += " " + (left[i] ? row[i] + room : room + row[i]) + (i + 1 < row.size() ? " " : "");
    }
    while (!line.empty() && line.back() == ' ') line.pop_back();
    text += line + "\n";
  }
  return text;
}

std::string quantity(const PieceRow& row) {
  return row.mirrored > 0 ? std::to_string(row.as_drawn) + "+" + std::to_string(row.mirrored) : std::to_string(row.as_drawn);
}

std::string pieces_table(const std::vector<PieceRow>& rows) {
  const bool sized = std::any_of(rows.begin(), rows.end(), [](const PieceRow& r) { return !r.size.empty(); });
  const bool stuff = std::any_of(rows.begin(), rows.end(), [](const PieceRow& r) { return !r.material.empty(); });
  Rows table{{"piece"}};
  std::vector<bool> left{true};
  const auto head = [&](const char* word, bool is_word) {
    table.front().push_back(word);
    left.push_back(is_word);
  };
  if (sized) head("size", true);
  head("cut", false);
  if (stuff) head("material", true);
  for (const char* word : {"mm", "inch", "cm2", "points", "turns", "notches", "holes", "lines", "grain"}) head(word, false);
  head("sew line", true);
  for (const PieceRow& row : rows) {
    std::vector<std::string> line{row.name};
    if (sized) line.push_back(row.size);
    line.push_back(quantity(row));
    if (stuff) line.push_back(row.material);
    line.push_back(figure(row.width_mm, 1) + " x " + figure(row.height_mm, 1));
    line.push_back(figure(row.width_mm / 25.4, 2) + " x " + figure(row.height_mm / 25.4, 2));
    line.push_back(figure(row.area_mm2 / 100, 1));
    for (const int count : {row.outline_points, row.turn_points, row.notches, row.drill_holes, row.internal_lines})
      line.push_back(std::to_string(count));
    line.push_back(row.grainline_deg ? figure(*row.grainline_deg, 0) + "\xC2\xB0" : "none");
    line.push_back(row.sew_line_source + (row.unfolded ? ", unfolded" : ""));
    table.push_back(std::move(line));
  }
  return columns(table, left);
}

}  // namespace

std::string inspection_table(const std::string& name, const Loaded<PatternFile>& loaded, const std::vector<PieceRow>& rows) {
  std::string text = name + "\n";
  if (loaded.value) {
    const PatternFile& file = *loaded.value;
    Rows facts{{"format", file.format + (file.dialect.empty() ? "" : ", " + file.dialect)}};
    if (!file.author.empty()) facts.push_back({"author", file.author});
    if (!file.units.name.empty()) facts.push_back({"units", file.units.name + " (by " + file.units.decided_by + ")"});
    if (!file.sizes.empty()) {
      std::string sizes;
      for (const std::string& size : file.sizes)
        sizes += (sizes.empty() ? "" : " ") + (size == file.sample_size ? "[" + size + "]" : size);
      facts.push_back({"sizes", sizes + (file.graded_by == "nest"    ? ", a nest"
                                         : file.graded_by == "rules" ? ", graded by rules"
                                                                     : "")});
    }
    facts.push_back({"pieces", std::to_string(file.pattern.pieces.size())});
    facts.push_back({"seams", std::to_string(file.pattern.seams.size())});
    text += columns(facts, {true, true}) + "\n" + pieces_table(rows);
  }
  if (!loaded.report.findings.empty()) text += "\n";
  for (const Finding& finding : loaded.report.findings) text += in_words(finding) + "\n";
  return text;
}

}  // namespace toile
