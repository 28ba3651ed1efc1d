// Drafts the T-shirt: front, back, short sleeve. README.md beside this file gives the rules.
// Usage: draft_t_shirt FOLDER [SIZE]   writes FOLDER/t_shirt.dxf

#include "bodice_block.h"
#include "garment/units.h"

namespace {

using namespace toile;
using namespace toile::drafting;
using Eigen::Vector2d;

// The block's half down to the hem, the side a little in at the waist.
Piece body(const std::string& name, const BodiceHalf& half, double hem_half, double below_waist,
           const std::vector<double>& notches, const std::string& right, const std::string& left) {
  const Vector2d underarm = half.underarm(), hem(hem_half, .8_cm - below_waist);
  const Vector2d waist((underarm.x() + hem_half) / 2 - 1.2_cm, 0);
  const Line side = through({hem, waist, underarm}, 5);
  // Square to the centre line and to the side, which the bust and the seat would otherwise leave hanging lower.
  const Vector2d centre(0, -below_waist);
  const Line bottom = curve(centre, centre + Vector2d(.4 * hem_half, 0), hem - Vector2d(.25 * hem_half, .25_cm), hem, 8);
  const double waist_at = share_at(side, length(side) * below_waist / (below_waist + underarm.y()));
  std::vector<double> on_armhole;
  for (const double at : notches) on_armhole.push_back(share_at(half.armhole, at));
  Piece out = piece(name, whole({{"hem", bottom, 2.0_cm, true},
                                 {"side", side, 1.0_cm, false, {waist_at}},
                                 {"armhole", half.armhole, 1.0_cm, false, on_armhole},
                                 {"shoulder", half.shoulder},
                                 {"neck", half.neck, .7_cm}},
                                right, left));
  out.grainline = Grainline{{0, -below_waist * .7}, {0, underarm.y() * .8}};
  return out;
}

std::vector<Piece> pieces(const Measures& m) {
  const Bodice block = draft_bodice(
      m, {.bust = 8.0_cm, .armhole = 1.0_cm, .front_neck = 1.5_cm, .neck = 1.0_cm, .shoulder = 1.0_cm, .bust_dart = false});
  const double below_waist = waist_to_hip(m) - 2.0_cm;
  const double hem = (m.hip + 6.0_cm) / 4;
  const double forward = (block.front.side - block.back.side) / 2;
  return {body("FRONT", block.front, hem + forward, below_waist, {front_notch(block)}, "_left", "_right"),
          body("BACK", block.back, hem - forward, below_waist, back_notches(block), "_right", "_left"),
          draft_sleeve(
              m, block,
              {.biceps_ease = 7.0_cm, .cap_ease = 0, .length = 20.0_cm, .hem = m.upper_arm + 4.5_cm, .hem_allowance = 2.0_cm})};
}

}  // namespace

int main(int count, char** arguments) { return draft_program(count, arguments, "t_shirt", "T-SHIRT", pieces); }
