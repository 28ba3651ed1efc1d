#include "formats/pdf/drawing.h"

#include <cairo-pdf.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double points_per_mm = 72 / 25.4;

template <auto destroy>
struct Deleter {
  template <class T>
  void operator()(T* value) const {
    destroy(value);
  }
};
using SurfacePointer = std::unique_ptr<cairo_surface_t, Deleter<cairo_surface_destroy>>;
using CairoPointer = std::unique_ptr<cairo_t, Deleter<cairo_destroy>>;
using HandlePointer = std::unique_ptr<RsvgHandle, Deleter<g_object_unref>>;

[[noreturn]] void fail(const char* what, GError* error) {
  const std::string why = error ? error->message : "unknown";
  g_clear_error(&error);
  throw std::invalid_argument(std::string(what) + ": " + why);
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

cairo_status_t keep(void* into, const unsigned char* bytes, unsigned int length) {
  try {
    static_cast<std::string*>(into)->append(reinterpret_cast<const char*>(bytes), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

}  // namespace

struct SvgDrawing::Handle {
  HandlePointer svg;
  Vector2d size;  // mm

  // In millimetres from the origin of `cairo`.
  void render(cairo_t* cairo) const {
    const RsvgRectangle whole{0, 0, size.x(), size.y()};
    GError* error = nullptr;
    if (!rsvg_handle_render_document(svg.get(), cairo, &whole, &error)) fail("drawing", error);
  }
};

SvgDrawing::SvgDrawing(const std::string& text, const Vector2d& size) : handle_(std::make_unique<Handle>()) {
  GError* error = nullptr;
  const std::unique_ptr<GInputStream, Deleter<g_object_unref>> stream(
      g_memory_input_stream_new_from_data(text.data(), static_cast<gssize>(text.size()), nullptr));
  handle_->svg.reset(rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
  if (!handle_->svg) fail("drawing", error);
  handle_->size = size;
}

SvgDrawing::~SvgDrawing() = default;
SvgDrawing::SvgDrawing(SvgDrawing&&) noexcept = default;
SvgDrawing& SvgDrawing::operator=(SvgDrawing&&) noexcept = default;

bool SvgDrawing::marks(const PageBox& part) const {
  constexpr double longest = 4000;  // pixels
  const double scale = std::min(2.0, longest / part.size.maxCoeff());
  const int width = static_cast<int>(std::ceil(scale * part.size.x()));
  const int height = static_cast<int>(std::ceil(scale * part.size.y()));
  const SurfacePointer image(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));
  const CairoPointer cairo(cairo_create(image.get()));
  cairo_scale(cairo.get(), scale, scale);
  cairo_translate(cairo.get(), -part.corner.x(), -part.corner.y());
  cairo_rectangle(cairo.get(), part.corner.x(), part.corner.y(), part.size.x(), part.size.y());
  cairo_clip(cairo.get());
  handle_->render(cairo.get());
  check(cairo_status(cairo.get()));
  cairo_surface_flush(image.get());
  const unsigned char* row = cairo_image_surface_get_data(image.get());
  const int stride = cairo_image_surface_get_stride(image.get());
  for (int y = 0; y < height; ++y, row += stride)
    if (std::any_of(row, row + width, [](unsigned char ink) { return ink != 0; })) return true;
  return false;
}

struct PdfPages::Surface {
  std::string bytes;
  SurfacePointer surface;
  CairoPointer cairo;
};

PdfPages::PdfPages(const std::string& title) : surface_(std::make_unique<Surface>()) {
  surface_->surface.reset(cairo_pdf_surface_create_for_stream(keep, &surface_->bytes, 1, 1));
  cairo_surface_t* pdf = surface_->surface.get();
  check(cairo_surface_status(pdf));
  cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_TITLE, title.c_str());
  cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATOR, "Toile");
}

PdfPages::~PdfPages() = default;

void PdfPages::begin(const Vector2d& size, const std::string& name) {
  Surface& at = *surface_;
  if (at.cairo) cairo_show_page(at.cairo.get());
  const Vector2d points = points_per_mm * size;
  cairo_pdf_surface_set_size(at.surface.get(), points.x(), points.y());
  cairo_pdf_surface_set_page_label(at.surface.get(), name.c_str());
  if (!at.cairo) at.cairo.reset(cairo_create(at.surface.get()));
  check(cairo_status(at.cairo.get()));
}

void PdfPages::draw(const SvgDrawing& drawing, const PageBox& part, const Vector2d& at, double scale) {
  cairo_t* cairo = surface_->cairo.get();
  if (!cairo) throw std::invalid_argument("PDF: no page was begun");
  cairo_save(cairo);
  cairo_scale(cairo, points_per_mm, points_per_mm);
  cairo_translate(cairo, at.x(), at.y());
  cairo_scale(cairo, scale, scale);
  cairo_rectangle(cairo, 0, 0, part.size.x(), part.size.y());
  cairo_clip(cairo);
  cairo_translate(cairo, -part.corner.x(), -part.corner.y());
  drawing.handle_->render(cairo);
  cairo_restore(cairo);
  check(cairo_status(cairo));
}

void PdfPages::draw(const SvgDrawing& drawing) { draw(drawing, {Vector2d::Zero(), drawing.handle_->size}, Vector2d::Zero()); }

std::string PdfPages::done() {
  if (surface_->cairo) cairo_show_page(surface_->cairo.get());
  surface_->cairo.reset();
  cairo_surface_finish(surface_->surface.get());
  check(cairo_surface_status(surface_->surface.get()));
  return std::move(surface_->bytes);
}

}  // namespace toile
