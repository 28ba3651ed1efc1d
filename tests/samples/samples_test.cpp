// The samples' drafts: the committed files are what the programs draw, and what is sewn together fits, in every size.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "formats/formats.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

struct Sample {
  const char* name;
  double sleeve_ease;  // m, of each half of the cap
};

class SampleDraft : public testing::TestWithParam<Sample> {
 protected:
  // The DXF that the draft's program writes for `size`, the committed seams beside it.
  fs::path drafted(const std::string& size) const {
    const std::string name = GetParam().name;
    const fs::path folder = fs::path(testing::TempDir()) / ("samples_" + name + "_" + size);
    fs::create_directories(folder);
    const std::string command =
        "'" + (fs::path(TOILE_DRAFTS) / ("draft_" + name)).string() + "' '" + folder.string() + "' " + size;
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    fs::copy_file(committed(".seams.toml"), folder / (name + ".seams.toml"), fs::copy_options::overwrite_existing);
    return folder / (name + ".dxf");
  }

  fs::path committed(const std::string& extension) const {
    const std::string name = GetParam().name;
    return fs::path(TOILE_SOURCE_DIR) / "samples" / name / (name + extension);
  }
};

TEST_P(SampleDraft, IsTheCommittedFileByteForByte) {
  EXPECT_TRUE(value_or_throw(read_whole_file(drafted("38"))) == value_or_throw(read_whole_file(committed(".dxf"))))
      << "draw it again: ninja draft_" << GetParam().name;
}

TEST_P(SampleDraft, FitsAlongItsSeamsInEverySize) {
  for (const std::string size : {"34", "38", "46", "52"}) {
    const auto loaded = read_pattern(drafted(size));
    for (const Finding& finding : loaded.report.findings) EXPECT_EQ(finding.severity, Severity::note) << in_words(finding);
    ASSERT_TRUE(loaded.value);
    ASSERT_FALSE(loaded.value->seams.empty());
    for (const Seam& seam : loaded.value->seams) {
      const bool sleeve = seam.name.find("sleeve, ") != std::string::npos;
      const double longer = span_length(*loaded.value, seam.a) - span_length(*loaded.value, seam.b);
      EXPECT_NEAR(longer, sleeve ? GetParam().sleeve_ease : 0, 1e-3) << "size " << size << ", seam '" << seam.name << "'";
    }
  }
}

TEST_P(SampleDraft, SewsEveryEdgeButItsOpenings) {
  const Pattern pattern = value_or_throw(read_pattern(committed(".dxf")));
  for (const Piece& piece : pattern.pieces) {
    EXPECT_TRUE(piece.grainline) << piece.name;
    for (const Edge& edge : piece.outline) {
      const bool sewn = std::any_of(pattern.seams.begin(), pattern.seams.end(), [&](const Seam& seam) {
        return (seam.a.piece == piece.name && seam.a.edge == edge.id) || (seam.b.piece == piece.name && seam.b.edge == edge.id);
      });
      EXPECT_EQ(sewn, !edge.hem && edge.id != "neck" && edge.id != "top") << piece.name << "." << edge.id;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleDraft,
                         testing::Values(Sample{"sheath_dress", 10e-3}, Sample{"strapless_dress", 0}, Sample{"t_shirt", 0},
                                         Sample{"trousers", 0}),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace toile
