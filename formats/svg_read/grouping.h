#pragma once
// Which lines, texts and marks of a drawing belong to one piece.

#include <string>
#include <vector>

#include "formats/svg_read/line_roles.h"
#include "formats/svg_read/rings.h"
#include "garment/report.h"

namespace toile::svg {

struct PieceParts {
  int group = -1;                  // its own group, when the file has one for each piece
  std::vector<Ring> rings;         // [0] is the outermost; empty: the file draws its outline open
  std::vector<std::size_t> lines;  // others
  std::vector<std::size_t> texts, marks;
};

struct Grouping {
  std::vector<PieceParts> pieces;                // in file order
  std::vector<std::size_t> lines, texts, marks;  // in no piece
};

// By the file's own groups, else by what lies within what. Frames round several pieces, test squares and headings are no
// pieces. Warnings "svg.far-out" for closed lines larger than 20 m, "svg.no-outline" for groups without one.
Grouping grouped(const Drawing& drawing, const std::vector<Role>& roles, const Producer& producer, const Page& page,
                 const std::string& name, Report& report);

}  // namespace toile::svg
