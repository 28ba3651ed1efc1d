#pragma once
// templates/table1/table1.toml: rows like those of the paper's Table 1, with the paper's figures.

#include <filesystem>
#include <string>
#include <vector>

#include "garment/report.h"

namespace toile {

struct PaperFigures {
  int triangles = 0;
  double flattened_stretch = 0, stretch = 0;
  double flattened_hausdorff = 0, hausdorff = 0;  // percent of the mannequin's height
};

struct TableRow {
  std::string name;  // "Fig. 2"
  std::string what;
  std::filesystem::path recipe;
  PaperFigures paper;
};

Loaded<std::vector<TableRow>> read_table1(const std::filesystem::path& file);

}  // namespace toile
