#pragma once
// The files that pass between us and a simulator that is another program. Positions in the program's unit and axes, rest shapes
// in its unit with the grain along +v.

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "drape/external/program.h"
#include "drape/simulator.h"

namespace toile::external {

// A new, empty folder, removed with its owner unless it is kept, or TOILE_KEEP_EXTERNAL is in the environment.
class ExchangeFolder {
 public:
  ExchangeFolder();
  ExchangeFolder(const ExchangeFolder&) = delete;
  ExchangeFolder& operator=(const ExchangeFolder&) = delete;
  ~ExchangeFolder();
  const std::filesystem::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

// Writes the garment's OBJ (`v` start, `vt` rest, one group a panel, `f v/vt` in the order of garment triangles), body.obj,
// fabric.json and request.json.
void write_request(const DrapeRequest& request, const Eigen::Matrix3Xd& start, const Program& program,
                   const std::filesystem::path& folder);

// What the command and the files of a program may name: figures of the garment, the fabric and the request in SI.
std::map<std::string, std::string> request_values(const DrapeRequest& request, const Program& program,
                                                  const std::filesystem::path& folder);

void write_file(const std::filesystem::path& file, const std::string& bytes);
std::string read_file(const std::filesystem::path& file);  // throws BadInput("simulator.external-no-file")

// The `v` lines of an OBJ, in m and our axes; whatever else is in the file is passed over. Throws BadInput
// ("simulator.external-no-file", "simulator.external-unreadable") naming file and line.
Eigen::Matrix3Xd read_vertices(const std::filesystem::path& file, const Program& program);

// One vertex for every panel vertex (panels in order) -> one for every garment vertex: the mean of its copies. `widest` gets
// the farthest of a copy from that mean.
Eigen::Matrix3Xd welded(const GarmentMesh& garment, const Eigen::Matrix3Xd& panel_vertices, double& widest);

}  // namespace toile::external
