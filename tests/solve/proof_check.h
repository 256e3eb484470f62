#pragma once
#include <string>

namespace solitaire {

/// Whether a proof shows that a formula in the DIMACS format is unsatisfiable. The proof is a text in the
/// DRAT format, of clauses that follow from those before by unit propagation alone (RUP), as CaDiCaL's do;
/// each is checked where it stands. Empty, else what is wrong with it.
std::string fault_of_proof(const std::string& formula, const std::string& proof);

}  // namespace solitaire
