#pragma once
// The same edit again and again with another amount, as when its handle is dragged: an editor's new targets.

#include <memory>
#include <string>

#include "edit/edit_memory.h"
#include "edit/operation.h"

namespace toile {

class EditSession {
 public:
  // `arguments` as for EditOperation::apply. What `input` refers to must live as long as the session and not change. Throws
  // BadInput when there is no such operation.
  EditSession(const EditInput& input, const std::string& operation, EditArguments arguments);
  ~EditSession();
  EditSession(const EditSession&) = delete;
  EditSession& operator=(const EditSession&) = delete;

  // The target of the session's arguments: what apply() gives, byte for byte. Worked out once.
  const Target& first();
  // The target with `changed` in place of the session's own arguments of these names, much faster after first(). It does not
  // depend on what was asked for between. "length": what apply() gives, byte for byte. "fit": the same loops, limits, anchors
  // and report; the shape follows first()'s (follow_style) instead of being sought from the source, unless that would turn
  // triangles over. Throws what apply() throws.
  Target target(const EditArguments& changed);

 private:
  EditArguments arguments_;
  std::unique_ptr<EditMemory> memory_;
  EditInput input_;
  const EditOperation& operation_;
  std::unique_ptr<Target> first_;
};

}  // namespace toile
