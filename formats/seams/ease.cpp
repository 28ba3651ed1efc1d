#include "formats/seams/ease.h"

#include <algorithm>
#include <cmath>

#include "formats/seams/join.h"
#include "formats/seams/span_text.h"

namespace toile {

std::map<std::string, double> meant_ease(const std::string& text, const std::string& file, const Pattern& pattern) {
  std::map<std::string, double> ease;
  const auto root = parse_toml(text, file);
  const TomlNode* seams = root.value ? find(*root.value, "seam") : nullptr;
  if (!seams) return ease;
  for (const TomlNode& entry : seams->items) {
    const TomlNode* meant = find(entry, "ease");
    if (!meant) continue;
    Pattern joined = pattern;
    joined.seams.clear();
    Sidecar sidecar{file, {}};
    add_seams(entry, joined, sidecar);
    double total = 0;
    for (const Seam& seam : joined.seams) total += std::min(span_length(joined, seam.a), span_length(joined, seam.b));
    if (joined.seams.empty() || total <= 0) continue;
    const bool share = meant->kind == TomlKind::text && !meant->text.empty() && meant->text.back() == '%';
    const auto part = share ? parse_along(meant->text) : std::nullopt;
    const auto metres = share ? std::nullopt : length_of(*meant, sidecar);
    for (const Seam& seam : joined.seams) {
      const double length = std::min(span_length(joined, seam.a), span_length(joined, seam.b));
      if (part) ease[seam.name] = part->value * length;
      if (metres) ease[seam.name] = std::abs(*metres) * (find(entry, "along") ? length / total : 1);
    }
  }
  return ease;
}

}  // namespace toile
