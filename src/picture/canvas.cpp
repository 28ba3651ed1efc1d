#include "picture/canvas.h"

#include <cairo.h>

#include <new>
#include <stdexcept>

namespace toile {
namespace {

void trace(cairo_t* cairo, const std::vector<Eigen::Vector2d>& points) {
  cairo_new_path(cairo);
  for (const Eigen::Vector2d& p : points) cairo_line_to(cairo, p.x(), p.y());
}

// Byte order of a cairo pixel is that of the machine.
void into_cairo(const Image& image, cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  auto byte = image.pixels.begin();
  for (int y = 0; y < image.height; ++y) {
    auto* row = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < image.width; ++x, byte += 3)
      row[x] = static_cast<std::uint32_t>(byte[0]) << 16 | static_cast<std::uint32_t>(byte[1]) << 8 |
               static_cast<std::uint32_t>(byte[2]);
  }
  cairo_surface_mark_dirty(surface);
}

Image out_of_cairo(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Image image{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < image.height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < image.width; ++x)
      for (const int shift : {16, 8, 0}) image.pixels.push_back(static_cast<std::uint8_t>(row[x] >> shift & 0xFFU));
  }
  return image;
}

struct Sheet {
  cairo_surface_t* surface;
  explicit Sheet(const Image& image) : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height)) {
    if (image.pixels.empty() || cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
      cairo_surface_destroy(surface);
      throw std::invalid_argument("picture: it is empty or too large");
    }
    into_cairo(image, surface);
  }
  ~Sheet() { cairo_surface_destroy(surface); }
  Sheet(const Sheet&) = delete;
  Sheet& operator=(const Sheet&) = delete;
};

}  // namespace

struct Canvas::Drawing {
  Sheet sheet;
  cairo_t* cairo;
  explicit Drawing(const Image& image) : sheet(image), cairo(cairo_create(sheet.surface)) {
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(cairo, options);
    cairo_font_options_destroy(options);
  }
  ~Drawing() { cairo_destroy(cairo); }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  void colour(const Colour& c, double opacity) const { cairo_set_source_rgba(cairo, c.red, c.green, c.blue, opacity); }
  void font(double size, bool bold) const {
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, size);
  }
  double advance(const std::string& words) const {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, words.c_str(), &extents);
    return extents.x_advance;
  }
};

Canvas::Canvas(const Image& image) : drawing_(std::make_unique<Drawing>(image)) {}
Canvas::~Canvas() = default;

void Canvas::line(const std::vector<Eigen::Vector2d>& points, const Colour& colour, double width, bool closed) {
  trace(drawing_->cairo, points);
  if (closed) cairo_close_path(drawing_->cairo);
  drawing_->colour(colour, 1);
  cairo_set_line_width(drawing_->cairo, width);
  cairo_stroke(drawing_->cairo);
}

void Canvas::fill(const std::vector<Eigen::Vector2d>& points, const Colour& colour, double opacity) {
  trace(drawing_->cairo, points);
  cairo_close_path(drawing_->cairo);
  drawing_->colour(colour, opacity);
  cairo_fill(drawing_->cairo);
}

void Canvas::words(const std::string& words, const Eigen::Vector2d& at, double size, const Colour& colour, Align align,
                   bool bold) {
  drawing_->font(size, bold);
  const double width = align == Align::left ? 0 : drawing_->advance(words);
  drawing_->colour(colour, 1);
  cairo_move_to(drawing_->cairo, at.x() - (align == Align::centre ? width / 2 : width), at.y());
  cairo_show_text(drawing_->cairo, words.c_str());
}

double Canvas::width_of(const std::string& words, double size, bool bold) const {
  drawing_->font(size, bold);
  return drawing_->advance(words);
}

Image Canvas::image() const { return out_of_cairo(drawing_->sheet.surface); }

std::string png_bytes(const Image& image) {
  const Sheet sheet(image);
  std::string bytes;
  const auto append = [](void* to, const unsigned char* data, unsigned length) {
    try {
      static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
      return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
      return CAIRO_STATUS_NO_MEMORY;
    }
  };
  if (cairo_surface_write_to_png_stream(sheet.surface, append, &bytes) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("png_bytes: cairo could not encode the picture");
  return bytes;
}

}  // namespace toile
