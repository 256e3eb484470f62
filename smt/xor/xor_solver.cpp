#include "smt/xor/xor_solver.h"

#include <cryptominisat5/cryptominisat.h>
#include <cstdlib>
#include <vector>

namespace solitaire {
namespace {

/// What CryptoMiniSat throws is a lack of memory or of numbers for variables, which is no other matter.
template <class Action>
bool succeeds(Action action) noexcept {
  try {
    action();
    return true;
  } catch (...) {
    return false;
  }
}

class CryptoMiniSat : public XorSolver {
 public:
  explicit CryptoMiniSat(int variables) {
    solver_.set_up_for_scalmc();  // for searches with many parities
    solver_.set_allow_otf_gauss();
    solver_.new_vars(static_cast<std::size_t>(variables));
  }

  bool add_clause(const int* literals, std::size_t size) noexcept override {
    return succeeds([&] {
      clause_.clear();
      for (std::size_t i = 0; i < size; ++i)
        clause_.emplace_back(number(std::abs(literals[i])), literals[i] < 0);
      solver_.add_clause(clause_);
    });
  }

  bool add_xor(const int* variables, std::size_t size, bool odd) noexcept override {
    return succeeds([&] {
      std::vector<std::uint32_t> numbers;
      for (std::size_t i = 0; i < size; ++i) numbers.push_back(number(variables[i]));
      solver_.add_xor_clause(numbers, odd);
    });
  }

  Verdict solve(std::uint64_t conflicts) noexcept override {
    CMSat::lbool verdict = CMSat::l_Undef;
    const bool done = succeeds([&] {
      solver_.set_max_confl(conflicts);
      verdict = solver_.solve();
    });
    if (!done) return Verdict::kOutOfMemory;
    if (verdict == CMSat::l_Undef) return Verdict::kUndecided;
    return verdict == CMSat::l_True ? Verdict::kSatisfiable : Verdict::kUnsatisfiable;
  }

  bool holds(int variable) const noexcept override {
    return solver_.get_model()[number(variable)] == CMSat::l_True;
  }

 private:
  static std::uint32_t number(int variable) { return static_cast<std::uint32_t>(variable - 1); }

  CMSat::SATSolver solver_;
  std::vector<CMSat::Lit> clause_;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) XorSolver* make_xor_solver(int variables) noexcept {
  XorSolver* solver = nullptr;
  succeeds([&] { solver = new CryptoMiniSat(variables); });
  return solver;
}

}  // namespace solitaire
