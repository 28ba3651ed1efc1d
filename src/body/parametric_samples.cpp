#include "body/parametric_samples.h"

#include <algorithm>

namespace toile {
namespace {

// How much of the women's change of shape with girth is taken over for men, of whom only one body was measured.
constexpr double share_for_men = .6;
constexpr double furthest = .7;  // of an interval of samples: how far shapes are carried beyond the last body

constexpr std::array<BodySample, 3> women = {{
    {160.3,
     80,
     86,
     {86.0, .579, 2.9, 8.2, 10.7, 3.05, 2.40},
     {83.5, .628, 2.2, 9.0, 10.5, 2.83, 2.19},
     {73.0, .604, 3.4, 9.2, 7.7, 2.11, 2.50},
     {62.0, .602, 3.3, 9.4, 4.6, 2.34, 3.22},
     {68.0, .673, 5.9, 8.2, 8.4, 2.09, 3.09},
     {80.0, .764, 2.3, 12.7, 6.8, 5.00, 2.86},
     {77.0, .598, 2.7, 9.4, 7.9, 2.74, 2.39},
     15.25,
     12.7,
     {26.6, 25.0, 22.3, 20.6, 20.3, 16.5, 15.0},
     {50.0, 43.0, 35.5, 32.2, 31.7, 33.0, 26.6, 17.1}},
    {168.0,
     88,
     94,
     {94.0, .574, 3.0, 8.9, 11.6, 3.00, 2.36},
     {90.8, .631, 2.1, 10.1, 11.3, 2.63, 2.17},
     {80.3, .645, 4.4, 9.9, 9.6, 1.90, 2.66},
     {70.0, .686, 5.2, 9.7, 7.6, 2.19, 3.15},
     {74.5, .706, 6.3, 9.3, 9.5, 2.08, 2.97},
     {88.0, .754, 2.6, 13.7, 7.7, 4.46, 2.91},
     {88.7, .543, 2.5, 10.6, 8.6, 2.29, 2.17},
     16.25,
     14.1,
     {28.7, 28.0, 24.5, 21.6, 21.3, 17.4, 16.0},
     {56.0, 49.7, 38.1, 34.2, 33.8, 35.5, 28.1, 17.7}},
    {167.5,
     110,
     116,
     {116.0, .587, 3.2, 11.4, 14.1, 3.05, 2.61},
     {111.8, .637, 2.2, 12.7, 13.7, 2.59, 2.37},
     {100.2, .747, 4.6, 13.9, 13.0, 1.73, 2.57},
     {92.0, .825, 4.1, 15.6, 10.0, 2.16, 2.46},
     {96.0, .803, 6.2, 13.4, 12.7, 2.17, 2.89},
     {110.0, .812, 0.5, 19.5, 8.3, 5.00, 2.86},
     {102.9, .638, 1.4, 14.1, 9.8, 2.81, 2.52},
     17.25,
     17.0,
     {34.0, 35.4, 28.3, 22.9, 22.6, 18.5, 17.6},
     {66.5, 54.2, 40.2, 35.7, 37.8, 41.0, 29.9, 18.0}},
}};

constexpr BodySample man = {177,
                            100,
                            100,
                            {100.0, .650, 4.5, 8.4, 15.2, 2.39, 2.68},
                            {98.9, .686, 4.4, 9.0, 15.2, 2.26, 2.68},
                            {90.6, .761, 3.0, 11.8, 12.4, 2.15, 2.35},
                            {86.0, .807, 4.4, 11.4, 12.1, 2.39, 2.41},
                            {92.8, .795, 2.4, 13.2, 11.0, 3.12, 2.92},
                            {100.0, .680, 2.3, 12.8, 11.3, 2.77, 3.04},
                            {104.3, .629, 2.4, 11.9, 12.1, 2.90, 2.75},
                            19.25,
                            17.7,
                            {33.6, 31.2, 28.3, 25.9, 26.0, 21.3, 17.5},
                            {58.1, 49.0, 38.7, 35.9, 36.9, 38.0, 30.7, 22.3}};

}  // namespace

const BodySample& reference_woman() { return women[1]; }

double interpolated(bool female, double at, const std::function<double(const BodySample&)>& key,
                    const std::function<double(const BodySample&)>& value) {
  const auto place = [&](const BodySample& a, const BodySample& b) { return (at - key(a)) / (key(b) - key(a)); };
  const auto line = [&](const BodySample& a, const BodySample& b, double t) { return value(a) + t * (value(b) - value(a)); };
  const auto [small, medium, large] = women;
  if (!female) {
    const double t = std::clamp((at - key(man)) / (key(large) - key(medium)), -furthest, 1 + furthest);
    return value(man) + share_for_men * t * (value(large) - value(medium));
  }
  if (at < key(medium)) return line(small, medium, std::max(place(small, medium), -furthest));
  return line(medium, large, std::min(place(medium, large), 1 + furthest));
}

}  // namespace toile
