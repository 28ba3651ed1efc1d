#include "formats/html/grading.h"

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
    Slot girths{Slot::type::list};
    for (const SummaryGirth& girth : from.girths) {
      Slot line;
      line.set("name", girth.name);
      line.set("body_cm", number(girth.body * cm_per_m, 1));
      line.set("garment_cm", girth.covered ? number(girth.garment * cm_per_m, 1) : "");
      line.set("ease_cm", girth.covered ? number(girth.ease * cm_per_m, 1) : "");
      girths.push_back(line);
    }
    row.set("girths", girths);
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
    slots.set("sizes", sizes(report));
    slots.set("pieces", pieces(report));
    slots.set("points", points(report));
    slots.set("files", texts(report.files));
    return html::rendered(slots, form, "templates/reports/grading.html");
  });
}

}  // namespace toile
