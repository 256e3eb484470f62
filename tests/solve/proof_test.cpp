// The formula that a search leaves behind, as a user gets it with --formula: other solvers find nothing in it
// where the search proved that there is no other solution, and find the rest of them where it was not over.
#include "tests/solve/proof.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/solve/proof_check.h"
#include "tests/support/command.h"

namespace solitaire {
namespace {

using nlohmann::json;

constexpr const char* kRoot = SOLITAIRE_SOURCE_DIR;
/// Its choices have a negative end, a step, and a single value.
constexpr const char* kMixed =
    "x = range(-5, 6);\ny = range(10, 50, 8);\nz = range(7, 7);\nif flip() { assert(x * y == -z - z - 6); }\n"
    "else { assert(x + y > 50); }\n";

std::vector<json> json_lines(const std::string& text) {
  std::vector<json> values;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) values.push_back(json::parse(line));
  return values;
}

/// What `solve` prints with these options, and the formula that it writes.
struct Solved {
  std::vector<json> solutions;
  std::string formula;
};

Solved solve(std::vector<std::string> options, const std::string& ending) {
  const Workplace place;
  const std::string file = place / ("formula" + ending);
  options.insert(options.begin(), "solve");
  options.insert(options.end(), {"-q", "--json", "--formula", file});
  const Outcome outcome = run_solitaire(options);
  CHECK(outcome.status == 0);
  CHECK(outcome.err == "");
  return {json_lines(outcome.out), bytes_of(file)};
}

/// The choices' values in a model of clauses, by what the comments in them say.
std::map<std::string, std::int64_t> choices_in(const std::string& clauses, const std::string& model) {
  std::map<int, bool> bits;
  std::istringstream values(model);
  for (std::string word; values >> word;) {
    if (const int literal = std::atoi(word.c_str()); literal != 0) bits[std::abs(literal)] = literal > 0;
  }
  std::map<std::string, std::int64_t> choices;
  std::istringstream lines(clauses);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("c choice ", 0) != 0) continue;
    std::istringstream words(line);
    std::string word, address;
    std::int64_t lowest = 0, step = 0, number = 0, weight = 1;
    words >> word >> word >> address >> word >> lowest >> word >> word >> step >> word;
    bool last = false;
    for (; words >> word; weight *= 2) {
      const int literal = std::atoi(word.c_str());
      last = word == "T" || (literal != 0 && bits.at(std::abs(literal)) == (literal > 0));
      if (last) number += weight;
    }
    if (step != 1) {
      choices[address] = lowest + number * step;
    } else {
      choices[address] = lowest < 0 && last ? number - weight : number;
    }
  }
  return choices;
}

}  // namespace

TEST_CASE("proof: other solvers confirm that a search found all there is, and find the last if it was left") {
  const std::string root = kRoot;
  const std::vector<std::pair<std::vector<std::string>, std::size_t>> searches = {
      {{root + "/examples/queens.sol", "--set", "n=8"}, 92},
      {{root + "/examples/magic_square.sol"}, 8},
      {{root + "/tests/programs/dominoes.sol", "--engine", "z3"}, 36},
      {{root + "/tests/language/recursion_unbounded.sol"}, 0},
  };
  for (const auto& [search, count] : searches) {
    const std::string& script = search.front();
    CAPTURE(script);
    std::vector<std::string> all = search;
    all.push_back("--all");
    const Solved whole = solve(all, ".smt2");
    if (count > 0) CHECK(whole.solutions.size() == count);
    CHECK(cvc5_verdict(whole.formula) == "unsat");
    const std::string clauses = solve(all, ".cnf").formula;
    const SatVerdict verdict = cadical_verdict(clauses);
    CHECK(!verdict.satisfiable);
    CHECK(fault_of_proof(clauses, verdict.proof) == "");

    if (whole.solutions.size() < 2) continue;
    std::vector<std::string> all_but_one = search;
    all_but_one.insert(all_but_one.end(), {"-n", std::to_string(whole.solutions.size() - 1)});
    CHECK(cvc5_verdict(solve(all_but_one, ".smt2").formula) == "sat");
    CHECK(cadical_verdict(solve(all_but_one, ".cnf").formula).satisfiable);
  }
}

TEST_CASE("proof: the comments of a .cnf say how a model is read") {
  const Workplace place;
  const std::string script = place.file("mixed.sol", kMixed);
  const auto choices_of = [](const json& solution) {
    std::map<std::string, std::int64_t> choices;
    for (const json& choice : solution["choices"]) {
      const json& value = choice["value"];
      choices[choice["at"]] = value.is_boolean() ? value.get<bool>() : value.get<std::int64_t>();
    }
    return choices;
  };
  std::vector<std::map<std::string, std::int64_t>> expected;
  for (const json& solution : solve({script, "--all"}, ".cnf").solutions) {
    expected.push_back(choices_of(solution));
    expected.back().erase("z");  // nothing depends on it
  }
  REQUIRE(expected.size() > 3);
  for (std::size_t n = 1; n < expected.size(); ++n) {
    const Solved part = solve({script, "-n", std::to_string(n)}, ".cnf");
    const SatVerdict verdict = cadical_verdict(part.formula);
    REQUIRE(verdict.satisfiable);
    auto next = choices_in(part.formula, verdict.model);
    CHECK(std::find(expected.begin(), expected.end(), next) != expected.end());
    for (json solution : part.solutions) {
      auto known = choices_of(solution);
      known.erase("z");
      CHECK(known != next);
    }
  }
}

TEST_CASE("proof: where a search gives up, the formula says what it left open") {
  const Workplace place;
  const std::string script =
      place.file("rare.sol", "x = range(0, 1000000);\nif x == 5 { return 1; }\nassert(false);\n");
  const std::string file = place / "formula.smt2";
  const Outcome outcome = run_solitaire({"solve", script, "--explore", "random:1", "--formula", file});
  CHECK(outcome.status == 4);
  CHECK(cvc5_verdict(bytes_of(file)) == "unsat");  // nothing on the path that was explored
}

TEST_CASE("proof: a formula is written for endings that are known, and a script's mistake leaves none") {
  const Workplace place;
  const std::string script = place.file("pair.sol", "x = range(0, 3);\nreturn x;\n");
  for (const char* name : {"formula", "formula.txt", "formula.smt"}) {
    const Outcome outcome = run_solitaire({"solve", script, "--formula", place / name});
    CHECK(outcome.status == 2);
    CHECK(outcome.err.find("formula") != std::string::npos);
  }
  CHECK(run_solitaire({"solve", script, "--formula", place / "no_folder/formula.cnf"}).status == 3);
  const std::string file = place / "scene.cnf";
  CHECK(run_solitaire({"generate", script, "-n", "4", "-o", place / "out", "--formula", file}).status == 0);
  CHECK(!cadical_verdict(bytes_of(file)).satisfiable);
  const std::string wrong = place.file("wrong.sol", "x = range(0, 3);\nreturn x + \"a\";\n");
  CHECK(run_solitaire({"solve", wrong, "--formula", place / "wrong.cnf"}).status == 3);
  CHECK(!std::filesystem::exists(place / "wrong.cnf"));
}

TEST_CASE("proof: a proof that leaves out a step is refused, and one of a satisfiable formula") {
  // Two pigeons more than holes would do; these are four and three.
  std::string clauses = "p cnf 12 22\n";
  for (int pigeon = 0; pigeon < 4; ++pigeon) {
    for (int hole = 1; hole <= 3; ++hole) clauses += std::to_string(3 * pigeon + hole) + " ";
    clauses += "0\n";
    for (int other = 0; other < pigeon; ++other) {
      for (int hole = 1; hole <= 3; ++hole)
        clauses += std::to_string(-3 * pigeon - hole) + " " + std::to_string(-3 * other - hole) + " 0\n";
    }
  }
  const std::string proof = cadical_verdict(clauses).proof;
  CHECK(fault_of_proof(clauses, proof) == "");
  CHECK(fault_of_proof(clauses, "0\n") == "this does not follow: 0");
  CHECK(fault_of_proof(clauses, "") != "");
  CHECK(fault_of_proof("p cnf 2 1\n1 2 0\n", "1 0\n-1 0\n0\n") == "this does not follow: 1 0");
  CHECK(fault_of_proof("p cnf 1 2\n1 0\n-1 0\n", "") == "");
  CHECK(fault_of_proof("p cnf 2 4\n1 2 0\n-1 2 0\n1 -2 0\n-1 -2 0\n", "d 1 2 0\n2 0\n0\n") != "");
}

}  // namespace solitaire
