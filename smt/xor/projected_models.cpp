#include "smt/xor/projected_models.h"

#include <algorithm>
#include <cstdlib>

#include "smt/sat/cadical.h"
#include "smt/xor/xor_solver.h"

namespace solitaire {
namespace {

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
  if (parities.empty()) {
    Cadical solver;
    for_each_clause([&](std::span<const int> clause) { solver.clause(clause); });
    const auto satisfiable = [&] {
      const Verdict verdict = solver.solve({}, stop);
      if (verdict == Verdict::kStopped) throw Interrupted{};
      return verdict == Verdict::kSatisfiable;
    };
    return list(solver, satisfiable, most, found);
  }
  XorSolver solver(variables_);
  for (const XorConstraint& parity : reduced(parities)) add(parity, solver);
  for_each_clause([&](std::span<const int> clause) { solver.clause(clause); });
  return list(
      solver, [&] { return solver.satisfiable(stop); }, most, found);
}

/// A negative literal holds where its variable does not, so each negative literal changes odd to even and
/// back.
void ProjectedModels::add(const XorConstraint& parity, XorSolver& solver) const {
  std::vector<int> variables;
  bool odd = parity.odd;
  for (std::size_t i = 0; i < projection_.size(); ++i) {
    if (!parity.chosen[i]) continue;
    variables.push_back(std::abs(projection_[i]));
    odd = odd != (projection_[i] < 0);
  }
  solver.add_xor(variables, odd);
}

template <class Visit>
void ProjectedModels::for_each_clause(Visit visit) const {
  std::size_t begin = 0;
  for (const std::size_t end : ends_) {
    visit(std::span(literals_).subspan(begin, end - begin));
    begin = end;
  }
}

/// Asks for one model after the other, each with a clause against all that were found before.
template <class ModelSolver, class Satisfiable>
std::vector<BitModel> ProjectedModels::list(ModelSolver& solver, Satisfiable satisfiable, std::size_t most,
                                            std::atomic<std::uint64_t>* found) const {
  std::vector<BitModel> models;
  std::vector<int> other;  // a clause that the model found last does not fulfil
  while (models.size() < most && satisfiable()) {
    BitModel& model = models.emplace_back();
    other.clear();
    for (const int literal : projection_) {
      model.push_back(solver.holds(std::abs(literal)) == (literal > 0));
      other.push_back(model.back() ? -literal : literal);
    }
    if (found != nullptr) *found = models.size();
    solver.clause(other);
  }
  return models;
}

}  // namespace solitaire
