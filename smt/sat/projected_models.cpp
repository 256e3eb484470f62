#include "smt/sat/projected_models.h"

#include <algorithm>
#include <cadical.hpp>
#include <cstdlib>
#include <new>

#include "base/installation.h"
#include "smt/xor/xor_solver.h"
#include "smt/z3/shared_library.h"

namespace solitaire {
namespace {

/// What a search for several models needs of a SAT solver.
class ModelSolver {
 public:
  virtual ~ModelSolver() = default;
  virtual void add(std::span<const int> clause) = 0;
  /// Whether the clauses have a model. Throws Interrupted.
  virtual bool satisfiable(const StopSignal& stop) = 0;
  virtual bool holds(int variable) = 0;
};

class Cadical : public ModelSolver {
 public:
  Cadical() {
    solver_.set("quiet", 1);
    solver_.set("lucky", 0);  // would be tried for each model anew
    solver_.set("stabilizeonly", 1);
  }

  void add(std::span<const int> clause) override {
    for (const int literal : clause) solver_.add(literal);
    solver_.add(0);
  }

  bool satisfiable(const StopSignal& stop) override {
    constexpr int kSatisfied = 10;
    while (true) {
      if (stop.stopped()) throw Interrupted{};
      solver_.limit("conflicts", kConflictsPerLook);
      const int verdict = solver_.solve();
      if (verdict != 0) return verdict == kSatisfied;
    }
  }

  bool holds(int variable) override { return solver_.val(variable) > 0; }

 private:
  static constexpr int kConflictsPerLook = 2000;
  CaDiCaL::Solver solver_;
};

/// As std::bad_alloc, if there is too little memory.
void require_memory(bool enough) {
  if (!enough) throw std::bad_alloc();
}

class CryptoMiniSat : public ModelSolver {
 public:
  explicit CryptoMiniSat(int variables) : solver_(make(variables)) { require_memory(solver_ != nullptr); }

  void add(std::span<const int> clause) override {
    require_memory(solver_->add_clause(clause.data(), clause.size()));
  }

  void add_xor(const std::vector<int>& variables, bool odd) {
    require_memory(solver_->add_xor(variables.data(), variables.size(), odd));
  }

  bool satisfiable(const StopSignal& stop) override {
    using enum XorSolver::Verdict;
    while (true) {
      if (stop.stopped()) throw Interrupted{};
      const XorSolver::Verdict verdict = solver_->solve(kConflictsPerLook);
      require_memory(verdict != kOutOfMemory);
      if (verdict != kUndecided) return verdict == kSatisfiable;
    }
  }

  bool holds(int variable) override { return solver_->holds(variable); }

 private:
  static constexpr std::uint64_t kConflictsPerLook = 2000;

  static XorSolver* make(int variables) {
    static const SharedLibrary module(find_module("solitaire_xor.so"));
    static const auto make_solver = reinterpret_cast<MakeXorSolver>(module.symbol("make_xor_solver"));
    return make_solver(variables);
  }

  std::unique_ptr<XorSolver> solver_;
};

/// Brings the parities into reduced echelon form: they say the same with about half as many members less.
std::vector<XorConstraint> reduced(std::span<const XorConstraint> parities) {
  std::vector<XorConstraint> rows(parities.begin(), parities.end());
  const auto add_to = [](const XorConstraint& row, XorConstraint& sum) {
    for (std::size_t i = 0; i < row.chosen.size(); ++i) sum.chosen[i] = sum.chosen[i] != row.chosen[i];
    sum.odd = sum.odd != row.odd;
  };
  std::size_t rank = 0;
  for (std::size_t column = 0; column < rows.front().chosen.size() && rank < rows.size(); ++column) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [&](const XorConstraint& row) { return row.chosen[column]; });
    if (pivot == rows.end()) continue;
    std::swap(rows[rank], *pivot);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i != rank && rows[i].chosen[column]) add_to(rows[rank], rows[i]);
    }
    ++rank;
  }
  return rows;
}

}  // namespace

void ProjectedModels::clause(std::span<const int> literals) {
  for (const int literal : literals) variables_ = std::max(variables_, std::abs(literal));
  literals_.insert(literals_.end(), literals.begin(), literals.end());
  ends_.push_back(literals_.size());
}

void ProjectedModels::project_on(std::vector<int> literals) {
  projection_ = std::move(literals);
  for (const int literal : projection_) variables_ = std::max(variables_, std::abs(literal));
}

std::vector<BitModel> ProjectedModels::find(std::span<const XorConstraint> parities, std::size_t most,
                                            const StopSignal& stop, std::atomic<std::uint64_t>* found) const {
  std::unique_ptr<ModelSolver> solver;
  if (parities.empty()) {
    solver = std::make_unique<Cadical>();
  } else {
    auto with_parities = std::make_unique<CryptoMiniSat>(variables_);
    std::vector<int> members;
    for (const XorConstraint& parity : reduced(parities)) {
      members.clear();
      bool odd = parity.odd;
      for (std::size_t i = 0; i < projection_.size(); ++i) {
        if (!parity.chosen[i]) continue;
        members.push_back(std::abs(projection_[i]));
        odd = odd != (projection_[i] < 0);
      }
      with_parities->add_xor(members, odd);
    }
    solver = std::move(with_parities);
  }
  std::size_t begin = 0;
  for (const std::size_t end : ends_) {
    solver->add(std::span(literals_).subspan(begin, end - begin));
    begin = end;
  }
  std::vector<BitModel> models;
  std::vector<int> other;  // than the model found last
  while (models.size() < most && solver->satisfiable(stop)) {
    BitModel& model = models.emplace_back();
    other.clear();
    for (const int literal : projection_) {
      model.push_back(solver->holds(std::abs(literal)) == (literal > 0));
      other.push_back(model.back() ? -literal : literal);
    }
    if (found != nullptr) *found = models.size();
    solver->add(other);
  }
  return models;
}

}  // namespace solitaire
