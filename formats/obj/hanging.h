#pragma once
// Where pieces would have to hang flat to be sewn again into the shape they have.

#include "garment/pattern_file.h"

namespace toile {

// Gives the pieces of `pattern` a placement for each copy whose panel mostly faces one way: turned as it hangs (Kabsch), moved
// out along its outside until none of its cloth is in front of it, and 5 cm further. Others, such as bands round a limb, have
// none.
void place_by_drape(Pattern& pattern, const DrapedGarment& draped);

}  // namespace toile
