// Real garments that say how they are sewn, with that taken away.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <tuple>

#include "formats/formats.h"
#include "pairing/pairing.h"
#include "pairing/pieces.h"

namespace toile {
namespace {

using Place = std::tuple<std::string, int, std::string>;
using Sewn = std::set<std::set<Place>>;

Sewn sewn(const std::vector<Seam>& seams) {
  Sewn out;
  for (const Seam& seam : seams)
    out.insert({Place{seam.a.piece, seam.a.copy, seam.a.edge}, Place{seam.b.piece, seam.b.copy, seam.b.edge}});
  return out;
}

// Neither seams nor places, and ids of edges that say nothing.
Pattern stripped(Pattern pattern, bool blank) {
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    Piece& piece = pattern.pieces[p];
    piece.placement.clear();
    piece.body_part.clear();
    const std::string name = blank ? "x" + std::string(1, static_cast<char>('a' + p)) : piece.name;
    for (Seam& seam : pattern.seams)
      for (EdgeSpan* span : {&seam.a, &seam.b})
        if (span->piece == piece.name) span->piece = name;
    piece.name = name;
  }
  return pattern;
}

struct Count {
  int there = 0, found = 0, wrong = 0;
};

Count count(const std::filesystem::path& file, bool blank) {
  Pattern pattern = stripped(value_or_throw(read_pattern(file)), blank);
  const Sewn truth = sewn(pattern.seams);
  pattern.seams.clear();
  const Sewn found = sewn(propose_seams(pattern, test::templates()).pattern.seams);
  Count out{static_cast<int>(truth.size()), 0, 0};
  for (const auto& seam : found) ++(truth.count(seam) ? out.found : out.wrong);
  return out;
}

Count over_all(bool blank) {
  const std::filesystem::path folder = std::filesystem::path(std::getenv("TOILE_CORPUS")) / "patterns/garmentcode/mh_f38";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Count all;
  for (const auto& file : files) {
    const Count one = count(file, blank);
    std::printf("%s%s: %d of %d found, %d wrong\n", file.stem().c_str(), blank ? ", names blanked" : "", one.found, one.there,
                one.wrong);
    all.there += one.there;
    all.found += one.found;
    all.wrong += one.wrong;
  }
  return all;
}

TEST(PairingCorpus, FindsNineSeamsOfTenAndFewWrong) {
  if (!std::getenv("TOILE_CORPUS")) GTEST_SKIP() << "no corpus";
  const Count all = over_all(false);
  EXPECT_GE(all.found, .9 * all.there);
  EXPECT_LE(all.wrong, .05 * (all.found + all.wrong));
}

TEST(PairingCorpus, FindsMostByShapesAlone) {
  if (!std::getenv("TOILE_CORPUS")) GTEST_SKIP() << "no corpus";
  const Count all = over_all(true);
  EXPECT_GE(all.found, .65 * all.there);
}

}  // namespace
}  // namespace toile
