#include "formats/html/page.h"

#include "formats/formats.h"

namespace toile::html {

std::string rendered(const Slot& slots, const std::string& page, const std::string& pattern) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput(
        {.code = "report.bad-template", .place = "report template", .text = why, .remedy = "compare it with " + pattern});
  };
  kainjow::mustache::mustache form(page);
  if (!form.is_valid()) refuse(form.error_message());
  std::string html = form.render(slots);
  if (!form.error_message().empty()) refuse(form.error_message());
  return html;
}

void write_page(const std::filesystem::path& file, const std::filesystem::path& page,
                const std::function<std::string(const std::string&)>& fill) {
  const std::string form = value_or_throw(read_whole_file(page));
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
