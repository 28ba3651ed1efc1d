#include <cmath>
#include <utility>

#include "formats/formats.h"
#include "formats/obj/mesh_text.h"
#include "formats/obj/skeleton.h"

namespace toile {

std::optional<std::filesystem::path> skeleton_beside(const std::filesystem::path& file) {
  const auto candidate = [&](const std::string& name) { return file.parent_path() / (name + ".skeleton.json"); };
  const std::string stem = file.stem().string(), wrap = "_wrap";
  std::error_code ignored;
  if (std::filesystem::exists(candidate(stem), ignored)) return candidate(stem);
  if (stem.size() > wrap.size() && stem.compare(stem.size() - wrap.size(), wrap.size(), wrap) == 0)
    if (const auto found = candidate(stem.substr(0, stem.size() - wrap.size())); std::filesystem::exists(found, ignored))
      return found;
  return std::nullopt;
}

Loaded<Mannequin> read_body(const std::filesystem::path& file, const std::optional<std::filesystem::path>& skeleton) {
  Loaded<Mannequin> loaded;
  const Loaded<std::string> text = read_whole_file(file);
  loaded.report.append(text.report);
  if (!text.value) return loaded;
  Loaded<ObjMesh> mesh = read_obj_mesh(*text.value, file.string());
  loaded.report.append(mesh.report);

  Mannequin body;
  body.name = file.stem().string();
  std::optional<double> stated_height;
  if (const auto beside = skeleton ? skeleton : skeleton_beside(file)) {
    const Loaded<std::string> words = read_whole_file(*beside);
    loaded.report.append(words.report);
    if (words.value) {
      Loaded<Skeleton> read = read_skeleton_text(*words.value, beside->string());
      loaded.report.append(read.report);
      if (read.value) {
        if (!read.value->name.empty()) body.name = read.value->name;
        body.bones = std::move(read.value->bones);
        body.landmarks = std::move(read.value->landmarks);
        body.measures = std::move(read.value->measures);
        stated_height = read.value->height;
      }
    }
  }
  if (!loaded.report.ok()) return loaded;
  body.positions = std::move(mesh.value->positions);
  body.triangles = std::move(mesh.value->triangles);
  // A wrap stands a millimetre off the body, so the height somebody stated counts, if it can be meant for this body.
  body.height = body.positions.row(1).maxCoeff() - body.positions.row(1).minCoeff();
  if (stated_height && std::abs(*stated_height - body.height) < .02 * body.height) body.height = *stated_height;
  loaded.value = std::move(body);
  return loaded;
}

}  // namespace toile
