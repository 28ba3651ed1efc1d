#include "edit/edit_session.h"

#include <utility>

namespace toile {

EditSession::EditSession(const EditInput& input, const std::string& operation, EditArguments arguments)
    : arguments_(std::move(arguments)),
      memory_(std::make_unique<EditMemory>(true)),
      input_(input),
      operation_(find_operation(operation)) {
  input_.memory = memory_.get();
}

EditSession::~EditSession() = default;

const Target& EditSession::first() {
  if (!first_) first_ = std::make_unique<Target>(operation_.apply(input_, arguments_));
  return *first_;
}

Target EditSession::target(const EditArguments& changed) {
  first();
  EditArguments arguments = arguments_;
  for (const auto& [name, value] : changed) arguments[name] = value;
  return arguments == arguments_ ? first() : operation_.apply(input_, arguments);
}

}  // namespace toile
