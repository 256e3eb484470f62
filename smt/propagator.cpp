#include "smt/propagator.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace solitaire {
namespace {

/// Calls with each of the clauses that stand one after the other, each behind its length.
template <class Visit>
void for_each_clause(const std::vector<int>& clauses, Visit visit) {
  for (std::size_t at = 0; at < clauses.size();) {
    const auto size = static_cast<std::size_t>(clauses[at]);
    visit(std::span(&clauses[at] + 1, size));
    at += size + 1;
  }
}

/// From how many entries each has to where they start.
std::vector<std::uint32_t> starts_of(std::vector<std::uint32_t> counts) {
  std::uint32_t sum = 0;
  for (std::uint32_t& count : counts) count = std::exchange(sum, sum + count);
  counts.push_back(sum);
  return counts;
}

}  // namespace

void Propagator::reserve(int variable) {
  const std::size_t size = 2 * (static_cast<std::size_t>(variable) + 1);
  if (values_.size() >= size) return;
  values_.resize(size);
  watches_.resize(size);
  assigned_.resize(size / 2);
}

void Propagator::clause(std::span<const int> literals) {
  waiting_.push_back(static_cast<int>(literals.size()));
  waiting_.insert(waiting_.end(), literals.begin(), literals.end());
}

void Propagator::take_clauses() {
  if (waiting_.empty()) return;
  if (!has_tables_) make_tables();
  for_each_clause(waiting_, [this](std::span<const int> clause) { take(clause); });
  waiting_.clear();
}

/// Of the clauses that wait, leaving behind those that they have no place for.
void Propagator::make_tables() {
  has_tables_ = true;
  int most = 0;
  for_each_clause(waiting_, [&](std::span<const int> clause) {
    for (const int literal : clause) most = std::max(most, std::abs(literal));
  });
  reserve(most);
  std::vector<std::uint32_t> in_pairs(values_.size()), in_triples(values_.size());
  for_each_clause(waiting_, [&](std::span<const int> clause) {
    if (clause.size() != 2 && clause.size() != 3) return;
    for (const int literal : clause) ++(clause.size() == 2 ? in_pairs : in_triples)[index(literal)];
  });
  pairs_.starts = starts_of(std::move(in_pairs));
  triples_.starts = starts_of(std::move(in_triples));
  pairs_.entries.resize(pairs_.starts.back());
  triples_.entries.resize(triples_.starts.back());
  std::vector<std::uint32_t> next_pair = pairs_.starts, next_triple = triples_.starts;
  std::vector<int> others;
  for_each_clause(waiting_, [&](std::span<const int> clause) {
    if (clause.size() == 2) {
      for (std::size_t i = 0; i < 2; ++i) pairs_.entries[next_pair[index(clause[i])]++] = clause[1 - i];
    } else if (clause.size() == 3) {
      for (std::size_t i = 0; i < 3; ++i)
        triples_.entries[next_triple[index(clause[i])]++] = {clause[(i + 1) % 3], clause[(i + 2) % 3]};
    } else {
      others.push_back(static_cast<int>(clause.size()));
      others.insert(others.end(), clause.begin(), clause.end());
    }
  });
  waiting_ = std::move(others);
}

void Propagator::take(std::span<const int> literals) {
  for (const int literal : literals) reserve(std::abs(literal));
  if (trail_.empty()) return add(literals);
  std::vector<int> open;
  for (const int literal : literals) {
    if (value(literal) > 0) return;
    if (is_open(literal)) open.push_back(literal);
  }
  add(open);
}

/// Of open literals.
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
  watches_[index(literals[0])].push_back({clause, literals[1]});
  watches_[index(literals[1])].push_back({clause, literals[0]});
}

void Propagator::learn(std::span<const int> clause) {
  if (clause.size() == 1) {
    this->clause(clause);  // for the time when the decisions that are left are taken back
    return assign(clause[0]);
  }
  const std::uint32_t start = append(clause);
  watch(start);
  learned_.push_back(start);
  assign(clause[0], {start});
}

void Propagator::forget_half() {
  const std::vector<int> all = std::exchange(literals_, {});
  const std::vector<std::uint32_t> learned = std::exchange(learned_, {});
  for (std::vector<Watch>& watches : watches_) watches.clear();
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
  levels_.push_back(trail_.size());
  assign(literal);
}

void Propagator::assign(int literal, Reason reason) {
  assigned_[static_cast<std::size_t>(std::abs(literal))] = {static_cast<std::uint32_t>(levels_.size()),
                                                            reason};
  values_[index(literal)] = 1;
  values_[index(-literal)] = -1;
  trail_.push_back(literal);
}

int Propagator::undo() {
  const std::size_t start = levels_.back();
  const int decision = trail_[start];
  for (std::size_t i = start; i < trail_.size(); ++i) {
    values_[index(trail_[i])] = 0;
    values_[index(-trail_[i])] = 0;
  }
  trail_.resize(start);
  levels_.pop_back();
  propagated_ = start;
  return decision;
}

bool Propagator::propagate() {
  if (levels_.empty()) take_clauses();
  if (broken_) return false;
  while (propagated_ < trail_.size()) {
    const int falsified = -trail_[propagated_++];
    if (visit_tables(falsified) && visit_clauses(falsified)) continue;
    broken_ = levels_.empty();
    return false;
  }
  return true;
}

bool Propagator::visit_tables(int falsified) {
  for (const int literal : pairs_.of(index(falsified))) {
    if (value(literal) < 0) {
      conflict_ = {falsified, literal};
      return false;
    }
    if (is_open(literal)) assign(literal, {kNoClause, falsified});
  }
  for (const auto& [a, b] : triples_.of(index(falsified))) {
    const int value_of_a = value(a), value_of_b = value(b);
    if (value_of_a > 0 || value_of_b > 0 || (value_of_a == 0 && value_of_b == 0)) continue;
    if (value_of_a == value_of_b) {
      conflict_ = {falsified, a, b};
      return false;
    }
    assign(value_of_a == 0 ? a : b, {kNoClause, falsified, value_of_a == 0 ? b : a});
  }
  return true;
}

/// Clauses that watch the literal find another one to watch, or what is left of them follows.
bool Propagator::visit_clauses(int falsified) {
  std::vector<Watch>& watches = watches_[index(falsified)];
  std::size_t kept = 0;
  bool holds = true;
  for (std::size_t i = 0; i < watches.size(); ++i) {
    Watch watch = watches[i];
    bool moved = false;
    if (holds && value(watch.blocker) <= 0) holds = visit(watch, falsified, &moved);
    if (!moved) watches[kept++] = watch;
  }
  watches.resize(kept);
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
    watches_[index(clause[1])].push_back(watch);
    *moved = true;
    return true;
  }
  if (value(clause[0]) < 0) {
    conflict_.assign(clause, clause + size);
    return false;
  }
  assign(clause[0], {watch.clause});
  return true;
}

}  // namespace solitaire
