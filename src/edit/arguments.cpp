#include "edit/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "garment/units.h"

namespace toile {
namespace {

std::optional<double> plain_number(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string names_of(const std::vector<Parameter>& parameters) {
  std::string list;
  for (const Parameter& parameter : parameters) list += (list.empty() ? "" : ", ") + parameter.name;
  return list;
}

double read_number(const std::string& place, const Parameter& parameter, const std::string& written) {
  const bool length = parameter.unit == "m";
  const std::optional<double> number = length ? parse_length(written) : plain_number(written);
  if (!number && length)
    throw BadInput({"edit.bad-length", Severity::error, place, "'" + written + "' is not a length",
                    "write a number and its unit, such as \"-10 cm\", \"35 mm\" or \"5/8 in\""});
  if (!number)
    throw BadInput(
        {"edit.bad-number", Severity::error, place, "'" + written + "' is not a number", "write a number without a unit"});
  const auto shown = [&](double value) { return length ? in_mm(value, 0) : std::to_string(value); };
  if ((parameter.least && *number < *parameter.least) || (parameter.most && *number > *parameter.most))
    throw BadInput({"edit.out-of-range", Severity::error, place, shown(*number) + " is out of range",
                    "between " + (parameter.least ? shown(*parameter.least) : "-inf") + " and " +
                        (parameter.most ? shown(*parameter.most) : "inf")});
  return *number;
}

}  // namespace

ReadArguments read_arguments(const std::string& operation, const std::vector<Parameter>& parameters,
                             const EditArguments& arguments) {
  const std::string edit = "edit '" + operation + "'";
  for (const auto& [name, written] : arguments)
    if (std::none_of(parameters.begin(), parameters.end(), [&, key = name](const Parameter& p) { return p.name == key; }))
      throw BadInput({"edit.unknown-parameter", Severity::error, edit, "has no parameter '" + name + "'",
                      "it has: " + names_of(parameters)});
  ReadArguments read;
  for (const Parameter& parameter : parameters) {
    const std::string place = edit + ", " + parameter.name;
    const auto given = arguments.find(parameter.name);
    if (given == arguments.end() && !parameter.by_default)
      throw BadInput({"edit.missing-parameter", Severity::error, place, "is not given",
                      "add it: " + parameter.meaning + (parameter.unit == "m" ? ", with its unit" : "")});
    const std::string& written = given == arguments.end() ? *parameter.by_default : given->second;
    if (parameter.unit == "loop")
      read.names[parameter.name] = written;
    else
      read.numbers[parameter.name] = read_number(place, parameter, written);
  }
  return read;
}

}  // namespace toile
