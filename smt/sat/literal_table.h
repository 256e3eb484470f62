#pragma once
#include <cstddef>
#include <span>

#include "smt/sat/grouped_table.h"

namespace solitaire {

/// Entries by literal, side by side, made once.
template <class Entry>
class LiteralTable {
 public:
  LiteralTable() = default;
  /// For variables below `variables`. `each` is called twice with a function to call with each literal and
  /// entry.
  template <class Each>
  LiteralTable(std::size_t variables, Each each)
      : middle_(static_cast<std::ptrdiff_t>(variables)), table_(2 * variables, [&](const auto& put) {
          each([&](int literal, const Entry& entry) { put(group(literal), entry); });
        }) {}

  std::span<const Entry> of(int literal) const { return table_.of(group(literal)); }

 private:
  std::size_t group(int literal) const { return static_cast<std::size_t>(middle_ + literal); }

  std::ptrdiff_t middle_ = 0;  // between the literals' negations and them
  GroupedTable<Entry> table_;
};

}  // namespace solitaire
