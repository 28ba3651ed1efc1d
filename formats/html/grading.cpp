#include "formats/html/grading.h"

#include <algorithm>
#include <cmath>

#include "formats/html/base64.h"
#include "formats/html/figures.h"
#include "formats/html/page.h"
#include "garment/units.h"

namespace toile {
namespace {

using html::change;
using html::mm;
using html::number;
using html::percent;
using html::Slot;

Slot texts(const std::vector<std::string>& from) {
  Slot list{Slot::type::list};
  for (const std::string& text : from) list.push_back(Slot(text));
  return list;
}

Slot sizes(const GradingReport& report) {
  Slot rows{Slot::type::list};
  for (const GradingSize& from : report.sizes) {
    Slot row;
    row.set("size", from.size);
    row.set("folder", from.folder);
    row.set("body", from.body);
    row.set("mean_mm", mm(from.mean));
    row.set("hausdorff_mm", mm(from.hausdorff, 1));
    row.set("hausdorff_percent", percent(from.hausdorff / from.height));
    row.set("stretch", number(from.stretch, 4));
    row.set("seams_mm", mm(from.seam_mismatch));
    row.set("class", from.ok ? "good" : "error");
    row.set("words", from.ok ? "as it should be" : from.trouble);
    row.set("png", base64(from.png));
    rows.push_back(row);
  }
  return rows;
}

std::string girth_cell(const SummaryGirth& girth) {
  const auto cm = [](double metres) { return number(metres * cm_per_m, 1); };
  return cm(girth.garment) + " = " + cm(girth.body) + (girth.ease < 0 ? " - " : " + ") + cm(std::abs(girth.ease));
}

// A row for each girth that the garment has in some size.
Slot girths(const GradingReport& report) {
  std::vector<std::string> names;
  for (const GradingSize& size : report.sizes)
    for (const SummaryGirth& girth : size.girths)
      if (girth.covered && std::find(names.begin(), names.end(), girth.name) == names.end()) names.push_back(girth.name);
  Slot rows{Slot::type::list};
  for (const std::string& name : names) {
    std::vector<std::string> cells;
    for (const GradingSize& size : report.sizes) {
      const auto found = std::find_if(size.girths.begin(), size.girths.end(),
                                      [&](const SummaryGirth& girth) { return girth.covered && girth.name == name; });
      cells.push_back(found == size.girths.end() ? "" : girth_cell(*found));
    }
    Slot row;
    row.set("name", name);
    row.set("cells", texts(cells));
    rows.push_back(row);
  }
  return rows;
}

Slot pieces(const GradingReport& report) {
  Slot rows{Slot::type::list};
  for (const GradingPiece& from : report.pieces) {
    std::vector<std::string> cells;
    for (std::size_t s = 0; s < from.width.size(); ++s) cells.push_back(mm(from.width[s], 1) + " x " + mm(from.height[s], 1));
    Slot row;
    row.set("name", from.name);
    row.set("cells", texts(cells));
    rows.push_back(row);
  }
  return rows;
}

Slot points(const GradingReport& report) {
  Slot rows{Slot::type::list};
  for (const GradingPoint& from : report.points) {
    std::vector<std::string> cells;
    for (std::size_t s = 0; s < from.dx.size(); ++s) cells.push_back(change(from.dx[s]) + " / " + change(from.dy[s]));
    Slot row;
    row.set("piece", from.piece);
    row.set("point", from.point);
    row.set("cells", texts(cells));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

void write_grading(const std::filesystem::path& file, const GradingReport& report, const std::filesystem::path& page) {
  html::write_page(file, page, [&](const std::string& form) {
    Slot slots;
    slots.set("title", report.title);
    slots.set("base", report.base);
    slots.set("sizes", sizes(report));
    slots.set("girths", girths(report));
    slots.set("pieces", pieces(report));
    slots.set("points", points(report));
    slots.set("files", texts(report.files));
    return html::rendered(slots, form, "templates/reports/grading.html");
  });
}

}  // namespace toile
