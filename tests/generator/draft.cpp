#include "tests/generator/draft.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace solitaire::generator {

using fmt::format;

Kind Draft::any_kind() {
  static const std::vector<Kind> kinds = {Kind::kInt,    Kind::kInt,   Kind::kInt,    Kind::kBool,
                                          Kind::kList,   Kind::kList,  Kind::kNested, Kind::kRecord,
                                          Kind::kRecord, Kind::kPairs, Kind::kString, Kind::kFloat};
  return any_of(kinds);
}

void Draft::declare(std::string name, Kind kind, bool fixed) {
  variables.push_back({std::move(name), kind, fixed, level});
}

void Draft::line(const std::string& content) {
  text += std::string(static_cast<std::size_t>(2 * block), ' ') + content + "\n";
}

std::vector<Variable> Draft::visible(Kind kind, bool assignable) const {
  std::vector<Variable> found;
  for (const Variable& variable : variables) {
    if (variable.kind != kind) continue;
    if (assignable && (variable.fixed || variable.level != level)) continue;
    found.push_back(variable);
  }
  return found;
}

std::string Draft::variable_or(Kind kind, const Maker& otherwise) {
  const auto found = visible(kind, false);
  return found.empty() ? otherwise() : any_of(found).name;
}

std::string Draft::everything() const {
  std::vector<std::string> names;
  for (const Variable& variable : variables) {
    if (variable.level == level && variable.kind != Kind::kFunction) names.push_back(variable.name);
  }
  for (const Mixed& each : mixed) names.push_back(each.name);
  return format("[{}]", fmt::join(names, ", "));
}

std::string Draft::digest() const {
  std::string sum = "0";
  int factor = 1;
  for (const Variable& variable : variables) {
    if (variable.level != level) continue;
    const std::string part = digest_of(variable);
    if (!part.empty()) sum += format(" + {} * {}", factor++, part);
  }
  for (const Mixed& each : mixed) sum += format(" + (if {} == [1, 2] then 1 else 0)", each.name);
  return sum;
}

std::string Draft::digest_of(const Variable& variable) {
  const std::string& name = variable.name;
  switch (variable.kind) {
    case Kind::kInt:
      return name;
    case Kind::kBool:
      return format("(if {} then 1 else 0)", name);
    case Kind::kList:
      return format("(sum({}) + length({}))", name, name);
    case Kind::kNested:
      return format("sum([sum(u) + 1 for u in {}])", name);
    case Kind::kPairs:
      return format("length({})", name);
    case Kind::kRecord:
      return format("({}.a + {}.c + sum({}.b))", name, name, name);
    default:
      return "";
  }
}

}  // namespace solitaire::generator
