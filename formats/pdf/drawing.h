#pragma once
// SVG drawings onto the pages of a PDF, as lines and text (librsvg, cairo). Millimetres, y down.

#include <Eigen/Core>
#include <memory>
#include <string>

namespace toile {

struct PageBox {
  Eigen::Vector2d corner, size;  // upper left
};

class SvgDrawing {
 public:
  // `text`: SVG written by Toile; `size`: of its page. Throws std::invalid_argument when it is no SVG.
  SvgDrawing(const std::string& text, const Eigen::Vector2d& size);
  ~SvgDrawing();
  SvgDrawing(SvgDrawing&&) noexcept;
  SvgDrawing& operator=(SvgDrawing&&) noexcept;

  // Whether anything is drawn in that part of it, to about half a millimetre.
  bool marks(const PageBox& part) const;

 private:
  friend class PdfPages;
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

class PdfPages {
 public:
  explicit PdfPages(const std::string& title);
  ~PdfPages();
  PdfPages(const PdfPages&) = delete;
  PdfPages& operator=(const PdfPages&) = delete;

  // A page of `size`; `name` is what a viewer calls it.
  void begin(const Eigen::Vector2d& size, const std::string& name);
  // The part of `drawing`, `scale` as large, with its upper left corner at `at` on the page. What does not touch the part is
  // left out.
  void draw(const SvgDrawing& drawing, const PageBox& part, const Eigen::Vector2d& at, double scale = 1);
  // The whole drawing from the page's corner.
  void draw(const SvgDrawing& drawing);
  // The bytes of the PDF. No page follows.
  std::string done();

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
};

}  // namespace toile
