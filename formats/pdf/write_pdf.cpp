#include "formats/pdf/write_pdf.h"

#include <algorithm>

#include "formats/formats.h"
#include "formats/pdf/cover.h"
#include "formats/pdf/drawing.h"
#include "formats/pdf/finish.h"
#include "formats/pdf/papers.h"
#include "formats/pdf/tile_frame.h"
#include "formats/pdf/tiling.h"
#include "formats/svg/write_svg.h"
#include "formats/svg/xml_text.h"
#include "garment/units.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double least_margin = 5e-3;  // m; no home printer prints nearer to the edge, and words stand there
constexpr double most_overlap = 50e-3;
constexpr int most_pages = 5000;  // empty ones too

class Printing {
 public:
  Printing(const CutSheet& sheet, const SheetStyle& style, const PrintOptions& options)
      : sheet_(sheet),
        style_(style),
        margin_(options.margin * mm_per_m),
        overlap_(options.overlap * mm_per_m),
        pages_(printable(sheet.title)) {}

  std::string on_roll() {
    const Vector2d size = svg_size(sheet_, style_, SheetParts::uncoloured);
    const SvgDrawing whole(svg_text(sheet_, style_, SheetParts::uncoloured), size);
    TilePlan plan{unrolled(size, margin_, overlap_), {}};
    choose(plan, [&](const PageBox& part) { return whole.marks(part); });
    if (plan.printed.size() > 1) {
      tiles(plan, whole, 0);
    } else {
      pages_.begin(size, tile_name(0, 0));
      pages_.draw(whole);
    }
    return ready_for_print(pages_.done());
  }

  std::string on(const Paper& paper) {
    const Vector2d size = svg_size(sheet_, style_, SheetParts::pieces);
    const SvgDrawing pieces(svg_text(sheet_, style_, SheetParts::pieces), size);
    TilePlan plan{tiled(size, mm_per_m * Vector2d(paper.width, paper.length), margin_, overlap_), {}};
    // Also what lies inside a piece: the paper pattern has no holes.
    const SvgDrawing filled = outlines(size, 1);
    choose(plan, [&](const PageBox& part) { return filled.marks(part) || pieces.marks(part); });
    plan.drop_empty_columns();
    const std::vector<CoverPage> covers = cover_pages(sheet_, plan, style_);
    for (const CoverPage& cover : covers) {
      pages_.begin(plan.tiling.page, cover.map ? "map" : "notes");
      if (cover.map) pages_.draw(outlines(size, cover.scale), {Vector2d::Zero(), size}, cover.map->corner, cover.scale);
      pages_.draw(SvgDrawing(cover.svg, plan.tiling.page));
    }
    tiles(plan, pieces, static_cast<int>(covers.size()));
    return ready_for_print(pages_.done());
  }

 private:
  static std::size_t count(const Tiling& tiling) {
    const double pages = static_cast<double>(tiling.rows) * tiling.columns;
    if (pages > most_pages)
      throw BadInput({"pdf.too-many-pages", Severity::error, "paper", "the sheet would be " + in_digits(pages) + " pages of it",
                      "Choose a larger paper, or roll"});
    return static_cast<std::size_t>(pages);
  }

  // The cut lines so that they are .3 mm wide when they are drawn that much smaller.
  SvgDrawing outlines(const Vector2d& size, double scale) const {
    SheetStyle thin = style_;
    thin.cut = {.colour = "#707070", .width = .3e-3 / scale, .dash = {}, .shown = true};
    return {svg_text(sheet_, thin, SheetParts::outlines), size};
  }

  template <class Shows>
  static void choose(TilePlan& plan, const Shows& shows) {
    plan.printed.reserve(count(plan.tiling));
    for (int row = 0; row < plan.tiling.rows; ++row)
      for (int column = 0; column < plan.tiling.columns; ++column) {
        plan.printed.push_back(shows(PageBox{plan.tiling.corner(row, column), plan.tiling.window()}));
      }
  }

  void tiles(const TilePlan& plan, const SvgDrawing& drawing, int before) {
    const Tiling& tiling = plan.tiling;
    const std::string title = printable(sheet_.title);
    int page = before;
    for (int row = 0; row < tiling.rows; ++row)
      for (int column = 0; column < tiling.columns; ++column) {
        if (!plan.prints(row, column)) continue;
        ++page;
        pages_.begin(tiling.page, tile_name(row, column));
        pages_.draw(SvgDrawing(tile_frame(plan, row, column, title, page, before + plan.pages(), style_), tiling.page));
        pages_.draw(drawing, {tiling.corner(row, column), tiling.window()}, tiling.margin);
      }
  }

  const CutSheet& sheet_;
  const SheetStyle& style_;
  double margin_, overlap_;  // mm
  PdfPages pages_;
};

}  // namespace

std::optional<Finding> fault_of(const PrintOptions& options) {
  const auto fault = [](const char* code, const char* place, const std::string& text, const std::string& remedy) {
    return Finding{code, Severity::error, place, text, remedy};
  };
  const Paper* paper = find_paper(options.paper);
  if (!paper && !is_roll(options.paper))
    return fault("pdf.no-such-paper", "paper", "there is no paper '" + options.paper + "'", "They are " + paper_names());
  const double side = paper ? paper->width : longest_pdf_side / mm_per_m;
  if (!(options.margin >= least_margin) || !(options.margin <= side / 4))
    return fault("pdf.margin", "margin", "a margin of " + in_mm(options.margin) + " cannot be printed",
                 "Give " + in_mm(least_margin) + " to " + in_mm(side / 4));
  const double most = std::min(most_overlap, (side - 2 * options.margin) / 2);
  if (!(options.overlap >= 0) || !(options.overlap <= most))
    return fault("pdf.overlap", "overlap", "pages cannot overlap by " + in_mm(options.overlap), "Give 0 mm to " + in_mm(most));
  return std::nullopt;
}

std::string pdf_bytes(const CutSheet& sheet, const SheetStyle& style, const PrintOptions& options) {
  if (const auto fault = fault_of(options)) throw BadInput(*fault);
  Printing printing(sheet, style, options);
  const Paper* paper = find_paper(options.paper);
  return paper ? printing.on(*paper) : printing.on_roll();
}

void write_pdf(const std::filesystem::path& file, const CutSheet& sheet, const SheetStyle& style, const PrintOptions& options) {
  write_whole_file(file, pdf_bytes(sheet, style, options));
}

}  // namespace toile
