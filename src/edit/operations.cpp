#include "edit/fit/fit.h"
#include "edit/grade/grade.h"
#include "edit/length/length.h"
#include "edit/mix/mix.h"
#include "edit/operation.h"

namespace toile {

const std::vector<EditOperation>& operations() {
  static const std::vector<EditOperation> list{length_operation(), fit_operation(), grade_operation(), mix_operation()};
  return list;
}

const EditOperation& find_operation(const std::string& name) {
  std::string names;
  for (const EditOperation& operation : operations()) {
    if (operation.name == name) return operation;
    names += (names.empty() ? "" : ", ") + operation.name;
  }
  throw BadInput({"edit.unknown-operation", Severity::error, "edit", "there is no edit '" + name + "'", "there are: " + names});
}

}  // namespace toile
