#include "body/parametric_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "garment/report.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr double cm = 1 / cm_per_m;

// Horizontal section of the trunk as measured, cm. The girth is the tape's.
struct TrunkSample {
  double girth, depth_to_width, centre, front, back, front_exponent, back_exponent;
};

struct BodySample {
  double height, bust, hip;  // cm
  TrunkSample hip_section, seat, high_hip, waist, underbust, bust_section, armpit;
  double shoulder_x, cage_half_width;
  std::array<double, 7> arm;  // girths at upper_arm_root, upper_arm, above_elbow, elbow, forearm, low_forearm, wrist
  std::array<double, 8> leg;  // thigh, mid_thigh, above_knee, knee, below_knee, calf, low_calf, ankle
};

constexpr std::array arm_names = {"upper_arm_root", "upper_arm", "above_elbow", "elbow", "forearm", "low_forearm", "wrist"};
constexpr std::array leg_names = {"thigh", "mid_thigh", "above_knee", "knee", "below_knee", "calf", "low_calf", "ankle"};

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

// How much of the women's change of shape with girth is taken over for men, of whom only one body was measured.
constexpr double share_for_men = .6;
constexpr double furthest = .7;  // of an interval of samples: how far shapes are carried beyond the last body

// A figure of the samples as a function of a ratio (girth to stature) of the samples.
template <class Key, class Value>
double interpolated(bool female, double at, Key key, Value value, double reach = furthest) {
  const auto line = [&](const BodySample& a, const BodySample& b, double t) { return value(a) + t * (value(b) - value(a)); };
  const auto between = [&](const BodySample& a, const BodySample& b) { return (at - key(a)) / (key(b) - key(a)); };
  if (!female) {
    const double t = std::clamp((at - key(man)) / (key(women[2]) - key(women[1])), -reach, 1 + reach);
    return value(man) + share_for_men * t * (value(women[2]) - value(women[1]));
  }
  if (at < key(women[1])) return line(women[0], women[1], std::max(between(women[0], women[1]), -reach));
  return line(women[1], women[2], std::min(between(women[1], women[2]), 1 + reach));
}

Section with_girth(Section section, double girth) { return scaled(section, girth / section_girth(section)); }

Section trunk_section(bool female, double height, double girth, const TrunkSample BodySample::*level) {
  const auto key = [&](const BodySample& b) { return (b.*level).girth / b.height; };
  const auto shape = [&](auto value) { return interpolated(female, girth / height, key, value); };
  const double depth_to_width = shape([&](const BodySample& b) { return (b.*level).depth_to_width; });
  const double front_share =
      shape([&](const BodySample& b) { return (b.*level).front / ((b.*level).front + (b.*level).back); });
  const double middle =
      shape([&](const BodySample& b) { return ((b.*level).centre + ((b.*level).front - (b.*level).back) / 2) / b.height; });
  Section section;
  section.half_width = .5;
  section.front = depth_to_width * front_share, section.back = depth_to_width * (1 - front_share);
  section.front_exponent = shape([&](const BodySample& b) { return (b.*level).front_exponent; });
  section.back_exponent = shape([&](const BodySample& b) { return (b.*level).back_exponent; });
  section = with_girth(section, girth);
  section.centre_v = middle * height - (section.front - section.back) / 2;
  return section;
}

Section ellipse(double girth, double depth_to_width) {
  return with_girth({0, 0, .5, .5 * depth_to_width, .5 * depth_to_width, 2, 2}, girth);
}

struct Proportion {
  const char* name;
  double women, men;
};

// Height above the floor / stature.
constexpr Proportion proportions[] = {{"nape", .842, .840},       {"shoulder", .800, .797},    {"armpit", .757, .753},
                                      {"bust", .726, .732},       {"underbust", .6805, .6865}, {"ribs", .652, .655},
                                      {"waist", .624, .623},      {"high_hip", .552, .568},    {"seat", .504, .524},
                                      {"hip", .480, .513},        {"crotch", .450, .482},      {"mid_thigh", .361, .387},
                                      {"above_knee", .308, .326}, {"knee", .272, .292},        {"below_knee", .236, .258},
                                      {"calf", .202, .228},       {"low_calf", .137, .153},    {"ankle", .071, .077}};

void place_levels(const SizeChartRow& row, Figure& figure) {
  for (const Proportion& p : proportions) figure.levels[p.name] = (row.female ? p.women : p.men) * row.height;
  if (const auto inside_leg = row.others.find("inside_leg"); inside_leg != row.others.end()) {
    const double waist = figure.levels["waist"], before = figure.levels["crotch"], crotch = inside_leg->second;
    for (auto& [name, y] : figure.levels)
      if (y <= before)
        y *= crotch / before;
      else if (y < waist)
        y = waist - (waist - y) * (waist - crotch) / (waist - before);
  }
  figure.levels["floor"] = 0;
}

void complete_girths(const SizeChartRow& row, Figure& figure) {
  const bool female = row.female;
  const double height = row.height;
  auto& girths = figure.girths;
  const auto bust_key = [](const BodySample& b) { return b.bust / b.height; };
  const auto hip_key = [](const BodySample& b) { return b.hip / b.height; };
  const double waist_to_hip = row.hip - row.waist;
  girths["bust"] = row.bust, girths["waist"] = row.waist, girths["hip"] = row.hip;
  const double waist_ratio = row.waist / height;
  const double high_hip_share = female ? .43 - .67 * (waist_ratio - .417) : .33 - .67 * (waist_ratio - .486);
  girths["high_hip"] = row.waist + std::clamp(high_hip_share, .25, .5) * waist_to_hip;
  girths["seat"] = (female ? .966 : .975) * row.hip;  // men: shape only, see below
  // Anchored at the measured body; the step is that of ASTM D5585-11.
  girths["underbust"] = female ? .745 + .95 * (row.bust - .88) : row.waist + .49 * (row.bust - row.waist);
  if (female) girths["underbust"] = std::min(girths["underbust"], row.bust - .04);
  girths["neck"] = female ? .335 + .17 * (row.bust - .88) : .386 + .2 * (row.bust - 1.0);
  girths["thigh"] = .5 * row.hip + (female ? .09 : .081);
  const double regressed_arm =
      height * interpolated(female, row.bust / height, bust_key, [](const BodySample& b) { return b.arm[1] / b.height; });
  const double regressed_thigh =
      height * interpolated(female, row.hip / height, hip_key, [](const BodySample& b) { return b.leg[0] / b.height; });
  girths["upper_arm"] = regressed_arm;
  for (const auto& [name, value] : row.others)
    if (name != "upper_arm" && name != "thigh" && girths.count(name) == 0)
      continue;
    else
      girths[name] = value;
  const double arm_factor = girths["upper_arm"] / regressed_arm, thigh_factor = girths["thigh"] / regressed_thigh;
  constexpr std::array arm_share = {1., 1., .8, .3, .3, .1, 0.};
  constexpr std::array leg_share = {1., .8, .4, .2, .2, .2, .1, 0.};
  for (std::size_t i = 0; i < arm_names.size(); ++i)
    if (i != 1)
      girths[arm_names[i]] =
          std::pow(arm_factor, arm_share[i]) * height *
          interpolated(female, row.bust / height, bust_key, [&](const BodySample& b) { return b.arm[i] / b.height; });
  for (std::size_t i = 1; i < leg_names.size(); ++i)
    girths[leg_names[i]] =
        std::pow(thigh_factor, leg_share[i]) * height *
        interpolated(female, row.hip / height, hip_key, [&](const BodySample& b) { return b.leg[i] / b.height; });
  for (const auto& [name, value] : row.others)
    if (girths.count(name)) girths[name] = value;
}

void shape_sections(Figure& figure) {
  const bool female = figure.female;
  const double height = figure.height;
  const auto trunk = [&](const char* name, const TrunkSample BodySample::*level) {
    figure.sections[name] = trunk_section(female, height, figure.girths.at(name), level);
  };
  trunk("hip", &BodySample::hip_section), trunk("seat", &BodySample::seat), trunk("high_hip", &BodySample::high_hip);
  trunk("waist", &BodySample::waist), trunk("underbust", &BodySample::underbust);
  if (female) {
    // The rib cage under the breasts: as wide as the bust line, as deep as below the breasts.
    const double width_share = interpolated(
        female, figure.girths.at("bust") / height, [](const BodySample& b) { return b.bust / b.height; },
        [](const BodySample& b) { return b.cage_half_width / b.bust; });
    const Section& below = figure.sections["underbust"];
    const double depth = below.front + below.back, back = below.centre_v - below.back - .0083 * height;
    const double half_width = width_share * std::min(figure.girths.at("bust"), 1.3 * figure.girths.at("underbust"));
    const Section cage{0, back + .527 * depth, half_width, .473 * depth, .527 * depth, 2.2, 2.8};
    figure.sections["bust"] = cage;
  } else {
    trunk("bust", &BodySample::bust_section);
  }
  constexpr std::array arm_ratio = {1.07, 1.09, 1.10, 1.05, .94, .97, 1.19};
  constexpr std::array leg_ratio_women = {1.02, 1.09, 1.07, 1.03, .98, 1.04, 1.12, 1.26};
  constexpr std::array leg_ratio_men = {1.05, 1.04, 1.06, 1.13, 1.10, 1.01, 1.01, 1.45};
  for (std::size_t i = 0; i < arm_names.size(); ++i)
    figure.sections[arm_names[i]] = ellipse(figure.girths.at(arm_names[i]), arm_ratio[i]);
  for (std::size_t i = 0; i < leg_names.size(); ++i)
    figure.sections[leg_names[i]] = ellipse(figure.girths.at(leg_names[i]), (female ? leg_ratio_women : leg_ratio_men)[i]);
}

void place_joints(Figure& figure) {
  const bool female = figure.female;
  const double height = figure.height;
  const auto bust_key = [](const BodySample& b) { return b.bust / b.height; };
  const auto& y = figure.levels;
  double shoulder_x = height * interpolated(female, figure.girths["bust"] / height, bust_key,
                                            [](const BodySample& b) { return b.shoulder_x / b.height; });
  // An arm 45 degrees down must leave the trunk above the bust line, so heavy arms on a wide rib cage move out.
  const double arm_radius = figure.girths["upper_arm_root"] / 6.283;
  const double pit = y.at("shoulder") + shoulder_x - figure.sections["bust"].half_width - std::sqrt(2.) * arm_radius - .006;
  shoulder_x += std::max(0., y.at("bust") + .022 * height - pit);
  figure.shoulder = {shoulder_x, y.at("shoulder"), (female ? .0127 : .0103) * height};
  const double upper_arm = (female ? .1414 : .1455) * height, forearm = (female ? .1262 : .1521) * height;
  figure.elbow = figure.shoulder + upper_arm * std::sqrt(.5) * Eigen::Vector3d(1, -1, 0);
  figure.wrist = figure.elbow + forearm * Eigen::Vector3d(.1499, -.1499, female ? .0374 : .0374).normalized();
  figure.fingertip = figure.wrist + .104 * height * Eigen::Vector3d(.0609, -.0664, .027).normalized();
  figure.hip_joint = {(female ? .0574 : .0627) * height, (y.at("crotch") / height + (female ? .0464 : .0496)) * height,
                      (female ? .0106 : -.0044) * height};
  figure.knee = {(female ? .0735 : .0811) * height, y.at("knee"), (female ? .0292 : .0155) * height};
  figure.ankle = {(female ? .0836 : .1014) * height, (female ? .0415 : .0413) * height, (female ? .0183 : .0088) * height};
  figure.toe = figure.ankle + Eigen::Vector3d(.014 * height, -.0275 * height, .112 * height);
  figure.neck_base = {0, (female ? .851 : .858) * height, (female ? -.0008 : .0067) * height};
  figure.head_joint = {0, (female ? .9149 : .9136) * height, (female ? .0249 : .0275) * height};
  const BodySample& reference = women[1];
  figure.shoulder_factor = shoulder_x / height / (reference.shoulder_x / reference.height);
  figure.neck_factor = figure.girths["neck"] / height / (33.5 / reference.height);
  const auto chest = [&](auto reach) {
    return height * (interpolated(female, figure.girths["bust"] / height, bust_key,
                                  [&](const BodySample& b) { return reach(b) / b.height; }) -
                     reach(reference) / reference.height);
  };
  figure.chest_front = chest([](const BodySample& b) { return b.armpit.centre + b.armpit.front; });
  figure.chest_back = chest([](const BodySample& b) { return b.armpit.centre - b.armpit.back; });
}

void check_row(const SizeChartRow& row) {
  const auto refuse = [&](const std::string& what) {
    throw BadInput({"chart.implausible", Severity::error, row.chart + " " + row.size, what,
                    "Measures are height, bust, waist and hip of one adult, in centimetres in the chart"});
  };
  for (const double value : {row.height, row.bust, row.waist, row.hip})
    if (!std::isfinite(value) || value <= 0) refuse("a measure is not a positive number");
  if (row.height < 1.3 || row.height > 2.2) refuse("height " + in_mm(row.height, 0) + " is outside 1300 to 2200 mm");
  const auto within = [&](const char* name, double girth, double least, double most) {
    if (girth < least * row.height || girth > most * row.height)
      refuse(std::string(name) + " " + in_mm(girth, 0) + " does not fit a height of " + in_mm(row.height, 0));
  };
  within("bust", row.bust, .38, .95), within("waist", row.waist, .28, .90), within("hip", row.hip, .40, 1.0);
}

}  // namespace

Figure complete_figure(const SizeChartRow& row) {
  check_row(row);
  Figure figure;
  figure.female = row.female;
  figure.height = row.height;
  place_levels(row, figure);
  complete_girths(row, figure);
  shape_sections(figure);
  // A man's seat lies so close above his hip line that one girth settles both.
  if (!row.female) figure.girths.erase("seat");
  place_joints(figure);
  const auto span = row.others.find("bust_point_distance");
  figure.bust_point_distance = span != row.others.end() ? span->second : .195 + .125 * (row.bust - .88);
  return figure;
}

}  // namespace toile
