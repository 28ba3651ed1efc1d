#include "formats/obj/line_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace toile {
namespace {

constexpr double farthest = 1e9;  // of a coordinate, in the file's unit

using Words = std::vector<std::string_view>;

Words fields(std::string_view line) {
  Words found;
  constexpr std::string_view blank = " \t\r\v\f";
  for (std::size_t at = line.find_first_not_of(blank); at != std::string_view::npos; at = line.find_first_not_of(blank, at)) {
    const std::size_t end = std::min(line.find_first_of(blank, at), line.size());
    found.push_back(line.substr(at, end - at));
    at = end;
  }
  return found;
}

template <class Number>
std::optional<Number> read_number(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  Number value{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string joined(const Words& words) {
  std::string text;
  for (std::size_t i = 1; i < words.size(); ++i) text += (i > 1 ? " " : "") + std::string(words[i]);
  return text;
}

class LineCheck {
 public:
  LineCheck(const std::string& place, bool with_texture, Report& report)
      : place_(place), with_texture_(with_texture), report_(report) {}

  ObjLines check(const std::string& text) {
    std::string_view rest = text;
    while (!rest.empty() && report_.ok()) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      ++line_;
      look_at(fields(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (report_.ok()) look_at_whole();
    return std::move(lines_);
  }

 private:
  // The greatest index of its kind that a face has named so far, and where.
  struct Greatest {
    long index = 0, line = 0;
  };

  void look_at(const Words& words) {
    if (words.empty()) return;
    if (words[0] == "v") {
      ++lines_.vertices;
      numbers(words, 3, "the vertex has fewer than three numbers");
    } else if (words[0] == "vt" && with_texture_) {
      ++lines_.textures;
      numbers(words, 2, "the texture coordinate has fewer than two numbers");
    } else if (words[0] == "f") {
      face(words);
    } else if (words[0] == "g" || words[0] == "o" || words[0] == "usemtl") {
      (words[0] == "g" ? names_.group : words[0] == "o" ? names_.object : names_.material) = joined(words);
    }
  }

  void look_at_whole() {
    if (lines_.vertices == 0 || lines_.faces == 0)
      report_.error("obj.no-faces", place_, lines_.vertices == 0 ? "the file has no vertices" : "the file has no faces",
                    "export it as OBJ with its faces; is this an OBJ file at all?");
    else if (vertex_.index > lines_.vertices)
      beyond("vertex", vertex_, lines_.vertices);
    else if (texture_.index > lines_.textures)
      beyond("texture coordinate", texture_, lines_.textures);
  }

  void beyond(const std::string& what, const Greatest& greatest, long count) {
    report_.error("obj.no-such-vertex", place_ + ":" + std::to_string(greatest.line),
                  "the face names " + what + " " + std::to_string(greatest.index) + ", there are " + std::to_string(count),
                  "the file may be cut off; export it again");
  }

  void say(const std::string& code, const std::string& text, const std::string& remedy) {
    report_.error(code, place_ + ":" + std::to_string(line_), text, remedy);
  }

  void numbers(const Words& words, std::size_t count, const char* too_few) {
    if (words.size() < count + 1) return say("obj.not-a-number", too_few, "the file may be cut off; export it again");
    for (std::size_t i = 1; i <= count; ++i) {
      const auto value = read_number<double>(words[i]);
      if (!value) return say("obj.not-a-number", "'" + std::string(words[i]) + "' is not a number", "export it again");
      if (!std::isfinite(*value))
        return say(with_texture_ ? "obj.not-finite" : "body.not-finite",
                   "the " + std::string(words[0] == "v" ? "vertex" : "texture coordinate") + " is not finite: '" +
                       std::string(words[i]) + "'",
                   "export it again; a modifier or a simulation may have blown it up");
      if (std::abs(*value) > farthest)
        return say(with_texture_ ? "obj.too-far" : "body.too-far",
                   "'" + std::string(words[i]) + "' is beyond any garment or body in any unit",
                   "export it again; a modifier or a simulation may have blown it up");
    }
  }

  void index(std::string_view word, long count, const char* what, Greatest& greatest) {
    const auto named = read_number<long>(word);
    if (!named || *named == 0) return say("obj.bad-face", "'" + std::string(word) + "' names no " + what, "export it again");
    if (*named < -count)
      return say("obj.no-such-vertex",
                 "the face names " + std::string(what) + " " + std::to_string(*named) + " before there are so many",
                 "export it again");
    if (*named > greatest.index) greatest = {*named, line_};
  }

  void face(const Words& words) {
    ++lines_.faces;
    if (lines_.names.empty() || lines_.names.back() != names_) lines_.names.push_back(names_);
    lines_.names_of_face.push_back(static_cast<int>(lines_.names.size()) - 1);
    lines_.line_of_face.push_back(line_);
    if (words.size() < 4)
      return say("obj.bad-face", "the face has fewer than three corners", "the file may be cut off; export it again");
    for (std::size_t i = 1; i < words.size() && report_.ok(); ++i) {
      const std::size_t slash = words[i].find('/');
      if (std::count(words[i].begin(), words[i].end(), '/') > 2)  // the loader would make two corners of it
        return say("obj.bad-face", "the corner '" + std::string(words[i]) + "' has more than a vertex, a texture and a normal",
                   "export it again");
      index(words[i].substr(0, slash), lines_.vertices, "vertex", vertex_);
      if (!with_texture_ || !report_.ok()) continue;
      const std::string_view after = slash == std::string_view::npos ? std::string_view{} : words[i].substr(slash + 1);
      const std::string_view texture = after.substr(0, after.find('/'));
      if (texture.empty())
        return say("obj.no-vt", "the face has no texture coordinates (vt), which are the flat pattern" + under(),
                   "export the garment alone and with its texture coordinates (UV), one island for each pattern piece");
      index(texture, lines_.textures, "texture coordinate", texture_);
    }
  }

  std::string under() const {
    const std::string& name = !names_.group.empty() ? names_.group : !names_.object.empty() ? names_.object : names_.material;
    return name.empty() ? "" : " (under '" + name + "')";
  }

  std::string place_;
  bool with_texture_;
  Report& report_;
  ObjLines lines_;
  ObjNames names_;
  long line_ = 0;
  Greatest vertex_, texture_;
};

}  // namespace

ObjLines check_obj_lines(const std::string& text, const std::string& place, bool with_texture, Report& report) {
  return LineCheck(place, with_texture, report).check(text);
}

}  // namespace toile
