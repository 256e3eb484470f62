// Breaking symmetries leaves at least one solution of each look, and fewer in all.
#include "engines/solve/conclusions/symmetry.h"

#include <doctest/doctest.h>
#include <set>

#include "engines/exhaustive/exhaustive.h"
#include "engines/solve/series.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

std::set<std::string> all_looks(const Program& program) {
  std::set<std::string> looks;
  ExhaustiveEngine engine(program, {}, {});
  while (const auto solution = engine.next()) looks.insert(DistinctResults::key(*solution));
  return looks;
}

struct Listed {
  std::set<std::string> looks;
  std::uint64_t alike = 0;  // found, and left out
};

Listed list(const Program& program) {
  TracingOptions tracing;
  tracing.diverse = false;
  SeriesOptions options;
  options.apart = Apart::kResult;
  Series series(program, {}, tracing, options);
  Listed listed;
  while (const auto solution = series.next()) {
    CHECK(listed.looks.insert(DistinctResults::key(*solution)).second);
  }
  CHECK(series.ending() == Ending::kExhausted);
  listed.alike = series.alike();
  return listed;
}

}  // namespace

TEST_CASE("symmetry: things of one kind that change places are found in one order only") {
  struct Case {
    const char* text;
    std::uint64_t alike;  // that are left, as no swap leads from one to the other
  };
  const Case cases[] = {
      // three crates in a row
      {"at = [range(0, 5) for i in 1..3]; for x in at: place(\"crate\", at: [x, 0]); assert(distinct(at));",
       0},
      // two kinds, each with its own order, and one thing that stands alone
      {"a = [range(0, 3) for i in 1..2]; b = [range(0, 3) for i in 1..2]; c = range(0, 1);\n"
       "for x in a: place(\"chair\", at: [x, 0], turn: c); for x in b: place(\"table\", at: [x, 2]);\n"
       "assert(a[0] + a[1] != b[0] + b[1]);",
       0},
      // things within things: both levels change places
      {"record Box(x, y); fun make() { return [Box(range(0, 2), range(0, 1)) for i in 1..2]; }\n"
       "groups = [make() for g in 1..2];\n"
       "for group in groups { for box in group: place(\"crate\", at: [box.x, box.y]); }\n"
       "for group in groups { assert(group[0].x != group[1].x or group[0].y != group[1].y); }",
       30},
      // a name and an extra do not count
      {"for i in 0..2 { place(\"crate\", at: [range(0, 3), 0], name: str(i), weight: i); }", 0},
  };
  for (const Case& each : cases) {
    INFO(std::string(each.text));
    const Program program = program_of(each.text);
    const Listed listed = list(program);
    CHECK(listed.looks == all_looks(program));
    CHECK(listed.alike == each.alike);
  }
}

TEST_CASE("symmetry: what does not change places stays as it is") {
  const char* const texts[] = {
      "at = [range(0, 3) for i in 1..3]; return at;",  // the value tells them apart
      "at = [range(0, 3) for i in 1..3]; assert(at[0] < at[1]); return sum(at);",  // a condition does
      "for i in 0..1 { place(\"crate\", at: [range(0, 2), i]); }",                 // where they stand does
      "for i in 0..1 { place(\"crate\", at: [range(0, 2 + i), 0]); }",             // their ranges do
      "for i in 0..1 { place(if i == 0 then \"crate\" else \"chair\", at: [range(0, 2), 0]); }",
      "a = [flip() for i in 1..3]; if a[0] then place(\"crate\", at: [0, 0]); return a[1] and a[2];",
      "at = [range(0, 3) for i in 1..2]; place(\"crate\", at: [at[0] * 10 + at[1], 0]);",
      "fun f() { return range(0, 2); } at = [if flip() then f() else 0 for i in 1..2]; return at[0] + at[1];",
  };
  for (const char* const text : texts) {
    INFO(std::string(text));
    const Program program = program_of(text);
    CHECK(list(program).looks == all_looks(program));
  }
}

}  // namespace solitaire
