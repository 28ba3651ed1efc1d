#pragma once
// Grade rule tables (.rul) that come with AAMA/ASTM DXF: how far points of the sample size move in the other sizes.

#include <Eigen/Core>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "garment/report.h"

namespace toile {

struct GradeTable {
  std::string name;  // "GRADE RULE TABLE"
  std::string author;
  std::string units;                                  // "METRIC", "ENGLISH", ... as the file says
  std::vector<std::string> sizes;                     // "SIZE LIST"
  std::string sample_size;                            // one of `sizes`
  std::map<int, std::vector<Eigen::Vector2d>> rules;  // number -> one move from the sample size for each size, file units
  bool operator==(const GradeTable&) const = default;
};

// The table in `bytes`; `name` is what findings call the file. Errors: "rul.not-rul" (no size list), "rul.sizes" (the number of
// sizes is not that of the list, the sample size is none of them), "rul.rule" (a rule without a number, with other than a pair
// of finite numbers for each size, or of another kind than DELTA), "rul.too-large". Warnings: "rul.duplicate-rule" (the first
// counts), "rul.sample-moves" (a rule moves the sample size; what it does to the others is taken relative to that),
// "rul.no-end". Header lines it does not know are the note "rul.header".
Loaded<GradeTable> read_rul_bytes(std::string_view bytes, const std::string& name);

}  // namespace toile
