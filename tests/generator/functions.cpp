#include "tests/generator/functions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

namespace solitaire::generator {

using fmt::format;

void Functions::declare() {
  Declared made{draft_.fresh("f"), {}, 0, draft_.one_in(3) ? Kind::kList : Kind::kInt, ""};
  const std::size_t before = draft_.variables.size();
  const auto mixed_before = draft_.mixed;
  const auto functions_before = draft_.functions;
  const int loops_before = std::exchange(draft_.loops, 0);
  ++draft_.level;
  draft_.open(format("fun {}({})", made.name, parameters(made)));
  ++draft_.block;
  body(made);
  --draft_.block;
  draft_.close();
  --draft_.level;
  draft_.loops = loops_before;
  draft_.variables.resize(before);
  draft_.mixed = mixed_before;
  draft_.functions = functions_before;
  if (made.parameters.size() == 1 && made.result == Kind::kInt)
    draft_.declare(made.name, Kind::kFunction, true);
  draft_.functions.push_back(std::move(made));
}

std::string Functions::parameters(Declared& made) {
  std::vector<std::string> header;
  const std::size_t count = 1 + draft_.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    const Kind kind = i == 0 || draft_.one_in(2) ? Kind::kInt : Kind::kList;
    const std::string name = draft_.fresh("q");
    const bool optional = i > 0 && (draft_.one_in(2) || i > made.required);
    header.push_back(optional ? format("{} = {}", name, expressions_.expression(kind, 2)) : name);
    if (!optional) made.required = i + 1;
    made.parameters.emplace_back(name, kind);
    draft_.declare(name, kind, i == 0);
  }
  return format("{}", fmt::join(header, ", "));
}

void Functions::body(Declared& made) {
  const std::string& first = made.parameters.front().first;
  const bool recursive = draft_.one_in(3);
  if (recursive) {
    draft_.line(format("if {} {} {} {{ return {}; }}", first, draft_.one_in(2) ? "<=" : "<",
                       draft_.number(0, 1), expressions_.expression(made.result, 1)));
  }
  read_outer(made);
  for (int i = draft_.number(0, 3); i > 0; --i) statement_();
  const std::string value = expressions_.expression(made.result, recursive ? 1 : 0);
  if (!recursive) return draft_.line(format("return {};", value));
  draft_.line(
      format("return {} + {};", value, expressions_.call_of(made, 2, format("min({}, 3) - 1", first))));
}

void Functions::read_outer(Declared& made) {
  std::vector<std::string> outer;
  for (const Variable& variable : draft_.variables) {
    if (variable.kind == Kind::kInt && variable.level < draft_.level) outer.push_back(variable.name);
  }
  if (outer.empty() || draft_.one_in(3)) return;
  const std::string& first = made.parameters.front().first;
  const std::string other = made.reads = draft_.any_of(outer);
  if (draft_.one_in(2))
    draft_.line(format("if {} < {} {{ return {}; }}", first, draft_.number(0, 2),
                       expressions_.expression(made.result, 1)));
  if (draft_.one_in(3))
    draft_.line(format("if {} == {} {{ assert({}); }}", first, other,
                       draft_.one_in(2) ? "false" : expressions_.boolean(2)));
  const std::string way = draft_.any_of<std::string>({"<", ">=", "==", "!="});
  if (draft_.one_in(3))
    draft_.line(format("assert({} {} {} or {});", first, way, other, expressions_.boolean(2)));
  if (draft_.one_in(2))
    draft_.line(
        format("if {} {} {} {{ return {}; }}", first, way, other, expressions_.expression(made.result, 1)));
  const std::string name = draft_.fresh("v");
  draft_.line(format("{} = {} - {};", name, other, first));
  draft_.declare(name, Kind::kInt);
}

}  // namespace solitaire::generator
