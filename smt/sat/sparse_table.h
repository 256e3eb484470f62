#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace solitaire {

/// Entries by index, made when they are asked for, where only few of the indices have one. They stay where
/// they are in memory.
template <class Entry>
class SparseTable {
 public:
  /// For indices below `size`, if it is not for more already.
  void resize(std::size_t size) {
    if (numbers_.size() < size) numbers_.resize(size);
  }
  std::size_t size() const { return numbers_.size(); }
  /// Null where there is none.
  Entry* find(std::size_t index) {
    const std::uint32_t number = numbers_[index];
    return number == 0 ? nullptr : &entries_[number - 1];
  }
  /// Made without a value where there was none.
  Entry& operator[](std::size_t index) {
    if (numbers_[index] == 0) {
      entries_.emplace_back();
      numbers_[index] = static_cast<std::uint32_t>(entries_.size());
    }
    return entries_[numbers_[index] - 1];
  }
  /// All, in no order.
  std::deque<Entry>& entries() { return entries_; }
  void clear() {
    numbers_.clear();
    entries_.clear();
  }

 private:
  std::vector<std::uint32_t> numbers_;  // by index: where its entry is, from 1 on; 0: it has none
  std::deque<Entry> entries_;
};

}  // namespace solitaire
