#include "formats/svg_read/drawing.h"

#include <algorithm>
#include <cmath>

#include "formats/svg_read/words.h"

namespace toile::svg {
namespace {

constexpr double tolerance = 8e-5, farthest = 1e4;  // m: of sampled curves; of coordinates
constexpr int most_elements = 100000;               // uses counted as often as drawn
constexpr std::size_t most_points = 3000000;
constexpr int deepest_use = 12;

struct Scope {
  Affine to_metres = Affine::Identity();
  Style style;
  int group = 0;
  int uses = 0;
  bool removed = false;  // by display or opacity
};

class Walker {
 public:
  Walker(const Element& root, const std::string& name, Report& report)
      : sheet_(StyleSheet::of(root)), name_(name), report_(report) {
    collect_ids(root);
  }

  Drawing draw(const Element& root, const Affine& to_metres) {
    drawing_.groups.push_back({names_of(root), -1, false});
    way_.push_back(&root);
    Scope scope;
    scope.to_metres = to_metres;
    scope.style = sheet_.style_of(way_, scope.style);
    children(root, scope);
    place_texts_on_paths();
    if (bad_transforms_ > 0)
      report_.warn("svg.bad-transform", name_ + ":" + std::to_string(bad_transform_line_),
                   std::to_string(bad_transforms_) + " transforms cannot be read and are left out", "flatten the transforms");
    if (clipped_ > 0)
      report_.warn(
          "svg.clip-path", name_ + ":" + std::to_string(clipped_line_),
          "clipped or masked, and read whole with what that hides: " + std::to_string(clipped_) + " elements or groups",
          "release the clips (Inkscape: Object > Clip) where they hide something");
    return std::move(drawing_);
  }

 private:
  void collect_ids(const Element& element) {
    if (!element.get("id").empty()) ids_.emplace(element.get("id"), &element);
    for (const Element& child : element.children) collect_ids(child);
  }

  std::string at_line(const Element& element) const { return name_ + ":" + std::to_string(element.line); }

  void stop(const char* code, const Element& element, const std::string& text, const std::string& remedy) {
    if (!stopped_) report_.error(code, at_line(element), text, remedy);
    stopped_ = true;
  }

  void children(const Element& element, const Scope& scope) {
    for (const Element& child : element.children) {
      if (stopped_) return;
      if (child.name != "#text") visit(child, scope);
    }
  }

  void visit(const Element& element, const Scope& outer) {
    const std::string& name = element.name;
    if (is_definition(element)) return;
    if (++elements_ > most_elements)
      return stop("svg.too-many-elements", element, "the file draws more than 100000 elements", "take decoration out of it");
    way_.push_back(&element);
    Scope scope = outer;
    scope.style = sheet_.style_of(way_, outer.style);
    const bool group_hidden =
        scope.style.is_removed() || (!is_shape(element) && length_of(scope.style.opacity).value_or(Length{1, {}}).value <= 0);
    scope.removed = outer.removed || group_hidden;
    if (const std::string& text = element.get("transform"); !text.empty()) {
      if (const std::optional<Affine> own = transform_of(text))
        scope.to_metres = outer.to_metres * *own;
      else if (++bad_transforms_ == 1)
        bad_transform_line_ = element.line;
    }
    if (scope.style.is_clipped() && !scope.removed && ++clipped_ == 1) clipped_line_ = element.line;
    if (is_shape(element))
      shape(element, scope);
    else if (name == "text")
      text(element, scope);
    else if (name == "use")
      use(element, scope);
    else if (name == "g" || name == "a")
      group(element, scope);
    else if (name == "svg")
      nested(element, scope, user_units(element.get("width")), user_units(element.get("height")));
    else if (name == "switch")
      chosen(element, scope);
    else if (name == "image" || name == "foreignObject")
      leave_out(scope.removed ? "hidden elements" : name == "image" ? "pictures" : "foreign objects");
    way_.pop_back();
  }

  void leave_out(const std::string& what) { ++drawing_.left_out[what]; }
  void group(const Element& element, Scope scope) {
    const bool layer = element.get("inkscape:groupmode") == "layer";
    drawing_.groups.push_back({names_of(element), scope.group, layer});
    scope.group = static_cast<int>(drawing_.groups.size()) - 1;
    children(element, scope);
  }

  // Of a <switch>, what a program without extensions draws.
  void chosen(const Element& element, const Scope& scope) {
    for (const Element& child : element.children)
      if (child.name != "#text" && child.get("requiredExtensions").empty() && child.name != "foreignObject")
        return visit(child, scope);
  }

  void nested(const Element& element, Scope scope, const std::optional<double>& width, const std::optional<double>& height) {
    scope.to_metres.translate(
        Eigen::Vector2d(user_units(element.get("x")).value_or(0), user_units(element.get("y")).value_or(0)));
    viewed(element, scope, width, height);
  }

  void viewed(const Element& element, Scope scope, const std::optional<double>& width, const std::optional<double>& height) {
    const std::vector<double> box = numbers_in(element.get("viewBox"));
    if (box.size() == 4 && box[2] > 0 && box[3] > 0 && width && height && *width > 0 && *height > 0) {
      double sx = *width / box[2], sy = *height / box[3];
      Eigen::Vector2d shift(0, 0);
      if (element.get("preserveAspectRatio").find("none") == std::string::npos) {
        sx = sy = std::min(sx, sy);
        shift = Eigen::Vector2d(*width - sx * box[2], *height - sy * box[3]) / 2;
      }
      scope.to_metres.translate(shift).scale(Eigen::Vector2d(sx, sy)).translate(-Eigen::Vector2d(box[0], box[1]));
    }
    group(element, scope);
  }

  void use(const Element& element, Scope scope) {
    std::string target = element.get("href");
    if (target.empty()) target = element.get("xlink:href");
    const auto found = target.empty() || target[0] != '#' ? ids_.end() : ids_.find(target.substr(1));
    if (found == ids_.end()) return leave_out("uses of what is not in the file");
    if (scope.removed || !scope.style.is_shown()) return leave_out("hidden elements");
    if (++scope.uses > deepest_use)
      return stop("svg.use-too-deep", element, "<use> refers to itself, or goes deeper than 12", "expand the clones");
    scope.to_metres.translate(
        Eigen::Vector2d(user_units(element.get("x")).value_or(0), user_units(element.get("y")).value_or(0)));
    const Element& symbol = *found->second;
    const Role role = role_in_words(symbol.get("id"));
    if (role == Role::decoration) return leave_out("decorations");
    if (role == Role::notch || role == Role::drill) {
      Affine own = scope.to_metres;
      if (const auto inner = transform_of(symbol.get("transform"))) own = own * *inner;
      DrawnMark mark{symbol.get("id"), own * Eigen::Vector2d::Zero(), names_of(element), scope.group};
      if (!mark.at.allFinite() || mark.at.cwiseAbs().maxCoeff() > farthest) return bad_number(element);
      drawing_.marks.push_back(std::move(mark));
      return;
    }
    way_.push_back(&symbol);
    if (symbol.name == "symbol" || symbol.name == "svg") {
      Scope inner = scope;
      inner.style = sheet_.style_of(way_, scope.style);
      const auto size = [&](const char* key) {
        const std::optional<double> own = user_units(element.get(key));
        return own ? own : user_units(symbol.get(key));
      };
      if (++elements_ <= most_elements) viewed(symbol, inner, size("width"), size("height"));
      way_.pop_back();
    } else {
      way_.pop_back();
      drawing_.groups.push_back({names_of(element), scope.group, false});
      scope.group = static_cast<int>(drawing_.groups.size()) - 1;
      visit(symbol, scope);
    }
  }

  void bad_number(const Element& element) {
    stop("svg.bad-number", element, "a coordinate of <" + element.name + "> is no finite number or beyond 10 km",
         "delete the element, or export it again");
  }

  void shape(const Element& element, const Scope& scope) {
    const bool marked = scope.style.marker_start != "none" || scope.style.marker_end != "none";
    if (scope.removed || !scope.style.is_shown() || (!scope.style.is_drawn() && !marked)) return leave_out("hidden elements");
    const PathData data = shape_of(element);
    if (data.not_finite) return bad_number(element);
    if (data.broken)
      report_.warn("svg.bad-path", at_line(element),
                   "the path of <" + element.name + "> cannot be read from character " + std::to_string(data.at + 1) +
                       " on; what stands before is kept",
                   "correct the path or export it again");
    DrawnLine line{{},
                   names_of(element),
                   scope.group,
                   paths_++,
                   scope.style.is_dashed(),
                   scope.style.fill != "none",
                   scope.style.stroke != "none",
                   scope.style.stroke,
                   scope.style.marker_start,
                   scope.style.marker_end};
    bool drawn = false;
    for (const SubPath& part : data.parts) {
      for (const Segment& s : part.segments)
        for (const Eigen::Vector2d* p : {&s.to, &s.c1, &s.c2, &s.from}) {
          const Eigen::Vector2d at = scope.to_metres * *p;
          if (!at.allFinite() || at.cwiseAbs().maxCoeff() > farthest) return bad_number(element);
        }
      line.shape = sampled(part, scope.to_metres, tolerance, element.has("data-piece"));
      if (line.shape.points.size() < 2) continue;
      points_ += line.shape.points.size();
      if (points_ > most_points)
        return stop("svg.too-many-points", element, "the file has more than 3 million points", "simplify it");
      drawing_.lines.push_back(line);
      drawn = true;
    }
    if (!drawn) leave_out("lines without length");
  }

  // Each line of text by itself; a <tspan> that moves down begins another.
  void text(const Element& element, const Scope& scope) {
    if (scope.removed || !scope.style.is_shown() || !scope.style.is_drawn()) return leave_out("hidden elements");
    Eigen::Vector2d at(user_units(element.get("x")).value_or(0), user_units(element.get("y")).value_or(0));
    bool any = false;
    std::string plain;
    for (const Element& part : element.children) {
      if (part.name == "#text") {
        plain += part.text;
        continue;
      }
      way_.push_back(&part);
      const Style style = sheet_.style_of(way_, scope.style);
      way_.pop_back();
      Eigen::Vector2d begin = at;
      if (const auto x = user_units(part.get("x"))) begin.x() = *x;
      if (const auto y = user_units(part.get("y"))) begin.y() = *y;
      if (const auto dy = user_units(part.get("dy"))) begin.y() += *dy;
      at.y() = begin.y();
      std::string path = part.get("xlink:href").empty() ? part.get("href") : part.get("xlink:href");
      if (part.name != "textPath") path.clear();
      any |= add_text(words_of(part), begin, style, part, scope, path.empty() ? path : path.substr(1));
    }
    Element own;
    own.name = "#text";
    own.text = plain;
    any |= add_text(words_of(own),
                    Eigen::Vector2d(user_units(element.get("x")).value_or(0), user_units(element.get("y")).value_or(0)),
                    scope.style, element, scope, {});
    if (!any) leave_out("empty texts");
  }

  bool add_text(const std::string& words, const Eigen::Vector2d& begin, const Style& style, const Element& part,
                const Scope& scope, const std::string& on_path) {
    if (words.empty()) return false;
    DrawnText text{words, scope.to_metres * begin, 0, false, names_of(part), scope.group};
    for (const std::string& name : names_of(*way_.back()).classes) text.names.classes.push_back(name);
    text.names.line = way_.back()->line;
    text.size = user_units(style.font_size).value_or(16) * std::sqrt(std::abs(scope.to_metres.linear().determinant()));
    text.bold = style.font_weight == "bold" || style.font_weight == "bolder" ||
                numbers_in(style.font_weight + " ") >= std::vector<double>{600} || text.names.has_class("font-bold") ||
                text.names.has_class("bold");
    if (!text.at.allFinite() || text.at.cwiseAbs().maxCoeff() > farthest) {
      leave_out("texts far outside");
      return true;
    }
    if (!on_path.empty()) on_paths_[drawing_.texts.size()] = on_path;
    drawing_.texts.push_back(std::move(text));
    return true;
  }

  void place_texts_on_paths() {
    for (const auto& [index, id] : on_paths_)
      for (const DrawnLine& line : drawing_.lines)
        if (line.names.id == id) {
          drawing_.texts[index].at = point_at<2>(line.shape.points, .5);
          break;
        }
  }

  StyleSheet sheet_;
  const std::string& name_;
  Report& report_;
  std::map<std::string, const Element*> ids_;
  std::vector<const Element*> way_;
  Drawing drawing_;
  std::map<std::size_t, std::string> on_paths_;
  int elements_ = 0, paths_ = 0, bad_transforms_ = 0, bad_transform_line_ = 0, clipped_ = 0, clipped_line_ = 0;
  std::size_t points_ = 0;
  bool stopped_ = false;
};

}  // namespace

Drawing drawing_of(const Element& root, const Affine& to_metres, const std::string& name, Report& report) {
  return Walker(root, name, report).draw(root, to_metres);
}

}  // namespace toile::svg
