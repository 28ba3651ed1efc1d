#include "body/parametric_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "body/parametric_samples.h"
#include "garment/report.h"
#include "garment/units.h"

namespace toile {
namespace {

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

[[noreturn]] void refuse(const SizeChartRow& row, const std::string& what) {
  throw BadInput({"chart.implausible", Severity::error, row.chart + " " + row.size, what,
                  "Check the row: the measures of one adult, in centimetres in the chart"});
}

// What the girths are when only height, bust, waist and hip are known.
std::map<std::string, double> usual_girths(const SizeChartRow& row) {
  const bool female = row.female;
  std::map<std::string, double> girths = {{"bust", row.bust}, {"waist", row.waist}, {"hip", row.hip}};
  const double waist_ratio = row.waist / row.height;
  const double high_hip_share = female ? .43 - .67 * (waist_ratio - .417) : .33 - .67 * (waist_ratio - .486);
  girths["high_hip"] = row.waist + std::clamp(high_hip_share, .25, .5) * (row.hip - row.waist);
  girths["seat"] = (female ? .966 : .975) * row.hip;
  // Anchored at the measured woman; the step is that of ASTM D5585-11.
  girths["underbust"] =
      female ? std::min(.745 + .95 * (row.bust - .88), row.bust - .04) : row.waist + .49 * (row.bust - row.waist);
  girths["neck"] = female ? .335 + .17 * (row.bust - .88) : .386 + .2 * (row.bust - 1.0);
  for (std::size_t i = 0; i < arm_names.size(); ++i)
    girths[arm_names[i]] =
        row.height * interpolated(
                         female, row.bust / row.height, [](const BodySample& b) { return b.bust / b.height; },
                         [&](const BodySample& b) { return b.arm[i] / b.height; });
  for (std::size_t i = 0; i < leg_names.size(); ++i)
    girths[leg_names[i]] = row.height * interpolated(
                                            female, row.hip / row.height, [](const BodySample& b) { return b.hip / b.height; },
                                            [&](const BodySample& b) { return b.leg[i] / b.height; });
  return girths;
}

// Steeper below size 38, where half of what the hips lose would leave thighs too wide for them.
double usual_thigh_of(const SizeChartRow& row) {
  if (!row.female) return .5 * row.hip + .081;
  return .56 + (row.hip < .94 ? .75 : .5) * (row.hip - .94);
}

void complete_girths(const SizeChartRow& row, Figure& figure) {
  figure.girths = usual_girths(row);
  const auto given = [&](const char* name, double otherwise) {
    const auto found = row.others.find(name);
    return found == row.others.end() ? otherwise : found->second;
  };
  // How much of what upper arm and thigh have more or less than usual is shared by the rest of the limb.
  constexpr std::array arm_share = {1., 1., .8, .3, .3, .1, 0.};
  constexpr std::array leg_share = {1., .8, .4, .2, .2, .2, .1, 0.};
  auto& girths = figure.girths;
  const double usual_thigh = girths["thigh"], usual_arm = girths["upper_arm"];
  const double arm_factor = given("upper_arm", usual_arm) / usual_arm;
  const double thigh_factor = given("thigh", usual_thigh_of(row)) / usual_thigh;
  for (std::size_t i = 0; i < arm_names.size(); ++i) girths[arm_names[i]] *= std::pow(arm_factor, arm_share[i]);
  for (std::size_t i = 0; i < leg_names.size(); ++i) girths[leg_names[i]] *= std::pow(thigh_factor, leg_share[i]);
  for (const auto& [name, value] : row.others) {
    const auto usual = girths.find(name);
    if (usual == girths.end()) continue;
    const double base = name == "thigh" ? usual_thigh : name == "upper_arm" ? usual_arm : usual->second;
    if (!(value > .6 * base && value < 1.6 * base))
      refuse(row,
             "column '" + name + "' says " + in_mm(value, 0) + ", about " + in_mm(base, 0) + " would fit the other measures");
    usual->second = value;
  }
  if (row.female && girths["underbust"] > row.bust - .015) refuse(row, "the underbust girth is not below the bust girth");
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
  const BodySample& reference = reference_woman();
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
  for (const double value : {row.height, row.bust, row.waist, row.hip})
    if (!std::isfinite(value) || value <= 0) refuse(row, "a measure is not a positive number");
  if (row.height < 1.3 || row.height > 2.2) refuse(row, "height " + in_mm(row.height, 0) + " is outside 1300 to 2200 mm");
  const auto within = [&](const char* name, double girth, double least, double most) {
    if (girth < least * row.height || girth > most * row.height)
      refuse(row, std::string(name) + " " + in_mm(girth, 0) + " does not fit a height of " + in_mm(row.height, 0));
  };
  within("bust", row.bust, .38, .95), within("waist", row.waist, .28, .90), within("hip", row.hip, .38, 1.0);
  if (const auto leg = row.others.find("inside_leg"); leg != row.others.end()) within("inside leg", leg->second, .38, .53);
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
