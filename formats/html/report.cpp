#include "formats/html/report.h"

#include <cmath>
#include <stdexcept>

#include "formats/formats.h"
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
using html::rendered;
using html::Slot;
using html::write_page;

Slot facts(const std::vector<ReportFact>& from) {
  Slot rows{Slot::type::list};
  for (const ReportFact& fact : from) {
    Slot row;
    row.set("name", fact.name);
    row.set("value", fact.value);
    rows.push_back(row);
  }
  return rows;
}

Slot distances(const RunReport& report) {
  Slot rows{Slot::type::list};
  for (const ReportDistance& from : report.distances) {
    Slot row;
    row.set("name", from.name);
    row.set("mean_mm", mm(from.mean));
    row.set("mean_percent", percent(from.mean / report.height, 3));
    row.set("hausdorff_mm", mm(from.hausdorff));
    row.set("hausdorff_percent", percent(from.hausdorff / report.height));
    row.set("stretch", number(from.stretch, 4));
    rows.push_back(row);
  }
  return rows;
}

Slot steps(const RunReport& report) {
  Slot rows{Slot::type::list};
  for (std::size_t i = 0; i < report.steps.size(); ++i) {
    const AdjustStep& from = report.steps[i];
    Slot row;
    row.set("number", i == 0 ? "0 (plain flattening)" : std::to_string(i));
    row.set("best", Slot(static_cast<int>(i) == report.best));
    row.set("mean_mm", mm(from.mean));
    row.set("hausdorff_mm", mm(from.hausdorff));
    row.set("hausdorff_percent", percent(from.hausdorff / report.height));
    row.set("stretch", number(from.stretch, 4));
    row.set("worst_stretch", number(from.worst_stretch, 3));
    row.set("seam_mismatch_mm", mm(from.seam_mismatch));
    row.set("contracting_percent", percent(from.contracting, 1));
    row.set("slipped_mm", mm(from.slipped, 1));
    row.set("seconds", number(from.seconds, 1));
    rows.push_back(row);
  }
  return rows;
}

Slot seams(const RunReport& report) {
  Slot rows{Slot::type::list};
  for (const ReportSeam& from : report.seams) {
    Slot row;
    row.set("name", from.name);
    row.set("before_a", mm(from.before_a, 1));
    row.set("before_b", mm(from.before_b, 1));
    row.set("after_a", mm(from.after_a, 1));
    row.set("after_b", mm(from.after_b, 1));
    row.set("mismatch", mm(from.mismatch));
    const bool fails = from.mismatch > report.seam_failure;
    const bool warns = !fails && from.mismatch > report.seam_warning;
    row.set("class", fails ? "error" : warns ? "warning" : "good");
    row.set("words", fails ? "does not match" : warns ? "check" : "matches");
    rows.push_back(row);
  }
  return rows;
}

Slot edges(const RunReport& report) {
  Slot rows{Slot::type::list};
  for (const ReportEdge& from : report.edges) {
    Slot row;
    row.set("piece", from.piece);
    row.set("edge", from.edge);
    row.set("before", mm(from.before, 1));
    row.set("after", mm(from.after, 1));
    row.set("change", change(from.after - from.before));
    row.set("shape", from.straight ? "straight" : "curved");
    row.set("points", std::to_string(from.points));
    rows.push_back(row);
  }
  return rows;
}

std::string in_words(Severity severity) {
  return severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note";
}

Slot findings(const std::vector<Finding>& from) {
  Slot rows{Slot::type::list};
  for (const Finding& finding : from) {
    Slot row;
    row.set("class", in_words(finding.severity));
    row.set("code", finding.code);
    row.set("place", finding.place);
    row.set("text", finding.text);
    row.set("remedy", finding.remedy);
    rows.push_back(row);
  }
  return rows;
}

Slot pictures(const std::vector<ReportPicture>& from) {
  Slot rows{Slot::type::list};
  for (const ReportPicture& picture : from) {
    Slot row;
    row.set("caption", picture.caption);
    row.set("base64", base64(picture.png));
    rows.push_back(row);
  }
  return rows;
}

Slot girths(const std::vector<SummaryGirth>& from) {
  Slot rows{Slot::type::list};
  for (const SummaryGirth& girth : from) {
    Slot row;
    row.set("name", girth.name);
    row.set("height_cm", number(girth.height * cm_per_m, 1));
    row.set("body_cm", number(girth.body * cm_per_m, 1));
    row.set("covered", Slot(girth.covered));
    if (girth.covered) {
      row.set("garment_cm", number(girth.garment * cm_per_m, 1));
      row.set("cloth_cm", number(girth.cloth * cm_per_m, 1));
      row.set("ease_cm", number(girth.ease * cm_per_m, 1));
    }
    rows.push_back(row);
  }
  return rows;
}

Slot names(const std::vector<std::string>& from) {
  Slot rows{Slot::type::list};
  for (const std::string& name : from) rows.push_back(Slot(name));
  return rows;
}

// A list together with the question whether it has anything in it, for its heading.
void set_list(Slot& page, const std::string& name, const Slot& rows) {
  page.set("has_" + name, Slot(!rows.list_value().empty()));
  page.set(name, rows);
}

}  // namespace

std::string report_html(const RunReport& report, const std::string& page) {
  if (!(report.height > 0)) throw std::invalid_argument("report: height must be above 0");
  Slot slots;
  slots.set("title", report.title);
  slots.set("verdict", report.verdict);
  slots.set("outcome", report.outcome == Severity::note ? "good" : in_words(report.outcome));
  slots.set("height_cm", number(report.height * cm_per_m, 1));
  slots.set("stop", report.stop);
  slots.set("seam_warning_mm", mm(report.seam_warning, 0));
  slots.set("seam_failure_mm", mm(report.seam_failure, 0));
  slots.set("recipe", report.recipe);
  slots.set("has_recipe", Slot(!report.recipe.empty()));
  set_list(slots, "certificate", names(report.certificate));
  set_list(slots, "inputs", facts(report.inputs));
  slots.set("drape_heading", report.drape_heading);
  set_list(slots, "drape", facts(report.drape));
  set_list(slots, "distances", distances(report));
  set_list(slots, "steps", steps(report));
  set_list(slots, "seams", seams(report));
  set_list(slots, "edges", edges(report));
  set_list(slots, "findings", findings(report.findings));
  set_list(slots, "pictures", pictures(report.pictures));
  set_list(slots, "girths", girths(report.girths));
  set_list(slots, "maps", pictures(report.maps));
  set_list(slots, "files", names(report.files));
  return rendered(slots, page, "templates/reports/report.html");
}

void write_report(const std::filesystem::path& file, const RunReport& report, const std::filesystem::path& page) {
  write_page(file, page, [&](const std::string& form) { return report_html(report, form); });
}

}  // namespace toile
