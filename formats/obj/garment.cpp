#include "formats/obj/garment.h"

#include <algorithm>
#include <map>
#include <utility>

#include "formats/formats.h"
#include "formats/obj/coincident_seams.h"
#include "formats/obj/faces.h"
#include "formats/obj/garment_piece.h"
#include "formats/obj/garment_scale.h"
#include "formats/obj/hanging.h"
#include "formats/obj/islands.h"
#include "formats/obj/panel_copies.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr double sewn_within = .2e-3;  // m; unwelded seams of other programs are exact or nearly so

struct Panels {
  Pattern pattern;
  std::vector<PanelMesh> panels;
  std::vector<int> island;  // by panel
};

std::optional<Panels> panels_of(const std::vector<Island>& islands, const std::string& place, Report& report) {
  Panels made;
  for (const PanelCopies& copies : panel_copies(islands)) {
    auto first = island_piece(islands[static_cast<std::size_t>(copies.islands.front())], place, report);
    if (!first) return std::nullopt;
    first->piece.name = copies.name;
    first->piece.quantity = static_cast<int>(copies.islands.size()) - copies.mirrored;
    first->piece.mirrored_quantity = copies.mirrored;
    for (std::size_t i = 0; i < copies.islands.size(); ++i) {
      PanelMesh panel = first->panel;
      panel.piece = static_cast<int>(made.pattern.pieces.size());
      panel.copy = static_cast<int>(i) + 1;
      panel.mirrored = is_mirrored(first->piece, panel.copy);
      panel.name = copies.name + (copies.islands.size() > 1 ? ":" + std::to_string(i + 1) : "");
      const Island& island = islands[static_cast<std::size_t>(copies.islands[i])];
      panel.rest = island.flat;
      panel.triangles = island.triangles;
      if (panel.mirrored) panel.boundary = mirrored_boundary(panel.boundary);
      made.panels.push_back(std::move(panel));
      made.island.push_back(copies.islands[i]);
    }
    made.pattern.pieces.push_back(std::move(first->piece));
  }
  return made;
}

// Panels joined where their boundaries lie on one another.
DrapedGarment hung(const Panels& made, const std::vector<Island>& islands, const Eigen::Matrix3Xd& positions) {
  std::vector<int> boundary;
  for (std::size_t p = 0; p < made.panels.size(); ++p)
    for (const BoundaryVertex& b : made.panels[p].boundary)
      boundary.push_back(islands[static_cast<std::size_t>(made.island[p])].vertex[static_cast<std::size_t>(b.vertex)]);
  std::sort(boundary.begin(), boundary.end());
  boundary.erase(std::unique(boundary.begin(), boundary.end()), boundary.end());
  const std::vector<int> joined = joined_where_near(positions, boundary, sewn_within);

  DrapedGarment draped;
  draped.garment.panels = made.panels;
  std::map<int, int> number;  // of the joined vertices that the garment has
  std::vector<Eigen::Vector3d> sums;
  std::vector<int> counts;
  std::vector<Eigen::Vector3i> triangles;
  for (std::size_t p = 0; p < made.panels.size(); ++p) {
    const Island& island = islands[static_cast<std::size_t>(made.island[p])];
    Eigen::VectorXi welded(static_cast<Eigen::Index>(island.vertex.size()));
    for (std::size_t v = 0; v < island.vertex.size(); ++v) {
      const auto vertex = static_cast<std::size_t>(island.vertex[v]);
      const int at = number.try_emplace(joined[vertex], static_cast<int>(number.size())).first->second;
      if (static_cast<std::size_t>(at) == sums.size()) sums.emplace_back(Eigen::Vector3d::Zero()), counts.push_back(0);
      sums[static_cast<std::size_t>(at)] += positions.col(island.vertex[v]);
      ++counts[static_cast<std::size_t>(at)];
      welded(static_cast<Eigen::Index>(v)) = at;
    }
    for (Eigen::Index t = 0; t < island.triangles.cols(); ++t)
      triangles.emplace_back(island.triangles.col(t).unaryExpr([&](int v) { return welded(v); }));
    draped.garment.welded.push_back(std::move(welded));
  }
  draped.garment.vertex_count = static_cast<int>(sums.size());
  draped.garment.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) draped.garment.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  draped.positions.resize(3, draped.garment.vertex_count);
  for (std::size_t v = 0; v < sums.size(); ++v) draped.positions.col(static_cast<Eigen::Index>(v)) = sums[v] / counts[v];
  return draped;
}

}  // namespace

Loaded<PatternFile> read_obj_garment(const std::string& text, const std::string& place, std::optional<double> unit_in_metres) {
  Loaded<PatternFile> loaded;
  Report& report = loaded.report;
  Loaded<ObjFaces> faces = read_obj_faces(text, place);
  report.append(faces.report);
  if (!faces.value) return loaded;
  Loaded<std::vector<Island>> read = islands_of(*faces.value, place);
  report.append(read.report);
  if (!read.value) return loaded;
  std::vector<Island> islands = std::move(*read.value);

  std::vector<int> used;
  for (const Island& island : islands) used.insert(used.end(), island.vertex.begin(), island.vertex.end());
  Eigen::Matrix3Xd of_garment(3, static_cast<Eigen::Index>(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i)
    of_garment.col(static_cast<Eigen::Index>(i)) = faces.value->positions.col(used[i]);
  const auto units = garment_units(of_garment, unit_in_metres, place, report);
  if (!units) return loaded;
  const Eigen::Matrix3Xd positions = units->in_metres * faces.value->positions;
  lay_flat(islands, positions, place, report);
  if (!report.ok()) return loaded;

  std::optional<Panels> panels = panels_of(islands, place, report);
  if (!panels) return loaded;
  PatternFile file;
  file.format = "OBJ";
  file.units = *units;
  file.pattern = std::move(panels->pattern);
  file.pattern.name = std::filesystem::path(place).stem().string();
  file.drape.push_back(hung(*panels, islands, positions));
  const GarmentMesh& garment = file.drape.front().garment;
  file.pattern.seams = welded_seams_of(garment, file.pattern, place, report);
  place_by_drape(file.pattern, file.drape.front());
  for (const Piece& piece : file.pattern.pieces) file.facts.push_back({piece.name, true, "vt island", false, 0});

  const auto turned = std::count_if(islands.begin(), islands.end(), [](const Island& island) { return island.turned_over; });
  if (turned > 0)
    report.note("obj.turned-over", place,
                std::to_string(turned) + " of " + std::to_string(islands.size()) +
                    " pieces show their inside in the texture (vt) and were reflected");
  report.note("obj.grain", place, "the format knows no grain line; the grain is taken along v of the texture");
  if (file.pattern.seams.empty())
    report.warn("obj.no-seams", place, "no outlines of pieces lie on one another: nothing is sewn",
                "Export the garment as it is sewn, or write what is sewn to what to a seams file beside it");
  loaded.value = std::move(file);
  return loaded;
}

Loaded<PatternFile> read_obj_garment(const std::filesystem::path& file, std::optional<double> unit_in_metres) {
  const Loaded<std::string> bytes = read_whole_file(file);
  if (!bytes.value) return {std::nullopt, bytes.report};
  return read_obj_garment(*bytes.value, file.filename().string(), unit_in_metres);
}

}  // namespace toile
