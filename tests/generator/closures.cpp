// Functions that see variables around them which change: between two calls, or after the function was
// returned.
#include <fmt/format.h>

#include "tests/generator/statements.h"

namespace solitaire::generator {

using fmt::format;

void Statements::closure() {
  if (draft_.level > 0) return same_calls();
  const std::string maker = draft_.fresh("f");
  make_closures(maker);
  const std::string made = draft_.fresh("g");
  const std::string argument = expressions_.literal();
  draft_.line(format("{} = {}({});", made, maker, expressions_.integer(1)));
  const std::string name = draft_.fresh("v");
  draft_.open(format("if {}", expressions_.boolean(1)));
  ++draft_.block;
  draft_.line(format("{} = {}({});", name, made, argument));
  --draft_.block;
  draft_.line("} else {");
  ++draft_.block;
  if (draft_.one_in(2)) draft_.line(format("{} = {}({});", made, maker, expressions_.integer(1)));
  draft_.line(format("{} = {}({});", name, made, argument));
  --draft_.block;
  draft_.close();
  draft_.declare(made, Kind::kFunction, true);
  draft_.declare(name, Kind::kInt);
}

/// Writes a function that returns a function, whose variable changes where it does not return early.
void Statements::make_closures(const std::string& maker) {
  const std::string parameter = draft_.fresh("q");
  const std::string kept = draft_.fresh("k");
  const std::string made = draft_.fresh("g");
  draft_.open(format("fun {}({})", maker, parameter));
  ++draft_.level;
  ++draft_.block;
  const std::size_t before = draft_.variables.size();
  draft_.declare(parameter, Kind::kInt, true);
  draft_.line(format("{} = {};", kept, draft_.one_in(2) ? parameter : expressions_.integer(2)));
  draft_.declare(kept, Kind::kInt, true);
  draft_.line(format("{} = fun(p) {{ return p {} {}; }};", made, draft_.one_in(2) ? "-" : "+", kept));
  if (!draft_.one_in(4)) draft_.line(format("if {} {{ return {}; }}", expressions_.boolean(1), made));
  if (!draft_.one_in(4)) draft_.line(format("{} = {};", kept, expressions_.integer(1)));
  draft_.line(format("return {};", made));
  draft_.variables.resize(before);
  --draft_.block;
  --draft_.level;
  draft_.close();
}

void Statements::reads_below() {
  const auto ints = draft_.visible(Kind::kInt, true);
  if (draft_.level > 0 || ints.empty()) return same_calls();
  const std::string read = draft_.any_of(ints).name;
  const std::string below = draft_.fresh("f");
  const std::string above = draft_.fresh("f");
  const std::string name = draft_.fresh("v");
  draft_.line(format("fun {}(p) {{ return p {} {}; }}", below, draft_.one_in(2) ? "-" : "+", read));
  const std::string condition =
      draft_.one_in(3) ? "p < 1" : draft_.variable_or(Kind::kBool, [&] { return read + " < 1"; });
  draft_.line(
      format("fun {}(p) {{ if {} {{ return {}(p); }} return {}(p) * 2; }}", above, condition, below, below));
  const std::string argument = draft_.one_in(2) ? "1" : expressions_.integer(2);
  draft_.open(format("if {}", expressions_.boolean(1)));
  for (const bool first : {true, false}) {
    ++draft_.block;
    if (first || draft_.one_in(2)) draft_.line(format("{} = {};", read, expressions_.integer(1)));
    draft_.line(format("{} = {}({});", name, above, argument));
    --draft_.block;
    if (first) draft_.line("} else {");
  }
  draft_.close();
  draft_.declare(name, Kind::kInt);
}

}  // namespace solitaire::generator
