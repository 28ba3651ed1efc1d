#pragma once
// NAME.skeleton.json: what a body's mesh cannot say - bones, heights of levels, measures. Format: README.md beside this file.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "garment/mannequin.h"
#include "garment/report.h"

namespace toile {

struct Skeleton {
  std::string name;
  std::vector<Bone> bones;
  std::map<std::string, double> landmarks, measures;  // m
  std::optional<double> height;                       // m
};

// Errors "skeleton.malformed" (FILE:LINE for broken JSON, else the field), "skeleton.no-such-parent", "skeleton.unknown-unit";
// warnings "skeleton.unknown-landmark".
Loaded<Skeleton> read_skeleton_text(const std::string& text, const std::string& place);

std::string skeleton_text(const Mannequin& mannequin);

}  // namespace toile
