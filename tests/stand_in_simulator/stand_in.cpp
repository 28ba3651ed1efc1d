// stand_in_simulator FOLDER SIMULATOR [MISDEED]: drapes what is in FOLDER as SIMULATOR of toile does, from the files alone, so
// that what the protocol does not carry is missed. With a MISDEED it does what other programs do on bad days.

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "drape/simulator.h"

namespace {

using namespace toile;

struct Obj {
  std::vector<Eigen::Vector3d> v;
  std::vector<Eigen::Vector2d> vt;
  std::vector<std::vector<std::array<int, 6>>> groups;  // faces: three v, three vt, from 0
};

Obj read_obj(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("no " + file);
  Obj obj;
  for (std::string line, kind; std::getline(in, line);) {
    std::istringstream words(line);
    words >> kind;
    if (kind == "v") {
      Eigen::Vector3d at;
      words >> at.x() >> at.y() >> at.z();
      obj.v.push_back(at);
    } else if (kind == "vt") {
      Eigen::Vector2d at;
      words >> at.x() >> at.y();
      obj.vt.push_back(at);
    } else if (kind == "g" || (kind == "f" && obj.groups.empty())) {
      obj.groups.emplace_back();
    }
    if (kind != "f") continue;
    std::array<int, 6> face{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::string corner;
      words >> corner;
      face[i] = std::stoi(corner) - 1;
      if (const auto slash = corner.find('/'); slash != std::string::npos)
        face[i + 3] = std::stoi(corner.substr(slash + 1)) - 1;
    }
    obj.groups.back().push_back(face);
  }
  return obj;
}

Eigen::Matrix3Xd columns(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd x(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) x.col(static_cast<Eigen::Index>(i)) = points[i];
  return x;
}

GarmentMesh garment_of(const Obj& obj, const nlohmann::json& request) {
  GarmentMesh garment;
  garment.vertex_count = static_cast<int>(obj.v.size());
  std::vector<Eigen::Vector3i> all;
  std::size_t first_layer = 0;
  for (const auto& group : obj.groups) {
    std::map<int, int> own;  // vt -> panel vertex
    std::map<int, int> weld;
    for (const auto& face : group)
      for (std::size_t i = 0; i < 3; ++i) weld[face[i + 3]] = face[i];
    for (const auto& [vt, v] : weld) own.emplace(vt, static_cast<int>(own.size()));
    PanelMesh panel;
    panel.rest.resize(2, static_cast<Eigen::Index>(own.size()));
    Eigen::VectorXi welded(static_cast<Eigen::Index>(own.size()));
    for (const auto& [vt, i] : own) {
      panel.rest.col(i) = obj.vt[static_cast<std::size_t>(vt)];
      welded(i) = weld[vt];
    }
    panel.triangles.resize(3, static_cast<Eigen::Index>(group.size()));
    for (std::size_t t = 0; t < group.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i)
        panel.triangles(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(t)) = own[group[t][i + 3]];
      all.emplace_back(group[t][0], group[t][1], group[t][2]);
    }
    if (request.contains("layers")) {
      panel.layers.resize(static_cast<Eigen::Index>(group.size()));
      for (std::size_t t = 0; t < group.size(); ++t)
        panel.layers(static_cast<Eigen::Index>(t)) = request["layers"].at(first_layer + t).get<double>();
    }
    first_layer += group.size();
    garment.panels.push_back(std::move(panel));
    garment.welded.push_back(std::move(welded));
  }
  garment.triangles.resize(3, static_cast<Eigen::Index>(all.size()));
  for (std::size_t t = 0; t < all.size(); ++t) garment.triangles.col(static_cast<Eigen::Index>(t)) = all[t];
  return garment;
}

Body body_of(const Obj& obj) {
  Mannequin form;
  form.name = "body";
  form.positions = columns(obj.v);
  std::vector<std::array<int, 6>> faces;
  for (const auto& group : obj.groups) faces.insert(faces.end(), group.begin(), group.end());
  form.triangles.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t t = 0; t < faces.size(); ++t)
    form.triangles.col(static_cast<Eigen::Index>(t)) << faces[t][0], faces[t][1], faces[t][2];
  return {form, DistanceField(form.positions, form.triangles), TriangleTree(form.positions, form.triangles)};
}

nlohmann::json read_json(const std::string& file) {
  std::ifstream in(file);
  return nlohmann::json::parse(in);
}

Fabric fabric_of(const nlohmann::json& json) {
  Fabric fabric;
  const auto take = [&](const char* name, double& field) { field = json.at(name).get<double>(); };
  take("area_density", fabric.area_density);
  take("stretch_warp", fabric.stretch_warp);
  take("stretch_weft", fabric.stretch_weft);
  take("stretch_cross", fabric.stretch_cross);
  take("shear", fabric.shear);
  take("bend_warp", fabric.bend_warp);
  take("bend_weft", fabric.bend_weft);
  take("friction", fabric.friction);
  take("thickness", fabric.thickness);
  take("most_stretch", fabric.most_stretch);
  return fabric;
}

void misbehave_before(const std::string& misdeed) {
  if (misdeed == "fail") {
    std::cerr << "cannot open display\n";
    std::exit(3);
  }
  if (misdeed == "crash") std::abort();
  if (misdeed == "write-nothing") std::exit(0);
  if (misdeed == "hang")
    for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
}

void misbehave_after(const std::string& misdeed, Eigen::Matrix3Xd& x) {
  if (misdeed == "lose-a-vertex") x.conservativeResize(3, x.cols() - 1);
  if (misdeed == "explode") x(1, 2) = std::nan("");
  if (misdeed == "use-centimetres") x *= 100;
  if (misdeed == "fall") x.row(1).array() -= 1000;
}

void write_result(const std::string& folder, const Eigen::Matrix3Xd& x, const Obj& garment, bool by_panel) {
  std::ofstream out(folder + "/drape.obj");
  out.precision(17);
  const auto write = [&](Eigen::Index v) { out << "v " << x(0, v) << ' ' << x(1, v) << ' ' << x(2, v) << '\n'; };
  if (!by_panel) {
    for (Eigen::Index v = 0; v < x.cols(); ++v) write(v);
    return;
  }
  std::vector<int> vertex(garment.vt.size());
  for (const auto& group : garment.groups)
    for (const auto& face : group)
      for (std::size_t i = 0; i < 3; ++i) vertex[static_cast<std::size_t>(face[i + 3])] = face[i];
  for (const int v : vertex) write(v);
}

int drape(const std::string& folder, const std::string& simulator, const std::string& misdeed) {
  misbehave_before(misdeed);
  const auto asked = read_json(folder + "/request.json");
  const Obj cloth = read_obj(folder + "/garment.obj");
  const GarmentMesh garment = garment_of(cloth, asked);
  const Eigen::Matrix3Xd start = columns(cloth.v);
  const Body body = body_of(read_obj(folder + "/body.obj"));
  const Fabric fabric = fabric_of(read_json(folder + "/fabric.json"));
  Drape made = find_simulator(simulator).drape({.garment = garment,
                                                .start = start,
                                                .body = body,
                                                .fabric = fabric,
                                                .tolerance = asked.at("tolerance"),
                                                .time_limit = asked.at("time_limit").get<double>()});
  misbehave_after(misdeed, made.positions);
  write_result(folder, made.positions, cloth, misdeed == "loose-panels");
  std::ofstream(folder + "/state.json") << nlohmann::json{{"settled", made.settled}, {"steps", made.steps}};
  if (misdeed == "hang-at-the-end") misbehave_before("hang");
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count < 3) {
    std::cerr << "stand_in_simulator FOLDER SIMULATOR [MISDEED]\n";
    return 2;
  }
  try {
    return drape(words[1], words[2], count > 3 ? words[3] : "");
  } catch (const std::exception& trouble) {
    std::cerr << trouble.what() << '\n';
    return 1;
  }
}
