#include "smt/cdcl/propagator.h"

#include <algorithm>
#include <cstdlib>

namespace solitaire {
namespace {

/// Calls `visit` with each clause of a list in which they stand one after the other, each behind its length.
template <class Visit>
void for_each_clause(const std::vector<int>& clauses, Visit visit) {
  for (std::size_t at = 0; at < clauses.size();) {
    const auto size = static_cast<std::size_t>(clauses[at]);
    visit(std::span(&clauses[at] + 1, size));
    at += size + 1;
  }
}

}  // namespace

void Propagator::reserve(int variable) {
  trail_.reserve(variable);
  watched_.reserve(trail_.variables());
}

void Propagator::clause(std::span<const int> literals) {
  int largest = largest_;
  for (const int literal : literals) largest = std::max(largest, std::abs(literal));
  largest_ = largest;
  if (!is_built_ && literals.size() == 2) {
    short_.add(literals[0], literals[1]);
  } else if (!is_built_ && literals.size() == 3) {
    short_.add(literals[0], literals[1], literals[2]);
  } else {
    waiting_.push_back(static_cast<int>(literals.size()));
    waiting_.insert(waiting_.end(), literals.begin(), literals.end());
  }
}

void Propagator::order_implication(const OrderImplication& order_implication) {
  if (is_built_) return ClauseSink::order_implication(order_implication);
  spared_clauses_ += order_implication.count;
  bounds_.add(order_implication);
}

void Propagator::order_difference(const OrderDifference& difference) {
  if (is_built_) return ClauseSink::order_difference(difference);
  spared_clauses_ += difference.count;
  bounds_.add(difference);
}

void Propagator::take_clauses() {
  if (waiting_.empty() && !short_.has_new() && !bounds_.has_new()) return;
  if (!is_built_) {
    build();
    is_broken_ = !bounds_.visit_all(trail_);
  }
  for_each_clause(waiting_, [this](std::span<const int> clause) { take(clause); });
  waiting_.clear();
}

void Propagator::build() {
  is_built_ = true;
  bounds_.for_each_literal([this](int literal) { largest_ = std::max(largest_, std::abs(literal)); });
  reserve(largest_);
  short_.build(variables());
  bounds_.build(variables());
}

void Propagator::take(std::span<const int> literals) {
  reserve(largest_);
  if (trail_.literals().empty()) return add(literals);
  std::vector<int> open;
  for (const int literal : literals) {
    if (value(literal) > 0) return;
    if (is_open(literal)) open.push_back(literal);
  }
  add(open);
}

/// Adds a clause whose literals are all open.
void Propagator::add(std::span<const int> literals) {
  if (literals.empty()) {
    is_broken_ = true;
  } else if (literals.size() == 1) {
    trail_.assign(literals[0]);
  } else {
    watched_.add(literals);
  }
}

void Propagator::learn(std::span<const int> clause) {
  if (clause.size() == 1) {
    this->clause(clause);  // so that it is known, too, when the decisions that are left are taken back
    return trail_.assign(clause[0]);
  }
  trail_.assign(clause[0], {watched_.learn(clause), 0, 0});
}

void Propagator::decide(int literal) {
  bounds_.begin_level();
  trail_.decide(literal);
}

int Propagator::undo() {
  bounds_.undo_level();
  return trail_.undo();
}

bool Propagator::propagate() {
  if (decisions() == 0) take_clauses();
  if (is_broken_) return false;
  while (const int assigned = trail_.take_new()) {
    if (short_.visit(-assigned, trail_) && bounds_.visit(assigned, trail_) &&
        watched_.visit(-assigned, trail_))
      continue;
    is_broken_ = decisions() == 0;
    return false;
  }
  return true;
}

}  // namespace solitaire
