#pragma once
// What every edit checks before and says afterwards.

#include <string>

#include "edit/operation.h"
#include "style/normal_deviation.h"

namespace toile {

// Throws std::invalid_argument when the drape is not one of the garment, or not finite.
void check_source(const EditInput& input, const std::string& operation);

std::string in_cm(double metres);        // "92.4 cm"
std::string in_degrees(double radians);  // "0.23"

// Notes how far normals turned and how far the fabric is stretched; warns when the style could not be kept.
void describe_style(Report& report, const std::string& place, const NormalDeviation& deviation);

// Warns of a target `deepest` m deeper inside the body than its source; notes one that was still moving.
void describe_end(Report& report, const std::string& place, double deepest, bool settled);

}  // namespace toile
