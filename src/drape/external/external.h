#pragma once
// The simulator "external": any program that reads files and leaves files (design and keys: templates/simulators/README.md).

#include <optional>
#include <string>

#include "drape/simulator.h"

namespace toile::external {

// The simulator that `name` means: "external:NAME", a file NAME.toml of templates/simulators, or the path of such a file;
// nothing for other names. Throws BadInput "simulator.unknown" or "simulator.external-template".
//
// Its drape throws BadInput for whatever goes wrong outside ("simulator.external-missing", "-failed", "-no-file",
// "-unreadable",
// "-counts", "-not-finite", "-size", "-seam-open", "-too-long"), with the end of what the program printed, and keeps the files
// that passed. Drape::residual is ours (static_residual.h); `settled` is decided as the template's `at_rest` says.
std::optional<Simulator> simulator(const std::string& name);

}  // namespace toile::external
