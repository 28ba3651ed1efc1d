#include "body/parametric.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body/girth.h"
#include "body/parametric_fit.h"
#include "body/parametric_surface.h"
#include "garment/report.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr int smoothing_rounds = 30;

Eigen::Vector3d mirrored(const Eigen::Vector3d& p) { return {-p.x(), p.y(), p.z()}; }

std::vector<Bone> skeleton(const Figure& f) {
  const double tall = f.height;
  const Eigen::Vector3d pelvis(0, f.hip_joint.y() + .0077 * tall, -.037 * tall);
  const Eigen::Vector3d spine(0, f.hip_joint.y() + .0068 * tall, .0142 * tall);
  const Eigen::Vector3d low(0, spine.y() + .45 * (f.levels.at("ribs") - spine.y()) + .012 * tall, -.0002 * tall);
  const Eigen::Vector3d middle(0, f.levels.at("ribs") - .0043 * tall, .0072 * tall);
  std::vector<Bone> bones = {{"pelvis", "", pelvis, spine},
                             {"spine_low", "pelvis", spine, low},
                             {"spine_mid", "spine_low", low, middle},
                             {"chest", "spine_mid", middle, f.neck_base},
                             {"neck", "chest", f.neck_base, f.head_joint},
                             {"head", "neck", f.head_joint, {0, tall, f.head_joint.z()}}};
  const Eigen::Vector3d clavicle(.0138 * tall, f.shoulder.y() + .0047 * tall, f.shoulder.z());
  const Eigen::Vector3d hand = f.wrist + .54 * (f.fingertip - f.wrist);
  const Eigen::Vector3d foot = f.ankle + .3 * (f.toe - f.ankle);
  const std::vector<Bone> left = {{"clavicle", "chest", clavicle, f.shoulder},
                                  {"upperarm", "clavicle", f.shoulder, f.elbow},
                                  {"forearm", "upperarm", f.elbow, f.wrist},
                                  {"hand", "forearm", f.wrist, hand},
                                  {"thigh", "pelvis", f.hip_joint, f.knee},
                                  {"shin", "thigh", f.knee, f.ankle},
                                  {"foot", "shin", f.ankle, foot}};
  const auto sided = [](const std::string& name, const char* side) {
    return name == "chest" || name == "pelvis" ? name : name + side;
  };
  for (const Bone& bone : left) bones.push_back({bone.name + ".L", sided(bone.parent, ".L"), bone.from, bone.to});
  for (const Bone& bone : left)
    bones.push_back({bone.name + ".R", sided(bone.parent, ".R"), mirrored(bone.from), mirrored(bone.to)});
  return bones;
}

std::map<std::string, double> taped(const Surface& surface, const Figure& figure) {
  std::map<std::string, double> girths;
  for (const auto& [name, place] : tape_places(figure))
    girths[name] = place.trunk ? trunk_girth(surface.positions, surface.triangles, place.at.y())
                               : limb_girth(surface.positions, surface.triangles, place.at, place.along);
  return girths;
}

// Flat triangles cut the corners of the form, so the form is fitted once more, to what the first surface lacked.
Surface fitted_surface(const Figure& figure, Net& net) {
  Figure aim = figure;
  {
    const BodyForm form(aim, fitted_scales(aim));
    net.points = laid_out_like(net, form, aim);
    even_out(net, form, smoothing_rounds);
  }
  for (const auto& [name, girth] : taped(mirrored_surface(net), figure))
    if (figure.girths.count(name)) aim.girths[name] += std::clamp(figure.girths.at(name) - girth, -.01, .01);
  even_out(net, BodyForm(aim, fitted_scales(aim)), 4);
  return mirrored_surface(net);
}

// Within 5 mm of the chart, or there is no such body.
void check_reached(const SizeChartRow& row, const Figure& figure, const std::map<std::string, double>& measures) {
  for (const auto& [name, girth] : figure.girths)
    if (const auto found = measures.find(name); found != measures.end() && !(std::abs(found->second - girth) < 5e-3))
      throw BadInput({"chart.implausible", Severity::error, row.chart + " " + row.size,
                      "no body has these measures together: " + name + " comes out at " + in_mm(found->second, 0) +
                          " instead of " + in_mm(girth, 0),
                      "Check the row: the measures of one adult, in centimetres in the chart"});
}

}  // namespace

Mannequin build_mannequin(const SizeChartRow& row, const MannequinOptions& options) {
  if (!(options.edge_length >= 4e-3 && options.edge_length <= 18e-3))
    throw std::invalid_argument("edge length of a mannequin must be between 4 and 18 mm");
  const Figure figure = complete_figure(row);
  const Figure reference = complete_figure({});
  Net net = lay_out_net(BodyForm(reference, {}), reference, options.edge_length);
  const Surface surface = fitted_surface(figure, net);

  Mannequin mannequin;
  mannequin.name = row.chart + " " + row.size;
  mannequin.positions = surface.positions;
  mannequin.triangles = surface.triangles;
  mannequin.bones = skeleton(figure);
  mannequin.height = row.height;
  mannequin.landmarks = figure.levels;
  mannequin.landmarks["height"] = row.height;
  mannequin.measures = taped(surface, figure);
  check_reached(row, figure, mannequin.measures);
  mannequin.measures["height"] = row.height;
  mannequin.measures["inside_leg"] = figure.levels.at("crotch");
  mannequin.measures["nape_to_waist"] = figure.levels.at("nape") - figure.levels.at("waist");
  mannequin.measures["upper_arm_length"] = (figure.elbow - figure.shoulder).norm();
  mannequin.measures["forearm_length"] = (figure.wrist - figure.elbow).norm();
  return mannequin;
}

}  // namespace toile
