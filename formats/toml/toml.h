#pragma once
// A TOML file as a plain tree that remembers its lines, so that every complaint can name the place.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "garment/report.h"

namespace toile {

enum class TomlKind { text, integer, real, boolean, array, table, date };

struct TomlNode {
  TomlKind kind = TomlKind::table;
  int line = 0;
  std::string key;              // when it stands in a table
  std::string text;             // kind text
  double number = 0;            // kinds integer and real
  bool truth = false;           // kind boolean
  std::vector<TomlNode> items;  // of an array in order; of a table in the order of the file
};

// The root table. `file` is only named in findings: "toml.syntax" at "FILE:LINE:COLUMN".
Loaded<TomlNode> parse_toml(const std::string& bytes, const std::string& file);

// The entry of a table, or nothing.
const TomlNode* find(const TomlNode& table, std::string_view key);

// What a node is, for people: "a text", "a list", ...
std::string in_words(TomlKind);

// A text as TOML writes it, quoted and escaped.
std::string toml_quoted(std::string_view text);

// "FILE:LINE"
std::string toml_place(const std::string& file, const TomlNode& node);

// Error "`code`" for every key of `table` that is not among `known`, with the known ones as the remedy.
void refuse_unknown_keys(const TomlNode& table, std::initializer_list<std::string_view> known, const std::string& file,
                         const std::string& code, Report& report);

}  // namespace toile
