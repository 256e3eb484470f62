#pragma once
#include <cstddef>
#include <span>

#include "base/grouped_table.h"

namespace solitaire {

/// Keeps the entries of each literal side by side in one array. The table is made once.
template <class Entry>
class LiteralTable {
 public:
  LiteralTable() = default;
  /// Makes the table for variables below `variables`. `each` is called several times, with a function that it
  /// has to call with the literal and the entry of each. A table without entries takes no memory.
  template <class Each>
  LiteralTable(std::size_t variables, Each each) : middle_(static_cast<std::ptrdiff_t>(variables)) {
    bool is_empty = true;
    each([&](int /*literal*/, const Entry& /*entry*/) { is_empty = false; });
    if (is_empty) return;
    table_ = {2 * variables, [&](const auto& put) {
                each([&](int literal, const Entry& entry) { put(group(literal), entry); });
              }};
  }

  std::span<const Entry> of(int literal) const { return table_.of(group(literal)); }

 private:
  std::size_t group(int literal) const { return static_cast<std::size_t>(middle_ + literal); }

  std::ptrdiff_t middle_ = 0;  // the place of literal 0; negative literals come before it
  GroupedTable<Entry> table_;
};

}  // namespace solitaire
