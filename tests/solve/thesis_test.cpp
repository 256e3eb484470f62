// The dissertation's engine: the solutions that the others find where 16 bits hold every int, and no wrong
// ones where they do not.
#include <doctest/doctest.h>

#include "engines/thesis/all_different.h"
#include "engines/thesis/published_method.h"
#include "smt/z3/choice_too_wide.h"
#include "smt/z3/z3_solver.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

struct Run {
  std::vector<Found> solutions;
  Ending ending = Ending::kNone;
};

Run run_thesis(const std::string& text, std::uint64_t executions = 200) {
  const Program program = program_of(text);
  TracingOptions options;
  options.method = &published_method();
  options.exploration = {Exploration::Policy::kRandom, executions};
  TracingEngine engine(program, {}, options);
  Run run{all_solutions(engine), {}};
  run.ending = engine.ending();
  return run;
}

void check_same(const std::string& text) {
  CAPTURE(text);
  const Run run = run_thesis(text);
  CHECK(run.solutions == all_solutions(program_of(text), {}, Way::kExhaustive));
  CHECK(run.ending == Ending::kExhausted);
}

TEST_CASE("thesis: all solutions of small programs, with paths that differ, steps, bools and negative ints") {
  check_same("x = range(0, 3); y = range(0, 3); assert(x + y == 3); return [x, y];");
  check_same("n = range(0, 3); return [choose([1, 2, 3]) for i in 1..n];");
  check_same("if flip() { x = range(-5, 5); assert(x * x > 8); return x; } return range(0, 6, 3);");
  check_same("a = range(-7, 7); b = range(1, 3); assert(a / b == -2 or mod(a, b) == 2); return [a, b];");
  check_same("x = range(0, 3); assert(x > 5);");
  check_same("return 5;");
  check_same("x = range(-40, 40, 20); y = range(0, 9); assert(min(x, y) + abs(x) > 30); return x + y;");
}

TEST_CASE("thesis: all solutions of the programs that others are tested with") {
  for (const std::string name : {"queens.sol", "example.sol", "magic_square.sol", "subset.sol"}) {
    CAPTURE(name);
    Program program = load("programs/" + name);
    ParamValues params;
    if (name == "subset.sol") params = read_params(program, {{"n", "4"}}, program.sources);
    if (name == "queens.sol") params = read_params(program, {{"n", "6"}}, program.sources);
    CHECK(all_solutions(program, params, Way::kThesis) == all_solutions(program, params, Way::kDemand));
  }
}

TEST_CASE("thesis: a model in which 16 bits wrap is none, and the search goes on") {
  // 218 * 302 is 65836, in 16 bits 300.
  const Run run = run_thesis("x = range(0, 300); y = range(300, 303); assert(x * y == 300); return [x, y];");
  REQUIRE(run.solutions.size() == 1);
  CHECK(run.solutions.front().value == "[1, 300]");
  CHECK(run.ending == Ending::kWrapped);
}

TEST_CASE("thesis: solutions whose ints leave 16 bits are lost, and nothing is called proved") {
  const std::string text = "x = range(170, 200); y = range(30000, 30001); assert(x * x > y); return [x, y];";
  const Run run = run_thesis(text);
  CHECK(run.solutions.size() == 2 * (181 - 173));  // of 2 * (200 - 173); 182 * 182 is too large
  CHECK(run.ending == Ending::kWrapped);
}

TEST_CASE("thesis: with wishes the search ends also where costs wrap") {
  const Run run = run_thesis("x = range(0, 300); minimize(x * x); assert(x > 290); return x;");
  CHECK(run.solutions.size() == 10);
  CHECK(run.ending == Ending::kWrapped);
}

TEST_CASE("thesis: what random executions do not take is not there") {
  const Run run =
      run_thesis("x = range(0, 30000); if x == 77 { return \"rare\"; } assert(x < 3); return x;", 5);
  CHECK(run.solutions.size() == 3);
  CHECK(run.ending == Ending::kUnexplored);
}

TEST_CASE("thesis: choices that do not exist have their reserved value") {
  Graph graph;
  AddressTable addresses;
  const auto choice = [&](const char* name, std::int64_t lo) {
    return graph.choice({addresses.site(addresses.root(), name), {lo, lo + 5, 1, {}}});
  };
  const NodeId f = choice("f", 0), x = choice("x", 3);
  const NodeId exists = graph.apply(Op::kEqInt, {f, graph.constant(std::int64_t{1})});
  Trace trace;
  trace.choices.push_back({kTrue, f, addresses.site(addresses.root(), "f"), {}, {}});
  trace.choices.push_back({exists, x, addresses.site(addresses.root(), "x"), {}, {}});
  const std::vector<NodeId> reserved = reserved_values(graph, trace);
  REQUIRE(reserved.size() == 1);
  const auto holds = [&](NodeId condition, std::int64_t f_value, std::int64_t x_value) {
    return Assignment(graph, [&](std::size_t i) { return Scalar::of(i == 0 ? f_value : x_value); })
        .holds(condition);
  };
  CHECK(holds(reserved[0], 0, 3));
  CHECK(!holds(reserved[0], 0, 4));
  CHECK(holds(reserved[0], 1, 4));
  const std::vector<NodeId> differ =
      differences(graph, trace, {{addresses.site(addresses.root(), "f"), TypedScalar::of(std::int64_t{0})}});
  REQUIRE(differ.size() == 2);
  CHECK(!holds(differ[0], 0, 3));
  CHECK(!holds(differ[1], 0, 4));  // x does not exist there
  CHECK(holds(differ[1], 1, 4));
}

TEST_CASE("thesis: a choice that 16 bits do not hold is an error that says so") {
  CHECK_THROWS_WITH_AS(run_thesis("x = range(0, 40000); assert(x > 7); return x;"),
                       doctest::Contains("the values of x go from 0 to 40000"), ChoiceTooWide);
}

TEST_CASE("thesis: on the command line") {
  const Workplace place;
  const std::string script =
      place.file("p.sol", "x = range(0, 9); y = range(0, 9); assert(x < y); return [x, y];\n");
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin() + 1, script);
    return run_solitaire(arguments);
  };
  const Outcome all = with({"solve", "--all", "--engine", "thesis"});
  CHECK(all.status == 0);
  CHECK(all.err.find("45 solutions") != std::string::npos);
  CHECK(with({"solve", "--engine", "thesis", "--explore", "random:3"}).status == 0);
  CHECK(with({"solve", "--engine", "thesis", "--explore", "demand"}).status == 2);
  CHECK(with({"explain", "--engine", "thesis"}).status == 2);
  CHECK(with({"generate", "--engine", "thesis", "-o", place / "out"}).status == 0);
  CHECK(bytes_of(place / "out/p-0001.json").find("\"engine\": \"tracing/thesis\"") != std::string::npos);
}

}  // namespace
}  // namespace solitaire
