#pragma once
// One panel of a GarmentCode specification as a piece.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct GarmentCodeUnits {
  double metres = .01;          // of one unit of the file
  bool relative_curves = true;  // control points in the frame of their edge
};

// The panel `name`, one copy, placed. Nothing after an error "garmentcode.*"; `file` is named in findings.
std::optional<Piece> read_panel(const nlohmann::json& panel, const std::string& name, const GarmentCodeUnits& units,
                                const std::string& file, Report& report);

}  // namespace toile
