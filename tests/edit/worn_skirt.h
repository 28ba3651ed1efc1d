#pragma once
// The synthetic skirt on its body, for tests of edit operations.

#include <string>

#include "edit/operation.h"
#include "style/synthetic_skirt.h"

namespace toile::testing {

struct WornSkirt {
  SyntheticSkirt skirt;
  Body body;
  explicit WornSkirt(const SkirtShape& shape = {}) : skirt(synthetic_skirt(shape)), body(make_body(skirt.form)) {}

  EditInput input() const { return {skirt.pattern, skirt.garment, skirt.drape, body}; }
  Target apply(const std::string& operation, const EditArguments& arguments) const {
    return find_operation(operation).apply(input(), arguments);
  }
  // Why the operation refuses; empty when it does not.
  Finding refusal(const std::string& operation, const EditArguments& arguments) const {
    try {
      apply(operation, arguments);
    } catch (const BadInput& bad) {
      return bad.finding();
    }
    return {};
  }
};

}  // namespace toile::testing
