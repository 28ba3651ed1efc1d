#pragma once
// Files in, files out. Readers never throw for bad input: they return findings. Writers write to a temporary file and rename
// it; they throw BadInput("file.cannot-create") and leave nothing behind.

#include <filesystem>
#include <optional>
#include <string>

#include "garment/cut_sheet.h"
#include "garment/fabric.h"
#include "garment/garment_map.h"
#include "garment/mannequin.h"
#include "garment/mesh.h"
#include "garment/pattern.h"
#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile {

struct PatternReadOptions {
  std::optional<double> unit_in_metres;        // overrides what the file says: 1e-3 for mm
  std::optional<std::filesystem::path> seams;  // default: NAME.seams.toml beside the pattern, when it exists
  std::string size;                            // of a graded file; empty: the sample size
};

// By extension and content: DXF (AAMA), GarmentCode JSON. Everything of the file is in the value or in a finding.
Loaded<PatternFile> read_pattern_file(const std::filesystem::path& file, const PatternReadOptions& options = {});

// The pattern alone.
Loaded<Pattern> read_pattern(const std::filesystem::path& file, const PatternReadOptions& options = {});

// NAME.seams.toml beside the pattern NAME.dxf, when there is one.
std::optional<std::filesystem::path> seams_beside(const std::filesystem::path& pattern);

// A body: OBJ in metres, with NAME.skeleton.json (or `skeleton`) when there is one.
Loaded<Mannequin> read_body(const std::filesystem::path& file, const std::optional<std::filesystem::path>& skeleton = {});

// NAME.skeleton.json beside NAME.obj or NAME_wrap.obj, when there is one.
std::optional<std::filesystem::path> skeleton_beside(const std::filesystem::path& body);

// templates/fabrics/*.toml
Loaded<Fabric> read_fabric(const std::filesystem::path& file);

// One row of a size chart, templates/mannequins/*.csv
Loaded<SizeChartRow> read_size_chart_row(const std::filesystem::path& file, const std::string& size);

// AAMA DXF (R12): blocks of cut pieces, mm.
void write_dxf_aama(const std::filesystem::path& file, const CutSheet& sheet);
// `pattern` under the piece names of the DXF of `sheet`: ASCII ("Ärmel" is "Aermel"), each once. So must it be given to
// write_seams for the two files to belong together.
Pattern as_named_in_dxf(Pattern pattern, const CutSheet& sheet);
// Seams sidecar for a pattern written as DXF.
void write_seams(const std::filesystem::path& file, const Pattern& pattern);
// GarmentCode specification (formats/garmentcode). The report has what the format cannot hold.
Report write_garmentcode(const std::filesystem::path& file, const Pattern& pattern);
// Cut sheet in mm.
void write_svg(const std::filesystem::path& file, const CutSheet& sheet);
// A drape: v in metres, vt = rest shape in metres, one group per panel.
void write_obj(const std::filesystem::path& file, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions);
void write_obj(const std::filesystem::path& file, const Mannequin& mannequin);
// Body and drape as binary glTF 2.0 (metres, Y up, faces +Z): a node "body" and one below "garment" for each panel by its name,
// smooth normals across seams, both sides shown. With `map`, its colours on the vertices (triangles of their own where it is a
// map of triangles), its values in the map's unit in the attribute _VALUE, and title, unit and ends of the scale in the extras
// of the node "garment".
void write_glb(const std::filesystem::path& file, const Mannequin& body, const GarmentMesh& garment,
               const Eigen::Matrix3Xd& positions, const ColouredMap* map = nullptr);
// Bones, landmarks and measures of a body: NAME.skeleton.json beside NAME.obj.
void write_skeleton(const std::filesystem::path& file, const Mannequin& mannequin);

// Writes `bytes` to a temporary file beside `file`, then renames it. Every writer ends here.
void write_whole_file(const std::filesystem::path& file, const std::string& bytes);
// The file's bytes; error "file.missing" or "file.unreadable".
Loaded<std::string> read_whole_file(const std::filesystem::path& file);

}  // namespace toile
