#pragma once
// Pages made from Mustache templates (templates/reports).

#include <filesystem>
#include <functional>
#include <kainjow/mustache.hpp>
#include <string>

namespace toile::html {

using Slot = kainjow::mustache::data;

// `page` with its slots filled. Throws BadInput "report.bad-template"; `pattern` is the file to compare it with.
std::string rendered(const Slot& slots, const std::string& page, const std::string& pattern);

// Reads the template `page`, and writes what `fill` makes of its text to `file`. Throws BadInput.
void write_page(const std::filesystem::path& file, const std::filesystem::path& page,
                const std::function<std::string(const std::string&)>& fill);

}  // namespace toile::html
