#pragma once
#include "engines/solve/tracing.h"

namespace solitaire {

/// Checks that other solvers, too, find nothing in what an engine has left after its last solution: cvc5 by
/// the formula as SMT-LIB, CaDiCaL by its clauses, with a proof that is checked. None of them knows what the
/// engine did.
void check_that_nothing_is_left(TracingEngine& engine);

/// What cvc5 says about a script: "sat" or "unsat".
std::string cvc5_verdict(const std::string& smt2);

struct SatVerdict {
  bool satisfiable = false;
  std::string proof;  // in the DRAT format, if it is not
  std::string model;  // the lines of values, if it is
};
/// What the program of CaDiCaL says about clauses. Throws where it says neither.
SatVerdict cadical_verdict(const std::string& dimacs);

}  // namespace solitaire
