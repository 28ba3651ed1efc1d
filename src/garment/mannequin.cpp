#include "garment/mannequin.h"

#include <algorithm>

namespace toile {

const Bone* find_bone(const Mannequin& mannequin, const std::string& name) {
  const auto found =
      std::find_if(mannequin.bones.begin(), mannequin.bones.end(), [&](const Bone& bone) { return bone.name == name; });
  return found == mannequin.bones.end() ? nullptr : &*found;
}

}  // namespace toile
