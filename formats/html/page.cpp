#include "formats/html/page.h"

#include <kainjow/mustache.hpp>

#include "formats/formats.h"

namespace toile::html {
namespace {

using kainjow::mustache::data;

const std::string part_begins = "{{> ";

data as_data(const Slot& slot) {
  switch (slot.kind()) {
    case Slot::type::text:
      return data(slot.text());
    case Slot::type::condition:
      return data(slot.holds());
    case Slot::type::list: {
      data list{data::type::list};
      for (const Slot& row : slot.list_value()) list.push_back(as_data(row));
      return list;
    }
    case Slot::type::fields:
      break;
  }
  data fields;
  for (std::size_t i = 0; i < slot.names().size(); ++i) fields.set(slot.names()[i], as_data(slot.list_value()[i]));
  return fields;
}

}  // namespace

void Slot::set(const std::string& name, Slot value) {
  names_.push_back(name);
  below_.push_back(std::move(value));
}

void Slot::push_back(Slot value) { below_.push_back(std::move(value)); }

std::string rendered(const Slot& slots, const std::string& page, const std::string& pattern) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput(
        {.code = "report.bad-template", .place = "report template", .text = why, .remedy = "compare it with " + pattern});
  };
  kainjow::mustache::mustache form(page);
  if (!form.is_valid()) refuse(form.error_message());
  std::string html = form.render(as_data(slots));
  if (!form.error_message().empty()) refuse(form.error_message());
  return html;
}

std::string read_page(const std::filesystem::path& page) {
  std::string form = value_or_throw(read_whole_file(page));
  for (std::size_t at = 0; (at = form.find(part_begins, at)) != std::string::npos;) {
    const std::size_t name = at + part_begins.size(), end = form.find("}}", name);
    if (end == std::string::npos)
      throw BadInput({"report.bad-template", Severity::error, page.string(), "a part is named that does not end",
                      "Write {{> NAME}}"});
    const std::string part = value_or_throw(read_whole_file(page.parent_path() / form.substr(name, end - name)));
    form.replace(at, end + 2 - at, part);
    at += part.size();
  }
  return form;
}

void write_page(const std::filesystem::path& file, const std::filesystem::path& page,
                const std::function<std::string(const std::string&)>& fill) {
  const std::string form = read_page(page);
  try {
    write_whole_file(file, fill(form));
  } catch (const BadInput& bad) {
    Finding finding = bad.finding();
    if (finding.code != "report.bad-template") throw;
    finding.place = page.string();
    throw BadInput(finding);
  }
}

}  // namespace toile::html
