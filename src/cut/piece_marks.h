#pragma once
// What is put on a cut piece beside its lines.

#include <string>
#include <vector>

#include "cut/cut.h"
#include "cut/polygon.h"

namespace toile {

// Every notch of the piece where the outward normal at its place meets the cut line. `widths`: allowance of each edge, m.
std::vector<CutNotch> notches_on(const Piece& piece, const std::vector<double>& widths, const Polygon& cut_line);

// "Cut 8", "Cut 1 pair (2 mirrored)", "Cut 3 (1 mirrored)".
std::string cut_quantity(const Piece& piece);

// "10 mm (0.39 in)"
std::string in_both_units(double metres);

// Piece name, quantity, material, allowances in words.
std::vector<std::string> labels_of(const Piece& piece, const std::vector<double>& widths, const std::vector<bool>& hems);

}  // namespace toile
