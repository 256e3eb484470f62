#include "smt/cdcl/watched_clauses.h"

#include <utility>

namespace solitaire {
namespace {

/// Returns the index of a literal in the watches: each variable has two in a row, the second for its
/// negation. They start at 2.
std::size_t literal_index(int literal) {
  return literal > 0 ? 2 * static_cast<std::size_t>(literal) : 2 * static_cast<std::size_t>(-literal) + 1;
}

}  // namespace

std::uint32_t WatchedClauses::add(std::span<const int> clause) {
  const auto start = static_cast<std::uint32_t>(literals_.size());
  literals_.push_back(static_cast<int>(clause.size()));
  literals_.insert(literals_.end(), clause.begin(), clause.end());
  watch(clause[0], {start, clause[1]});
  watch(clause[1], {start, clause[0]});
  return start;
}

std::uint32_t WatchedClauses::learn(std::span<const int> clause) {
  return learned_.emplace_back(add(clause));
}

void WatchedClauses::forget_half() {
  const std::vector<int> all = std::exchange(literals_, {});
  const std::vector<std::uint32_t> learned = std::exchange(learned_, {});
  for (std::vector<Watch>& watches : watches_.entries()) watches.clear();
  std::size_t met = 0;
  for (std::size_t at = 0; at < all.size(); at += static_cast<std::size_t>(all[at]) + 1) {
    const std::span<const int> clause(&all[at] + 1, static_cast<std::size_t>(all[at]));
    const bool is_learned = met < learned.size() && learned[met] == at;
    if (!is_learned) {
      add(clause);
    } else if (met++ >= learned.size() / 2) {
      learn(clause);
    }
  }
}

void WatchedClauses::watch(int literal, Watch watch) { watches_[literal_index(literal)].push_back(watch); }

bool WatchedClauses::visit(int falsified, Trail& trail) {
  std::vector<Watch>* const watches = watches_.find(literal_index(falsified));
  if (watches == nullptr) return true;
  std::size_t kept = 0;
  bool holds = true;
  for (std::size_t i = 0; i < watches->size(); ++i) {
    Watch watch = (*watches)[i];
    bool moved = false;
    if (holds && trail.value(watch.blocker) <= 0) holds = visit(watch, falsified, trail, &moved);
    if (!moved) (*watches)[kept++] = watch;
  }
  watches->resize(kept);
  return holds;
}

bool WatchedClauses::visit(Watch& watch, int falsified, Trail& trail, bool* moved) {
  int* const clause = &literals_[watch.clause + 1];
  const int size = literals_[watch.clause];
  if (clause[0] == falsified) std::swap(clause[0], clause[1]);
  watch.blocker = clause[0];
  if (trail.value(clause[0]) > 0) return true;
  for (int i = 2; i < size; ++i) {
    if (trail.value(clause[i]) < 0) continue;
    std::swap(clause[1], clause[i]);
    this->watch(clause[1], watch);
    *moved = true;
    return true;
  }
  if (trail.value(clause[0]) < 0) {
    trail.break_clause({clause, static_cast<std::size_t>(size)});
    return false;
  }
  trail.assign(clause[0], {watch.clause, 0, 0});
  return true;
}

}  // namespace solitaire
