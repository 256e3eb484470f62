// Expressions of lists, records, texts, floats and functions.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/generator/expressions.h"

namespace solitaire::generator {

using fmt::format;

std::string Expressions::list(int depth) {
  const int d = depth + 1;
  return pick(depth,
              {
                  {5,
                   [&] {
                     return draft_.variable_or(Kind::kList,
                                               [&] { return format("[{}, {}]", literal(), literal()); });
                   }},
                  {3, [&] { return list_of(Kind::kInt, d, draft_.number(0, 3)); }},
                  {2, [&] { return comprehension(depth); }},
                  {1, [&] { return format("({} + {})", list(d), list_of(Kind::kInt, d, 1)); }},
                  {1,
                   [&] {
                     return format("({}..{})", draft_.number(-1, 1),
                                   draft_.one_in(2) ? format("({} % 4)", integer(d)) : literal());
                   }},
                  {2, [&] { return either(Kind::kList, depth); }},
                  {1, [&] { return format("{}({})", draft_.one_in(2) ? "reverse" : "cdr", list(d)); }},
                  {1, [&] { return format("cons({}, {})", integer(d), list(d)); }},
                  {1, [&] { return format("({} + [0, 1])[[{} % 2, 0]]", list(d), integer(d)); }},
                  {1, [&] { return format("({} + [1])[{}..0]", list(d), index(depth)); }},
                  {1,
                   [&] {
                     return format("({} + [1, 2])[{}..{}]", list(d), draft_.number(0, 1),
                                   draft_.one_in(2) ? "1" : format("({} % 2)", integer(d)));
                   }},
                  {1, [&] { return format("sort({})", list(d)); }},
                  {1, [&] { return format("sort({}, key: {})", list(d), function(d)); }},
                  {1, [&] { return format("map({}, {})", function(d), list(d)); }},
                  {1, [&] { return format("map({}, {})", draft_.one_in(2) ? "length" : "sum", nested(d)); }},
                  {draft_.libraries.contains("graph") ? 3U : 0U, [&] { return of_graph(depth); }},
                  {draft_.libraries.contains("bin") ? 2U : 0U, [&] { return packed(depth); }},
                  {draft_.libraries.contains("grid") ? 3U : 0U, [&] { return of_grid(depth); }},
                  {1, [&] { return format("filter({}, {})", predicate(depth), list(d)); }},
                  {1, [&] { return format("{}.b", record(d)); }},
                  {1, [&] { return format("{}[{}]", nested(d), index(depth)); }},
                  {1, [&] { return format("choose([{}, {}])", list(d), list(d)); }},
                  {1, [&] { return call(Kind::kList, depth); }},
                  {1, [&] { return use_mixed(Kind::kList, depth); }},
              });
}

std::string Expressions::list_of(Kind kind, int depth, int count) {
  std::vector<std::string> items;
  for (int i = 0; i < count; ++i) items.push_back(expression(kind, depth));
  return format("[{}]", fmt::join(items, ", "));
}

std::string Expressions::comprehension(int depth) {
  const std::size_t before = draft_.variables.size();
  std::string clauses;
  const int count = draft_.one_in(4) ? 2 : 1;
  for (int i = 0; i < count; ++i) {
    const std::string name = draft_.fresh("u");
    clauses += format(" for {} in {}", name, list(depth + 1));
    draft_.declare(name, Kind::kInt, true);
    if (draft_.one_in(2)) clauses += format(" if {}", boolean(depth + 1));
  }
  std::string made = format("[{}{}]", integer(depth + 1), clauses);
  draft_.variables.resize(before);
  return made;
}

std::string Expressions::pairs(int depth) {
  const int d = depth + 1;
  return pick(depth, {
                         {3,
                          [&] {
                            return draft_.variable_or(
                                Kind::kPairs, [&] { return format("[[{}, {}]]", literal(), literal()); });
                          }},
                         {2, [&] { return format("zip({}, {})", list(d), list(d)); }},
                         {1, [&] { return format("pairs({})", list(d)); }},
                         {1, [&] { return format("enumerate({})", list(d)); }},
                         {1, [&] { return either(Kind::kPairs, depth); }},
                     });
}

std::string Expressions::nested(int depth) {
  const int d = depth + 1;
  return pick(depth, {
                         {2,
                          [&] {
                            return draft_.variable_or(Kind::kNested, [&] {
                              return format("[[{}], [{}, {}]]", literal(), literal(), literal());
                            });
                          }},
                         {2, [&] { return list_of(Kind::kList, d, draft_.number(1, 2)); }},
                         {1, [&] { return either(Kind::kNested, depth); }},
                         {1, [&] { return format("({} + [{}])", nested(d), list(d)); }},
                         {1, [&] { return format("sort({}, key: length)", nested(d)); }},
                     });
}

std::string Expressions::record(int depth) {
  const int d = depth + 1;
  return pick(depth,
              {
                  {3,
                   [&] {
                     return draft_.variable_or(
                         Kind::kRecord, [&] { return format("Point({}, [{}])", literal(), literal()); });
                   }},
                  {2, [&] { return format("Point({}, {})", integer(d), list(d)); }},
                  {1, [&] { return format("Point(b: {}, a: {}, c: {})", list(d), integer(d), integer(d)); }},
                  {1, [&] { return either(Kind::kRecord, depth); }},
                  {1,
                   [&] {
                     return format("{}([{}, {}], key: {})", draft_.one_in(2) ? "max" : "min", record(d),
                                   record(d), function_of_record());
                   }},
              });
}

std::string Expressions::text(int depth) {
  const int d = depth + 1;
  return pick(depth, {
                         {2,
                          [&] {
                            return draft_.one_in(2)
                                       ? "\"a\""
                                       : draft_.variable_or(Kind::kString, [] { return "\"bc\""; });
                          }},
                         {1, [&] { return format("str({})", integer(d)); }},
                         {1, [&] { return format("str({})", expression(draft_.any_kind(), d)); }},
                         {1, [&] { return format("({} + {})", text(d), text(d)); }},
                         {1, [&] { return format("str({}, {})", integer(d), text(d)); }},
                         {1, [&] { return format("format(\"{{}}/{{:3}}\", {}, {})", text(d), integer(d)); }},
                         {1, [&] { return format("format(\"{{:<2}}{{:.1}}\", {}, {})", text(d), real(d)); }},
                         {1, [&] { return format("({} + str({}))", text(d), flip()); }},
                         {1, [&] { return choice("choose([\"a\", \"\", \"bc\"])", Kind::kString); }},
                         {1, [&] { return either(Kind::kString, depth); }},
                     });
}

std::string Expressions::real(int depth) {
  const int d = depth + 1;
  return pick(
      depth,
      {
          {3, [&] { return draft_.variable_or(Kind::kFloat, [] { return "0.5"; }); }},
          {2, [&] { return format("({} * 0.25)", integer(d)); }},
          {1,
           [&] {
             return format("({} {} {})", real(d), draft_.any_of<std::string>({"+", "-", "*"}), integer(d));
           }},
          {1,
           [&] {
             return format("({} / {})", integer(d), draft_.any_of<std::string>({"2.0", "-4.0", "0.5"}));
           }},
          {1, [&] { return format("({} / {})", real(d), integer(d)); }},
          {1, [&] { return format("abs({})", real(d)); }},
          {1, [&] { return format("sqrt(abs({}))", integer(d)); }},
          {1, [&] { return either(Kind::kFloat, depth); }},
          {1, [&] { return format("cond({}, {}, {})", boolean(d), real(d), real(d)); }},
      });
}

std::string Expressions::function(int depth) {
  const int d = depth + 1;
  return pick(depth, {
                         {3, [&] { return draft_.variable_or(Kind::kFunction, [] { return "abs"; }); }},
                         {2, [&] { return lambda(depth); }},
                         {1, [&] { return format("choose([{}, {}])", function(d), function(d)); }},
                         {1, [&] { return either(Kind::kFunction, depth); }},
                         {1,
                          [&] {
                            const std::string v = draft_.fresh("u");
                            return format("[fun({}) {{ return {} + {}; }} for {} in {}][{}]", v + "p",
                                          v + "p", v, v, list(d), index(depth));
                          }},
                     });
}

std::string Expressions::lambda(int depth) {
  return lambda([&] { return integer(depth + 1); });
}

/// A function of a record that gives an int.
std::string Expressions::function_of_record() {
  return format("(fun(p) {{ return p.{}; }})", draft_.one_in(2) ? "c" : "a");
}

/// A function of an int that gives a bool.
std::string Expressions::predicate(int depth) {
  return lambda([&] { return boolean(depth + 1); });
}

template <class Body>
std::string Expressions::lambda(Body body) {
  const std::size_t before = draft_.variables.size();
  const std::string name = draft_.fresh("p");
  ++draft_.level;
  draft_.declare(name, Kind::kInt);
  std::string made = format("fun({}) {{ return {}; }}", name, body());
  --draft_.level;
  draft_.variables.resize(before);
  return format("({})", made);
}

}  // namespace solitaire::generator
