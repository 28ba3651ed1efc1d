#include "formats/seams/join.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "formats/seams/span.h"
#include "formats/seams/span_text.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr double unnoticed = 1e-3;  // m, two lengths may differ by this without a word

struct Ease {
  double metres = 0;
  double share = 0;  // of the shorter length
};

struct Manner {
  std::string name;
  bool reversed = false;
  bool right_to_wrong = false;
  Ease ease;
};

std::optional<Ease> ease_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::text && !node.text.empty() && node.text.back() == '%') {
    const auto share = parse_along(node.text);
    if (share && share->value >= 0) return Ease{0, share->value};
  } else if (const auto metres = length_of(node, sidecar)) {
    return Ease{std::abs(*metres), 0};
  } else {
    return std::nullopt;
  }
  sidecar.report.error("seams.bad-value", sidecar.at(node),
                       "'ease' must be a length or a percentage, not " + toml_quoted(node.text),
                       "Write for example \"2.5 cm\" or \"4 %\"");
  return std::nullopt;
}

std::optional<Manner> manner_of(const TomlNode& entry, Sidecar& sidecar) {
  Manner manner;
  bool good = true;
  const auto take = [&](const char* key, auto read, auto& into) {
    const TomlNode* node = find(entry, key);
    if (!node) return;
    if (const auto value = read(*node, sidecar))
      into = *value;
    else
      good = false;
  };
  take("name", text_of, manner.name);
  take("reversed", truth_of, manner.reversed);
  take("right_to_wrong", truth_of, manner.right_to_wrong);
  take("ease", ease_of, manner.ease);
  return good ? std::optional(manner) : std::nullopt;
}

bool runs_against_drawing(const Pattern& pattern, const EdgeSpan& span) {
  return is_mirrored(*find_piece(pattern, span.piece), span.copy);
}

std::string in_words(const Pattern& pattern, const EdgeSpan& span) {
  return span_text(span, copies(*find_piece(pattern, span.piece)) == 1);
}

// Whether the beginning of `b`, as drawn, lies at the beginning of `a`. Outlines that both run counter-clockwise on the right
// side run against each other along their seam; a mirrored copy's runs clockwise.
bool same_way(const Pattern& pattern, const EdgeSpan& a, const EdgeSpan& b, const Manner& manner) {
  return (runs_against_drawing(pattern, a) != runs_against_drawing(pattern, b)) != manner.reversed;
}

void sew(Pattern& pattern, const EdgeSpan& a, EdgeSpan b, const Manner& manner, const std::string& numbered) {
  const std::string name = manner.name.empty() ? in_words(pattern, a) + " to " + in_words(pattern, b) : manner.name + numbered;
  if (!same_way(pattern, a, b, manner)) std::swap(b.begin, b.end);
  pattern.seams.push_back({name, a, b, manner.right_to_wrong});
}

void compare_lengths(const std::string& a, double length_a, const std::string& b, double length_b, const Manner& manner,
                     const std::string& place, Sidecar& sidecar) {
  const double difference = std::abs(length_a - length_b);
  if (difference <= unnoticed + manner.ease.metres + manner.ease.share * std::min(length_a, length_b)) return;
  sidecar.report.warn(
      "seam.length", place,
      a + " is " + in_mm(length_a) + " long, " + b + " is " + in_mm(length_b) + ": " + in_mm(difference) + " apart",
      "If it is meant to be eased or gathered in, add ease = \"" + in_mm(std::ceil(difference * 1e4) / 1e4) +
          "\"; otherwise true the edges");
}

const TomlNode* needed(const TomlNode& entry, const char* key, Sidecar& sidecar) {
  const TomlNode* node = find(entry, key);
  if (!node)
    sidecar.report.error("seam.syntax", sidecar.at(entry), "this seam has no '" + std::string(key) + "'",
                         "A seam has a and b, or ring, from and to, or along and each");
  return node;
}

void pair_of_runs(const TomlNode& entry, const Manner& manner, Pattern& pattern, Sidecar& sidecar) {
  const TomlNode* a = needed(entry, "a", sidecar);
  const TomlNode* b = needed(entry, "b", sidecar);
  if (!a || !b) return;
  const auto span_a = spans_of(*a, pattern, false, sidecar), span_b = spans_of(*b, pattern, false, sidecar);
  if (span_a.empty() || span_b.empty()) return;
  sew(pattern, span_a[0], span_b[0], manner, "");
  compare_lengths(in_words(pattern, span_a[0]), span_length(pattern, span_a[0]), in_words(pattern, span_b[0]),
                  span_length(pattern, span_b[0]), manner, sidecar.at(entry), sidecar);
}

void ring_of_copies(const TomlNode& entry, const Manner& manner, Pattern& pattern, Sidecar& sidecar) {
  const TomlNode* ring = needed(entry, "ring", sidecar);
  const TomlNode* from = needed(entry, "from", sidecar);
  const TomlNode* to = needed(entry, "to", sidecar);
  const TomlNode* open_node = find(entry, "open");
  const auto open = open_node ? truth_of(*open_node, sidecar) : std::optional(false);
  if (!ring || !from || !to || !open) return;
  const auto piece = text_of(*ring, sidecar), from_edge = text_of(*from, sidecar), to_edge = text_of(*to, sidecar);
  if (!piece || !from_edge || !to_edge) return;
  const auto named = [&](const TomlNode& node, const std::string& edge) {
    TomlNode text = node;
    text.text = *piece + "." + edge;
    return spans_of(text, pattern, true, sidecar);
  };
  const auto ends = named(*from, *from_edge);
  const auto starts = ends.empty() ? ends : named(*to, *to_edge);
  if (starts.empty()) return;
  const std::size_t count = ends.size();
  for (std::size_t k = 0; k < (*open ? count - 1 : count); ++k)
    sew(pattern, ends[k], starts[(k + 1) % count], manner, " " + std::to_string(k + 1));
  compare_lengths(in_words(pattern, ends[0]), span_length(pattern, ends[0]), in_words(pattern, starts[0]),
                  span_length(pattern, starts[0]), manner, sidecar.at(entry), sidecar);
}

// Sews the share [from, to] of `along` to `other`; both are fractions of the whole run and may pass its end, where it goes on
// at the beginning.
void sew_share(Pattern& pattern, const EdgeSpan& along, double from, double to, const EdgeSpan& other, const Manner& manner,
               const std::string& numbered) {
  const bool same = same_way(pattern, along, other, manner);
  const auto part = [&](double begin, double end, const std::string& suffix) {
    const double turns = std::floor(begin + 1e-12);
    const double width = along.end - along.begin;
    EdgeSpan a = along;
    a.begin = along.begin + std::max(begin - turns, 0.0) * width;
    a.end = along.begin + std::min(end - turns, 1.0) * width;
    double low = (begin - from) / (to - from), high = (end - from) / (to - from);
    if (!same) std::tie(low, high) = std::pair(1 - high, 1 - low);
    EdgeSpan b = other;
    b.begin = other.begin + low * (other.end - other.begin);
    b.end = other.begin + high * (other.end - other.begin);
    sew(pattern, a, b, manner, numbered + suffix);
  };
  const double end_of_run = std::floor(from + 1e-12) + 1;
  if (to > end_of_run + 1e-12) {
    part(from, end_of_run, "a");
    part(end_of_run, to, "b");
  } else {
    part(from, to, "");
  }
}

void shared_out(const TomlNode& entry, const Manner& manner, Pattern& pattern, Sidecar& sidecar) {
  const TomlNode* along_node = needed(entry, "along", sidecar);
  const TomlNode* each = needed(entry, "each", sidecar);
  if (!along_node || !each) return;
  const auto along = spans_of(*along_node, pattern, false, sidecar);
  if (along.empty()) return;
  std::vector<EdgeSpan> others;
  const bool list = each->kind == TomlKind::array;
  for (const TomlNode& item : list ? each->items : std::vector<TomlNode>{*each}) {
    const auto spans = spans_of(item, pattern, true, sidecar);
    if (spans.empty()) return;
    others.insert(others.end(), spans.begin(), spans.end());
  }
  if (const TomlNode* backwards = find(entry, "backwards")) {
    const auto truth = truth_of(*backwards, sidecar);
    if (!truth) return;
    if (*truth) std::reverse(others.begin(), others.end());
  }
  double start = 0;
  if (const TomlNode* node = find(entry, "start")) {
    const auto place = parse_along(node->text);  // empty unless a text
    const double whole = span_length(pattern, along[0]);
    if (place) start = place->is_length ? place->value / whole : place->value;
    if (!place || start < 0 || start >= 1 || along[0].begin != 0 || along[0].end != 1) {
      sidecar.report.error("seam.range", sidecar.at(*node), "'start' must be a place on a whole edge that closes to a ring",
                           "Write a fraction such as \"1/16\" or a length such as \"5 cm\", and give 'along' without a range");
      return;
    }
  }
  double total = 0;
  for (const EdgeSpan& other : others) total += span_length(pattern, other);
  double from = start;
  for (std::size_t k = 0; k < others.size(); ++k) {
    const double share = span_length(pattern, others[k]) / total;
    const double to = k + 1 == others.size() ? start + 1 : from + share;
    sew_share(pattern, along[0], from, to, others[k], manner, " " + std::to_string(k + 1));
    from = to;
  }
  compare_lengths(in_words(pattern, along[0]), span_length(pattern, along[0]),
                  "what is sewn along it (" + std::to_string(others.size()) + " edges)", total, manner, sidecar.at(entry),
                  sidecar);
}

}  // namespace

void add_seams(const TomlNode& entry, Pattern& pattern, Sidecar& sidecar) {
  const auto refuse_others = [&](std::initializer_list<std::string_view> known) {
    refuse_unknown_keys(entry, known, sidecar.file, "seam.unknown-key", sidecar.report);
  };
  const auto manner = manner_of(entry, sidecar);
  if (find(entry, "ring")) {
    refuse_others({"name", "ring", "from", "to", "open", "reversed", "right_to_wrong", "ease"});
    if (manner) ring_of_copies(entry, *manner, pattern, sidecar);
  } else if (find(entry, "along")) {
    refuse_others({"name", "along", "each", "backwards", "start", "reversed", "right_to_wrong", "ease"});
    if (manner) shared_out(entry, *manner, pattern, sidecar);
  } else {
    refuse_others({"name", "a", "b", "reversed", "right_to_wrong", "ease"});
    if (manner) pair_of_runs(entry, *manner, pattern, sidecar);
  }
}

}  // namespace toile
