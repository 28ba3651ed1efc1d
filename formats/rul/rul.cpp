#include "formats/rul/rul.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "formats/dxf/tags.h"

namespace toile {
namespace {

constexpr std::size_t most_bytes = 64'000'000, most_sizes = 1000;

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\v\f,;", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\v\f,;", at), text.size());
    words.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

// The numbers of a rule's body, whatever stands between them; nothing when one is out of range or something else stands there.
std::optional<std::vector<double>> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\v\f,;()=\r\n", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(" \t\v\f,;()=\r\n", at), text.size());
    const std::optional<double> value = dxf::number(text.substr(at, end - at));
    if (!value) return {};
    numbers.push_back(*value);
    at = end;
  }
  return numbers;
}

bool begins_with(std::string_view line, std::string_view word) {
  return line.size() >= word.size() && dxf::same_word(line.substr(0, word.size()), word);
}

class TableReader {
 public:
  TableReader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  Loaded<GradeTable> read() {
    if (rest_.substr(0, 3) == "\xEF\xBB\xBF") rest_.remove_prefix(3);
    while (!ended_ && next_line()) {
      if (line_.empty()) continue;
      if (dxf::same_word(line_, "END"))
        ended_ = true;
      else if (begins_with(line_, "RULE:"))
        read_rule();
      else if (!heading())
        break;
      if (!report_.ok()) break;
    }
    if (report_.ok()) finish();
    Loaded<GradeTable> loaded;
    loaded.report = std::move(report_);
    if (loaded.report.ok()) loaded.value = std::move(table_);
    return loaded;
  }

 private:
  bool next_line() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find_first_of("\r\n");
    line_ = dxf::trimmed(rest_.substr(0, end));
    if (end == std::string_view::npos) {
      rest_ = {};
    } else {
      const bool pair = rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n';
      rest_.remove_prefix(end + (pair ? 2 : 1));
    }
    ++number_;
    return true;
  }
  std::string place() const { return name_ + ":" + std::to_string(number_); }

  // False when the file is no rule table.
  bool heading() {
    std::size_t colon = line_.find(':');
    if (colon == std::string_view::npos) {
      const bool version = begins_with(line_, "version") || begins_with(line_, "ANSI/AAMA") || begins_with(line_, "ASTM");
      if (!version && table_.sizes.empty()) {
        report_.error("rul.not-rul", place(),
                      "this is no grade rule table: '" + std::string(line_.substr(0, 40)) + "' is none of its headings",
                      "export the grading as AAMA or ASTM rule table (.rul)");
        return false;
      }
      if (!version) report_.note("rul.header", place(), "'" + std::string(line_.substr(0, 60)) + "' is not read");
      return true;
    }
    const std::string_view key = dxf::trimmed(line_.substr(0, colon));
    const std::string value(dxf::trimmed(line_.substr(colon + 1)));
    const auto is = [&](std::string_view word) { return dxf::same_word(key, word); };
    if (is("SIZE LIST")) {
      table_.sizes = words_of(value);
      sizes_at_ = number_;
    } else if (is("NUMBER OF SIZES")) {
      announced_ = dxf::whole_number(value);
    } else if (is("SAMPLE SIZE") || is("BASE SIZE")) {
      table_.sample_size = value;
    } else if (is("UNITS")) {
      table_.units = value;
    } else if (is("GRADE RULE TABLE") || is("GRADING RULE TABLE")) {
      table_.name = value;
    } else if (is("AUTHOR")) {
      table_.author = value;
    } else if (!known_heading(key)) {
      report_.note("rul.header", place(), "'" + std::string(line_.substr(0, 60)) + "' is not read");
    }
    return true;
  }

  static bool known_heading(std::string_view key) {
    for (const char* word : {"PRODUCT", "VERSION", "CREATION DATE", "CREATION TIME", "STYLE NAME"})
      if (dxf::same_word(key, word)) return true;
    return begins_with(key, "ASTM") || begins_with(key, "ANSI/AAMA") || begins_with(key, "version");
  }

  void rule_error(int line, const std::string& text) {
    report_.error("rul.rule", name_ + ":" + std::to_string(line), text,
                  "a rule is written as 'RULE: DELTA 7' and a pair dx, dy for each size; export the table again");
  }

  void read_rule() {
    const int begin = number_;
    if (table_.sizes.empty()) {
      report_.error("rul.not-rul", place(), "a rule stands before the size list", "export the table again");
      return;
    }
    std::string_view head = dxf::trimmed(line_.substr(5));
    const std::size_t kind_ends = std::min(head.find_first_of(" \t"), head.size());
    const std::string kind(head.substr(0, kind_ends));
    head = dxf::trimmed(head.substr(kind_ends));
    const std::size_t number_ends = std::min(head.find_first_not_of("+-0123456789"), head.size());
    const std::optional<int> number = dxf::whole_number(head.substr(0, number_ends));
    if (!dxf::same_word(kind, "DELTA"))
      return rule_error(begin, "a rule of the kind '" + kind.substr(0, 40) + "' is unknown; only DELTA is");
    if (!number || *number < 0) return rule_error(begin, "a rule without a number");
    std::string body(head.substr(number_ends));
    for (std::string_view saved = rest_; next_line(); saved = rest_) {
      if (begins_with(line_, "RULE:") || dxf::same_word(line_, "END")) {
        rest_ = saved;
        --number_;
        break;
      }
      body += ' ';
      body += line_;
    }
    const std::optional<std::vector<double>> numbers = numbers_of(body);
    const std::size_t n = table_.sizes.size();
    if (!numbers || numbers->size() != 2 * n)
      return rule_error(begin, "rule " + std::to_string(*number) + " should have " + std::to_string(2 * n) +
                                   " numbers, a pair for each of " + std::to_string(n) + " sizes, but has " +
                                   (numbers ? std::to_string(numbers->size()) : std::string("something else among them")));
    std::vector<Eigen::Vector2d> moves;
    for (std::size_t i = 0; i < n; ++i) moves.emplace_back((*numbers)[2 * i], (*numbers)[2 * i + 1]);
    if (!table_.rules.emplace(*number, std::move(moves)).second)
      report_.warn("rul.duplicate-rule", name_ + ":" + std::to_string(begin),
                   "rule " + std::to_string(*number) + " comes twice; the first counts", "number the rules once each");
  }

  void finish() {
    const std::string at_sizes = sizes_at_ > 0 ? name_ + ":" + std::to_string(sizes_at_) : name_;
    if (table_.sizes.empty()) {
      report_.error("rul.not-rul", name_, "this is no grade rule table: it has no SIZE LIST",
                    "export the grading as AAMA or ASTM rule table (.rul)");
      return;
    }
    if (announced_ && *announced_ != static_cast<int>(table_.sizes.size()))
      report_.error("rul.sizes", at_sizes,
                    "NUMBER OF SIZES is " + std::to_string(*announced_) + ", but the size list has " +
                        std::to_string(table_.sizes.size()),
                    "size names have no blanks in a rule table; rename the sizes and export again");
    for (std::size_t i = 0; i < table_.sizes.size(); ++i)
      if (std::find(table_.sizes.begin(), table_.sizes.begin() + static_cast<std::ptrdiff_t>(i), table_.sizes[i]) !=
          table_.sizes.begin() + static_cast<std::ptrdiff_t>(i))
        report_.error("rul.sizes", at_sizes, "size '" + table_.sizes[i] + "' is listed twice", "name each size once");
    if (table_.sizes.size() > most_sizes) report_.error("rul.sizes", at_sizes, "more than 1000 sizes", "split the table");
    const auto sample = std::find_if(table_.sizes.begin(), table_.sizes.end(),
                                     [&](const std::string& size) { return dxf::same_word(size, table_.sample_size); });
    if (sample == table_.sizes.end())
      report_.error("rul.sizes", name_, "the sample size '" + table_.sample_size + "' is none of the size list",
                    "set the sample size in the pattern program and export again");
    if (!report_.ok()) return;
    table_.sample_size = *sample;
    const auto base = static_cast<std::size_t>(sample - table_.sizes.begin());
    std::string moving;
    for (auto& [number, moves] : table_.rules) {
      const Eigen::Vector2d from = moves[base];
      if (from.isZero(1e-9)) continue;
      moving += " " + std::to_string(number);
      for (Eigen::Vector2d& move : moves) move -= from;
    }
    if (!moving.empty())
      report_.warn("rul.sample-moves", name_,
                   "rules should leave the sample size where it is, but these do not:" + moving +
                       "; the other sizes are taken relative to it",
                   "check the sample size of the table");
    if (!ended_)
      report_.warn("rul.no-end", place(), "the table has no END; its last rule is complete",
                   "check that the file was copied whole");
  }

  std::string_view rest_, line_;
  const std::string& name_;
  int number_ = 0, sizes_at_ = 0;
  bool ended_ = false;
  std::optional<int> announced_;
  GradeTable table_;
  Report report_;
};

}  // namespace

Loaded<GradeTable> read_rul_bytes(std::string_view bytes, const std::string& name) {
  if (bytes.size() > most_bytes) {
    Loaded<GradeTable> loaded;
    loaded.report.error("rul.too-large", name, "a grade rule table of more than 64 MB", "is this the right file?");
    return loaded;
  }
  return TableReader(bytes, name).read();
}

}  // namespace toile
