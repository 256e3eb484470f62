#pragma once
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace solitaire {

/// Keeps the entries of each group side by side in one array. The table is made once.
template <class Entry>
class GroupedTable {
 public:
  GroupedTable() = default;
  /// Makes the table for groups below `groups`. `each` is called twice, with a function that it has to call
  /// with the group and the entry of each.
  template <class Each>
  GroupedTable(std::size_t groups, Each each) : groups_(groups), starts_(groups + 2) {
    each([&](std::size_t group, const Entry&) { ++starts_[group + 2]; });
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    entries_.resize(starts_.back());
    // Filling a group moves its start to its end, which is the start of the next one.
    each([&](std::size_t group, const Entry& entry) { entries_[starts_[group + 1]++] = entry; });
  }

  /// Returns how many groups it was made for.
  std::size_t groups() const { return groups_; }
  /// Returns the entries of a group; none for a group that the table was not made for.
  std::span<const Entry> of(std::size_t group) const {
    if (group >= groups_) return {};
    return {entries_.data() + starts_[group], entries_.data() + starts_[group + 1]};
  }

 private:
  std::size_t groups_ = 0;
  std::vector<std::uint32_t> starts_;  // by group, and the end
  std::vector<Entry> entries_;
};

}  // namespace solitaire
