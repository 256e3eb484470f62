#include "tests/generator/statements.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace solitaire::generator {

using fmt::format;

namespace {

constexpr int kDeepestBlock = 3;
constexpr int kMostStatements = 34;

}  // namespace

void Statements::block(int most) {
  const std::size_t before = draft_.variables.size();
  const std::size_t mixed_before = draft_.mixed.size();
  const std::size_t functions_before = draft_.functions.size();
  ++draft_.block;
  for (int i = draft_.number(1, most); i > 0; --i) statement();
  --draft_.block;
  const bool leak = draft_.mistakes > 0 && draft_.variables.size() > before && draft_.one_in(3);
  if (leak) --draft_.mistakes;
  draft_.variables.resize(before + (leak ? 1 : 0), Variable{});
  draft_.mixed.resize(mixed_before);
  draft_.functions.resize(functions_before);
}

void Statements::statement() {
  if (++draft_.statements > kMostStatements) return draft_.line("// enough");
  if (draft_.block >= kDeepestBlock) return simple_statement();
  switch (draft_.below(24)) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
      return simple_statement();
    case 6:
    case 7:
    case 8:
      return if_statement();
    case 9:
    case 10:
      return for_statement();
    case 11:
      return while_statement();
    case 12:
      return same_calls();
    case 13:
      return draft_.one_in(2) ? closure() : reads_below();
    case 14:
      return assign_mixed();
    case 15:
    case 16:
      return leave();
    case 17:
    case 18:
      return draft_.wishes && draft_.one_in(2) ? wish() : draft_.line(assertion());
    case 19:
      return assign_new(Kind::kFunction);
    case 20:
      if (draft_.one_in(2)) return optional_append();
      return draft_.one_in(3) ? pack() : auxiliary();
    case 21:
      return declare_function();
    case 22:
      return draft_.libraries.empty() ? simple_statement() : use_library();
    default:
      return simple_statement();
  }
}

void Statements::declare_function() {
  if (draft_.level > 1 || draft_.block > 1) return simple_statement();
  functions_.declare();
}

void Statements::wish() {
  switch (draft_.below(3)) {
    case 0:
      return draft_.line(format("prefer({}, {});", expressions_.boolean(1), draft_.number(0, 3)));
    case 1:
      return draft_.line(format("minimize({});", expressions_.integer(2)));
    default:
      return draft_.line(format("maximize({} % 5);", expressions_.integer(2)));
  }
}

std::string Statements::assertion() {
  const std::string first = expressions_.boolean(1);
  return draft_.one_in(3) ? format("assert({});", first)
                          : format("assert({} or {});", first, expressions_.boolean(1));
}

void Statements::simple_statement() {
  switch (draft_.below(12)) {
    case 0:
    case 1:
    case 2:
      return assign_new(draft_.any_kind());
    case 3:
    case 4:
    case 5:
      return assign_again();
    case 6:
    case 7:
      return write_element();
    case 8:
      return draft_.line(
          format("print({}, {});", expressions_.text(1), expressions_.expression(draft_.any_kind(), 1)));
    case 9:
      return place();
    case 10:
      return swap();
    default:
      return draft_.line(assertion());
  }
}

void Statements::assign_new(Kind kind) {
  const std::string value = expressions_.expression(kind);
  const std::string name = draft_.fresh(kind == Kind::kFunction ? "g" : "v");
  draft_.line(format("{} = {};", name, value));
  draft_.declare(name, kind, kind == Kind::kFunction);
}

void Statements::assign_again() {
  const Kind kind = draft_.any_kind();
  const auto targets = draft_.visible(kind, true);
  if (targets.empty()) return assign_new(kind);
  const std::string name = draft_.any_of(targets).name;
  if (kind == Kind::kInt && draft_.one_in(3))
    return draft_.line(format("{} {}= {};", name, draft_.one_in(2) ? "-" : "+", expressions_.integer(1)));
  if (kind == Kind::kString && draft_.one_in(2))
    return draft_.line(format("{} += {};", name, expressions_.text(1)));
  if (kind == Kind::kInt && draft_.loops > 0)
    return draft_.line(format("{} = {} % 7;", name, expressions_.integer(1)));
  draft_.line(format("{} = {};", name, expressions_.expression(kind, 1)));
}

void Statements::assign_mixed() {
  const std::string condition = draft_.fresh("m");
  const std::string name = draft_.fresh("x");
  Mixed made{name, condition, draft_.any_kind(), draft_.any_kind()};
  draft_.line(format("{} = {};", condition, expressions_.boolean(1)));
  draft_.line(format("{} = {};", name, expressions_.expression(made.then_kind, 1)));
  draft_.line(format("if not {} {{ {} = {}; }}", condition, name,
                     draft_.one_in(4) ? "nil" : expressions_.expression(made.else_kind, 1)));
  draft_.declare(condition, Kind::kBool, true);
  draft_.mixed.push_back(std::move(made));
}

void Statements::write_element() {
  const auto lists = draft_.visible(Kind::kList, true);
  const auto nests = draft_.visible(Kind::kNested, true);
  const auto records = draft_.visible(Kind::kRecord, true);
  const std::uint32_t way = draft_.below(5);
  if (way < 2 && !lists.empty())
    return draft_.line(format("{}[{}] {} {};", draft_.any_of(lists).name, expressions_.index(1),
                              draft_.one_in(3) ? "+=" : "=", expressions_.integer(1)));
  if (way == 2 && !nests.empty())
    return draft_.line(format("{}[{}][{}] = {};", draft_.any_of(nests).name, expressions_.index(1),
                              expressions_.index(1), expressions_.integer(1)));
  if (way == 3 && !records.empty())
    return draft_.line(format("{}.b[{}] = {};", draft_.any_of(records).name, expressions_.index(1),
                              expressions_.integer(1)));
  if (!records.empty())
    return draft_.line(format("{}.{} = {};", draft_.any_of(records).name, draft_.one_in(3) ? "c" : "a",
                              expressions_.integer(1)));
  assign_new(Kind::kRecord);
}

void Statements::place() {
  draft_.line(format("place(\"chair\", at: [{}, {}], turn: {}, name: {});", expressions_.integer(2),
                     expressions_.integer(2), expressions_.integer(2), expressions_.text(2)));
}

void Statements::swap() {
  const auto ints = draft_.visible(Kind::kInt, true);
  if (ints.size() < 2) return assign_again();
  const std::string& a = ints[0].name;
  const std::string& b = ints[ints.size() - 1].name;
  if (draft_.one_in(2)) return draft_.line(format("{}, {} = {}, {};", a, b, b, a));
  draft_.line(format("{}, {} = {};", a, b,
                     expressions_.either(Kind::kInt, 1).empty()
                         ? ""
                         : format("[{}, {}]", expressions_.integer(1), expressions_.integer(1))));
}

/// An auxiliary choice that nothing but an assert looks at, so that which value it has is not seen.
void Statements::auxiliary() {
  if (draft_.choices <= draft_.level || draft_.loops > 0) return optional_append();
  const std::string name = draft_.fresh("w");
  draft_.choices -= 1 + draft_.level;
  draft_.line(format("aux {} = {};", name, draft_.one_in(2) ? "range(0, 2)" : "choose([-1, 1, 1])"));
  draft_.line(format("assert({} {} {});", name, draft_.one_in(2) ? "==" : "<=", expressions_.integer(1)));
}

void Statements::pack() {
  if (draft_.choices < 3 || draft_.level > 0 || draft_.loops > 0) return optional_append();
  draft_.choices -= 3;
  const std::string name = draft_.fresh("b");
  draft_.line(format("{} = [range(0, 1) for u in 0..2];", name));
  draft_.declare(name, Kind::kList);
  if (draft_.one_in(3))
    return draft_.line(format("assert(distinct({} + [{}]));", name, expressions_.integer(1)));
  const std::string held = format("[cond(b == j, z, 0) for b, z in zip({}, [{}, 2, {}])]", name,
                                  draft_.number(1, 3), draft_.number(1, 2));
  draft_.line(
      format("assert(all([sum({}) {} {} for j in 0..1]));", held, draft_.one_in(4) ? "==" : "<=",
             draft_.one_in(2) ? draft_.any_of<std::string>({"2", "3", "4"}) : expressions_.integer(1)));
}

void Statements::optional_append() {
  const auto lists = draft_.visible(Kind::kList, true);
  if (lists.empty()) return assign_new(Kind::kList);
  const std::string name = draft_.any_of(lists).name;
  draft_.line(format("if {} {{ {} += [{}]; }}", expressions_.boolean(1), name, expressions_.integer(1)));
}

}  // namespace solitaire::generator
