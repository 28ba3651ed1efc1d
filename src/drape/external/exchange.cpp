#include "drape/external/exchange.h"

#include <unistd.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "garment/report.h"

namespace toile::external {
namespace {

namespace fs = std::filesystem;

std::string number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

Eigen::Vector3d to_theirs(const Eigen::Vector3d& x, const Program& program) {
  const Eigen::Vector3d turned = program.z_up ? Eigen::Vector3d(x.x(), -x.z(), x.y()) : x;
  return turned / program.unit;
}

Eigen::Vector3d to_ours(const Eigen::Vector3d& x, const Program& program) {
  return program.unit * (program.z_up ? Eigen::Vector3d(x.x(), x.z(), -x.y()) : x);
}

void add_vertices(const Eigen::Matrix3Xd& x, const Program& program, std::string& text) {
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const Eigen::Vector3d at = to_theirs(x.col(v), program);
    text += "v " + number(at.x()) + ' ' + number(at.y()) + ' ' + number(at.z()) + '\n';
  }
}

// Turned so that the grain is +v.
Eigen::Matrix2Xd along_grain(const PanelMesh& panel) {
  Eigen::Matrix2d turn;
  turn << panel.warp.y(), -panel.warp.x(), panel.warp.x(), panel.warp.y();
  return turn * panel.rest;
}

std::string garment_text(const GarmentMesh& garment, const Eigen::Matrix3Xd& start, const Program& program) {
  std::string text = "# v: start, vt: rest shape with the grain along +v, one group a panel\n";
  add_vertices(start, program, text);
  for (const PanelMesh& panel : garment.panels) {
    const Eigen::Matrix2Xd rest = along_grain(panel) / program.unit;
    for (Eigen::Index v = 0; v < rest.cols(); ++v) text += "vt " + number(rest(0, v)) + ' ' + number(rest(1, v)) + '\n';
  }
  Eigen::Index first = 1;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    std::string name = panel.name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
    text += "g " + name + '\n';
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
      text += 'f';
      for (const int v : panel.triangles.col(t))
        text += ' ' + std::to_string(garment.welded[p](v) + 1) + '/' + std::to_string(first + v);
      text += '\n';
    }
    first += panel.rest.cols();
  }
  return text;
}

std::string body_text(const Mannequin& form, const Program& program) {
  std::string text;
  add_vertices(form.positions, program, text);
  for (Eigen::Index t = 0; t < form.triangles.cols(); ++t) {
    text += 'f';
    for (const int v : form.triangles.col(t)) text += ' ' + std::to_string(v + 1);
    text += '\n';
  }
  return text;
}

Eigen::Index panel_vertices(const GarmentMesh& garment) {
  Eigen::Index count = 0;
  for (const PanelMesh& panel : garment.panels) count += panel.rest.cols();
  return count;
}

double mean_edge(const GarmentMesh& garment) {
  double sum = 0;
  for (const Eigen::Matrix2d& shape : rest_triangles(garment))
    sum += shape.col(0).norm() + shape.col(1).norm() + (shape.col(1) - shape.col(0)).norm();
  return sum / (3 * static_cast<double>(std::max<Eigen::Index>(garment.triangles.cols(), 1)));
}

double mass(const GarmentMesh& garment, const Fabric& fabric) {
  const Eigen::VectorXd layers = triangle_layers(garment);
  double sum = 0;
  Eigen::Index t = 0;
  for (const Eigen::Matrix2d& shape : rest_triangles(garment))
    sum += fabric.area_density * layers(t++) * std::abs(shape.determinant()) / 2;
  return sum;
}

}  // namespace

ExchangeFolder::ExchangeFolder() {
  std::string name = (fs::temp_directory_path() / "toile-external-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
  path_ = name;
}

ExchangeFolder::~ExchangeFolder() {
  std::error_code ignored;
  if (!kept_ && !std::getenv("TOILE_KEEP_EXTERNAL")) fs::remove_all(path_, ignored);
}

void write_file(const fs::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out << bytes;
  out.close();
  if (!out)
    throw BadInput({"simulator.external-cannot-write", Severity::error, file.string(), "the file cannot be written",
                    "Make room in the folder for temporary files, or name another one in TMPDIR", Fault::cannot_create});
}

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw BadInput({"simulator.external-no-file", Severity::error, file.string(), "there is no such file",
                    "See what the program and its template in templates/simulators say about it"});
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_request(const DrapeRequest& request, const Eigen::Matrix3Xd& start, const Program& program, const fs::path& folder) {
  write_file(folder / program.garment, garment_text(request.garment, start, program));
  write_file(folder / "body.obj", body_text(request.body.form, program));
  const Fabric& fabric = request.fabric;
  write_file(folder / "fabric.json", nlohmann::ordered_json{{"name", fabric.name},
                                                            {"area_density", fabric.area_density},
                                                            {"stretch_warp", fabric.stretch_warp},
                                                            {"stretch_weft", fabric.stretch_weft},
                                                            {"stretch_cross", fabric.stretch_cross},
                                                            {"shear", fabric.shear},
                                                            {"bend_warp", fabric.bend_warp},
                                                            {"bend_weft", fabric.bend_weft},
                                                            {"friction", fabric.friction},
                                                            {"thickness", fabric.thickness},
                                                            {"most_stretch", fabric.most_stretch}}
                                         .dump(1));
  nlohmann::ordered_json asked{{"tolerance", request.tolerance},
                               {"time_limit", request.time_limit.value_or(program.time_limit)},
                               {"vertices", request.garment.vertex_count},
                               {"panel_vertices", panel_vertices(request.garment)},
                               {"triangles", request.garment.triangles.cols()},
                               {"unit", program.unit},
                               {"garment", program.garment},
                               {"result", program.result}};
  const Eigen::VectorXd layers = triangle_layers(request.garment);
  if ((layers.array() != 1).any()) asked["layers"] = std::vector<double>(layers.begin(), layers.end());
  write_file(folder / "request.json", asked.dump(1));
}

std::map<std::string, std::string> request_values(const DrapeRequest& request, const Program& program, const fs::path& folder) {
  const Fabric& fabric = request.fabric;
  std::map<std::string, std::string> values = program.values;
  const auto count = panel_vertices(request.garment);
  const double all = mass(request.garment, fabric);
  for (const auto& [name, value] :
       std::map<std::string, double>{{"area_density", fabric.area_density},
                                     {"stretch_warp", fabric.stretch_warp},
                                     {"stretch_weft", fabric.stretch_weft},
                                     {"half_stretch_warp", fabric.stretch_warp / 2},
                                     {"half_stretch_weft", fabric.stretch_weft / 2},
                                     {"half_stretch_cross", fabric.stretch_cross / 2},
                                     {"stretch_cross", fabric.stretch_cross},
                                     {"shear", fabric.shear},
                                     {"bend_warp", fabric.bend_warp},
                                     {"bend_weft", fabric.bend_weft},
                                     {"four_bend_warp", 4 * fabric.bend_warp},
                                     {"four_bend_weft", 4 * fabric.bend_weft},
                                     {"four_bend_bias", 2 * (fabric.bend_warp + fabric.bend_weft)},
                                     {"friction", fabric.friction},
                                     {"thickness", fabric.thickness},
                                     {"most_stretch", fabric.most_stretch},
                                     {"edge_length", mean_edge(request.garment)},
                                     {"between", program.between},
                                     {"still", program.still},
                                     {"mass", all},
                                     {"vertex_mass", all / static_cast<double>(std::max<Eigen::Index>(count, 1))},
                                     {"tolerance", request.tolerance},
                                     {"time_limit", request.time_limit.value_or(program.time_limit)}})
    values[name] = number(value);
  values["vertices"] = std::to_string(request.garment.vertex_count);
  values["panel_vertices"] = std::to_string(count);
  values["folder"] = folder.string();
  values["templates"] = fs::absolute(program.file).parent_path().string();
  values["garment"] = program.garment;
  values["result"] = program.result;
  values["before"] = program.before;
  return values;
}

Eigen::Matrix3Xd read_vertices(const fs::path& file, const Program& program) {
  const std::string text = read_file(file);
  std::vector<Eigen::Vector3d> points;
  int line = 0;
  for (std::string_view rest = text; !rest.empty();) {
    ++line;
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view words = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (words.size() < 2 || words[0] != 'v' || (words[1] != ' ' && words[1] != '\t')) continue;
    words.remove_prefix(1);
    Eigen::Vector3d at;
    for (int i = 0; i < 3; ++i) {
      words.remove_prefix(std::min(words.find_first_not_of(" \t+"), words.size()));
      const auto [next, error] = std::from_chars(words.data(), words.data() + words.size(), at(i));
      if (error != std::errc())
        throw BadInput({"simulator.external-unreadable", Severity::error, file.string() + ":" + std::to_string(line),
                        "a vertex without three numbers", "The program may have been interrupted or its disk be full",
                        Fault::checks_failed});
      words.remove_prefix(static_cast<std::size_t>(next - words.data()));
    }
    points.push_back(to_ours(at, program));
  }
  Eigen::Matrix3Xd x(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t v = 0; v < points.size(); ++v) x.col(static_cast<Eigen::Index>(v)) = points[v];
  return x;
}

Eigen::Matrix3Xd welded(const GarmentMesh& garment, const Eigen::Matrix3Xd& x, double& widest) {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, garment.vertex_count);
  Eigen::VectorXd copies = Eigen::VectorXd::Zero(garment.vertex_count);
  const auto for_copies = [&](const auto& visit) {
    Eigen::Index i = 0;
    for (const Eigen::VectorXi& panel : garment.welded)
      for (const int v : panel) visit(v, i++);
  };
  for_copies([&](int v, Eigen::Index i) {
    sum.col(v) += x.col(i);
    copies(v) += 1;
  });
  for (Eigen::Index v = 0; v < sum.cols(); ++v) sum.col(v) /= std::max(copies(v), 1.);
  widest = 0;
  for_copies([&](int v, Eigen::Index i) { widest = std::max(widest, (x.col(i) - sum.col(v)).norm()); });
  return sum;
}

}  // namespace toile::external
