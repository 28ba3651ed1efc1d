#pragma once
// DXF text, tag by tag, in fixed formats: codes padded to three columns, LF, the entities of R12 without handles.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace toile::dxf {

void put(std::string& out, int code, std::string_view value);
void put(std::string& out, int code, int value);
// Four digits after the point, never "-0.0000". Throws std::invalid_argument when `value` is not finite.
void put_number(std::string& out, int code, double value);
void put_xy(std::string& out, int code, const Eigen::Vector2d& at);  // codes `code` and `code` + 10

void put_section(std::string& out, std::string_view name);
void put_section_end(std::string& out);

void put_line(std::string& out, std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
void put_polyline(std::string& out, std::string_view layer, const std::vector<Eigen::Vector2d>& points, bool closed);
void put_text(std::string& out, std::string_view layer, const Eigen::Vector2d& at, double height, std::string_view text);
void put_insert(std::string& out, std::string_view layer, std::string_view block);  // at the origin, unscaled

}  // namespace toile::dxf
