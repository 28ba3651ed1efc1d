#include "formats/dxf/code_page.h"

#include <iconv.h>

#include <algorithm>
#include <cctype>

namespace toile::dxf {
namespace {

constexpr const char* replacement = "\xEF\xBF\xBD";

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

// The name that iconv knows a code page of AutoCAD by.
std::string iconv_name(std::string page) {
  for (char& c : page) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const char* prefix : {"ANSI_", "ANSI", "DOS"})
    if (page.starts_with(prefix)) return "CP" + page.substr(std::string(prefix).size());
  if (page.starts_with("ISO8859-") || page == "UTF-8" || page == "UTF8") return page;
  if (page.starts_with("ISO_8859-")) return "ISO" + page.substr(4);
  return {};
}

class Decoder {
 public:
  explicit Decoder(const std::string& from) : handle_(iconv_open("UTF-8", from.c_str())) {}
  ~Decoder() {
    if (known()) iconv_close(handle_);
  }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  bool known() const { return handle_ != reinterpret_cast<iconv_t>(-1); }

  // `lacking` counts the letters that the code page does not have.
  std::string operator()(std::string text, int& lacking) const {
    std::string out;
    char* in = text.data();
    std::size_t left = text.size();
    iconv(handle_, nullptr, nullptr, nullptr, nullptr);
    while (left > 0) {
      char buffer[256];
      char* to = buffer;
      std::size_t room = sizeof buffer;
      const std::size_t before = left;
      const bool done = iconv(handle_, &in, &left, &to, &room) != static_cast<std::size_t>(-1);
      out.append(buffer, sizeof buffer - room);
      if (done || left == 0) break;
      if (left == before && room == sizeof buffer) {
        out += replacement;
        ++lacking;
        ++in;
        --left;
      }
    }
    return out;
  }

 private:
  iconv_t handle_;
};

std::string header_value(const std::vector<Tag>& tags, const char* variable) {
  for (std::size_t i = 0; i + 1 < tags.size(); ++i)
    if (tags[i].code == 9 && same_word(tags[i].value, variable)) return tags[i + 1].value;
  return {};
}

}  // namespace

void decode(std::vector<Tag>& tags, const std::string& name, Report& report) {
  const auto foreign = [](const Tag& tag) { return !is_ascii(tag.value); };
  if (std::none_of(tags.begin(), tags.end(), foreign)) return;
  int lacking = 0;
  if (const Decoder utf8("UTF-8"); utf8.known()) {
    for (const Tag& tag : tags)
      if (foreign(tag)) utf8(tag.value, lacking);
    if (lacking == 0) return;
  }
  const std::string said = header_value(tags, "$DWGCODEPAGE");
  std::string page = iconv_name(said);
  if (page.empty() || !Decoder(page).known()) page = "CP1252";
  const bool guessed = iconv_name(said) != page;
  const Decoder decoder(page);
  if (!decoder.known()) {
    report.warn("dxf.code-page", name, "letters beyond ASCII cannot be read on this computer: it knows no code pages",
                "save the file as DXF 2007 or newer");
    for (Tag& tag : tags)
      for (char& c : tag.value)
        if (static_cast<unsigned char>(c) >= 0x80) c = '?';
    return;
  }
  lacking = 0;
  for (Tag& tag : tags)
    if (foreign(tag)) tag.value = decoder(std::move(tag.value), lacking);
  if (lacking > 0 || (guessed && !said.empty()))
    report.warn("dxf.code-page", name,
                "letters beyond ASCII are read in code page " + page +
                    (said.empty() ? ", the file naming none"
                                  : ", the file naming '" + (guessed ? std::string("another") : said) + "'") +
                    (lacking > 0 ? "; " + std::to_string(lacking) + " of them it does not have" : ""),
                "check the names; save as DXF 2007 or newer");
  else
    report.note("dxf.code-page", name,
                "letters beyond ASCII are read in code page " + page + (said.empty() ? ", the file naming none" : ""));
}

}  // namespace toile::dxf
