#include "body/body.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "body/landmarks.h"

namespace toile {
namespace {

std::string listed(const Mannequin& form) {
  std::string names;
  for (const auto& [name, height] : form.landmarks) names += (names.empty() ? "" : ", ") + name;
  std::string text = names.empty() ? "the body has no landmarks" : "landmarks of this body: " + names;
  if (!form.bones.empty()) text += "; or BONE:FRACTION with one of its bones, e.g. " + form.bones.front().name + ":0.5";
  return text;
}

[[noreturn]] void no_such_level(const Mannequin& form, const std::string& name, const std::string& text) {
  throw BadInput({"body.no-such-level", Severity::error, "body '" + form.name + "', level '" + name + "'", text, listed(form)});
}

}  // namespace

Body make_body(Mannequin form) {
  const Report report = check_body(form, "body '" + form.name + "'", SelfIntersections::not_looked_for);
  for (const Finding& finding : report.findings)
    if (finding.severity == Severity::error) throw BadInput(finding);
  const auto [low, high] = upright_extent(form);
  if (form.height <= 0) form.height = high - low;
  for (const auto& [name, level] : measured_landmarks(form)) form.landmarks.try_emplace(name, level);
  const double scale = std::min(1.0, (high - low) / 1.6);
  DistanceField distance(form.positions, form.triangles, 6e-3 * scale, 40e-3 * scale);
  TriangleTree skin(form.positions, form.triangles);
  return {std::move(form), std::move(distance), std::move(skin)};
}

double level_height(const Mannequin& form, const std::string& name) {
  if (const auto found = form.landmarks.find(name); found != form.landmarks.end()) return found->second;
  const std::size_t colon = name.rfind(':');
  if (colon == std::string::npos) no_such_level(form, name, "the body has no such landmark");
  const Bone* bone = find_bone(form, name.substr(0, colon));
  if (!bone) no_such_level(form, name, "the body has no bone '" + name.substr(0, colon) + "'");
  double fraction = 0;
  const char* end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + colon + 1, end, fraction);
  if (read.ec != std::errc() || read.ptr != end || !(fraction >= 0 && fraction <= 1))
    no_such_level(form, name, "'" + name.substr(colon + 1) + "' is not a fraction from 0 to 1");
  return (1 - fraction) * bone->from[1] + fraction * bone->to[1];
}

}  // namespace toile
