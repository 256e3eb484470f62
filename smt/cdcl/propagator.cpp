#include "smt/cdcl/propagator.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "smt/tuning.h"

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

/// Returns the index of a literal in the watches: each variable has two in a row, the second for its
/// negation. They start at 2.
std::size_t literal_index(int literal) {
  return literal > 0 ? 2 * static_cast<std::size_t>(literal) : 2 * static_cast<std::size_t>(-literal) + 1;
}

}  // namespace

void Propagator::reserve(int variable) {
  const std::size_t size = static_cast<std::size_t>(variable) + 1;
  if (assigned_.size() >= size) return;
  if (variable > middle_) {
    const int more = std::max(variable, 2 * middle_) - middle_;
    values_.insert(values_.begin(), static_cast<std::size_t>(more), Truth::kOpen);
    values_.insert(values_.end(), static_cast<std::size_t>(more), Truth::kOpen);
    middle_ += more;
  }
  watches_.resize(2 * size);
  assigned_.resize(size);
}

Propagator::Propagator() {
  new_pairs_.reserve(tuning::kUsualLiterals / 2);
  new_triples_.reserve(tuning::kUsualLiterals / 3);
}

void Propagator::clause(std::span<const int> literals) {
  int largest = largest_;
  for (const int literal : literals) largest = std::max(largest, std::abs(literal));
  largest_ = largest;
  if (!has_tables_ && literals.size() == 2) {
    new_pairs_.push_back({literals[0], literals[1]});
  } else if (!has_tables_ && literals.size() == 3) {
    new_triples_.push_back({literals[0], literals[1], literals[2]});
  } else {
    waiting_.push_back(static_cast<int>(literals.size()));
    waiting_.insert(waiting_.end(), literals.begin(), literals.end());
  }
}

void Propagator::order_implication(const OrderImplication& order_implication) {
  if (has_tables_) return ClauseSink::order_implication(order_implication);
  spared_clauses_ += order_implication.count;
  bounds_.add(order_implication);
}

void Propagator::order_difference(const OrderDifference& difference) {
  if (has_tables_) return ClauseSink::order_difference(difference);
  spared_clauses_ += difference.count;
  bounds_.add(difference);
}

void Propagator::take_clauses() {
  if (waiting_.empty() && new_pairs_.empty() && new_triples_.empty() && !bounds_.has_new()) return;
  if (!has_tables_) {
    make_tables();
    broken_ = !bounds_.visit_all(*this);
  }
  for_each_clause(waiting_, [this](std::span<const int> clause) { take(clause); });
  waiting_.clear();
}

void Propagator::make_tables() {
  has_tables_ = true;
  bounds_.for_each_literal([this](int literal) { largest_ = std::max(largest_, std::abs(literal)); });
  reserve(largest_);
  pairs_ = {variables(), [this](const auto& put) {
              for (const auto& [a, b] : new_pairs_) {
                put(a, b);
                put(b, a);
              }
            }};
  triples_ = {variables(), [this](const auto& put) {
                for (const auto& [a, b, c] : new_triples_) {
                  put(a, {b, c});
                  put(b, {c, a});
                  put(c, {a, b});
                }
              }};
  bounds_.build(variables());
  new_pairs_ = {};
  new_triples_ = {};
}

void Propagator::take(std::span<const int> literals) {
  reserve(largest_);
  if (trail_.empty()) return add(literals);
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
    broken_ = true;
  } else if (literals.size() == 1) {
    assign(literals[0]);
  } else {
    watch(append(literals));
  }
}

std::uint32_t Propagator::append(std::span<const int> literals) {
  const auto start = static_cast<std::uint32_t>(literals_.size());
  literals_.push_back(static_cast<int>(literals.size()));
  literals_.insert(literals_.end(), literals.begin(), literals.end());
  return start;
}

void Propagator::watch(std::uint32_t clause) {
  const std::span<const int> literals = literals_of(clause);
  watch(literals[0], {clause, literals[1]});
  watch(literals[1], {clause, literals[0]});
}

void Propagator::watch(int literal, Watch watch) { watches_[literal_index(literal)].push_back(watch); }

void Propagator::learn(std::span<const int> clause) {
  if (clause.size() == 1) {
    this->clause(clause);  // so that it is known, too, when the decisions that are left are taken back
    return assign(clause[0]);
  }
  const std::uint32_t start = append(clause);
  watch(start);
  learned_.push_back(start);
  assign(clause[0], start);
}

void Propagator::forget_half() {
  const std::vector<int> all = std::exchange(literals_, {});
  const std::vector<std::uint32_t> learned = std::exchange(learned_, {});
  for (std::vector<Watch>& watches : watches_.entries()) watches.clear();
  std::size_t met = 0;
  for (std::size_t at = 0; at < all.size(); at += static_cast<std::size_t>(all[at]) + 1) {
    const bool is_learned = met < learned.size() && learned[met] == at;
    if (is_learned && met++ < learned.size() / 2) continue;
    const std::uint32_t start = append(std::span(&all[at] + 1, static_cast<std::size_t>(all[at])));
    watch(start);
    if (is_learned) learned_.push_back(start);
  }
}

void Propagator::decide(int literal) {
  levels_.push_back({trail_.size(), bounds_.changes()});
  assign(literal);
}

void Propagator::assign(int literal, std::uint32_t clause, int first, int second) {
  assigned_[static_cast<std::size_t>(std::abs(literal))] = {static_cast<std::uint32_t>(levels_.size()),
                                                            static_cast<std::uint32_t>(trail_.size()),
                                                            {clause, first, second}};
  set(literal, Truth::kHolds);
  set(-literal, Truth::kFails);
  trail_.push_back(literal);
}

int Propagator::undo() {
  const Level level = levels_.back();
  const int decision = trail_[level.trail];
  for (std::size_t i = level.trail; i < trail_.size(); ++i) {
    set(trail_[i], Truth::kOpen);
    set(-trail_[i], Truth::kOpen);
  }
  bounds_.undo_to(level.bounds);
  trail_.resize(level.trail);
  kept_ = std::min(kept_, trail_.size());
  levels_.pop_back();
  propagated_ = level.trail;
  return decision;
}

bool Propagator::propagate() {
  if (levels_.empty()) take_clauses();
  if (broken_) return false;
  while (propagated_ < trail_.size()) {
    const int falsified = -trail_[propagated_++];
    if (visit_tables(falsified) && visit_bounds(-falsified) && visit_clauses(falsified)) continue;
    broken_ = levels_.empty();
    return false;
  }
  return true;
}

bool Propagator::visit_tables(int falsified) {
  for (const int literal : pairs_.of(falsified)) {
    if (value(literal) < 0) {
      conflict_ = {falsified, literal};
      return false;
    }
    if (is_open(literal)) assign(literal, kNoClause, falsified);
  }
  for (const auto& [a, b] : triples_.of(falsified)) {
    if (!apply(falsified, a, b)) return false;
  }
  return true;
}

/// Assigns what follows from a sum. Returns false if that is false already.
bool Propagator::assign_by_sum(int literal, std::uint32_t sum, std::uint32_t term) {
  if (value(literal) > 0) return true;
  if (is_open(literal)) {
    assign(literal, kSum, static_cast<int>(sum), static_cast<int>(term));
    return true;
  }
  conflict_.assign(1, literal);
  const auto holds = [this](int other) { return value(other) > 0; };
  bounds_.explain_by_sum(sum, term, holds, [this](int other) { conflict_.push_back(other); });
  return false;
}

/// Assigns the only literal of a clause that is not false, if there is only one. Returns false if there is
/// none.
bool Propagator::apply(int a, int b, int c) {
  const int value_of_a = value(a), value_of_b = value(b), value_of_c = value(c);
  if (value_of_a > 0 || value_of_b > 0 || value_of_c > 0) return true;
  const int failing = -(value_of_a + value_of_b + value_of_c);
  if (failing < 2) return true;
  if (failing == 3) {
    conflict_ = {a, b, c};
    return false;
  }
  if (value_of_a == 0) {
    assign(a, kNoClause, b, c);
  } else if (value_of_b == 0) {
    assign(b, kNoClause, a, c);
  } else {
    assign(c, kNoClause, a, b);
  }
  return true;
}

/// Goes through the clauses that watch a literal which became false. Each of them finds another literal to
/// watch, or has its last literal assigned. Returns false if one of them is broken.
bool Propagator::visit_clauses(int falsified) {
  std::vector<Watch>* const watches = watches_.find(literal_index(falsified));
  if (watches == nullptr) return true;
  std::size_t kept = 0;
  bool holds = true;
  for (std::size_t i = 0; i < watches->size(); ++i) {
    Watch watch = (*watches)[i];
    bool moved = false;
    if (holds && value(watch.blocker) <= 0) holds = visit(watch, falsified, &moved);
    if (!moved) (*watches)[kept++] = watch;
  }
  watches->resize(kept);
  return holds;
}

bool Propagator::visit(Watch& watch, int falsified, bool* moved) {
  int* const clause = &literals_[watch.clause + 1];
  const int size = literals_[watch.clause];
  if (clause[0] == falsified) std::swap(clause[0], clause[1]);
  watch.blocker = clause[0];
  if (value(clause[0]) > 0) return true;
  for (int i = 2; i < size; ++i) {
    if (value(clause[i]) < 0) continue;
    std::swap(clause[1], clause[i]);
    this->watch(clause[1], watch);
    *moved = true;
    return true;
  }
  if (value(clause[0]) < 0) {
    conflict_.assign(clause, clause + size);
    return false;
  }
  assign(clause[0], watch.clause);
  return true;
}

}  // namespace solitaire
