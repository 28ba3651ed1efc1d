#include "body/landmarks.h"

#include <algorithm>
#include <functional>

#include "body/girth.h"

namespace toile {
namespace {

struct Level {
  double at = 0, girth = 0;
};

// The level between `low` and `high` that is best by `better`; levels without a trunk section are passed over.
Level best_level(const Mannequin& form, double low, double high, double step,
                 const std::function<bool(double, double)>& better) {
  Level best;
  for (double y = low; y <= high; y += step)
    if (const double girth = trunk_girth(form.positions, form.triangles, y);
        girth > 0 && (best.girth == 0 || better(girth, best.girth)))
      best = {y, girth};
  return best;
}

// `best_level` to a tenth of the first step.
Level refined_level(const Mannequin& form, double low, double high, double step,
                    const std::function<bool(double, double)>& better) {
  const Level rough = best_level(form, low, high, step, better);
  if (rough.girth == 0) return rough;
  return best_level(form, std::max(low, rough.at - step), std::min(high, rough.at + step), step / 10, better);
}

}  // namespace

UprightExtent upright_extent(const Mannequin& form) {
  UprightExtent extent{form.positions(1, form.triangles(0, 0)), form.positions(1, form.triangles(0, 0))};
  for (Eigen::Index t = 0; t < form.triangles.cols(); ++t)
    for (Eigen::Index c = 0; c < 3; ++c) {
      extent.low = std::min(extent.low, form.positions(1, form.triangles(c, t)));
      extent.high = std::max(extent.high, form.positions(1, form.triangles(c, t)));
    }
  return extent;
}

std::map<std::string, double> measured_landmarks(const Mannequin& form) {
  const UprightExtent extent = upright_extent(form);
  const double height = extent.high - extent.low, step = .008 * height;
  const auto at = [&](double share) { return extent.low + share * height; };
  std::map<std::string, double> levels;

  const Level waist = refined_level(form, at(.55), at(.70), step, std::less<>());
  levels["waist"] = waist.girth > 0 ? waist.at : at(.624);

  // Thighs that touch keep one section: then the legs part below any crotch, and proportion takes over.
  levels["crotch"] = at(.45);
  for (double y = at(.54); y > at(.40); y -= step / 10)
    if (trunk_girth(form.positions, form.triangles, y) == 0) {
      if (y > at(.42)) levels["crotch"] = y + step / 10;
      break;
    }

  levels["hip"] = at(.484);
  levels["high_hip"] = (levels["hip"] + levels["waist"]) / 2;
  const Level bust = refined_level(form, at(.68), at(.745), step, std::greater<>());
  levels["bust"] = bust.girth > 0 ? bust.at : at(.726);
  levels["underbust"] = levels["bust"] - .0455 * height;
  levels["armpit"] = at(.755);

  // A bone starts or ends `drop` of the height above its level.
  const auto from_bone = [&](const std::string& landmark, const std::string& bone, bool end, double drop, double share) {
    const Bone* found = find_bone(form, bone);
    levels[landmark] = found ? (end ? found->to : found->from)[1] - drop * height : at(share);
  };
  from_bone("nape", "neck", false, .0085, .841);
  from_bone("shoulder", "upperarm.L", false, 0, .80);
  from_bone("knee", "thigh.L", true, 0, .275);
  levels["ankle"] = at(.072);
  return levels;
}

}  // namespace toile
