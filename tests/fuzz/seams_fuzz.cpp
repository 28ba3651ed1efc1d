// Any bytes as a seams file beside a pattern of two pieces: applied whole, or refused in words and nothing done.

#include "formats/seams/seams.h"
#include "fuzz/checks.h"

namespace {

toile::Piece rectangle(const char* name, double width, double height, int copies) {
  toile::Piece piece;
  piece.name = name;
  piece.quantity = copies;
  const Eigen::Vector2d corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}, {0, 0}};
  for (int e = 0; e < 4; ++e)
    piece.outline.push_back(
        {"e" + std::to_string(e), {{corners[e], true, {}}, {corners[e + 1], true, {}}}, std::nullopt, false});
  return piece;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace toile;
  Pattern pattern;
  pattern.pieces = {rectangle("GORE", .2, .6, 4), rectangle("WAISTBAND", .8, .04, 1)};
  const Pattern before = pattern;
  const Report report = apply_seams(pattern, fuzz::text_of(data, size), "fuzz.seams.toml");
  if (report.ok())
    fuzz::check_pattern(pattern);
  else
    fuzz::require(pattern == before);
  return 0;
}
