#include "formats/dxf/drawing.h"

#include <cstddef>
#include <span>

#include "formats/dxf/code_page.h"
#include "formats/dxf/entity.h"
#include "formats/dxf/tags.h"

namespace toile::dxf {
namespace {

constexpr std::size_t most_bytes = 256'000'000;
constexpr int most_errors = 20;  // a file with more is hopeless, and its report unreadable

class DrawingReader {
 public:
  DrawingReader(std::span<const Tag> tags, const std::string& name) : tags_(tags), name_(name) {}

  Loaded<Drawing> read() {
    while (at_ < tags_.size() && error_count() < most_errors) {
      const std::span<const Tag> group = next_group();
      const Tag& head = group.front();
      if (head.code != 0) {
        read_variables(group);  // "9 $ACADVER" before the first section
      } else if (head.value == "SECTION") {
        open_section(group);
      } else if (head.value == "ENDSEC") {
        close_section();
      } else if (head.value == "EOF") {
        ended_ = true;
      } else if (section_ == "BLOCKS" || section_ == "ENTITIES") {
        read_member(group);
      } else if (section_.empty()) {
        report_.error("dxf.broken-tag", name_ + ":" + std::to_string(head.line),
                      "'" + head.value.substr(0, 40) + "' outside of any section", "the file is damaged; export it again");
      }
    }
    if (error_count() < most_errors) check_end();
    Loaded<Drawing> loaded;
    loaded.report = std::move(report_);
    if (loaded.report.ok()) loaded.value = std::move(drawing_);
    return loaded;
  }

 private:
  // From one 0 tag to the next.
  std::span<const Tag> next_group() {
    const std::size_t first = at_++;
    while (at_ < tags_.size() && tags_[at_].code != 0) ++at_;
    return tags_.subspan(first, at_ - first);
  }

  void read_variables(std::span<const Tag> group) {
    for (std::size_t i = 0; i + 1 < group.size(); ++i)
      if (group[i].code == 9) drawing_.header.emplace(group[i].value, group[i + 1].value);
  }

  void open_section(std::span<const Tag> group) {
    section_ = "?";
    for (const Tag& tag : group)
      if (tag.code == 2) {
        section_ = tag.value;
        break;
      }
    section_line_ = group.front().line;
    if (section_ == "ENTITIES") has_entities_ = true;
    if (section_ == "HEADER") read_variables(group);
  }

  void close_section() {
    open_polyline_ = false;
    in_block_ = false;
    section_.clear();
  }

  void read_member(std::span<const Tag> group) {
    const Tag& head = group.front();
    if (head.value == "BLOCK" && section_ == "BLOCKS") return open_block(group);
    if (head.value == "ENDBLK") {
      in_block_ = open_polyline_ = false;
      return;
    }
    if (section_ == "BLOCKS" && !in_block_) return;
    if (head.value == "SEQEND") {
      open_polyline_ = false;
      return;
    }
    Entity entity = read_entity(group, name_, report_);
    std::vector<Entity>& members = section_ == "BLOCKS" ? drawing_.blocks.back().entities : drawing_.entities;
    if (entity.type == "VERTEX") {
      if (!open_polyline_ || entity.kind == Kind::other || entity.points.empty()) return;
      members.back().points.push_back(entity.points.front());
      members.back().bulges.push_back(entity.bulges.empty() ? 0.0 : entity.bulges.front());
      return;
    }
    open_polyline_ = entity.type == "POLYLINE";
    for (std::size_t end = entity.text.find('\n'); end != std::string::npos; end = entity.text.find('\n')) {
      members.push_back(entity);  // a paragraph of an MTEXT
      members.back().text = trimmed(std::string_view(entity.text).substr(0, end));
      entity.text.erase(0, end + 1);
    }
    members.push_back(std::move(entity));
  }

  void open_block(std::span<const Tag> group) {
    Block block;
    block.line = group.front().line;
    block.layer = "0";
    for (const Tag& tag : group) {
      if (tag.code == 2) block.name = tag.value;
      if (tag.code == 8) block.layer = tag.value;
      if (tag.code != 10 && tag.code != 20) continue;
      if (const std::optional<double> parsed = number(tag.value))
        (tag.code == 10 ? block.base.x() : block.base.y()) = *parsed;
      else
        report_.error("dxf.not-a-number", name_ + ":" + std::to_string(tag.line + 1),
                      "the base point of block '" + block.name + "' is '" + tag.value.substr(0, 40) + "'",
                      "export the file again");
    }
    drawing_.blocks.push_back(std::move(block));
    in_block_ = true;
    open_polyline_ = false;
  }

  // That the file is cut off comes first: what else is wrong follows from it.
  void check_end() {
    const std::string end = name_ + ":" + std::to_string(tags_.back().line + 1);
    const bool cut_off = !section_.empty() && !ended_;
    if (cut_off || (!has_entities_ && report_.ok())) {
      Report truncated;
      truncated.error(
          "dxf.truncated", end,
          cut_off ? "the file ends inside the " + section_ + " section that begins at line " + std::to_string(section_line_)
                  : std::string("the file has no ENTITIES section"),
          "the file is cut off; export or copy it again");
      truncated.append(report_);
      report_ = std::move(truncated);
    } else if (!ended_ && report_.ok()) {
      report_.warn("dxf.no-eof", end, "the file has no EOF mark; all its sections are complete");
    } else if (!section_.empty()) {
      report_.warn("dxf.no-endsec", end, "the " + section_ + " section is not ended");
    }
  }

  int error_count() const {
    int count = 0;
    for (const Finding& finding : report_.findings) count += finding.severity == Severity::error;
    return count;
  }

  std::span<const Tag> tags_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::string section_;  // empty: between sections
  int section_line_ = 0;
  bool in_block_ = false, open_polyline_ = false, has_entities_ = false, ended_ = false;
  Drawing drawing_;
  Report report_;
};

}  // namespace

Loaded<Drawing> read_drawing(std::string_view bytes, const std::string& name) {
  if (bytes.size() > most_bytes) {
    Loaded<Drawing> loaded;
    loaded.report.error("dxf.too-large", name, "a DXF of more than 256 MB", "export the pieces alone");
    return loaded;
  }
  Loaded<std::vector<Tag>> tags = read_tags(bytes, name);
  if (!tags.value) return {std::nullopt, std::move(tags.report)};
  Report report = std::move(tags.report);
  decode(*tags.value, name, report);
  Loaded<Drawing> loaded = DrawingReader(*tags.value, name).read();
  report.append(loaded.report);
  loaded.report = std::move(report);
  return loaded;
}

}  // namespace toile::dxf
