#include "formats/dxf_aama/dialect.h"

#include "formats/dxf_aama/layers.h"

namespace toile::aama {

Dialect dialect_of(const StyleTexts& style, const std::vector<dxf::Block>& blocks, bool flat) {
  if (style.says_astm) return {"ASTM", "its style texts are those of ASTM D6673"};
  if (style.says_aama) return {"AAMA", "its style texts are those of ANSI/AAMA-292"};
  for (const dxf::Block& block : blocks)
    for (const dxf::Entity& entity : block.entities) {
      const Layer* layer = find_layer(entity.layer);
      if (layer && layer->number.size() == 2 && layer->number[0] == '8')
        return {"ASTM", "it has layer " + entity.layer + " (" + std::string(layer->name) + ")"};
    }
  if (flat) return {"AutoCAD drawing", "no block is a piece"};
  return {"AAMA", "its blocks have boundaries on layer 1, and nothing that only ASTM has"};
}

}  // namespace toile::aama
