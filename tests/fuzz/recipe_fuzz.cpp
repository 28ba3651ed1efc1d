// Any bytes as a recipe: read or refused in words.

#include "cli/recipe_file.h"
#include "fuzz/checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  const Loaded<Recipe> loaded = read_recipe_text(fuzz::text_of(data, size), "fuzz.toml");
  fuzz::require(loaded.value.has_value() == loaded.report.ok());
  return 0;
}
