#include "tests/solve/proof.h"

#include <doctest/doctest.h>

#include "smt/write_dimacs.h"
#include "smt/write_smtlib.h"
#include "tests/solve/proof_check.h"
#include "tests/support/command.h"

namespace solitaire {

std::string cvc5_verdict(const std::string& smt2) {
  const Workplace place;
  const Outcome outcome = run({"cvc5", place.file("formula.smt2", smt2)});
  return outcome.out.substr(0, outcome.out.find('\n')) + outcome.err;
}

SatVerdict cadical_verdict(const std::string& dimacs) {
  const Workplace place;
  const std::string proof = place / "proof.drat";
  const Outcome outcome = run({"cadical", "-q", "--no-binary", place.file("formula.cnf", dimacs), proof});
  if (outcome.status == 10) return {true, "", outcome.out};
  if (outcome.status == 20) return {false, bytes_of(proof), ""};
  throw std::runtime_error("cadical failed: " + outcome.err);
}

void check_that_nothing_is_left(TracingEngine& engine) {
  const Formula formula = engine.formula_of_rest();
  CHECK(cvc5_verdict(to_smt2(formula.graph, formula.addresses, formula.conditions)) == "unsat");
  const std::string clauses = to_dimacs(formula.graph, formula.addresses, formula.conditions);
  const SatVerdict verdict = cadical_verdict(clauses);
  CHECK(!verdict.satisfiable);
  CHECK(fault_of_proof(clauses, verdict.proof) == "");
}

}  // namespace solitaire
