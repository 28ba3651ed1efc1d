#pragma once
// What a file of templates/simulators/ says about a simulator that is another program; the README there has the keys.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace toile::external {

enum class ResultVertices { garment, panels };
enum class AtRest { by_program, by_movement, by_residual };

struct RenderedFile {
  std::filesystem::path from;  // text with {{names}}
  std::string to;              // in the exchange folder
};

struct Program {
  std::string name;
  std::string summary;
  std::string program;   // as found on PATH, or a path
  std::string variable;  // of the environment, which names it instead
  std::string install;   // what to do when it is not there
  std::vector<std::string> command;
  double unit = 1;                      // m
  bool z_up = false;                    // else Y
  double clearance = 0;                 // m, kept between the start and the body
  double time_limit = 0;                // s; longer is a failure
  double most_gap = 1e-2;               // m, between the copies of a seam's vertex that are welded by averaging
  std::string garment = "garment.obj";  // the name it wants its cloth by
  std::string result = "drape.obj";
  ResultVertices result_vertices = ResultVertices::garment;
  AtRest at_rest = AtRest::by_residual;
  std::string before;  // by_movement: a result from `between` s before the last
  double between = 0;  // s
  double still = 0;    // m, farthest that a vertex at rest moved in between
  std::vector<RenderedFile> files;
  std::map<std::string, std::string> values;  // [values]: further names for the command and the files
  std::filesystem::path file;                 // this came from
};

// templates/simulators (garment/templates.h).
std::filesystem::path program_folder();
std::vector<std::string> program_names();  // sorted

// Throws BadInput "simulator.external-template" naming the line and the remedy.
Program read_program(const std::filesystem::path& file);

// `text` with every OPENnameCLOSE replaced by its value, `escape`d where JSON text wants it. Throws BadInput
// "simulator.external-template" at `place` for a name that is not in `values`.
enum class Escape { none, json };
std::string filled(const std::string& text, const std::string& open, const std::string& close,
                   const std::map<std::string, std::string>& values, const std::string& place, Escape escape);

}  // namespace toile::external
