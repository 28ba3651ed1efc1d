#pragma once
// What a kind of garment is made of: the roles its pieces play, which sides of them are sewn together, what stays open, and
// where each sits on the body. One file of templates/garments/ each.

#include <map>
#include <string>
#include <vector>

#include "garment/pattern.h"

namespace toile {

// Where the pieces of a role sit, by the face of the garment they belong to.
struct RolePlace {
  std::string face;  // "front", "back", "side"; empty: any
  BodyPart at;       // of a piece that spans both sides; "arm" and "leg" are those of the wearer's left
  double half = 0;   // radians from there for a piece of the wearer's left side; the right side is its mirror image
  bool operator==(const RolePlace&) const = default;
};

struct PieceRole {
  std::string role;                // "skirt", "sleeve"
  std::vector<std::string> names;  // of all languages, small letters
  bool is_default = false;         // what a piece is that is only called front, back or side
  bool extra = false;              // lies on another piece: not sewn into the shell (pocket, facing, lining)
  std::vector<std::string> open;   // sides that are not sewn: "top", "bottom"
  std::vector<RolePlace> places;
  bool operator==(const PieceRole&) const = default;
};

// Which faces or sides two pieces must be of to be sewn so.
enum class Kinship { any, same, other };

struct SeamRule {
  std::string name;            // "side", "armhole"
  std::string role_a, role_b;  // as in PieceRole
  std::string side_a, side_b;  // "top", "bottom", "side", "any": which way the edge looks when the piece hangs; "upright": it hangs
                               // straight down; "crotch": hollow, or from the waist down
  Kinship face = Kinship::any;
  Kinship hand = Kinship::any;  // left or right of the wearer
  bool once = false;            // two pieces are sewn so along one line only
  bool operator==(const SeamRule&) const = default;
};

struct GarmentTemplate {
  std::string name;           // "skirt"
  std::vector<int> openings;  // how many holes it may have once it is sewn
  std::vector<PieceRole> roles;
  std::vector<SeamRule> seams;
  std::map<std::string, std::vector<std::string>> words;  // "front", "back", "side", "left", "right": how they are said
  bool operator==(const GarmentTemplate&) const = default;
};

}  // namespace toile
