#pragma once
// What the name of a piece says, in the languages of the templates.

#include <string>
#include <vector>

#include "garment/garment_template.h"

namespace toile {

struct PieceName {
  int role = -1;      // index into GarmentTemplate::roles
  bool said = false;  // the name has a word for the role; otherwise it is the template's default
  std::string face;   // "front", "back", "side" or nothing
  std::string hand;   // "left", "right" (of the wearer) or nothing
  int number = -1;    // "panel_3"
};

// Small letters without accents, split where words end: "RückenTeil_2" is {"ruecken", "teil", "2"}.
std::vector<std::string> words_of(const std::string& name);

PieceName read_name(const std::string& name, const GarmentTemplate& garment);

}  // namespace toile
