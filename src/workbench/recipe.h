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

struct FabricName {
  std::string name;  // templates/fabrics/NAME.toml, or
  std::filesystem::path file;
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
  FabricName fabric;
  struct {
    std::string simulator = "fem";
    double edge_length = 12e-3;  // m
    double tolerance = 1e-4;     // of the drapes that are reported
  } drape;
  std::vector<Edit> edits;
  struct {
    std::optional<double> height;  // m, of the body that the edited garment is scaled to
  } replica;
  struct {
    std::vector<std::string> locked;   // edges that keep their shape: "neck", "FRONT.neck"
    std::optional<FabricName> fabric;  // that the new pattern is cut from, when it is another
    int steps = 5;
    double tolerance = 1e-3;  // of the drapes inside the loop
  } adjust;
  SheetRules cut;
  struct {
    std::string paper = "a4";                // of the tiled cut sheet: a name of formats/pdf/papers.h; "roll": none
    double margin = 10e-3, overlap = 10e-3;  // m
  } print;
};

}  // namespace toile
