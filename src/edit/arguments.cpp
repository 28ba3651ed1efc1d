#include "edit/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

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

std::optional<double> parse_angle(const std::string& text) {
  const std::size_t unit = text.rfind("deg");
  if (unit == std::string::npos || unit + 3 != text.size()) return std::nullopt;
  const std::size_t end = text.find_last_not_of(' ', unit == 0 ? 0 : unit - 1);
  const auto degrees = end == std::string::npos || unit == 0 ? std::nullopt : plain_number(text.substr(0, end + 1));
  return degrees ? std::optional(*degrees * units::degree) : std::nullopt;
}

std::string in_degrees(double radians) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f deg", radians / units::degree);
  return text;
}

double read_number(const std::string& place, const Parameter& parameter, const std::string& written) {
  const bool length = parameter.unit == "m", angle = parameter.unit == "deg";
  const std::optional<double> number = length ? parse_length(written) : angle ? parse_angle(written) : plain_number(written);
  if (!number && length)
    throw BadInput({"edit.bad-length", Severity::error, place, "'" + written + "' is not a length",
                    "write a number and its unit, such as \"-10 cm\", \"35 mm\" or \"5/8 in\""});
  if (!number && angle)
    throw BadInput({"edit.bad-angle", Severity::error, place, "'" + written + "' is not an angle",
                    "write degrees with their unit, such as \"-60 deg\" (0 = front, 90 deg = the wearer's left)"});
  if (!number)
    throw BadInput(
        {"edit.bad-number", Severity::error, place, "'" + written + "' is not a number", "write a number without a unit"});
  const auto shown = [&](double value) { return length ? in_mm(value, 0) : angle ? in_degrees(value) : std::to_string(value); };
  if ((parameter.least && *number < *parameter.least) || (parameter.most && *number > *parameter.most))
    throw BadInput({"edit.out-of-range", Severity::error, place, shown(*number) + " is out of range",
                    "between " + (parameter.least ? shown(*parameter.least) : "-inf") + " and " +
                        (parameter.most ? shown(*parameter.most) : "inf")});
  return *number;
}

const std::string& read_name(const std::string& place, const std::string& written) {
  if (written.find_first_not_of(' ') == std::string::npos)
    throw BadInput({"edit.bad-name", Severity::error, place, "is empty", "write a name, or leave the line out"});
  return written;
}

// Which of the parameters that stand for each other is given; the others of them are left out.
bool stood_for(const std::string& edit, const std::vector<Parameter>& parameters, const Parameter& parameter,
               const EditArguments& arguments) {
  const std::string& first = parameter.instead_of.empty() ? parameter.name : parameter.instead_of;
  std::vector<std::string> given;
  std::string names;
  for (const Parameter& other : parameters) {
    if (other.name != first && other.instead_of != first) continue;
    names += (names.empty() ? "" : " or ") + other.name;
    if (arguments.count(other.name)) given.push_back(other.name);
  }
  if (given.size() > 1)
    throw BadInput(
        {"edit.two-parameters", Severity::error, edit, "has both " + given[0] + " and " + given[1], "write one of " + names});
  if (given.empty() && !parameter.instead_of.empty()) return true;  // the first of them says that it is missing
  return !given.empty() && given[0] != parameter.name;
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
    if (stood_for(edit, parameters, parameter, arguments)) continue;
    const auto given = arguments.find(parameter.name);
    if (given == arguments.end() && !parameter.by_default)
      throw BadInput({"edit.missing-parameter", Severity::error, place, "is not given",
                      "add it: " + parameter.meaning + (parameter.unit == "m" ? ", with its unit" : "")});
    const std::string& written = given == arguments.end() ? *parameter.by_default : given->second;
    if (parameter.unit == "loop" || parameter.unit == "size" || parameter.unit == "file")
      read.names[parameter.name] = read_name(place, written);
    else
      read.numbers[parameter.name] = read_number(place, parameter, written);
  }
  return read;
}

std::optional<BodyName> body_name(const std::string& operation, const ReadArguments& read) {
  const auto name = [&](const char* parameter) {
    const auto found = read.names.find(parameter);
    return found == read.names.end() ? std::string() : found->second;
  };
  const bool sized = read.names.count("size") > 0;
  if (!sized && !read.names.count("body")) return std::nullopt;
  const std::string skeleton = name("skeleton");
  const bool given = !skeleton.empty() && skeleton != "beside";
  if (sized && given)
    throw BadInput({"edit.two-parameters", Severity::error, "edit '" + operation + "', skeleton",
                    "a size of the chart has its own skeleton",
                    "leave \"skeleton\" out, or give \"body\" instead of \"size\""});
  return BodyName{name("size"), name("body"), given ? skeleton : ""};
}

}  // namespace toile
