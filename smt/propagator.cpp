#include "smt/propagator.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <unordered_map>
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

void Propagator::ladder(const Ladder& ladder) {
  if (has_tables_) return ClauseSink::ladder(ladder);
  ladders_.push_back(ladder);
}

void Propagator::take_clauses() {
  if (waiting_.empty() && ladders_.empty()) return;
  if (!has_tables_) make_tables();
  for_each_clause(waiting_, [this](std::span<const int> clause) { take(clause); });
  waiting_.clear();
}

/// Of the clauses that wait, leaving behind those that they have no place for.
void Propagator::make_tables() {
  has_tables_ = true;
  reserve(largest_waiting());
  const auto of_size = [this](std::size_t size, const auto& visit) {
    for_each_clause(waiting_, [&](std::span<const int> clause) {
      if (clause.size() == size) visit(clause);
    });
  };
  pairs_ = table<int>([&](const auto& put) {
    of_size(2, [&](std::span<const int> clause) {
      for (std::size_t i = 0; i < 2; ++i) put(clause[i], clause[1 - i]);
    });
  });
  triples_ = table<Two>([&](const auto& put) {
    of_size(3, [&](std::span<const int> clause) {
      for (std::size_t i = 0; i < 3; ++i) put(clause[i], {clause[(i + 1) % 3], clause[(i + 2) % 3]});
    });
  });
  make_ladder_tables();
  std::vector<int> others;
  for_each_clause(waiting_, [&](std::span<const int> clause) {
    if (clause.size() == 2 || clause.size() == 3) return;
    others.push_back(static_cast<int>(clause.size()));
    others.insert(others.end(), clause.begin(), clause.end());
  });
  waiting_ = std::move(others);
}

int Propagator::largest_waiting() const {
  int most = 0;
  const auto look = [&](std::span<const int> literals) {
    for (const int literal : literals) most = std::max(most, std::abs(literal));
  };
  for_each_clause(waiting_, look);
  for (const Ladder& ladder : ladders_) {
    look({&ladder.guard, 1});
    look(*ladder.lower);
    look(*ladder.upper);
  }
  return most;
}

void Propagator::make_ladder_tables() {
  std::unordered_map<const std::vector<int>*, std::uint32_t> numbers;
  const auto chain = [&](const std::vector<int>* literals) {
    const auto [at, is_new] = numbers.try_emplace(literals, static_cast<std::uint32_t>(chains_.size()));
    const auto size = static_cast<std::uint32_t>(literals->size());
    if (is_new) chains_.push_back({*literals, {}, {}, 0, size});
    return at->second;
  };
  std::vector<Step> steps;
  for (const Ladder& ladder : ladders_) {
    const auto& [guard, lower, upper, first, base, count] = ladder;
    steps.push_back({guard, chain(lower), chain(upper), first, base, count});
    chains_[steps.back().lower].as_lower.push_back(steps.back());
    chains_[steps.back().upper].as_upper.push_back(steps.back());
  }
  ladders_ = {};
  guarded_ = table<Step>([&](const auto& put) {
    for (const Step& step : steps) put(step.guard, step);
  });
  const auto places = [&](const auto& visit) {
    for (std::uint32_t i = 0; i < chains_.size(); ++i) {
      const std::span<const int> literals = chains_[i].literals;
      for (std::uint32_t at = 0; at < literals.size(); ++at) visit(literals[at], Place{i, at});
    }
  };
  lower_places_ =
      table<Place>([&](const auto& put) { places([&](int literal, Place place) { put(literal, place); }); });
  upper_places_ =
      table<Place>([&](const auto& put) { places([&](int literal, Place place) { put(-literal, place); }); });
}

/// `each` calls with every literal and an entry of it; it is called twice.
template <class Entry, class Each>
Propagator::Table<Entry> Propagator::table(Each each) const {
  Table<Entry> made;
  made.starts.resize(values_.size() + 1);
  each([&](int literal, const Entry&) { ++made.starts[index(literal) + 1]; });
  std::partial_sum(made.starts.begin(), made.starts.end(), made.starts.begin());
  made.entries.resize(made.starts.back());
  std::vector<std::uint32_t> next = made.starts;
  each([&](int literal, const Entry& entry) { made.entries[next[index(literal)]++] = entry; });
  return made;
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
  levels_.push_back({trail_.size(), bounds_.size()});
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
  const Level level = levels_.back();
  const int decision = trail_[level.trail];
  for (std::size_t i = level.trail; i < trail_.size(); ++i) {
    values_[index(trail_[i])] = 0;
    values_[index(-trail_[i])] = 0;
  }
  for (; bounds_.size() > level.bounds; bounds_.pop_back()) {
    Chain& chain = chains_[bounds_.back().chain];
    chain.reached = bounds_.back().reached;
    chain.limit = bounds_.back().limit;
  }
  trail_.resize(level.trail);
  levels_.pop_back();
  propagated_ = level.trail;
  return decision;
}

bool Propagator::propagate() {
  if (levels_.empty()) take_clauses();
  if (broken_) return false;
  while (propagated_ < trail_.size()) {
    const int falsified = -trail_[propagated_++];
    if (visit_tables(falsified) && visit_ladders(-falsified) && visit_clauses(falsified)) continue;
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

bool Propagator::visit_ladders(int assigned) {
  const std::size_t at = index(assigned);
  for (const Place place : lower_places_.of(at)) {
    if (!raise(place)) return false;
  }
  for (const Place place : upper_places_.of(at)) {
    if (!limit(place)) return false;
  }
  for (const Step& ladder : guarded_.of(at)) {
    if (!apply_reached(ladder) || !apply_limit(ladder)) return false;
  }
  return true;
}

/// A literal holds.
bool Propagator::raise(Place place) {
  Chain& chain = chains_[place.chain];
  if (place.position < chain.reached) return true;
  bounds_.push_back({place.chain, chain.reached, chain.limit});
  chain.reached = place.position + 1;
  return std::ranges::all_of(chain.as_lower, [this](const Step& ladder) { return apply_reached(ladder); });
}

/// A literal does not hold.
bool Propagator::limit(Place place) {
  Chain& chain = chains_[place.chain];
  if (place.position >= chain.limit) return true;
  bounds_.push_back({place.chain, chain.reached, chain.limit});
  chain.limit = place.position;
  return std::ranges::all_of(chain.as_upper, [this](const Step& ladder) { return apply_limit(ladder); });
}

/// What follows from how far the lower number reaches.
bool Propagator::apply_reached(const Step& ladder) {
  const Chain& lower = chains_[ladder.lower];
  if (lower.reached <= ladder.first || value(ladder.guard) < 0) return true;
  const Chain& upper = chains_[ladder.upper];
  const std::uint32_t at = ladder.base + std::min(lower.reached - 1 - ladder.first, ladder.count - 1);
  const bool is_out = at >= upper.limit;
  if (!is_out && is_open(ladder.guard)) return true;
  return apply(ladder, lower.literals[lower.reached - 1], upper.literals[is_out ? upper.limit : at]);
}

/// What follows from where the upper number ends.
bool Propagator::apply_limit(const Step& ladder) {
  const Chain& upper = chains_[ladder.upper];
  if (upper.limit >= ladder.base + ladder.count || value(ladder.guard) < 0) return true;
  const Chain& lower = chains_[ladder.lower];
  const std::uint32_t at = ladder.first + (upper.limit > ladder.base ? upper.limit - ladder.base : 0);
  const bool is_reached = at < lower.reached;
  if (!is_reached && is_open(ladder.guard)) return true;
  return apply(ladder, lower.literals[is_reached ? lower.reached - 1 : at], upper.literals[upper.limit]);
}

/// That the guard and the lower literal imply the upper one.
bool Propagator::apply(const Step& ladder, int lower, int upper) {
  const int clause[] = {-ladder.guard, -lower, upper};
  int open = 0;
  for (const int literal : clause) {
    const int value = this->value(literal);
    if (value > 0 || (value == 0 && open != 0)) return true;
    if (value == 0) open = literal;
  }
  if (open == 0) {
    conflict_.assign(std::begin(clause), std::end(clause));
    return false;
  }
  const int first = clause[0] == open ? clause[1] : clause[0];
  const int second = clause[2] == open ? clause[1] : clause[2];
  assign(open, {kNoClause, first, second});
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
