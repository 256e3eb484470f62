#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace solitaire {

/// Says from what a literal followed, so that whoever assigned it can tell the clause again.
struct Reason {
  static constexpr std::uint32_t kOthers = static_cast<std::uint32_t>(-1);
  static constexpr std::uint32_t kDifference = static_cast<std::uint32_t>(-2);
  static constexpr std::uint32_t kSum = static_cast<std::uint32_t>(-3);

  /// Where the clause starts in WatchedClauses, or one of these.
  std::uint32_t clause = kOthers;
  /// kOthers: the other literals of the clause, or 0. kDifference: its number, and the position. kSum: its
  /// number, and that of the term.
  int first = 0, second = 0;
};

/// Keeps which literals hold, in the order in which they were assigned, each with its reason and the number
/// of decisions before it. Literals are those of ClauseSink.
class Trail {
 public:
  /// Returns one more than the largest variable.
  std::size_t variables() const { return assigned_.size(); }
  /// Makes room for variables up to this one.
  void reserve(int variable);
  /// Returns -1 for a literal that is false, 1 for one that is true, and 0 for an open one.
  int value(int literal) const {
    return static_cast<int>(values_[static_cast<std::size_t>(middle_ + literal)]);
  }
  bool is_open(int literal) const { return value(literal) == 0; }

  /// These assign an open literal: as a decision, and as a consequence of the decisions before it.
  void decide(int literal) {
    levels_.push_back(literals_.size());
    assign(literal);
  }
  void assign(int literal, Reason reason = {});
  /// Assigns the only literal of a clause that is not false, if there is only one. Returns false if there is
  /// none: the clause is broken.
  bool apply(int a, int b, int c);
  /// Takes back the last decision with all that followed, and returns it.
  int undo();

  /// Returns how many decisions were made: all, and before a variable was assigned.
  std::size_t decisions() const { return levels_.size(); }
  std::size_t level(int variable) const { return assigned_[static_cast<std::size_t>(variable)].level; }
  /// Returns the place in literals() of a literal that holds or is false.
  std::uint32_t place(int literal) const { return entry(literal).place; }
  const Reason& reason(int literal) const { return entry(literal).reason; }
  /// Returns what was assigned after so many decisions, in the order of assignment.
  std::span<const int> literals(std::size_t decisions = 0) const {
    return std::span(literals_).subspan(decisions == 0 ? 0 : levels_[decisions - 1]);
  }
  /// Returns the first literal of which nobody has looked yet at what follows, and counts it as looked at; 0
  /// if there is none.
  int take_new() { return looked_at_ < literals_.size() ? literals_[looked_at_++] : 0; }
  /// Returns how much of the trail has stayed as it was since the last call. What was assigned behind that is
  /// new.
  std::size_t take_kept() { return std::exchange(kept_, literals_.size()); }

  /// The clause that was found broken last.
  void break_clause(std::span<const int> literals) { conflict_.assign(literals.begin(), literals.end()); }
  std::span<const int> conflict() const { return conflict_; }

 private:
  /// This is an enum and no char, because a write through a char may change any object, so that compilers
  /// read all other members again after each.
  enum class Truth : std::int8_t { kFails = -1, kOpen, kHolds };

  struct Assigned {
    std::uint32_t level = 0;
    std::uint32_t place = 0;
    Reason reason;
  };

  void set(int literal, Truth value) { values_[static_cast<std::size_t>(middle_ + literal)] = value; }
  const Assigned& entry(int literal) const {
    return assigned_[static_cast<std::size_t>(literal > 0 ? literal : -literal)];
  }

  std::vector<Truth> values_{Truth::kOpen};  // by literal, from that of -middle_ to that of middle_
  int middle_ = 0;
  std::vector<Assigned> assigned_;  // by variable
  std::vector<int> literals_;
  std::vector<std::size_t> levels_;  // the place of each decision
  std::size_t looked_at_ = 0, kept_ = 0;
  std::vector<int> conflict_;
};

inline void Trail::assign(int literal, Reason reason) {
  assigned_[static_cast<std::size_t>(literal > 0 ? literal : -literal)] = {
      static_cast<std::uint32_t>(levels_.size()), static_cast<std::uint32_t>(literals_.size()), reason};
  set(literal, Truth::kHolds);
  set(-literal, Truth::kFails);
  literals_.push_back(literal);
}

inline bool Trail::apply(int a, int b, int c) {
  const int value_of_a = value(a), value_of_b = value(b), value_of_c = value(c);
  if (value_of_a > 0 || value_of_b > 0 || value_of_c > 0) return true;
  const int failing = -(value_of_a + value_of_b + value_of_c);
  if (failing < 2) return true;
  if (failing == 3) {
    conflict_ = {a, b, c};
    return false;
  }
  if (value_of_a == 0) {
    assign(a, {Reason::kOthers, b, c});
  } else if (value_of_b == 0) {
    assign(b, {Reason::kOthers, a, c});
  } else {
    assign(c, {Reason::kOthers, a, b});
  }
  return true;
}

}  // namespace solitaire
