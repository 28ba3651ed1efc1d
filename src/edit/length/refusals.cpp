#include "edit/length/refusals.h"

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "garment/units.h"

namespace toile {
namespace {

const char* const by_place = "edit 'length', by";

// Shortening at which `share` of the bearing area of the whole garment has been passed by the loop; none when it never is.
std::optional<double> shortening_that_loses(const EditInput& input, const std::vector<Handle>& handles,
                                            const ContactRegion& contact, const Eigen::VectorXd& areas, double share) {
  double all = 0;
  for (Eigen::Index v = 0; v < areas.size(); ++v) all += contact.bearing[static_cast<std::size_t>(v)] ? areas(v) : 0;
  std::vector<std::pair<double, double>> passed;  // distance from the loop, area
  std::set<int> counted;
  for (const Handle& handle : handles)
    for (Eigen::Index v = 0; v < areas.size(); ++v) {
      const double above = handle.level - handle.axis.dot(input.drape.col(v));
      const bool follows = std::binary_search(handle.moving.begin(), handle.moving.end(), static_cast<int>(v));
      // Beyond the anchor only what is on the loop's own axis counts: a trunk's, not the other sleeve's.
      const bool upright = handle.axis.y() < -0.99;
      if (!contact.bearing[static_cast<std::size_t>(v)] || above <= 0 || !(follows || upright)) continue;
      if (counted.insert(static_cast<int>(v)).second) passed.emplace_back(above, areas(v));
    }
  std::sort(passed.begin(), passed.end());
  double lost = 0;
  for (const auto& [above, area] : passed) {
    lost += area;
    if (lost > share * all) return above;
  }
  return std::nullopt;
}

}  // namespace

void refuse_impossible(const EditInput& input, const std::vector<Handle>& handles, const ContactRegion& contact,
                       const Eigen::VectorXd& areas, double by) {
  const auto falls = by < 0 ? shortening_that_loses(input, handles, contact, areas, 0.5) : std::nullopt;
  if (falls && -by > *falls)
    throw BadInput({"edit.slips-off", Severity::error, by_place,
                    in_mm(-by, 0) + " shorter, the garment would lose most of what it hangs by and slip off the body",
                    "shorten by less than " + in_mm(*falls, 0)});
  for (const Handle& handle : handles) {
    const double most = std::max(0.0, 0.75 * handle.room);
    if (by < 0 && -by > most)
      throw BadInput({"edit.past-anchor", Severity::error, by_place,
                      in_mm(-by, 0) + " shorter is too much for the " + in_mm(std::max(0.0, handle.room), 0) +
                          " between the loop and its anchor",
                      "at most " + in_mm(most, 0) + " with this anchor; or name an anchor farther from the loop"});
    double lowest = 1e9;
    for (const int v : handle.loop) lowest = std::min(lowest, input.drape(1, v));
    const double drop = -handle.axis.y() * by;
    if (drop > 0 && lowest - drop < 0)
      throw BadInput({"edit.below-floor", Severity::error, by_place,
                      in_mm(std::abs(by), 0) + (by > 0 ? " longer" : " shorter") + ", the loop would be " +
                          in_mm(drop - lowest, 0) + " below the floor",
                      "at most " + in_mm(std::max(0.0, lowest) / std::abs(handle.axis.y()), 0)});
  }
}

}  // namespace toile
