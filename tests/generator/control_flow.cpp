// Statements with blocks, and ways out of them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/generator/statements.h"

namespace solitaire::generator {

using fmt::format;

void Statements::if_statement() {
  draft_.open(format("if {}", expressions_.boolean(1)));
  block(3);
  if (draft_.one_in(2)) {
    draft_.close();
  } else {
    draft_.line("} else {");
    block(3);
    draft_.close();
  }
}

void Statements::same_calls() {
  if (draft_.functions.empty())
    return draft_.level == 0 && draft_.block == 0 ? declare_function() : if_statement();
  const Declared callee = draft_.any_of(draft_.functions);
  const std::string name = draft_.fresh("v");
  const std::string known = draft_.variable_or(Kind::kInt, [] { return "1"; });
  const std::string first =
      expressions_.call_of(callee, 2, draft_.one_in(3) ? expressions_.literal() : known);
  const std::string second = draft_.one_in(3) ? expressions_.call_of(callee, 1) : first;
  draft_.open(format(
      "if {}", draft_.one_in(2) ? format("{} < {}", known, draft_.number(0, 2)) : expressions_.boolean(1)));
  exclusive_call(callee, name, first);
  draft_.line("} else {");
  if (draft_.one_in(3)) {
    ++draft_.block;
    draft_.open(format("if {}", expressions_.boolean(2)));
    exclusive_call(callee, name, second);
    draft_.line("} else {");
    exclusive_call(callee, name, first);
    draft_.close();
    --draft_.block;
  } else {
    exclusive_call(callee, name, second);
  }
  draft_.close();
  draft_.declare(name, callee.result);
  if (draft_.one_in(2))
    draft_.line(format("assert({} % 3 != 1);", Draft::digest_of(draft_.variables.back())));
}

void Statements::exclusive_call(const Declared& callee, const std::string& name, const std::string& call) {
  ++draft_.block;
  const auto ints = draft_.visible(Kind::kInt, true);
  for (const Variable& variable : ints) {
    if (variable.name == callee.reads && draft_.one_in(2))
      draft_.line(format("{} = {};", variable.name, expressions_.integer(1)));
  }
  if (!ints.empty() && draft_.one_in(4))
    draft_.line(format("{} = {};", draft_.any_of(ints).name, expressions_.integer(2)));
  draft_.line(format("{} = {};", name, call));
  --draft_.block;
}

void Statements::for_statement() {
  const std::size_t before = draft_.variables.size();
  const std::string name = draft_.fresh("i");
  ++draft_.loops;
  switch (draft_.below(5)) {
    case 0:
    case 1:
      draft_.open(format("for {} in {}", name, expressions_.list(1)));
      draft_.declare(name, Kind::kInt, draft_.one_in(2));
      break;
    case 2:
      draft_.open(format("for {} in {}..{}", name, draft_.number(-1, 1),
                         draft_.one_in(2) ? format("({} % 3)", expressions_.integer(1)) : "2"));
      draft_.declare(name, Kind::kInt, draft_.one_in(2));
      break;
    case 3: {
      const std::string other = draft_.fresh("i");
      draft_.open(format("for {}, {} in {}", name, other, expressions_.pairs(1)));
      draft_.declare(name, Kind::kInt, true);
      draft_.declare(other, Kind::kInt, true);
      break;
    }
    default:
      draft_.open(format("for {} in {}", name, expressions_.nested(1)));
      draft_.declare(name, Kind::kList, draft_.one_in(2));
      break;
  }
  block(3);
  draft_.close();
  --draft_.loops;
  draft_.variables.resize(before);
}

void Statements::while_statement() {
  const std::string counter = draft_.fresh("k");
  draft_.line(format("{} = {} % 4;", counter, expressions_.integer(1)));
  draft_.declare(counter, Kind::kInt, true);
  ++draft_.loops;
  draft_.open(draft_.one_in(3) ? format("while {} > 0 and {}", counter, expressions_.boolean(2))
                               : format("while {} > 0", counter));
  ++draft_.block;
  draft_.line(format("{} -= 1;", counter));
  --draft_.block;
  block(3);
  draft_.close();
  --draft_.loops;
}

void Statements::leave() {
  const bool jumps = draft_.loops > 0 && !draft_.one_in(3);
  if (!jumps && draft_.level == 0 && (draft_.is_part || !draft_.one_in(3))) return simple_statement();
  const std::string way = jumps ? (draft_.one_in(2) ? "break;" : "continue;")
                                : format("return {};", draft_.level > 0 ? returned() : draft_.everything());
  draft_.line(format("if {} {{ {} }}", expressions_.boolean(1), way));
}

std::string Statements::returned() {
  return draft_.one_in(8) ? expressions_.expression(draft_.any_kind(), 1) : expressions_.integer(1);
}

}  // namespace solitaire::generator
