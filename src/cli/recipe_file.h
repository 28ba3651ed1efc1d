#pragma once

#include <filesystem>
#include <string>

#include "garment/report.h"
#include "workbench/recipe.h"

namespace toile {

// Reads a recipe (TOML). Paths in it are relative to its folder. An unknown key, a length without a unit, a missing part is an
// error with the line, and the keys or units there are.
Loaded<Recipe> read_recipe(const std::filesystem::path& file);
// The same from text.
Loaded<Recipe> read_recipe_text(const std::string& text, const std::filesystem::path& file);

}  // namespace toile
