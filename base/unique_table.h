#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace solitaire {

/// A hash table that finds equal things among things that somebody else keeps, each by its number: what makes
/// expressions and gates unique (hash-consing). It never forgets one.
///
/// Slots are probed one after the other. Each keeps 32 bits of the hash beside the number, so that the things
/// themselves are looked at only where they are most likely equal, and never when the table grows.
class UniqueTable {
 public:
  UniqueTable() : slots_(kFirstSlots) {}

  /// Returns the number of the thing with that hash for which equals(number) is true. If there is none, calls
  /// add() for a new one, which returns its number, and keeps that.
  template <class Equals, class Add>
  std::uint32_t find_or_add(std::uint64_t hash, Equals equals, Add add) {
    const auto mark = static_cast<std::uint32_t>(hash >> 32);
    std::size_t at = mark & (slots_.size() - 1);
    for (; slots_[at].next_number != 0; at = (at + 1) & (slots_.size() - 1)) {
      if (slots_[at].mark == mark && equals(slots_[at].next_number - 1)) return slots_[at].next_number - 1;
    }
    const std::uint32_t number = add();
    slots_[at] = {number + 1, mark};
    if (++count_ * 4 > slots_.size() * 3) grow();
    return number;
  }

 private:
  static constexpr std::size_t kFirstSlots = 1024;  // a power of two, as are all sizes

  struct Slot {
    std::uint32_t next_number = 0;  // one more than the number; 0: free
    std::uint32_t mark = 0;         // some bits of the hash
  };

  void grow() {
    std::vector<Slot> larger(2 * slots_.size());
    for (const Slot& slot : slots_) {
      if (slot.next_number == 0) continue;
      std::size_t at = slot.mark & (larger.size() - 1);
      while (larger[at].next_number != 0) at = (at + 1) & (larger.size() - 1);
      larger[at] = slot;
    }
    slots_.swap(larger);
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace solitaire
