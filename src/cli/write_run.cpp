#include "cli/write_run.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "cli/account.h"
#include "cli/certificate.h"
#include "cli/pictures.h"
#include "cli/templates.h"
#include "formats/formats.h"
#include "formats/pdf/papers.h"
#include "formats/pdf/write_pdf.h"
#include "formats/svg/sheet_style.h"
#include "formats/svg/write_svg.h"

namespace toile {
namespace {

void write_patterns(const Job& job, const OutputFolder& out, const std::string& stem) {
  write_dxf_aama(out.path(stem + ".dxf"), job.sheet);
  write_seams(out.path(stem + ".seams.toml"), as_named_in_dxf(cut_pattern(job), job.sheet));
}

// NAME.svg, NAME.pdf (one page) and NAME_a4.pdf (tiled).
void write_cut_sheets(const Job& job, const OutputFolder& out, const std::string& stem) {
  const SheetStyle style = value_or_throw(read_sheet_style(template_file("cut_sheets", "plotter.toml")));
  write_svg(out.path(stem + ".svg"), job.sheet, style);
  PrintOptions printing{std::string(roll), job.recipe.print.margin, job.recipe.print.overlap};
  write_pdf(out.path(stem + ".pdf"), job.sheet, style, printing);
  const Paper* paper = find_paper(job.recipe.print.paper);
  if (!paper) return;
  printing.paper = paper->name;
  write_pdf(out.path(stem + "_" + printing.paper + ".pdf"), job.sheet, style, printing);
}

void write_results(const Job& job, const OutputFolder& out, const std::string& stem) {
  write_cut_sheets(job, out, stem);
  const GarmentMesh& garment = job.target.garment;
  write_obj(out.path("source.obj"), job.worn.garment, job.worn.drape.positions);
  write_obj(out.path("target.obj"), garment, job.target.positions);
  write_obj(out.path("flattened.obj"), with_rest(garment, job.adjustment.flattened), job.adjustment.flattened_drape.positions);
  write_obj(out.path("redrape.obj"), with_rest(garment, job.verified.rest), job.verified.drape.positions);
  write_obj(out.path("body.obj"), job.scene.body.form);
}

}  // namespace

std::string file_stem(const std::filesystem::path& recipe) {
  std::string stem = recipe.stem().string();
  for (char& c : stem)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
  return stem;
}

void say(const Job& job, bool quiet) {
  for (const Finding& finding : job.findings)
    if (finding.severity == Severity::error || !quiet) std::fprintf(stderr, "toile: %s\n", in_words(finding).c_str());
}

void finish_run(Job& job, const OutputFolder& out, const std::string& recipe_text, std::chrono::steady_clock::time_point began,
                Progress& progress) {
  const std::string stem = file_stem(job.recipe_file);
  adjust_and_redraw(job, progress);
  write_patterns(job, out, stem);
  prove(job, out.path(stem + ".dxf"), out.path(stem + ".seams.toml"), progress);
  job.sheet.notes = certificate(job);
  write_patterns(job, out, stem);
  check_still_proved(job, out.path(stem + ".dxf"), out.path(stem + ".seams.toml"));

  progress.begin("write");
  write_results(job, out, stem);
  const ShownPictures pictures = write_run_pictures(job, out);
  std::vector<std::string> files = out.names();
  files.insert(files.end(), {"report.html", "summary.json"});
  std::sort(files.begin(), files.end());
  job.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  write_report(out.path("report.html"), report_of(job, recipe_text, pictures, files), template_file("reports", "report.html"));
  write_summary(out.path("summary.json"), summary_of(job, files));
  progress.end(std::to_string(files.size()) + " files in " + out.folder().string());
}

}  // namespace toile
