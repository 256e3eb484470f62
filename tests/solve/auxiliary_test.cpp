// Auxiliary choices: solutions that differ in nothing else are one, whoever finds, counts or draws them. Held
// against running every execution.
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "engines/exhaustive/exhaustive.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

using nlohmann::json;

/// What tells the solutions of a program apart, of all its executions: addresses and values of the choices
/// that are not auxiliary.
std::set<std::string> shown_by_brute_force(const std::string& text) {
  const Program program = program_of(text);
  ExhaustiveEngine engine(program, {}, {});
  std::set<std::string> shown;
  while (const auto solution = engine.next()) {
    std::string key;
    for (const ChosenValue& choice : solution->choices)
      key += choice.address + '=' + to_text(choice.value) + ' ';
    shown.insert(key);
  }
  return shown;
}

struct Printed {
  std::multiset<std::string> keys;
  int status = 0;
};

Printed printed(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), {"--json", "-q"});
  const Outcome outcome = run_solitaire(arguments);
  std::istringstream lines(outcome.out);
  Printed found{{}, outcome.status};
  for (std::string line; std::getline(lines, line);) {
    std::string key;
    const json solution = json::parse(line);
    for (const json& choice : solution["choices"])
      key += choice["at"].get<std::string>() + '=' + choice["value"].dump() + ' ';
    found.keys.insert(key);
  }
  return found;
}

/// Some with auxiliary choices that follow from the others, some with several that fit, some on paths.
const char* const kPrograms[] = {
    "x = range(0, 20); aux root = range(0, 4); assert(x == root * root or x == root * root + 1); return x;",
    "xs = [range(0, 2) for i in 1..3]; aux largest = range(0, 2); assert(largest == max(xs)); return xs;",
    "aux a = range(0, 3); x = range(0, 3); assert(x <= a); return x;",
    "if flip() then aux a = range(0, 3); x = range(0, 2); y = range(0, 1); return [x, y];",
    "fun witness(n) { w = range(0, n); return w; } x = range(0, 9); aux k = witness(3); assert(x == 3 * k); "
    "return x;",
    "aux order = [range(0, 2) for i in 1..3]; assert(distinct(order)); x = flip(); "
    "assert(not x or order[0] > order[1]); return x;",
    "x = range(0, 3); y = range(0, 3); aux s = range(0, 6); assert(s == x + y); aux even = flip(); "
    "assert(even == (s % 2 == 0)); assert(even and s > 2); return [x, y];",
    "aux a = range(0, 3); aux b = range(0, 3); assert(a == b); x = range(0, 3); assert(x <= a); return x;",
    "x = range(0, 3); if x > 1 { aux a = range(0, 9); assert(a == x * x); } y = flip(); return [x, y];",
    "x = range(0, 3); aux a = range(0, 2); assert(a == x); return x;",
    "x = range(0, 3); aux s = range(0, 9); assert(s == x * s); return x;",
};

}  // namespace

TEST_CASE("auxiliary: all solutions, counts and uniform draws are those of every execution, each once") {
  const Workplace place;
  for (const char* text : kPrograms) {
    CAPTURE(std::string(text));
    const std::set<std::string> expected = shown_by_brute_force(text);
    const std::string script = place.file("aux.sol", text);
    const auto is_expected = [&](const Printed& found) {
      return std::multiset<std::string>(expected.begin(), expected.end()) == found.keys;
    };
    CHECK(is_expected(printed({"solve", script, "--all"})));
    CHECK(is_expected(printed({"solve", script, "--all", "--engine", "z3"})));
    CHECK(is_expected(printed({"solve", script, "-n", "1000"})));
    CHECK(is_expected(printed({"solve", script, "-n", "1000", "--sample", "uniform"})));
    CHECK(json::parse(run_solitaire({"count", script, "--json", "-q"}).out)["solutions"] == expected.size());
  }
}

TEST_CASE("auxiliary: a pin may name them, and a file of a solution leaves them open") {
  const Workplace place;
  const std::string script = place.file("aux.sol", kPrograms[0]);
  CHECK(printed({"solve", script, "--all", "--pin", "root=3"}).keys ==
        std::multiset<std::string>{"x=10 ", "x=9 "});
  const std::string liked =
      place.file("liked.json", run_solitaire({"solve", script, "--json", "--pin", "x=4"}).out);
  CHECK(printed({"solve", script, "--all", "--pin-file", liked}).keys == std::multiset<std::string>{"x=4 "});
}

TEST_CASE("auxiliary: a resumed run goes on with what did not come before") {
  const Workplace place;
  const std::string script = place.file(
      "rows.sol",
      "x = range(0, 5); aux a = range(0, 5); assert(x <= a); place(\"box\", at: [x, 0]); return x;");
  const std::vector<std::string> run = {"generate", script,       "-o",     place / "out",
                                        "-q",       "--distinct", "choices"};
  const auto with = [&](std::vector<std::string> more) {
    std::vector<std::string> all = run;
    all.insert(all.end(), more.begin(), more.end());
    return run_solitaire(all).status;
  };
  CHECK(with({"-n", "3"}) == 0);
  CHECK(with({"-n", "10", "--resume"}) == 1);
  std::set<std::string> values;
  for (int i = 1; i <= 6; ++i)
    values.insert(
        json::parse(bytes_of(place / ("out/rows-000" + std::to_string(i) + ".json")))["value"].dump());
  CHECK(values == std::set<std::string>{"0", "1", "2", "3", "4", "5"});
}

}  // namespace solitaire
