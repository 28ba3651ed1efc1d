#include "formats/dxf_aama/profiles.h"

#include <algorithm>

namespace toile {

const DxfProfile* find_dxf_profile(std::string_view name) {
  for (const DxfProfile& profile : dxf_profiles)
    if (profile.name == name) return &profile;
  return nullptr;
}

CutSheet with_notches_as_drawn(CutSheet sheet) {
  for (PlacedPiece& placed : sheet.placed)
    for (std::size_t n = 0; n < std::min(placed.cut.notches.size(), placed.cut.piece.notches.size()); ++n)
      placed.cut.notches[n].notch = placed.cut.piece.notches[n];
  return sheet;
}

Report dxf_losses(const CutSheet& sheet, const DxfProfile& profile) {
  Report report;
  const auto lost = [&](const char* code, const char* text, const char* remedy, const auto& has) {
    std::string names;
    for (const PlacedPiece& placed : sheet.placed) {
      const std::string name = "'" + placed.cut.piece.name + "'";
      if (has(placed.cut.piece) && names.find(name) == std::string::npos) names += (names.empty() ? "" : ", ") + name;
    }
    if (!names.empty()) report.warn(code, "pieces " + names, text, remedy);
  };
  if (profile.plain_notches)
    lost("dxf.notch-kinds",
         "this profile writes every notch on layer 4: T, castle, check and U notches come back as slits or Vs",
         "Use the profile aama or astm if their kinds matter", [](const Piece& piece) {
           return std::any_of(piece.notches.begin(), piece.notches.end(),
                              [](const Notch& notch) { return notch.kind != NotchKind::slit && notch.kind != NotchKind::v; });
         });
  lost("dxf.placement", "the format does not say where a piece hangs round the body in 3D", "Keep the file it came from too",
       [](const Piece& piece) {
         return std::any_of(piece.placement.begin(), piece.placement.end(), [](const auto& at) { return at.has_value(); });
       });
  lost("dxf.edge-names", "the format has no names of edges and no hems; they are in the seams file beside it",
       "Keep the two files together", [&](const Piece& piece) {
         for (std::size_t e = 0; e < piece.outline.size(); ++e)
           if (piece.outline[e].hem || piece.outline[e].id != "e" + std::to_string(e)) return true;
         return false;
       });
  return report;
}

}  // namespace toile
