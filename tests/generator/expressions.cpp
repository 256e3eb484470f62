#include "tests/generator/expressions.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace solitaire::generator {

using fmt::format;

namespace {

constexpr int kDeepestExpression = 3;

}  // namespace

std::string Expressions::pick(int depth, const std::vector<Weighted>& makers) {
  if (depth >= kDeepestExpression) return makers.front().make();
  std::uint32_t sum = 0;
  for (const Weighted& maker : makers) sum += maker.weight;
  std::uint32_t at = draft_.below(sum);
  for (const Weighted& maker : makers) {
    if (at < maker.weight) return maker.make();
    at -= maker.weight;
  }
  return makers.front().make();
}

std::string Expressions::expression(Kind kind, int depth) {
  switch (kind) {
    case Kind::kInt:
      return integer(depth);
    case Kind::kBool:
      return boolean(depth);
    case Kind::kList:
      return list(depth);
    case Kind::kPairs:
      return pairs(depth);
    case Kind::kNested:
      return nested(depth);
    case Kind::kRecord:
      return record(depth);
    case Kind::kString:
      return text(depth);
    case Kind::kFloat:
      return real(depth);
    case Kind::kFunction:
      return function(depth);
  }
  return "nil";
}

std::string Expressions::either(Kind kind, int depth) {
  return format("(if {} then {} else {})", boolean(depth + 1), expression(kind, depth + 1),
                expression(kind, depth + 1));
}

std::string Expressions::literal() { return std::to_string(draft_.number(-2, 4)); }

std::string Expressions::index(int depth) {
  if (draft_.one_in(2)) return std::to_string(draft_.number(0, 1));
  return draft_.one_in(2) ? format("({} % 3)", integer(depth + 1)) : integer(depth + 1);
}

std::string Expressions::integer(int depth) {
  const int d = depth + 1;
  return pick(
      depth,
      {
          {6,
           [&] {
             return draft_.one_in(3) ? literal() : draft_.variable_or(Kind::kInt, [&] { return literal(); });
           }},
          {4, [&] { return choice_of_int(d); }},
          {3, [&] { return format("({} {} {})", integer(d), draft_.one_in(2) ? "-" : "+", integer(d)); }},
          {1, [&] { return format("({} * {})", integer(d), draft_.number(-1, 3)); }},
          {1, [&] { return format("({} {} {})", integer(d), draft_.one_in(2) ? "/" : "%", divisor(d)); }},
          {2, [&] { return either(Kind::kInt, depth); }},
          {3, [&] { return call(Kind::kInt, depth); }},
          {2, [&] { return format("{}[{}]", list(d), index(depth)); }},
          {1, [&] { return format("{}[{}][{}]", nested(d), index(depth), index(depth)); }},
          {2, [&] { return format("{}.{}", record(d), draft_.one_in(2) ? "c" : "a"); }},
          {1, [&] { return format("{}({}, {})", draft_.one_in(2) ? "max" : "min", integer(d), integer(d)); }},
          {1,
           [&] {
             return format("{}({})", draft_.any_of<std::string>({"length", "sum", "max", "min", "car"}),
                           list(d));
           }},
          {1, [&] { return format("abs({})", integer(d)); }},
          {1, [&] { return format("count({}, {})", list(d), integer(d)); }},
          {1, [&] { return format("count([{}, {}, {}])", boolean(d), boolean(d), flip()); }},
          {1,
           [&] {  // most often of what is there
             if (draft_.one_in(4)) return format("index_of({}, {})", list(d), integer(d));
             const std::string there = literal();
             return format("index_of(({} + [{}]), {})", list(d), there, there);
           }},
          {1, [&] { return format("{}({} + [1])", draft_.one_in(2) ? "first" : "last", list(d)); }},
          {1,
           [&] {
             return format("{}({} + [2], key: {})", draft_.one_in(2) ? "max" : "min", list(d), function(d));
           }},
          {1, [&] { return format("length({})", text(d)); }},
          {1, [&] { return format("cond({}, {}, {})", boolean(d), integer(d), integer(d)); }},
          {1, [&] { return format("sum([{} for {} in {}])", "1", draft_.fresh("u"), list(d)); }},
          {2, [&] { return format("{}({})", function(d), integer(d)); }},
          {2, [&] { return use_mixed(Kind::kInt, depth); }},
          {1, [&] { return mistaken(Kind::kInt, depth); }},
      });
}

std::string Expressions::divisor(int depth) {
  return draft_.one_in(3) ? integer(depth) : draft_.any_of<std::string>({"2", "3", "-2", "1", "-3"});
}

std::string Expressions::boolean(int depth) {
  const int d = depth + 1;
  return pick(
      depth,
      {
          {2,
           [&] {
             return draft_.variable_or(Kind::kBool, [&] {
               return format("({} < {})", draft_.variable_or(Kind::kInt, [] { return "1"; }),
                             draft_.number(0, 2));
             });
           }},
          {5,
           [&] {
             return format("({} {} {})", integer(d),
                           draft_.any_of<std::string>({"<", "<=", ">", ">=", "==", "!="}), integer(d));
           }},
          {3, [&] { return flip(); }},
          {2, [&] { return format("({} {} {})", boolean(d), draft_.one_in(2) ? "or" : "and", boolean(d)); }},
          {1, [&] { return format("(not {})", boolean(d)); }},
          {1, [&] { return either(Kind::kBool, depth); }},
          {1, [&] { return format("contains({}, {})", list(d), integer(d)); }},
          {1, [&] { return format("({} {} {})", integer(d), draft_.one_in(3) ? "not in" : "in", list(d)); }},
          {1, [&] { return format("distinct({})", list(d)); }},
          {1, [&] { return comparison_of_texts(depth); }},
          {draft_.libraries.contains("graph") ? 3U : 0U, [&] { return connection(depth); }},
          {draft_.libraries.contains("schedule") ? 2U : 0U, [&] { return turns(depth); }},
          {draft_.libraries.contains("grid") ? 2U : 0U, [&] { return pattern(depth); }},
          {1, [&] { return boxes(depth); }},
          {1, [&] { return codes(); }},
          {1, [&] { return format("null({})", list(d)); }},
          {1,
           [&] {
             const std::string v = draft_.fresh("u");
             return format("{}([{} {} {} for {} in {}])", draft_.one_in(2) ? "all" : "any", v,
                           draft_.one_in(2) ? "<" : "!=", literal(), v, list(d));
           }},
          {1,
           [&] {
             const Kind kind = draft_.any_kind();
             return format("({} == {})", expression(kind, d),
                           expression(draft_.one_in(5) ? draft_.any_kind() : kind, d));
           }},
          {1,
           [&] {
             return draft_.mixed.empty() ? "true"
                                         : format("({} != {})", draft_.any_of(draft_.mixed).name,
                                                  expression(draft_.any_kind(), d));
           }},
      });
}

std::string Expressions::codes() {
  const int width = draft_.number(2, 4);  // the digits are mostly from 0 to 2
  const auto drawn = [&] { return choice("range(0, 2)"); };
  const auto digit = [&] { return draft_.one_in(2) ? drawn() : draft_.variable_or(Kind::kInt, drawn); };
  const auto code = [&] { return format("({} * {} + {})", digit(), width, digit()); };
  return format("({} {} {})", code(), draft_.any_of<std::string>({"==", "!=", "<"}), code());
}

std::string Expressions::comparison_of_texts(int depth) {
  const int d = depth + 1;
  if (draft_.one_in(3)) return format("contains([{}, {}], {})", text(d), text(d), text(d));
  return format("({} {} {})", text(d), draft_.one_in(2) ? "==" : "!=", text(d));
}

std::string Expressions::choice(const std::string& call, Kind kind) {
  if (draft_.choices <= 0 || (draft_.loops > 0 && !draft_.one_in(2))) {
    return draft_.variable_or(kind, [&] {
      return kind == Kind::kBool ? "true" : kind == Kind::kString ? "\"a\"" : "1";
    });
  }
  draft_.choices -= draft_.loops > 0 || draft_.level > 0 ? 2 : 1;
  return call;
}

std::string Expressions::flip() {
  return choice(draft_.one_in(4) ? format("flip(0.{})", draft_.number(0, 9)) : "flip()", Kind::kBool);
}

std::string Expressions::weighted(int depth) {
  if (draft_.one_in(2)) return choice(format("categorical([{}, 1])", draft_.number(0, 3)));
  return draft_.choices > 0 ? choice(format("choose([{}, {}], weights: [1, {}])", integer(depth), literal(),
                                            draft_.number(0, 3)))
                            : literal();
}

std::string Expressions::choice_of_int(int depth) {
  switch (draft_.below(9)) {
    case 0:
      return choice("range(0, 1)");
    case 1:
      return choice("range(0, 2)");
    case 2:
      return choice("range(-1, 1)");
    case 3:
      return choice("range(-3, 5, 4)");
    case 4:
      return draft_.choices > 0 ? choice(format("range(0, {} % 3)", integer(depth))) : literal();
    case 5:
      return draft_.choices > 0
                 ? choice(format("range({} % 3, 2{})", integer(depth), draft_.one_in(2) ? ", 2" : ""))
                 : literal();
    case 6:
      return weighted(depth);
    default:
      return draft_.choices > 0 ? choice(format("choose({})", list(depth))) : literal();
  }
}

std::string Expressions::call(Kind result, int depth) {
  std::vector<Declared> fitting;
  for (const Declared& declared : draft_.functions) {
    if (declared.result == result) fitting.push_back(declared);
  }
  if (fitting.empty()) return expression(result, depth + 1);
  return call_of(draft_.any_of(fitting), depth);
}

std::string Expressions::call_of(const Declared& callee, int depth, const std::string& first) {
  std::vector<std::string> arguments;
  bool named = false;
  for (std::size_t i = 0; i < callee.parameters.size(); ++i) {
    const auto& [name, kind] = callee.parameters[i];
    if (i >= callee.required && draft_.one_in(2)) {
      named = true;
      continue;
    }
    const std::string value = i == 0 && !first.empty() ? first : expression(kind, depth + 1);
    named = named || draft_.one_in(6);
    arguments.push_back(named ? format("{}: {}", name, value) : value);
  }
  return format("{}({})", callee.name, fmt::join(arguments, ", "));
}

std::string Expressions::use_mixed(Kind kind, int depth) {
  for (const Mixed& mixed : draft_.mixed) {
    if (mixed.then_kind == kind)
      return format("(if {} then {} else {})", mixed.condition, mixed.name, expression(kind, depth + 1));
    if (mixed.else_kind == kind && draft_.mistakes > 0)
      return format("(if {} then {} else {})", mixed.condition, expression(kind, depth + 1), mixed.name);
  }
  return draft_.variable_or(kind, [&] { return expression(kind, depth + 1); });
}

std::string Expressions::mistaken(Kind kind, int depth) {
  if (draft_.mistakes <= 0) return expression(kind, depth + 1);
  --draft_.mistakes;
  static const std::vector<std::string> wrongs = {"(1 + \"a\")", "nil(2)",   "[1].a",     "(1 and true)",
                                                  "length(3)",   "Point(1)", "(nil < 2)", "[1, 2][nil]"};
  return format("(if {} then {} else {})", boolean(depth + 1), draft_.any_of(wrongs),
                expression(kind, depth + 1));
}

}  // namespace solitaire::generator
