#include "tests/solve/proof_check.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

namespace solitaire {
namespace {

using Clause = std::vector<int>;

/// Clauses, and what follows from them by unit propagation. The first two literals of each are watched: they
/// are not false, or one is true.
class Propagation {
 public:
  explicit Propagation(int variables)
      : middle_(variables), values_(2 * variables + 1), watched_(values_.size()) {}

  void add(const Clause& clause) {
    numbers_[sorted(clause)].push_back(clauses_.size());
    Clause& own = clauses_.emplace_back(clause);
    std::stable_sort(own.begin(), own.end(), [this](int a, int b) { return value(a) > value(b); });
    for (std::size_t i = 0; i < own.size() && i < 2; ++i) watched(own[i]).push_back(clauses_.size() - 1);
    const bool unit = own.size() < 2 || value(own[1]) < 0;
    if (own.empty() || (unit && (!assign(own[0]) || !propagate()))) contradiction_ = true;
    fixed_ = trail_.size();
  }

  /// What followed by itself stays, as it does follow from what was there.
  void remove(const Clause& clause) {
    const auto at = numbers_.find(sorted(clause));
    if (at == numbers_.end()) return;
    clauses_[at->second.back()].clear();
    at->second.pop_back();
    if (at->second.empty()) numbers_.erase(at);
  }

  /// Whether the opposite of the clause leads to a contradiction.
  bool implies(const Clause& clause) {
    bool consistent = std::all_of(clause.begin(), clause.end(), [this](int each) { return assign(-each); });
    consistent = consistent && propagate();
    for (; trail_.size() > fixed_; trail_.pop_back()) set(trail_.back(), 0);
    next_ = fixed_;
    return !consistent;
  }

  bool contradiction() const { return contradiction_; }

 private:
  static Clause sorted(Clause clause) {
    std::sort(clause.begin(), clause.end());
    return clause;
  }

  /// 1 for true, -1 for false, 0 for neither.
  int value(int literal) const { return values_[static_cast<std::size_t>(middle_ + literal)]; }
  void set(int literal, signed char value) {
    values_[static_cast<std::size_t>(middle_ + literal)] = value;
    values_[static_cast<std::size_t>(middle_ - literal)] = static_cast<signed char>(-value);
  }
  std::vector<std::size_t>& watched(int literal) {
    return watched_[static_cast<std::size_t>(middle_ + literal)];
  }

  bool assign(int literal) {
    if (value(literal) == 0) {
      set(literal, 1);
      trail_.push_back(literal);
    }
    return value(literal) > 0;
  }

  bool propagate() {
    while (next_ < trail_.size()) {
      if (!leave(-trail_[next_++])) return false;
    }
    return true;
  }

  /// Finds other literals to watch in the clauses of one that has become false.
  bool leave(int literal) {
    const std::vector<std::size_t> watching = std::move(watched(literal));
    watched(literal).clear();
    bool consistent = true;
    for (const std::size_t number : watching) {
      Clause& clause = clauses_[number];
      if (clause.empty()) continue;
      if (clause.size() > 1 && clause[0] == literal) std::swap(clause[0], clause[1]);
      const auto other =
          std::find_if(clause.begin() + 1, clause.end(), [&](int each) { return value(each) >= 0; });
      if (value(clause[0]) > 0 || other == clause.end()) {
        watched(literal).push_back(number);
        consistent = consistent && assign(clause[0]);
      } else {
        std::swap(clause[1], *other);
        watched(clause[1]).push_back(number);
      }
    }
    return consistent;
  }

  int middle_;
  std::vector<signed char> values_;                     // by literal, from the middle
  std::vector<std::vector<std::size_t>> watched_;       // the same: numbers of clauses
  std::vector<Clause> clauses_;                         // empty: removed
  std::map<Clause, std::vector<std::size_t>> numbers_;  // of equal ones
  std::vector<int> trail_;                              // what is true, in the order in which it came out
  std::size_t next_ = 0;                                // of the trail, to be propagated
  std::size_t fixed_ = 0;                               // so much of the trail follows from the clauses
  bool contradiction_ = false;
};

Clause read_clause(const std::string& line) {
  std::istringstream in(line);
  Clause clause;
  for (int literal = 0; in >> literal && literal != 0;) clause.push_back(literal);
  return clause;
}

}  // namespace

std::string fault_of_proof(const std::string& formula, const std::string& proof) {
  Propagation known(std::stoi(formula.substr(formula.find("\np cnf ") + 7)));
  std::istringstream clauses(formula), steps(proof);
  for (std::string line; std::getline(clauses, line);) {
    if (line[0] != 'c' && line[0] != 'p') known.add(read_clause(line));
  }
  for (std::string line; !known.contradiction() && std::getline(steps, line);) {
    const bool removes = line[0] == 'd';
    const Clause clause = read_clause(line.substr(removes ? 1 : 0));
    if (removes) {
      known.remove(clause);
    } else if (known.implies(clause)) {
      known.add(clause);
    } else {
      return "this does not follow: " + line;
    }
  }
  return known.contradiction() ? "" : "the proof does not come to a contradiction";
}

}  // namespace solitaire
