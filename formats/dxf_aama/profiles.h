#pragma once
// Ways to write pattern DXF that programs have been reported to want. Each differs by the fields of this table alone.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "garment/cut_sheet.h"
#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile {

struct DxfProfile {
  std::string_view name;
  std::string_view says;         // what it does, for the help: never what it works in
  std::string_view version;      // $ACADVER; empty: no header variables at all
  bool astm = false;             // style texts of D6673: version, curve tolerance, author "vendor ; product ; version"
  bool pair_quantity = false;    // "right,left" instead of one number where nothing is mirrored
  bool dense = false;            // copies of all lines on layers 84 to 87
  bool plotted_text = false;     // annotations on layer 15 too
  bool grade_reference = false;  // the grain line again on layer 5
  bool plain_notches = false;    // all on layer 4, told apart by depth and width alone
  std::string_view rul_heading;  // first line of its grade rule tables
  int pairs_in_line = 1;         // of a grade rule table
};

// clang-format off
inline constexpr DxfProfile dxf_profiles[] = {
    {"aama",    "R12, AAMA layers and texts, no header variables, no tables",              "",       false, false, false, false, false, false, "ANSI/AAMA VERSION: 1.0.0", 1},
    {"astm",    "follows the (withdrawn) D6673-10: its texts, right,left quantities, layer 15, dense copies on 84 to 87",
                                                                                           "",       true,  true,  true,  true,  true,  false, "ASTM/D13Proposal 1 Version: D6673-10", 1},
    {"clo",     "AAMA as R10 ($ACADVER AC1006), lines again on 84 to 87",                  "AC1006", false, false, true,  false, false, false, "ANSI/AAMA VERSION: 1.0.0", 1},
    {"optitex", "AAMA R12 with plotted text on layer 15; rule tables two pairs a line",    "",       false, false, false, true,  false, false, "ANSI/AAMA VERSION: 1.0.0", 2},
    {"gerber",  "AAMA R12, nothing but pieces in BLOCKS, grade reference lines on layer 5", "",       false, false, false, false, true,  false, "ANSI/AAMA VERSION: 1.0.0", 1},
    {"lectra",  "AAMA R12, single quantities, every notch on layer 4",                     "",       false, false, false, false, false, true,  "ANSI/AAMA VERSION: 1.0.0", 1},
    {"generic", "AAMA with $ACADVER AC1009, for CAD programs that know no patterns",       "AC1009", false, false, false, false, false, false, "ANSI/AAMA VERSION: 1.0.0", 1},
};
// clang-format on

const DxfProfile* find_dxf_profile(std::string_view name);

// `dxf_aama_bytes` in another profile. `rules`: name of the grade rule table that the numbers of the points are of.
std::string dxf_bytes(const CutSheet& sheet, const DxfProfile& profile, const std::string& rules = {});

// Notches as deep and wide as the pattern has them, also where the allowance leaves no room to snip: a file carries them as data.
CutSheet with_notches_as_drawn(CutSheet sheet);

// What the profile cannot hold of the sheet: "dxf.notch-kinds" (types told apart by depth alone), "dxf.hem" and others.
Report dxf_losses(const CutSheet& sheet, const DxfProfile& profile);

// The sample size of a graded pattern with a number for every outline point, and the table of the moves: rule 1 is none; points
// that move alike share a rule. The sizes must have the same pieces, edges and points: throws std::invalid_argument.
struct RuledPattern {
  Pattern pattern;
  std::string table;  // the text of the .rul, mm
};
RuledPattern with_rules(const PatternFile& graded, const std::string& name, const DxfProfile& profile);

}  // namespace toile
