#pragma once
// The verb `toile bench`: the paper's Table 1, and its test of scalability, on our own samples.

#include <string>

#include "cli/run.h"

namespace toile {

struct BenchOptions : RunOptions {
  std::string table = "table1";  // or "scalability"
  std::string rows;  // names separated by commas; empty: all
};

// Runs the rows, each into a folder of its own, and writes TABLE.csv, TABLE.txt, stretch.png and hausdorff.png; prints the
// table. A row that cannot be run is said so in the table. Returns exit_checks_failed when one could not, else exit_ok. Throws
// BadInput.
int bench(const BenchOptions& options);

}  // namespace toile
