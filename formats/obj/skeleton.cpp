#include "formats/obj/skeleton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace toile {
namespace {

using Json = nlohmann::ordered_json;

struct Word {
  const char *theirs, *ours;
};

// Keys of "landmarks_m": heights end in _y, the rest are girths and lengths.
constexpr std::array levels{Word{"waist_y", "waist"},    Word{"highhip_y", "high_hip"}, Word{"hip_y", "hip"},
                            Word{"seat_prot_y", "seat"}, Word{"bust_y", "bust"},        Word{"underbust_y", "underbust"},
                            Word{"crotch_y", "crotch"},  Word{"nape_y", "nape"},        Word{"neck_base_back_y", "neck_base"},
                            Word{"knee_y", "knee"},      Word{"calf_y", "calf"},        Word{"ankle_y", "ankle"},
                            Word{"armpit_y", "armpit"},  Word{"shoulder_y", "shoulder"}};
constexpr std::array measures{Word{"highhip", "high_hip"},          Word{"seat_girth", "seat"},
                              Word{"upperarm", "upper_arm"},        Word{"arm_len_joint", "arm_length"},
                              Word{"shoulder_w", "shoulder_width"}, Word{"napewaist", "nape_to_waist"},
                              Word{"bust_pt_x", "bust_point"}};

template <std::size_t N>
std::string ours(const std::array<Word, N>& words, const std::string& theirs) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const Word& word) { return theirs == word.theirs; });
  return found == words.end() ? std::string() : found->ours;
}

template <std::size_t N>
std::string theirs(const std::array<Word, N>& words, const std::string& ours) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const Word& word) { return ours == word.ours; });
  return found == words.end() ? ours : found->theirs;
}

class Reader {
 public:
  Reader(std::string place, Report& report) : place_(std::move(place)), report_(report) {}

  Skeleton read(const Json& json) {
    Skeleton skeleton;
    if (!json.is_object()) return malformed("", "an object {...} is expected"), skeleton;
    if (const Json* name = field(json, "name"); name && name->is_string()) skeleton.name = name->get<std::string>();
    unit(json);
    if (const Json* bones = field(json, "bones")) {
      if (!bones->is_array()) malformed("bones", "a list is expected");
      for (std::size_t i = 0; bones->is_array() && i < bones->size() && report_.ok(); ++i) bone((*bones)[i], i, skeleton);
    }
    for (const Bone& bone : skeleton.bones)
      if (!bone.parent.empty() &&
          std::none_of(skeleton.bones.begin(), skeleton.bones.end(), [&](const Bone& b) { return b.name == bone.parent; }))
        report_.error("skeleton.no-such-parent", place_,
                      "the parent '" + bone.parent + "' of bone '" + bone.name + "' is not in the file",
                      "name a bone of the same file, or null for the root");
    if (const Json* marks = field(json, "landmarks_m")) landmarks(*marks, skeleton);
    return skeleton;
  }

 private:
  static const Json* field(const Json& json, const char* name) {
    const auto found = json.find(name);
    return found == json.end() || found->is_null() ? nullptr : &*found;
  }

  void malformed(const std::string& where, const std::string& text) {
    report_.error("skeleton.malformed", where.empty() ? place_ : place_ + ", " + where, text,
                  "see the README of formats/obj for what the file must hold");
  }

  void unit(const Json& json) {
    const Json* given = field(json, "units");
    if (!given) return;
    const std::string name = given->is_string() ? given->get<std::string>() : given->dump();
    if (name == "m")
      scale_ = 1;
    else if (name == "cm")
      scale_ = 1e-2;
    else if (name == "mm")
      scale_ = 1e-3;
    else
      report_.error("skeleton.unknown-unit", place_ + ", units", "unit " + name + " is not known", "use m, cm or mm");
  }

  Eigen::Vector3d point(const Json& bone, const char* name, const std::string& where) {
    const Json* given = field(bone, name);
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    if (!given || !given->is_array() || given->size() != 3 || !std::all_of(given->begin(), given->end(), [](const Json& x) {
          return x.is_number() && std::isfinite(x.get<double>());
        })) {
      malformed(where + "." + name, "three numbers are expected");
      return at;
    }
    for (std::size_t i = 0; i < 3; ++i) at[static_cast<Eigen::Index>(i)] = scale_ * (*given)[i].get<double>();
    return at;
  }

  void bone(const Json& json, std::size_t index, Skeleton& skeleton) {
    const std::string where = "bones[" + std::to_string(index) + "]";
    if (!json.is_object()) return malformed(where, "an object {...} is expected");
    const Json *name = field(json, "name"), *parent = field(json, "parent");
    if (!name || !name->is_string()) return malformed(where + ".name", "a name is expected");
    if (parent && !parent->is_string()) return malformed(where + ".parent", "a name or null is expected");
    Bone bone{name->get<std::string>(), parent ? parent->get<std::string>() : "", point(json, "head", where),
              point(json, "tail", where)};
    if (std::any_of(skeleton.bones.begin(), skeleton.bones.end(), [&](const Bone& b) { return b.name == bone.name; }))
      return malformed(where + ".name", "bone '" + bone.name + "' is there twice");
    skeleton.bones.push_back(std::move(bone));
  }

  void landmarks(const Json& json, Skeleton& skeleton) {
    if (!json.is_object()) return malformed("landmarks_m", "an object {...} is expected");
    for (const auto& [key, value] : json.items()) {
      if (!value.is_number() || !std::isfinite(value.get<double>())) {
        malformed("landmarks_m." + key, "a number of metres is expected");
        continue;
      }
      const double metres = value.get<double>();
      const bool is_level = key.size() > 2 && key.compare(key.size() - 2, 2, "_y") == 0;
      if (key == "height") {
        skeleton.height = metres;
        continue;
      }
      if (const std::string level = ours(levels, key); !level.empty())
        skeleton.landmarks[level] = metres;
      else if (is_level)
        skeleton.landmarks[key.substr(0, key.size() - 2)] = metres;
      else if (const std::string measure = ours(measures, key); !measure.empty())
        skeleton.measures[measure] = metres;
      else
        skeleton.measures[key] = metres;
    }
  }

  std::string place_;
  Report& report_;
  double scale_ = 1;
};

}  // namespace

Loaded<Skeleton> read_skeleton_text(const std::string& text, const std::string& place) {
  Loaded<Skeleton> loaded;
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    const auto lines =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size())), '\n');
    loaded.report.error("skeleton.malformed", place + ":" + std::to_string(lines), "the file is no valid JSON from here on",
                        "write it again; it may be cut off");
    return loaded;
  }
  Skeleton skeleton = Reader(place, loaded.report).read(json);
  if (loaded.report.ok()) loaded.value = std::move(skeleton);
  return loaded;
}

std::string skeleton_text(const Mannequin& mannequin) {
  const auto rounded = [](double metres) { return std::round(metres * 1e7) / 1e7 + 0.0; };
  const auto point = [&](const Eigen::Vector3d& at) { return Json::array({rounded(at[0]), rounded(at[1]), rounded(at[2])}); };
  Json json;
  json["name"] = mannequin.name;
  json["units"] = "m";
  json["up"] = "Y";
  json["forward"] = "+Z";
  json["left"] = "+X";
  Json& marks = json["landmarks_m"] = Json::object();
  marks["height"] = rounded(mannequin.height);
  for (const auto& [name, height] : mannequin.landmarks) {
    const std::string key = theirs(levels, name);
    marks[key == name ? name + "_y" : key] = rounded(height);
  }
  for (const auto& [name, size] : mannequin.measures) marks[theirs(measures, name)] = rounded(size);
  Json& bones = json["bones"] = Json::array();
  for (const Bone& bone : mannequin.bones)
    bones.push_back({{"name", bone.name},
                     {"parent", bone.parent.empty() ? Json(nullptr) : Json(bone.parent)},
                     {"head", point(bone.from)},
                     {"tail", point(bone.to)}});
  return json.dump(1) + "\n";
}

}  // namespace toile
