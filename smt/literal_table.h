#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace solitaire {

/// A literal of ClauseSink as a place in a vector: that of a variable, then its negation, from 2 on.
inline std::size_t literal_index(int literal) {
  return literal > 0 ? 2 * static_cast<std::size_t>(literal) : 2 * static_cast<std::size_t>(-literal) + 1;
}

/// Entries by literal, side by side, made once.
template <class Entry>
class LiteralTable {
 public:
  LiteralTable() = default;
  /// For variables below `variables`. `each` is called twice with a function to call with each literal and
  /// entry.
  template <class Each>
  LiteralTable(std::size_t variables, Each each) : starts_(2 * variables + 2) {
    each([&](int literal, const Entry&) { ++starts_[literal_index(literal) + 2]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    entries_.resize(starts_.back());
    // What is the start of a literal moves to its end, which is the start of the next one.
    each([&](int literal, const Entry& entry) { entries_[starts_[literal_index(literal) + 1]++] = entry; });
  }

  std::span<const Entry> of(int literal) const {
    const std::size_t at = literal_index(literal);
    if (at + 2 >= starts_.size()) return {};
    return {entries_.data() + starts_[at], entries_.data() + starts_[at + 1]};
  }

 private:
  std::vector<std::uint32_t> starts_;  // by literal, and the end
  std::vector<Entry> entries_;
};

}  // namespace solitaire
