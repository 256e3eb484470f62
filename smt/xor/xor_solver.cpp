#include "smt/xor/xor_solver.h"

#include <cryptominisat5/cryptominisat.h>
#include <cstdlib>
#include <new>
#include <vector>

#include "smt/tuning.h"

namespace solitaire {
namespace {

std::uint32_t index_of(int variable) { return static_cast<std::uint32_t>(variable - 1); }

/// CryptoMiniSat throws exceptions of its own only where it has run out of memory or of variables. The
/// variables here are numbered by ints, of which it has enough.
template <class Action>
void run(Action action) {
  try {
    action();
  } catch (...) {
    throw std::bad_alloc();
  }
}

}  // namespace

class XorSolver::CryptoMiniSat : public CMSat::SATSolver {};

XorSolver::XorSolver(int variables) {
  run([&] {
    solver_ = std::make_unique<CryptoMiniSat>();
    solver_->set_up_for_scalmc();  // CryptoMiniSat's preset for searches with many equations
    solver_->set_allow_otf_gauss();
    solver_->new_vars(static_cast<std::size_t>(variables));
  });
}

XorSolver::~XorSolver() = default;

void XorSolver::clause(std::span<const int> clause) {
  run([&] {
    std::vector<CMSat::Lit> literals;
    for (const int literal : clause) literals.emplace_back(index_of(std::abs(literal)), literal < 0);
    solver_->add_clause(literals);
  });
}

void XorSolver::add_xor(std::span<const int> variables, bool odd) {
  run([&] {
    std::vector<std::uint32_t> indices;
    for (const int variable : variables) indices.push_back(index_of(variable));
    solver_->add_xor_clause(indices, odd);
  });
}

bool XorSolver::satisfiable(const StopSignal& stop) {
  CMSat::lbool verdict = CMSat::l_Undef;
  while (verdict == CMSat::l_Undef) {
    if (stop.stopped()) throw Interrupted{};
    run([&] {
      solver_->set_max_confl(tuning::kConflictsPerLookXor);
      verdict = solver_->solve();
    });
  }
  return verdict == CMSat::l_True;
}

bool XorSolver::holds(int variable) const {
  return solver_->get_model()[index_of(variable)] == CMSat::l_True;
}

}  // namespace solitaire
