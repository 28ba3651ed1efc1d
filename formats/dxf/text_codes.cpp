#include "formats/dxf/text_codes.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace toile::dxf {
namespace {

void append_utf8(std::string& out, unsigned code) {
  if (code < 0x20 || (code >= 0xD800 && code < 0xE000)) return;
  const auto put = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

std::optional<unsigned> digits(std::string_view text, std::size_t count, int base) {
  if (text.size() < count) return {};
  unsigned value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + count, value, base);
  if (error != std::errc{} || end != text.data() + count) return {};
  return value;
}

class Reader {
 public:
  Reader(std::string_view rest, bool mtext) : rest_(rest), mtext_(mtext) {}

  std::string read() {
    while (!rest_.empty())
      if (!percent() && !unicode() && !(mtext_ && (escape() || caret() || brace()))) {
        out_ += rest_.front();
        skip(1);
      }
    return std::move(out_);
  }

 private:
  void skip(std::size_t count) { rest_.remove_prefix(std::min(count, rest_.size())); }

  bool percent() {
    if (!rest_.starts_with("%%") || rest_.size() < 3) return false;
    if (const auto code = digits(rest_.substr(2), 3, 10); code && *code < 256) {
      append_utf8(out_, *code);
      skip(5);
      return true;
    }
    switch (rest_[2]) {
      case 'd':
      case 'D':
        out_ += "\u00B0";
        break;
      case 'p':
      case 'P':
        out_ += "\u00B1";
        break;
      case 'c':
      case 'C':
        out_ += "\u2300";
        break;
      case '%':
        out_ += '%';
        break;
      case 'u':
      case 'U':
      case 'o':
      case 'O':
      case 'k':
      case 'K':
        break;
      default:
        return false;
    }
    skip(3);
    return true;
  }

  bool unicode() {
    if (!rest_.starts_with("\\U+")) return false;
    const auto code = digits(rest_.substr(3), 4, 16);
    if (!code) return false;
    append_utf8(out_, *code);
    skip(7);
    return true;
  }

  bool escape() {
    if (rest_.front() != '\\' || rest_.size() < 2) return false;
    const char code = rest_[1];
    const std::string_view until_semicolon = "ACcFfHQTWp", switches = "LlOoKk", literal = "\\{}";
    if (literal.find(code) != std::string_view::npos) {
      out_ += code;
    } else if (code == '~') {
      out_ += ' ';
    } else if (code == 'P' || code == 'N' || code == 'X') {
      out_ += '\n';
    } else if (code == 'S' || until_semicolon.find(code) != std::string_view::npos) {
      const std::size_t end = rest_.find(';');
      if (end == std::string_view::npos) return false;
      if (code == 'S')
        for (const char c : rest_.substr(2, end - 2)) out_ += c == '^' || c == '#' ? '/' : c;
      skip(end + 1);
      return true;
    } else if (switches.find(code) == std::string_view::npos) {
      return false;
    }
    skip(2);
    return true;
  }

  bool caret() {
    if (rest_.front() != '^' || rest_.size() < 2) return false;
    if (rest_[1] == 'J')
      out_ += '\n';
    else if (rest_[1] == 'I')
      out_ += ' ';
    else if (rest_[1] != 'M')
      return false;
    skip(2);
    return true;
  }

  bool brace() {
    if (rest_.front() != '{' && rest_.front() != '}') return false;
    skip(1);
    return true;
  }

  std::string_view rest_;
  bool mtext_;
  std::string out_;
};

}  // namespace

std::string plain_text(const std::string& text, bool mtext) { return Reader(text, mtext).read(); }

}  // namespace toile::dxf
