#pragma once
// What independent programs see in a PDF: poppler's tools and qpdf. Sizes in points, pictures in grey at 254 dpi (10 pixels a
// mm).

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "formats/folder.h"

namespace toile::test {

// What `command` says; throws when it does not end well.
inline std::string said_by(const std::string& command) {
  struct Close {
    int* status;
    void operator()(FILE* pipe) const { *status = ::pclose(pipe); }
  };
  int status = -1;
  std::string said;
  {
    const std::unique_ptr<FILE, Close> pipe(::popen(command.c_str(), "r"), Close{&status});
    if (!pipe) throw std::runtime_error("cannot run " + command);
    char part[4096];
    for (std::size_t read; (read = std::fread(part, 1, sizeof part, pipe.get())) > 0;) said.append(part, read);
  }
  if (status != 0) throw std::runtime_error("failed: " + command);
  return said;
}

inline std::string quoted(const std::filesystem::path& file) { return "'" + file.string() + "'"; }

// Width and height of every page, points.
inline std::vector<std::pair<double, double>> page_sizes(const std::filesystem::path& file) {
  const std::string said = said_by("pdfinfo -f 1 -l 100000 " + quoted(file));
  const std::regex size(R"(Page +\d+ size: +([0-9.]+) x ([0-9.]+) pts)");
  std::vector<std::pair<double, double>> sizes;
  for (std::sregex_iterator at(said.begin(), said.end(), size), end; at != end; ++at)
    sizes.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]));
  return sizes;
}

inline std::string text_of(const std::filesystem::path& file, int first = 1, int last = 100000) {
  return said_by("pdftotext -layout -f " + std::to_string(first) + " -l " + std::to_string(last) + " " + quoted(file) + " -");
}

// Without compression: what can be searched.
inline std::string inside(const std::filesystem::path& file) {
  return said_by("qpdf --qdf --object-streams=disable " + quoted(file) + " -");
}

struct Picture {
  int width = 0, height = 0;
  std::vector<unsigned char> grey;  // row by row, 0 is black

  unsigned char at(double x, double y) const {  // mm
    return grey.at(static_cast<std::size_t>(static_cast<int>(y * 10) * width + static_cast<int>(x * 10)));
  }

  // From (x, y) in the direction (dx, dy) of length 1: how far it is to the middle of the next black line, mm; -1: none. Frames
  // are lighter.
  double to_line(double x, double y, double dx, double dy, unsigned char darkest = 85) const {
    double begin = -1;
    for (double way = 0;; way += .1) {
      const double px = x + way * dx, py = y + way * dy;
      if (px < 0 || py < 0 || px * 10 >= width || py * 10 >= height) return begin < 0 ? -1 : (begin + way) / 2;
      const bool dark = at(px, py) < darkest;
      if (dark && begin < 0) begin = way;
      if (!dark && begin >= 0) return (begin + way) / 2;
    }
  }
};

inline Picture picture_of(const std::filesystem::path& file, int page) {
  const std::string number = std::to_string(page);
  std::istringstream pgm(said_by("pdftoppm -gray -r 254 -f " + number + " -l " + number + " " + quoted(file)));
  std::string kind;
  int most = 0;
  Picture picture;
  pgm >> kind >> picture.width >> picture.height >> most;
  pgm.get();
  if (kind != "P5" || most != 255) throw std::runtime_error("no picture of page " + number);
  picture.grey.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  pgm.read(reinterpret_cast<char*>(picture.grey.data()), static_cast<std::streamsize>(picture.grey.size()));
  return picture;
}

// Middle of a word on the page, mm; throws when it is not there.
inline std::pair<double, double> place_of_word(const std::filesystem::path& file, int page, const std::string& word) {
  const std::string number = std::to_string(page);
  const std::string said = said_by("pdftotext -bbox -f " + number + " -l " + number + " " + quoted(file) + " -");
  const std::regex box(R"(xMin="([0-9.]+)\" yMin="([0-9.]+)\" xMax="([0-9.]+)\" yMax="([0-9.]+)\">)" + word + "</word>");
  std::smatch at;
  if (!std::regex_search(said, at, box)) throw std::runtime_error("the page does not say " + word);
  const double mm = 25.4 / 72;
  return {mm * (std::stod(at[1]) + std::stod(at[3])) / 2, mm * (std::stod(at[2]) + std::stod(at[4])) / 2};
}

}  // namespace toile::test
