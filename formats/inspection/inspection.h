#pragma once
// What a pattern file holds, for people and for programs: the answer of `toile inspect`.

#include <optional>
#include <string>
#include <vector>

#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile {

// One piece in one size, in the units of its people.
struct PieceRow {
  std::string name;
  std::string size;                // empty: the file names none
  int as_drawn = 0, mirrored = 0;  // copies; a cutter cuts both
  std::string material;
  double width_mm = 0, height_mm = 0, area_mm2 = 0;  // of the sew line
  int outline_points = 0, turn_points = 0, curve_points = 0, notches = 0, drill_holes = 0, internal_lines = 0;
  bool has_sew_line = false;
  std::string sew_line_source;
  bool unfolded = false;                // drawn as a half
  std::optional<double> grainline_deg;  // 0 .. 180, anticlockwise from the x axis
  int graded_points = 0;
};

// Every piece of the file, of a graded file in every size (pieces in order, the sizes of each in order); with `only_chosen`, of
// the pattern alone.
std::vector<PieceRow> piece_rows(const PatternFile& file, bool only_chosen = false);

// Schema 1, described in README.md beside this file. A file that could not be read has its findings, and null where nothing is
// known.
std::string inspection_json(const Loaded<PatternFile>& loaded, const std::vector<PieceRow>& rows);

// The same as a table of at most 120 columns or so, findings in words last. `name` is the file's.
std::string inspection_table(const std::string& name, const Loaded<PatternFile>& loaded, const std::vector<PieceRow>& rows);

}  // namespace toile
