#include "drape/external/external.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "drape/external/child.h"
#include "drape/external/exchange.h"
#include "drape/external/program.h"
#include "drape/external/static_residual.h"
#include "drape/guards.h"
#include "garment/report.h"

namespace toile::external {
namespace {

namespace fs = std::filesystem;

constexpr double most_size_change = 3;  // of the mean edge, either way: a wrong unit or an explosion
constexpr double farthest = 50;         // m from the start
constexpr int push_sweeps = 30;

[[noreturn]] void refuse(const char* what, const Program& program, const fs::path& folder, std::string text, std::string remedy,
                         Fault fault = Fault::checks_failed) {
  const std::string words = folder.empty() ? "" : last_words(folder);
  if (!words.empty()) text += "; its last words: " + words;
  std::string place = "simulator '" + program.name + "'";
  if (!folder.empty()) place += ", files in " + folder.string();
  throw BadInput(
      {std::string("simulator.external-") + what, Severity::error, place, std::move(text), std::move(remedy), fault});
}

// No vertex, edge midpoint or triangle centre nearer to the body than `clearance`, as far as sweeps do that.
Eigen::Matrix3Xd pushed_out(const DrapeRequest& request, double clearance) {
  Eigen::Matrix3Xd x = request.start;
  if (clearance <= 0) return x;
  const DistanceField& body = request.body.distance;
  for (int sweep = 0; sweep < push_sweeps; ++sweep) {
    bool clear = true;
    const auto push = [&](std::initializer_list<int> vertices) {
      Eigen::Vector3d at = Eigen::Vector3d::Zero();
      for (const int v : vertices) at += x.col(v) / static_cast<double>(vertices.size());
      const double missing = clearance - body.distance(at);
      if (missing <= 1e-6) return;
      clear = false;
      const Eigen::Vector3d out = body.sample(at).gradient;
      if (out.norm() > 0)
        for (const int v : vertices) x.col(v) += missing * out.normalized();
    };
    for (int v = 0; v < x.cols(); ++v) push({v});
    for (Eigen::Index t = 0; t < request.garment.triangles.cols(); ++t) {
      const auto corner = request.garment.triangles.col(t);
      for (int i = 0; i < 3; ++i) push({corner(i), corner((i + 1) % 3)});
      push({corner(0), corner(1), corner(2)});
    }
    if (clear) break;
  }
  return x;
}

double mean_size_change(const GarmentMesh& garment, const Eigen::Matrix3Xd& x) {
  double now = 0, rest = 0;
  const std::vector<Eigen::Matrix2d> shapes = rest_triangles(garment);
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    const auto corner = garment.triangles.col(t);
    now += (x.col(corner(1)) - x.col(corner(0))).norm() + (x.col(corner(2)) - x.col(corner(0))).norm();
    rest += shapes[static_cast<std::size_t>(t)].col(0).norm() + shapes[static_cast<std::size_t>(t)].col(1).norm();
  }
  return rest > 0 ? now / rest : 1;
}

// The positions by garment vertex that the program left in `name`, or a refusal.
Eigen::Matrix3Xd result(const DrapeRequest& request, const Program& program, const fs::path& folder, const std::string& name) {
  if (!fs::exists(folder / name))
    refuse("no-file", program, folder, "it ended without having written " + name,
           "See what it printed, and 'result' in its template");
  Eigen::Matrix3Xd x = read_vertices(folder / name, program);
  const bool loose = program.result_vertices == ResultVertices::panels;
  Eigen::Index expected = request.garment.vertex_count;
  if (loose) {
    expected = 0;
    for (const PanelMesh& panel : request.garment.panels) expected += panel.rest.cols();
  }
  if (x.cols() != expected)
    refuse("counts", program, folder,
           name + " has " + std::to_string(x.cols()) + " vertices instead of " + std::to_string(expected),
           "The program must keep number and order of vertices: no remeshing, no merging");
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    if (!x.col(v).allFinite())
      refuse("not-finite", program, folder, "vertex " + std::to_string(v + 1) + " of " + name + " is not a number",
             "Its simulation blew up: shorter steps, more damping");
  if (loose) {
    double widest = 0;
    x = welded(request.garment, x, widest);
    if (widest > program.most_gap)
      refuse("seam-open", program, folder, "it left a seam " + std::to_string(2e3 * widest) + " mm open",
             "More time, or stronger sewing in its template");
  }
  const double change = mean_size_change(request.garment, x);
  if (change > most_size_change || change < 1 / most_size_change)
    refuse("size", program, folder, "the cloth came back " + std::to_string(change) + " times as large as its pattern",
           "See 'units' in its template, and whether its simulation blew up");
  if ((x - request.start).colwise().norm().maxCoeff() > farthest)
    refuse("size", program, folder,
           "cloth came back more than " + std::to_string(static_cast<int>(farthest)) + " m from the start",
           "See 'units' and 'up' in its template, and whether its simulation blew up");
  return x;
}

bool at_rest(const DrapeRequest& request, const Program& program, const fs::path& folder, Drape& drape) {
  if (program.at_rest == AtRest::by_residual) return drape.residual <= request.tolerance;
  if (program.at_rest == AtRest::by_movement) {
    const Eigen::Matrix3Xd before = result(request, program, folder, program.before);
    return (drape.positions - before).colwise().norm().maxCoeff() <= program.still;
  }
  const std::string name = "state.json";
  try {
    const auto state = nlohmann::json::parse(read_file(folder / name));
    drape.steps = state.value("steps", 0);
    return state.at("settled").get<bool>();
  } catch (const nlohmann::json::exception& error) {
    refuse("unreadable", program, folder, name + ": " + error.what(),
           R"(It must be {"settled": true or false, "steps": number})");
  }
}

fs::path executable(const Program& program) {
  const char* given = program.variable.empty() ? nullptr : std::getenv(program.variable.c_str());
  std::string name = given ? given : program.program;
  if (!given && name.find('/') != std::string::npos && fs::path(name).is_relative())
    name = (fs::absolute(program.file).parent_path() / name).string();
  const fs::path found = find_on_path(name);
  if (found.empty())
    refuse("missing", program, "", "there is no program '" + name + "'",
           program.install + (program.variable.empty() ? "" : "; or name it in " + program.variable), Fault::missing);
  return found;
}

std::vector<std::string> command(const Program& program, std::map<std::string, std::string> values) {
  values["program"] = executable(program).string();
  std::vector<std::string> words;
  for (const std::string& word : program.command)
    words.push_back(filled(word, "{", "}", values, program.file.string(), Escape::none));
  words[0] = find_on_path(words[0]).string();
  if (words[0].empty())
    refuse("missing", program, "", "there is no program '" + program.command[0] + "'", program.install, Fault::missing);
  return words;
}

// Runs the program; false when the caller's time was up or the caller asked to stop.
bool run(const DrapeRequest& request, const Program& program, const fs::path& folder) {
  const auto values = request_values(request, program, folder);
  ChildOrder order{command(program, values), folder, program.time_limit, request.stop};
  const bool callers_limit = request.time_limit && *request.time_limit < program.time_limit;
  if (callers_limit) order.time_limit = *request.time_limit;
  write_request(request, pushed_out(request, program.clearance), program, folder);
  for (const RenderedFile& file : program.files)
    write_file(folder / file.to, filled(read_file(file.from), "{{", "}}", values, file.from.string(), Escape::json));
  ChildOutcome outcome;
  try {
    outcome = run_child(order);
  } catch (const std::system_error& error) {
    refuse("missing", program, folder, "'" + order.command[0] + "' cannot be started: " + error.code().message(),
           program.install, Fault::missing);
  }
  if (outcome.end == ChildEnd::stopped || (outcome.end == ChildEnd::out_of_time && callers_limit)) return false;
  if (outcome.end == ChildEnd::out_of_time)
    refuse("too-long", program, folder, "it ran for more than " + std::to_string(program.time_limit) + " s",
           "Raise 'time_limit' in " + program.file.string() + ", or see why it hangs");
  if (outcome.end == ChildEnd::signalled || outcome.code != 0)
    refuse("failed", program, folder,
           (outcome.end == ChildEnd::signalled ? "it was ended by signal " : "it ended with exit code ") +
               std::to_string(outcome.code),
           "See what it printed");
  return true;
}

// What a program that was interrupted had written, if it is whole.
void take_unfinished(const DrapeRequest& request, const Program& program, const fs::path& folder, Drape& drape) {
  try {
    drape.positions = result(request, program, folder, program.result);
  } catch (const BadInput&) {
    drape.positions = request.start;
  }
}

Drape drape(const Program& program, const std::string& name, const DrapeRequest& request) {
  if (request.start.cols() != request.garment.vertex_count)
    throw std::invalid_argument(name + ": start has another number of vertices than the garment");
  if (!request.start.allFinite()) throw std::invalid_argument(name + ": start is not finite");
  const auto began = std::chrono::steady_clock::now();
  Drape drape;
  drape.simulator = name;
  drape.positions = request.start;
  const bool no_time = (request.time_limit && *request.time_limit <= 0) || (request.stop && request.stop());
  if (no_time) {
    drape.residual = static_residual(request, drape.positions);
  } else {
    if (request.progress) request.progress({0, static_residual(request, request.start), request.tolerance});
    ExchangeFolder folder;
    try {
      const bool whole = run(request, program, folder.path());
      if (whole)
        drape.positions = result(request, program, folder.path(), program.result);
      else
        take_unfinished(request, program, folder.path(), drape);
      drape.residual = static_residual(request, drape.positions);
      drape.settled = whole && at_rest(request, program, folder.path(), drape);
    } catch (const BadInput& bad) {
      if (bad.finding().fault == Fault::checks_failed) folder.keep();
      throw;
    }
    if (request.progress) request.progress({std::max(drape.steps, 1), drape.residual, request.tolerance});
  }
  measure_guards(request, drape);
  drape.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return drape;
}

}  // namespace

std::optional<Simulator> simulator(const std::string& name) {
  const std::string prefix = "external:";
  const bool listed = name.rfind(prefix, 0) == 0;
  if (!listed && fs::path(name).extension() != ".toml") return std::nullopt;
  const fs::path file = listed ? program_folder() / (name.substr(prefix.size()) + ".toml") : fs::path(name);
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    std::string list;
    for (const std::string& known : program_names()) list += (list.empty() ? "" : ", ") + prefix + known;
    throw BadInput({"simulator.unknown", Severity::error, "simulator '" + name + "'", "there is no file " + file.string(),
                    "Use one of: " + list + "; or the path of a file like theirs"});
  }
  Program program = read_program(file);
  std::string summary = program.summary;
  return Simulator{name, std::move(summary),
                   [program = std::move(program), name](const DrapeRequest& request) { return drape(program, name, request); }};
}

}  // namespace toile::external
