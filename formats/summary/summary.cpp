#include "formats/summary/summary.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "formats/formats.h"
#include "garment/units.h"

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

double six_digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr) + 0.0;
}

void put(Json& object, const char* key, double value, const std::string& path) {
  if (!std::isfinite(value)) throw std::invalid_argument("summary: " + path + "." + key + " is not finite");
  object[key] = six_digits(value);
}

const char* code(AdjustStop stop) {
  switch (stop) {
    case AdjustStop::agreed:
      return "agreed";
    case AdjustStop::stalled:
      return "stalled";
    case AdjustStop::step_limit:
      return "step_limit";
    case AdjustStop::slipped:
      return "slipped";
    case AdjustStop::not_developable:
      return "not_developable";
  }
  throw std::invalid_argument("summary: adjusted.stop");
}

const char* code(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

void put_distance(Json& object, const SummaryDistance& distance, double height, const std::string& path) {
  put(object, "hausdorff_percent", 100 * distance.hausdorff / height, path);
  put(object, "mean_percent", 100 * distance.mean / height, path);
  put(object, "hausdorff_mm", distance.hausdorff * mm_per_m, path);
  put(object, "mean_mm", distance.mean * mm_per_m, path);
  put(object, "stretch", distance.stretch, path);
}

Json step(const AdjustStep& from, double height, const std::string& path) {
  Json to = Json::object();
  put_distance(to, {from.hausdorff, from.mean, from.stretch}, height, path);
  put(to, "worst_stretch", from.worst_stretch, path);
  put(to, "printed_stretch", from.printed_stretch, path);
  put(to, "seam_mismatch_mm", from.seam_mismatch * mm_per_m, path);
  put(to, "contracting", from.contracting, path);
  put(to, "embedding_distortion", from.embedding_distortion, path);
  put(to, "residual", from.residual, path);
  put(to, "slipped_mm", from.slipped * mm_per_m, path);
  put(to, "seconds", from.seconds, path);
  return to;
}

Json drape(const RunSummary& summary) {
  Json to = Json::object();
  to["simulator"] = summary.drape.simulator;
  to["settled"] = summary.drape.settled;
  put(to, "residual", summary.drape.residual, "drape");
  put(to, "tolerance", summary.tolerance, "drape");
  to["steps"] = summary.drape.steps;
  put(to, "max_penetration_mm", summary.drape.max_penetration * mm_per_m, "drape");
  put(to, "seam_gap_mm", summary.seam_gap * mm_per_m, "drape");
  put(to, "slipped_mm", summary.drape.slipped * mm_per_m, "drape");
  to["inverted_triangles"] = summary.drape.inverted_triangles;
  to["self_intersections"] = summary.drape.self_intersections;
  to["links_ok"] = summary.links_ok;
  put(to, "seconds", summary.drape.seconds, "drape");
  return to;
}

Json adjusted(const RunSummary& summary) {
  const auto& from = summary.adjusted;
  Json to = Json::object();
  put_distance(to, from.distance, summary.mannequin.height, "adjusted");
  to["stop"] = code(from.stop);
  to["best"] = from.best;
  to["steps"] = Json::array();
  for (std::size_t i = 0; i < from.steps.size(); ++i)
    to["steps"].push_back(step(from.steps[i], summary.mannequin.height, "adjusted.steps[" + std::to_string(i) + "]"));
  put(to, "seam_mismatch_mm", from.seam_mismatch * mm_per_m, "adjusted");
  to["settled"] = from.settled;
  put(to, "residual", from.residual, "adjusted");
  put(to, "max_penetration_mm", from.max_penetration * mm_per_m, "adjusted");
  put(to, "girth_percent", 100 * from.girth, "adjusted");
  put(to, "seam_length_mm", from.seam_length * mm_per_m, "adjusted");
  put(to, "level_mm", from.level * mm_per_m, "adjusted");
  put(to, "seconds", from.seconds, "adjusted");
  return to;
}

Json girths(const std::vector<SummaryGirth>& from) {
  Json rows = Json::array();
  for (const SummaryGirth& girth : from) {
    Json row = {{"name", girth.name}};
    put(row, "height_mm", girth.height * mm_per_m, "girths");
    put(row, "body_mm", girth.body * mm_per_m, "girths");
    row["covered"] = girth.covered;
    if (girth.covered) {
      put(row, "garment_mm", girth.garment * mm_per_m, "girths");
      put(row, "cloth_mm", girth.cloth * mm_per_m, "girths");
      put(row, "ease_mm", girth.ease * mm_per_m, "girths");
    }
    rows.push_back(row);
  }
  return rows;
}

Json finding(const Finding& from) {
  return {{"code", from.code},
          {"severity", code(from.severity)},
          {"place", from.place},
          {"text", from.text},
          {"remedy", from.remedy}};
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
  if (!(summary.mannequin.height > 0)) throw std::invalid_argument("summary: mannequin.height_m must be above 0");
  Json root = Json::object();
  root["schema"] = 1;
  root["toile"] = summary.version;
  root["recipe"] = summary.recipe;
  root["verdict"] = summary.verdict;
  if (!summary.certificate.empty()) root["certificate"] = summary.certificate;
  root["ok"] = summary.ok;
  root["mannequin"]["name"] = summary.mannequin.name;
  put(root["mannequin"], "height_m", summary.mannequin.height, "mannequin");
  root["garment"] = {
      {"name", summary.garment.name}, {"triangles", summary.garment.triangles}, {"panels", summary.garment.panels}};
  root["fabric"] = summary.fabric;
  root["drape"] = drape(summary);
  if (!summary.girths.empty()) root["girths"] = girths(summary.girths);
  if (!summary.only_draped) {
    root["flattened"] = Json::object();
    put_distance(root["flattened"], summary.flattened, summary.mannequin.height, "flattened");
    root["adjusted"] = adjusted(summary);
    root["outlines"] = Json::object();
    put(root["outlines"], "max_deviation_mm", summary.outlines.max_deviation * mm_per_m, "outlines");
    put(root["outlines"], "symmetry_mm", summary.outlines.symmetry * mm_per_m, "outlines");
  }
  root["findings"] = Json::array();
  for (const Finding& found : summary.findings) root["findings"].push_back(finding(found));
  root["inputs"] = Json::object();
  for (const auto& [file, hash] : summary.inputs) root["inputs"][file] = hash;
  root["files"] = summary.files;
  put(root, "seconds", summary.seconds, "summary");
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::filesystem::path& file, const RunSummary& summary) {
  write_whole_file(file, summary_json(summary));
}

}  // namespace toile
