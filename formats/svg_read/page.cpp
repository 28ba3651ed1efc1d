#include "formats/svg_read/page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "formats/svg_read/words.h"
#include "garment/units.h"

namespace toile::svg {
namespace {

constexpr double px96 = .0254 / 96;

std::string short_number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}

std::string version_in(std::string_view bytes, std::string_view before) {
  const std::size_t at = bytes.find(before);
  if (at == std::string_view::npos) return {};
  std::string version;
  for (std::size_t i = at + before.size();
       i < bytes.size() && (std::isdigit(static_cast<unsigned char>(bytes[i])) || bytes[i] == '.'); ++i)
    version += bytes[i];
  return version;
}

const Element* find_below(const Element& element, const std::string& name) {
  for (const Element& child : element.children) {
    if (child.name == name) return &child;
    if (const Element* found = find_below(child, name)) return found;
  }
  return nullptr;
}

bool any_with(const Element& element, const std::string& key, const std::string& value) {
  if (element.get(key) == value) return true;
  return std::any_of(element.children.begin(), element.children.end(),
                     [&](const Element& child) { return any_with(child, key, value); });
}

std::string unit_name(double unit) {
  for (const auto& [name, metres] :
       {std::pair{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1.0}, {"inch", .0254}, {"pt", .0254 / 72}, {"px", px96}})
    if (std::abs(unit - metres) < 1e-3 * metres) return name;
  return short_number(unit * mm_per_m) + " mm";
}

}  // namespace

Producer producer_of(const Element& root, std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 4096);
  const auto says = [&](std::string_view words) { return head.find(words) != std::string_view::npos; };
  const std::string freesewing = root.get("freesewing");
  if (!freesewing.empty() || root.get("class") == "freesewing")
    return {"FreeSewing", "FreeSewing" + (freesewing.empty() ? "" : " " + freesewing), 0};
  if (any_with(root, "data-type", "piece"))
    return any_with(root, "data-type", "pattern") ? Producer{"Seamly", "SeamlyLayout", 0} : Producer{"Toile", "Toile", 0};
  if (says("Adobe Illustrator") || root.has("xmlns:x") || root.has("i:viewOrigin") || says("ns_extend") || says("ns.adobe.com"))
    return {"Illustrator", "Adobe Illustrator " + version_in(head, "Adobe Illustrator "), 72};
  std::string inkscape = root.get("inkscape:version");
  if (!inkscape.empty() || says("inkscape.org/namespaces")) {
    inkscape = inkscape.substr(0, inkscape.find(' '));
    const std::vector<double> version = numbers_in(inkscape);
    const bool old = !version.empty() && version.front() < .92 && inkscape.compare(0, 2, "0.") == 0;
    return {"Inkscape", "Inkscape" + (inkscape.empty() ? "" : " " + inkscape), old ? 90.0 : 0};
  }
  // Qt writes SVG Tiny 1.2; Valentina calls every layout "Pattern".
  if (const Element* title = find_below(root, "title"))
    if (root.get("baseProfile") == "tiny" && words_of(*title) == "Pattern") return {"Valentina", "Valentina", 0};
  if (root.get("baseProfile") == "tiny" && says("Generated with Qt")) return {"Qt", "Qt", 0};
  if (says("svgwrite") || root.get("height").find("cm") != std::string::npos) {
    bool panels = false;
    for (const Element* e = find_below(root, "path"); e && !panels; e = nullptr)
      panels = e->get("fill").find("rgb(227") == 0 || e->get("style").find("rgb(227") != std::string::npos;
    if (panels) return {"GarmentCode", "GarmentCode", 0};
  }
  return {"plain", "", 0};
}

Affine Page::to_metres() const {
  Affine t = Affine::Identity();
  t.linear() << unit.x(), 0, 0, -unit.y();
  t.translation() = -(t.linear() * origin);
  return t;
}

Page page_of(const Element& root, const Producer& producer, std::optional<double> override_unit, const std::string& name,
             Report& report) {
  Page page;
  const std::vector<double> box = numbers_in(root.get("viewBox"));
  const bool has_box = box.size() == 4 && box[2] > 0 && box[3] > 0 && std::isfinite(box[2]) && std::isfinite(box[3]) &&
                       std::isfinite(box[0]) && std::isfinite(box[1]);
  if (has_box) page.origin = {box[0], box[1]};
  const std::optional<Length> sides[2] = {length_of(root.get("width")), length_of(root.get("height"))};
  const double pixel = producer.old_dpi > 0 ? .0254 / producer.old_dpi : px96;

  bool absolute = false;
  std::optional<double> metres[2];
  for (int i = 0; i < 2; ++i) {
    if (!sides[i] || sides[i]->value <= 0) continue;
    if (const std::optional<double> unit = metres_per(sides[i]->unit)) {
      metres[i] = sides[i]->value * *unit;
      absolute = true;
    } else if (sides[i]->unit.empty() || sides[i]->unit == "px") {
      metres[i] = sides[i]->value * pixel;
    }
  }
  page.known = metres[0] || metres[1];
  page.stated = absolute && has_box;
  if (has_box && page.known) {
    const double x = metres[0] ? *metres[0] / box[2] : *metres[1] / box[3];
    const double y = metres[1] ? *metres[1] / box[3] : x;
    page.unit = {x, y};
    if (std::abs(x / y - 1) > 5e-3) {
      const bool stretched = root.get("preserveAspectRatio").find("none") != std::string::npos;
      if (!stretched) page.unit.setConstant(std::min(x, y));
      report.warn("svg.aspect", name,
                  "width, height and viewBox do not agree (" + short_number(x * mm_per_m) + " and " +
                      short_number(y * mm_per_m) + " mm per unit); " +
                      (stretched ? "the drawing is stretched as it says" : "the smaller scale is taken"),
                  "check the size of a piece");
    }
    page.size = page.unit.cwiseProduct(Eigen::Vector2d(box[2], box[3]));
  } else {
    page.unit.setConstant(pixel);
    if (metres[0] && metres[1]) page.size = {*metres[0], *metres[1]};
    if (has_box) page.size = page.unit.cwiseProduct(Eigen::Vector2d(box[2], box[3]));
  }
  page.units = {unit_name(page.unit.x()), page.unit.x(), ""};
  if (page.stated)
    page.units.decided_by = "width and viewBox";
  else if (producer.old_dpi > 0)
    page.units.decided_by = producer.author + " draws " + short_number(producer.old_dpi) + " pixels an inch";
  else
    page.units.decided_by = "96 pixels an inch";
  if (override_unit) {
    page.unit.setConstant(*override_unit);
    if (has_box) page.size = page.unit.cwiseProduct(Eigen::Vector2d(box[2], box[3]));
    page.units = {unit_name(*override_unit), *override_unit, "override"};
    page.stated = page.known = true;
  }
  report.note("svg.units", name,
              "one unit of the drawing is " + short_number(page.unit.x() * mm_per_m) + " mm (" + page.units.decided_by + ")");
  return page;
}

namespace {

struct Square {
  Eigen::Vector2d size;        // as drawn, m
  std::vector<double> stated;  // m
  std::size_t index = 0;       // of the line
  int line = 0;                // of the file
};

bool is_rectangle(const Sampled& shape, Eigen::Vector2d& low, Eigen::Vector2d& high) {
  if (!shape.closed || shape.points.size() != 4) return false;
  low = high = shape.points.front();
  for (const Eigen::Vector2d& p : shape.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double slack = 1e-3 * (high - low).maxCoeff();
  for (const Eigen::Vector2d& p : shape.points)
    for (int k = 0; k < 2; ++k)
      if (std::min(std::abs(p[k] - low[k]), std::abs(p[k] - high[k])) > slack) return false;
  return (high - low).minCoeff() > 0;
}

std::vector<Square> rectangles_with_lengths(const Drawing& drawing) {
  std::vector<Square> squares;
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    const DrawnLine& line = drawing.lines[i];
    Eigen::Vector2d low, high;
    if (!is_rectangle(line.shape, low, high)) continue;
    Square square{high - low, {}, i, line.names.line};
    if (line.names.datum("type") == "test-square") {
      square.stated = lengths_in(line.names.datum("side"));
    } else if (line.names.has_class("scalebox")) {
      square.stated = line.names.has_class("imperial") ? std::vector<double>{.1016, .0508} : std::vector<double>{.1, .05};
    } else {
      const double side = square.size.maxCoeff();
      for (const DrawnText& text : drawing.texts) {
        const Eigen::Vector2d off = (low - text.at).cwiseMax(text.at - high).cwiseMax(0.0);
        if (off.norm() > .25 * side || !(speaks_of(text.words, Role::test_square) || text.words.size() < 24)) continue;
        if (allowance_text(text.words)) continue;
        for (const double length : lengths_in(text.words)) square.stated.push_back(length);
      }
    }
    if (!square.stated.empty()) squares.push_back(std::move(square));
  }
  return squares;
}

// How far `square` enlarged by `factor` is from the size it says, as a share.
double off_by(const Square& square, double factor) {
  double least = 1;
  for (const double wide : square.stated)
    for (const double high : square.stated)
      if (wide > 0 && high > 0)
        least = std::min(
            least, std::max(std::abs(square.size.x() * factor / wide - 1), std::abs(square.size.y() * factor / high - 1)));
  return least;
}

}  // namespace

std::vector<std::size_t> test_squares(const Drawing& drawing) {
  std::vector<std::size_t> found;
  for (const Square& square : rectangles_with_lengths(drawing))
    if (off_by(square, 1) < .015) found.push_back(square.index);
  return found;
}

double scale_by_test_squares(const Drawing& drawing, const Page& page, const std::string& name, Report& report) {
  static const double traps[] = {1,  96 / 90.0, 90 / 96.0, 96 / 72.0, 72 / 96.0, 90 / 72.0, 72 / 90.0, 25.4,    1 / 25.4,
                                 10, .1,        96 / 25.4, 25.4 / 96, 72 / 25.4, 25.4 / 72, 2.54,      1 / 2.54};
  double found = 0;
  int line = 0;
  std::string conflicting;
  for (const Square& square : rectangles_with_lengths(drawing)) {
    double best = 0, best_off = .01;
    for (const double trap : traps)
      if (const double off = off_by(square, trap); off < best_off - 1e-9) {
        best_off = off;
        best = trap;
      }
    if (best == 0) continue;
    if (found != 0 && std::abs(best / found - 1) > .01) conflicting += " " + std::to_string(square.line);
    if (found == 0 || std::abs(best - 1) < 1e-9) {
      found = best;
      line = square.line;
    }
  }
  const std::string place = name + ":" + std::to_string(line);
  if (found == 0) return 1;
  if (!conflicting.empty()) {
    report.warn("svg.test-square", place, "the test squares do not agree (lines" + conflicting + ")", "measure a piece");
    return 1;
  }
  if (std::abs(found - 1) < 1e-9) {
    report.note("svg.test-square", place, "the test square has the size it says");
    return 1;
  }
  report.warn("svg.test-square", place,
              "the test square is drawn " + short_number(1 / found) + " times the size it says" +
                  (page.units.decided_by == "override" ? "; the unit asked for is kept"
                                                       : "; the drawing is read at the size the square says"),
              "measure a piece");
  return page.units.decided_by == "override" ? 1 : found;
}

void check_size(double largest, const Page& page, const std::string& name, Report& report) {
  constexpr double least = .12, most = 3;  // m
  const bool fits = largest >= least && largest <= most;
  if (page.stated || page.units.decided_by == "test square") {
    if (!fits)
      report.warn("svg.size", name, "the largest piece is " + in_mm(largest) + ": no usual size of a garment",
                  "give its unit with --units when that is wrong");
    return;
  }
  if (page.known && fits) return;
  std::string candidates;
  int count = 0;
  for (const auto& [unit, metres] : {std::pair{"px", px96}, {"mm", 1e-3}, {"cm", 1e-2}, {"pt", .0254 / 72}, {"inch", .0254}}) {
    const double size = largest / page.unit.x() * metres;
    if (size < least || size > most) continue;
    candidates += (count++ ? ", " : "") + std::string(unit) + " (largest piece " + in_mm(size, 0) + ")";
  }
  report.error("svg.units-ambiguous", name,
               "the file does not say how large it is; the largest piece would be " + in_mm(largest, 0) + " at " +
                   page.units.decided_by + (count ? "; possible are " + candidates : ""),
               "give the unit of the drawing with --units", Fault::ambiguous);
}

}  // namespace toile::svg
