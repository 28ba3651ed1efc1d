#include "body/parametric_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "body/girth.h"
#include "body/parametric_rays.h"

namespace toile {
namespace {

constexpr int rays = 128;
constexpr int rounds = 10;

// Height of the body's lowest point on the midplane between the legs.
double crotch_height(const BodyForm& form, const Figure& figure) {
  const double z = form.trunk().section(figure.levels.at("crotch")).centre_v;
  double below = figure.levels.at("knee"), above = figure.levels.at("hip");
  for (double y = below; y < above; y += .004)
    if (form.distance({0, y, z}) < 0) {
      above = y;
      break;
    } else {
      below = y;
    }
  for (int i = 0; i < 14; ++i) {
    const double middle = (below + above) / 2;
    (form.distance({0, middle, z}) < 0 ? above : below) = middle;
  }
  return (above + below) / 2;
}

}  // namespace

std::map<std::string, TapePlace> tape_places(const Figure& figure) {
  std::map<std::string, TapePlace> places;
  const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  const auto& y = figure.levels;
  for (const char* name : {"hip", "seat", "high_hip", "waist", "underbust", "bust"}) {
    const Section& s = figure.sections.at(name);
    places[name] = {{0, y.at(name), s.centre_v + (s.front - s.back) / 2}, up, true};
  }
  const auto on_leg = [&](const char* name, double height) {
    const double t = (figure.hip_joint.y() - height) / (figure.hip_joint.y() - figure.knee.y());
    const double s = (figure.knee.y() - height) / (figure.knee.y() - figure.ankle.y());
    Eigen::Vector3d at = t < 1 ? Eigen::Vector3d(figure.hip_joint + t * (figure.knee - figure.hip_joint))
                               : Eigen::Vector3d(figure.knee + s * (figure.ankle - figure.knee));
    if (name == std::string("thigh")) at.x() = figure.sections.at(name).half_width + .01, at.z() += .02;
    places[name] = {at, up, false};
  };
  on_leg("thigh", y.at("crotch") - .02);
  for (const char* name : {"mid_thigh", "above_knee", "knee", "below_knee", "calf", "low_calf", "ankle"})
    on_leg(name, y.at(name));
  const auto on_bone = [&](const char* name, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t) {
    places[name] = {a + t * (b - a), (b - a).normalized(), false};
  };
  on_bone("upper_arm", figure.shoulder, figure.elbow, .55);
  on_bone("above_elbow", figure.shoulder, figure.elbow, .85);
  on_bone("forearm", figure.elbow, figure.wrist, .25);
  on_bone("low_forearm", figure.elbow, figure.wrist, .60);
  on_bone("wrist", figure.elbow, figure.wrist, .95);
  places["elbow"] = {figure.elbow, (figure.wrist - figure.shoulder).normalized(), false};
  on_bone("neck", figure.neck_base, figure.head_joint, .5);
  places["neck"].at.z() += .014;
  return places;
}

double tape_on_form(const BodyForm& form, const TapePlace& place) {
  const Eigen::Vector3d n = place.along.normalized();
  const Eigen::Vector3d first =
      (std::abs(n.x()) < .8 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ()).cross(n).normalized();
  return loop_girth(ring(form, place.at, first, n, rays), n, GirthKind::tape);
}

FormScales fitted_scales(const Figure& figure) {
  FormScales scales;
  const std::map<std::string, TapePlace> places = tape_places(figure);
  double bust_step = .02, last_error = 0, last_forward = 0;
  for (int round = 0; round < rounds; ++round) {
    const BodyForm form(figure, scales);
    double worst = 0;
    for (const auto& [name, place] : places) {
      if (!figure.girths.count(name)) continue;
      const double error = tape_on_form(form, place) - figure.girths.at(name);
      worst = std::max(worst, std::abs(error));
      if (name == "bust" && figure.female) {
        // Secant on how far the breasts stand out; a girth grows by about 1.2 per unit of it.
        double rate = 1.2;
        if (round > 0 && std::abs(scales.bust_forward - last_forward) > 1e-5)
          rate = std::clamp((error - last_error) / (scales.bust_forward - last_forward), .4, 3.0);
        last_error = error, last_forward = scales.bust_forward;
        scales.bust_forward -= std::clamp(error / rate, -bust_step, bust_step);
        continue;
      }
      double& scale = scales.sections.try_emplace(name, 1.0).first->second;
      scale = std::clamp(scale * figure.girths.at(name) / (figure.girths.at(name) + error), .6, 1.5);
    }
    const double crotch = crotch_height(form, figure) - figure.levels.at("crotch");
    scales.crotch_drop = std::clamp(scales.crotch_drop + crotch, -.03, .03);
    if (worst < 3e-4 && std::abs(crotch) < 5e-4) break;
  }
  return scales;
}

}  // namespace toile
