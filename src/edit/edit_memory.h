#pragma once
// What an edit has worked out of its input, kept for the next time that the same input is edited with another amount.

#include <any>
#include <map>
#include <string>
#include <utility>

#include "edit/contact_region.h"
#include "edit/reach.h"
#include "style/source_shape.h"
#include "style/style_memory.h"

namespace toile {

// Of one EditInput, which must not change.
class EditMemory {
 public:
  // `lasts`: there will be a next time.
  explicit EditMemory(bool lasts = false) : lasts_(lasts) {}
  bool lasts() const { return lasts_; }
  // What `make` gives, made once. `name` says what, and everything that it depends on besides the input.
  template <class Make>
  const auto& once(const std::string& name, const Make& make) {
    using Value = decltype(make());
    auto known = kept_.find(name);
    if (known == kept_.end()) known = kept_.emplace(name, std::any(std::in_place_type<Value>, make())).first;
    return std::any_cast<const Value&>(known->second);
  }
  // The same of what may be there or not.
  template <class Value>
  const Value* known(const std::string& name) const {
    const auto found = kept_.find(name);
    return found == kept_.end() ? nullptr : std::any_cast<Value>(&found->second);
  }
  StyleMemory& style() { return style_; }

 private:
  bool lasts_;
  std::map<std::string, std::any> kept_;
  StyleMemory style_;
};

const ContactRegion& source_contact(const EditInput& input, EditMemory& memory);
const std::vector<RelativePlace>& source_places(const EditInput& input, EditMemory& memory);
const std::vector<SourceTriangle>& source_shape(const EditInput& input, EditMemory& memory);
const LevelMesh& garment_edges(const EditInput& input, EditMemory& memory);
const VertexNeighbours& garment_neighbours(const EditInput& input, EditMemory& memory);
const std::vector<VertexLoop>& garment_boundary(const EditInput& input, EditMemory& memory);

}  // namespace toile
