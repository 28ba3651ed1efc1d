#include "formats/formats.h"

#include "formats/dxf/tags.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/garmentcode/garmentcode.h"
#include "formats/obj/garment.h"
#include "formats/seams/seams.h"
#include "formats/svg_read/svg_read.h"

namespace toile {
namespace {

// A way to write patterns that Toile reads.
struct PatternFormat {
  const char* name;
  const char* extension;
  bool (*looks_like)(std::string_view bytes);  // of a file with another extension
  Loaded<PatternFile> (*read)(const std::filesystem::path& file, const PatternReadOptions& options);
};

bool looks_like_json(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{';
}

const PatternFormat formats[] = {
    {"DXF (AAMA, ASTM)", ".dxf", dxf::looks_like_dxf, read_dxf_pattern},
    {"GarmentCode JSON", ".json", looks_like_json,
     [](const std::filesystem::path& file, const PatternReadOptions& options) {
       return read_garmentcode_file(file, options.unit_in_metres);
     }},
    {"OBJ with the pattern as texture coordinates", ".obj", [](std::string_view) { return false; },
     [](const std::filesystem::path& file, const PatternReadOptions& options) {
       return read_obj_garment(file, options.unit_in_metres);
     }},
    {"SVG", ".svg", looks_like_svg,
     [](const std::filesystem::path& file, const PatternReadOptions& options) {
       return read_svg(file, options.unit_in_metres, options.size);
     }},
    {"compressed SVG", ".svgz", [](std::string_view) { return false; },
     [](const std::filesystem::path& file, const PatternReadOptions& options) {
       return read_svg(file, options.unit_in_metres, options.size);
     }},
};

const PatternFormat* format_of(const std::filesystem::path& file, std::string_view bytes) {
  const std::string extension = file.extension().string();
  for (const PatternFormat& format : formats)
    if (dxf::same_word(extension, format.extension)) return &format;
  for (const PatternFormat& format : formats)
    if (format.looks_like(bytes)) return &format;
  return nullptr;
}

}  // namespace

std::optional<std::filesystem::path> seams_beside(const std::filesystem::path& pattern) {
  std::filesystem::path sidecar = std::filesystem::path(pattern).replace_extension(".seams.toml");
  std::error_code ignored;
  if (!std::filesystem::exists(sidecar, ignored)) return std::nullopt;
  return sidecar;
}

Loaded<PatternFile> read_pattern_file(const std::filesystem::path& file, const PatternReadOptions& options) {
  const Loaded<std::string> bytes = read_whole_file(file);
  if (!bytes.value) return {std::nullopt, bytes.report};
  const PatternFormat* format = format_of(file, *bytes.value);
  if (bytes.value->compare(0, 5, "%PDF-") == 0 || (!format && dxf::same_word(file.extension().string(), ".pdf"))) {
    Report report;
    report.error(
        "format.pdf", file.filename().string(), "a PDF is lines on paper: Toile writes it, and does not read it",
        "Give the DXF or SVG it was made from; or turn a page into SVG (inkscape IN.pdf --export-filename=OUT.svg) and see "
        "with toile inspect whether its pieces and its size are right");
    return {std::nullopt, report};
  }
  if (!format) {
    std::string known;
    for (const PatternFormat& each : formats)
      known += std::string(known.empty() ? "" : ", ") + each.name + " (" + each.extension + ")";
    Report report;
    report.error("format.unknown", file.filename().string(), "this is no pattern file Toile can read", "it reads " + known);
    return {std::nullopt, report};
  }
  Loaded<PatternFile> loaded = format->read(file, options);

  const auto sidecar = options.seams ? options.seams : seams_beside(file);
  if (!loaded.value || !sidecar) return loaded;
  loaded.report.append(apply_seams(loaded.value->pattern, *sidecar));
  if (!loaded.report.ok()) loaded.value.reset();
  return loaded;
}

Loaded<Pattern> read_pattern(const std::filesystem::path& file, const PatternReadOptions& options) {
  Loaded<PatternFile> loaded = read_pattern_file(file, options);
  if (!loaded.value) return {std::nullopt, std::move(loaded.report)};
  return {std::move(loaded.value->pattern), std::move(loaded.report)};
}

}  // namespace toile
