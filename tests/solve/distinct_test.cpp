// Solutions that are told apart by what is seen: exactly those come that running every execution shows, and
// choices that nothing shows are not gone through.
#include "engines/distinct.h"

#include <doctest/doctest.h>
#include <set>

#include "engines/exhaustive/exhaustive.h"
#include "engines/solve/series.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

std::set<std::string> all_keys(const Program& program, Apart apart) {
  std::set<std::string> keys;
  ExhaustiveEngine engine(program, {}, {});
  while (const auto solution = engine.next()) keys.insert(DistinctResults::key(*solution, apart));
  return keys;
}

struct Told {
  std::set<std::string> keys;
  std::uint64_t alike = 0;
};

Told tell_apart(const Program& program, Apart apart, bool diverse) {
  TracingOptions tracing;
  tracing.diverse = diverse;
  SeriesOptions options;
  options.apart = apart;
  Series series(program, {}, tracing, options);
  Told told;
  while (const auto solution = series.next())
    CHECK(told.keys.insert(DistinctResults::key(*solution, apart)).second);
  CHECK(series.ending() == Ending::kExhausted);
  told.alike = series.alike();
  return told;
}

}  // namespace

TEST_CASE("distinct: what comes is what every execution shows, once each") {
  const char* const texts[] = {
      "x = range(-3, 3); hidden = range(0, 3); return x * x;",
      "x = range(0, 2); y = range(0, 2); if x > y then return \"more\"; return [x, y > 0];",
      "n = range(0, 3); for i in 1..n { place(\"box\", at: [range(0, 1), i]); } hidden = flip(); return n > "
      "1;",
      "record P(a, b); p = choose([P(1, 2), P(2, 1)]); q = P(range(0, 1), flip()); return if flip() then p "
      "else q.a;",
      "x = range(0, 5); place(if x > 2 then \"table\" else \"chair\", at: [x / 2, 0], turn: x % 2, color: "
      "\"red\");",
      "x = range(0, 5); place(\"chair\", material: if x > 2 then \"oak\" else \"steel\", scale: 1 + x % 2, "
      "price: x);",
      "x = range(0, 3); return x * 0.5 + (if flip() then 0.0 else 0.5);",
      "v = range(0, 2); if v > 0 { w = range(0, 2); v = w; } return v * 0.25;",
      "aux a = range(0, 3); x = range(0, 3); assert(x <= a); return x / 2;",
      "x = range(0, 3); print(x); return x / 2;",
      "x = range(0, 3); y = flip(); return x / 2; output { return [x, y]; }",
      "fun deep(n) { if n == 0 then return 0; return 1 + deep(n - 1); } return deep(range(0, 6)) / 2;",
      "n = range(1, 2); xs = sort([0, 1, 2][1..n]); if flip() { xs += [1]; } return [xs, 1];",
  };
  for (const char* text : texts) {
    CAPTURE(std::string(text));
    const Program program = program_of(text);
    for (const Apart apart : {Apart::kResult, Apart::kValue}) {
      for (const bool diverse : {false, true}) {
        CAPTURE(diverse);
        CHECK(tell_apart(program, apart, diverse).keys == all_keys(program, apart));
      }
    }
  }
}

TEST_CASE("distinct: values are the same where the language says that they are equal") {
  const auto values = [](const char* text) {
    const Program program = program_of(text);
    const std::size_t in_order = tell_apart(program, Apart::kValue, false).keys.size();
    CHECK(tell_apart(program, Apart::kValue, true).keys.size() == in_order);
    return in_order;
  };
  CHECK(values("return choose([0.0, -0.0, 0, 1.0, 1, 1.5]);") == 3);
  CHECK(values("return [choose([0.0, -0.0]), range(0, 1) * 1.0];") == 2);
  CHECK(values("return choose([4611686018427387903, 4611686018427387904.0]);") == 2);
  CHECK(values("record A(x); record B(x); return choose([A(1), B(1), A(1.0)]);") == 2);
  CHECK(values("return choose([1, true, \"1\", [1], nil, \"nil\"]);") == 6);
}

TEST_CASE("distinct: choices that nothing shows are not gone through") {
  const Program cable = program_of(
      "lamp = range(0, 3);\ncable = [range(0, 9) for i in 1..8];\nassert(sum(cable) == 30 + lamp);\n"
      "place(\"lamp\", at: [lamp, 0]);\n");
  const Told as_it_comes = tell_apart(cable, Apart::kResult, true);
  CHECK(as_it_comes.keys.size() == 4);
  CHECK(as_it_comes.alike < 20);  // that blocks found side by side
  const Told in_order = tell_apart(cable, Apart::kResult, false);
  CHECK(in_order.keys.size() == 4);
  CHECK(in_order.alike < 40);

  const Program report =
      program_of("xs = [range(0, 9) for i in 1..6]; return sum(xs) / 20; output { return str(xs); }");
  const Told by_key = tell_apart(report, Apart::kValue, true);
  CHECK(by_key.keys.size() == 3);
  CHECK(by_key.alike < 20);
}

TEST_CASE("distinct: it is known whether only names and extras differ") {
  const auto names_differ = [](const char* text, bool diverse) {
    SeriesOptions options;
    options.apart = Apart::kResult;
    const Program program = program_of(text);
    TracingOptions tracing;
    tracing.diverse = diverse;
    Series series(program, {}, tracing, options);
    while (series.next()) {
    }
    return series.names_differed();
  };
  for (const bool diverse : {false, true}) {
    CHECK(names_differ("x = range(0, 1); place(\"box\", name: str(x));", diverse));
    CHECK(names_differ("x = range(0, 1); place(\"box\", weight: x);", diverse));
    CHECK_FALSE(names_differ("x = range(0, 1); place(\"box\");", diverse));
  }
}

}  // namespace solitaire
