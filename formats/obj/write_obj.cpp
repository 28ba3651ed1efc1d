#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "formats/formats.h"
#include "formats/obj/skeleton.h"

namespace toile {
namespace {

// Nine digits after the point: nanometres.
void add_number(std::string& text, double value) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 9).ptr;
  const std::string_view written(digits, static_cast<std::size_t>(end - digits));
  text += ' ';
  text += written == "-0.000000000" ? "0.000000000" : written;
}

template <class Columns>
void add_points(std::string& text, const char* keyword, const Columns& points) {
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    text += keyword;
    for (Eigen::Index row = 0; row < points.rows(); ++row) add_number(text, points(row, i));
    text += '\n';
  }
}

std::string one_word(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
  return name.empty() ? "unnamed" : name;
}

}  // namespace

void write_obj(const std::filesystem::path& file, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions) {
  check(garment);
  if (positions.cols() != garment.vertex_count)
    throw std::invalid_argument("write_obj: one position for each garment vertex is needed");
  if (!positions.allFinite()) throw std::invalid_argument("write_obj: positions are not finite");
  std::string text = "# garment, metres, Y up; v = where it hangs, vt = rest shape of its panels in metres\n";
  add_points(text, "v", positions);
  for (const PanelMesh& panel : garment.panels) {
    if (!panel.rest.allFinite())
      throw std::invalid_argument("write_obj: the rest shape of panel '" + panel.name + "' is not finite");
    add_points(text, "vt", panel.rest);
  }
  Eigen::Index first = 1;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    text += "g " + one_word(panel.name) + "\n";
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
      text += 'f';
      for (Eigen::Index c = 0; c < 3; ++c) {
        const int vertex = panel.triangles(c, t);
        text += ' ' + std::to_string(garment.welded[p][vertex] + 1) + '/' + std::to_string(first + vertex);
      }
      text += '\n';
    }
    first += panel.rest.cols();
  }
  write_whole_file(file, text);
}

void write_obj(const std::filesystem::path& file, const Mannequin& mannequin) {
  if (!mannequin.positions.allFinite()) throw std::invalid_argument("write_obj: positions of the body are not finite");
  std::string text = "# body, metres, Y up, floor y = 0, faces +Z, wearer's left = +X\no " + one_word(mannequin.name) + "\n";
  add_points(text, "v", mannequin.positions);
  for (Eigen::Index t = 0; t < mannequin.triangles.cols(); ++t) {
    text += 'f';
    for (Eigen::Index c = 0; c < 3; ++c) text += ' ' + std::to_string(mannequin.triangles(c, t) + 1);
    text += '\n';
  }
  write_whole_file(file, text);
}

void write_skeleton(const std::filesystem::path& file, const Mannequin& mannequin) {
  write_whole_file(file, skeleton_text(mannequin));
}

}  // namespace toile
