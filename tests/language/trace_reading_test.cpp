// What is read off a trace is what the program does. The differential tests compare the same for generated
// programs.
#include "solitaire/run/trace_reading.h"

#include <doctest/doctest.h>
#include <map>

#include "engines/distinct.h"
#include "engines/freeze.h"
#include "engines/solve/executions/exclusion.h"
#include "solitaire/value/plain_copy.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

class AllSides : public Branches {
 public:
  std::optional<std::uint32_t> open(const BranchSide&, std::uint32_t) override { return 0; }
};

/// A program's pass over all executions, and each of its solutions.
struct Whole {
  explicit Whole(const std::string& text) : program(program_of(text)) {
    OpenChoices open;
    AllSides all;
    pass = trace(program, {}, open, all, 0, graph, addresses, {});
    solutions = *all_executions(program, addresses, {});
  }

  std::optional<Execution> read(const Execution& solution, bool scene = true) {
    Valuation known;
    for (const MetChoice& choice : solution.choices) known.emplace(choice.address, choice.value);
    Assignment values = assignment_of(graph, known);
    return read_execution(program, pass, addresses, values, scene);
  }

  Program program;
  Graph graph;
  AddressTable addresses;
  SymbolicPass pass;
  std::vector<Execution> solutions;
};

}  // namespace

TEST_CASE("reading: what a solution comes to can be read off the trace") {
  const char* const texts[] = {
      "x = range(0, 3); y = range(0, 3); assert(x < y); return [x, y * 2, x == 1];",
      "record P(x, y);\np = P(range(0, 2), flip());\nif p.y then p.x = p.x + 10;\nreturn [p, p.x / 2];",
      "n = range(0, 3); list = []; for i in 0..2 { if i < n then list = list + [i * n]; }\n"
      "return if flip() then list else nil;",
      "a = range(1, 4); minimize(a); prefer(a > 2, 3); if flip() then prefer(a < 2); return a * 0.5;",
      "for i in 0..2 { x = range(0, 1); if x == 1 then place(if flip() then \"chair\" else \"table\",\n"
      "at: [x, 2 * i, 0.5], turn: x, name: \"n\", weight: x + 1); }",
      "unit(0.5); x = range(0, 2); place(at: [x, x], size: [1, 2 + x], color: if x > 0 then \"red\" else "
      "nil);",
  };
  for (const char* const text : texts) {
    INFO(std::string(text));
    Whole whole(text);
    REQUIRE(whole.solutions.size() > 2);
    for (const Execution& run : whole.solutions) {
      const std::optional<Execution> read = whole.read(run);
      REQUIRE(read);
      CHECK(to_json(read->value) == to_json(run.value));
      CHECK(looks_of(solution_of(*read, whole.addresses)) == looks_of(solution_of(run, whole.addresses)));
      CHECK(read->unit == run.unit);
      CHECK(read->cost == run.cost);
      CHECK(read->wishes.size() == run.wishes.size());
      REQUIRE(read->choices.size() == run.choices.size());
      for (std::size_t i = 0; i < run.choices.size(); ++i) {
        CHECK(read->choices[i].address == run.choices[i].address);
        CHECK(read->choices[i].value == run.choices[i].value);
      }
      for (std::size_t i = 0; i < run.placements.size(); ++i) {
        CHECK(read->placements[i].address == run.placements[i].address);
        CHECK(read->placements[i].source == run.placements[i].source);
        CHECK(read->placements[i].extras == run.placements[i].extras);
      }
      CHECK(whole.read(run, false)->placements.empty());
    }
  }
}

TEST_CASE("reading: what only shows when the program is run is left to that") {
  const char* const texts[] = {
      "x = range(0, 3); print(x); return x;",
      "x = range(0, 300) + range(0, 300); return str(x);",
      "if flip() then unit(2); return range(0, 1);",
      "unit(range(1, 3));",
  };
  for (const char* const text : texts) {
    INFO(std::string(text));
    Whole whole(text);
    REQUIRE(!whole.solutions.empty());
    CHECK(!whole.read(whole.solutions.back()));
  }
}

TEST_CASE("reading: an execution that fails an assert, or goes where the trace does not, is not read") {
  Whole whole("x = range(0, 3); if x == 2 then assert(flip()); return x;");
  std::size_t solutions = 0;
  for (const Execution& solution : whole.solutions) solutions += whole.read(solution) ? 1 : 0;
  CHECK(solutions == whole.solutions.size());
  const Term& required = whole.pass.trace.hard_terms.front();
  Assignment broken(whole.graph, [&](std::size_t number) {
    const bool is_bool = whole.graph.variables()[number].domain.type() == Type::kBool;
    return Scalar::of(std::int64_t{is_bool ? 0 : 2});
  });
  REQUIRE(broken.holds(required.guard));
  CHECK(!read_execution(whole.program, whole.pass, whole.addresses, broken, true));
  whole.pass.trace.blockers.push_back({kTrue, {}, {}});
  CHECK(!whole.read(whole.solutions.front()));
}

}  // namespace solitaire
