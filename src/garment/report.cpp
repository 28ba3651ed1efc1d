#include "garment/report.h"

#include <algorithm>

namespace toile {

bool Report::ok() const {
  return std::none_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severity == Severity::error; });
}

void Report::note(std::string code, std::string place, std::string text, std::string remedy) {
  findings.push_back({std::move(code), Severity::note, std::move(place), std::move(text), std::move(remedy)});
}

void Report::warn(std::string code, std::string place, std::string text, std::string remedy) {
  findings.push_back({std::move(code), Severity::warning, std::move(place), std::move(text), std::move(remedy)});
}

void Report::error(std::string code, std::string place, std::string text, std::string remedy, Fault fault) {
  findings.push_back({std::move(code), Severity::error, std::move(place), std::move(text), std::move(remedy), fault});
}

void Report::append(const Report& other) {
  findings.insert(findings.end(), other.findings.begin(), other.findings.end());
}

std::string in_words(const Finding& f) {
  const char* severity = f.severity == Severity::error ? "error" : f.severity == Severity::warning ? "warning" : "note";
  std::string words = f.place.empty() ? std::string{} : f.place + ": ";
  words += std::string(severity) + "[" + f.code + "] " + f.text;
  if (!f.remedy.empty()) words += ". " + f.remedy;
  return words;
}

}  // namespace toile
