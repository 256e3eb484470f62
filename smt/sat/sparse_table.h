#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace solitaire {

/// A table for indices of which only few have an entry. Entries are made when they are first asked for, and
/// never move in memory.
template <class Entry>
class SparseTable {
 public:
  /// Makes room for indices below `size`, if there is not enough yet.
  void resize(std::size_t size) {
    if (numbers_.size() < size) numbers_.resize(size);
  }
  std::size_t size() const { return numbers_.size(); }
  /// Returns the entry, or null if there is none.
  Entry* find(std::size_t index) {
    const std::uint32_t number = numbers_[index];
    return number == 0 ? nullptr : &entries_[number - 1];
  }
  const Entry* find(std::size_t index) const {
    const std::uint32_t number = numbers_[index];
    return number == 0 ? nullptr : &entries_[number - 1];
  }
  /// Returns the entry, which is made if there was none.
  Entry& operator[](std::size_t index) {
    if (numbers_[index] == 0) {
      entries_.emplace_back();
      numbers_[index] = static_cast<std::uint32_t>(entries_.size());
    }
    return entries_[numbers_[index] - 1];
  }
  /// Returns all entries, in the order in which they were made.
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
