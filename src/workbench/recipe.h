#pragma once
// A recipe: the main job as data. Read from TOML by cli/recipe_file.h; lengths in metres.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cut/cut.h"
#include "edit/operation.h"

namespace toile {

struct Edit {
  std::string operation;
  EditArguments arguments;
  std::string place;  // "recipe.toml:21", for errors
};

struct Recipe {
  std::string name;
  struct {
    std::filesystem::path file;
    std::optional<std::filesystem::path> seams;
    std::optional<double> unit_in_metres;
  } pattern;
  struct {
    std::string chart, size;     // a row of templates/mannequins/CHART.csv, or
    std::filesystem::path file;  // an OBJ body
    std::optional<std::filesystem::path> skeleton;
  } body;
  struct {
    std::string name;  // templates/fabrics/NAME.toml, or
    std::filesystem::path file;
  } fabric;
  struct {
    std::string simulator = "fem";
    double edge_length = 12e-3;  // m
    double tolerance = 1e-4;     // of the drapes that are reported
  } drape;
  std::vector<Edit> edits;
  struct {
    int steps = 5;
    double tolerance = 1e-3;  // of the drapes inside the loop
  } adjust;
  SheetRules cut;
};

}  // namespace toile
