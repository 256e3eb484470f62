#include "smt/propagator.h"

#include <cstdlib>

namespace solitaire {

void Propagator::reserve(int variable) {
  const std::size_t size = 2 * (static_cast<std::size_t>(variable) + 1);
  if (values_.size() >= size) return;
  values_.resize(size);
  implied_.resize(size);
  watches_.resize(size);
}

void Propagator::clause(std::span<const int> literals) {
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
  } else if (literals.size() == 2) {
    implied_[index(literals[0])].push_back(literals[1]);
    implied_[index(literals[1])].push_back(literals[0]);
  } else {
    const auto start = static_cast<std::uint32_t>(literals_.size());
    literals_.push_back(static_cast<int>(literals.size()));
    literals_.insert(literals_.end(), literals.begin(), literals.end());
    watches_[index(literals[0])].push_back({start, literals[1]});
    watches_[index(literals[1])].push_back({start, literals[0]});
  }
}

void Propagator::decide(int literal) {
  levels_.push_back(trail_.size());
  assign(literal);
}

void Propagator::assign(int literal) {
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
  if (broken_) return false;
  while (propagated_ < trail_.size()) {
    const int falsified = -trail_[propagated_++];
    for (const int literal : implied_[index(falsified)]) {
      if (value(literal) < 0) return false;
      if (is_open(literal)) assign(literal);
    }
    if (!visit_clauses(falsified)) return false;
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
  if (value(clause[0]) < 0) return false;
  assign(clause[0]);
  return true;
}

}  // namespace solitaire
