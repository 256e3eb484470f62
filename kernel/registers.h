#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/score_program.h"

namespace solitaire {

/// Which cells, of floats, stand in registers while code runs: those that were used last. A float may stand
/// in a register only, and has to be written to its cell where it gives way and is still needed.
class Registers {
 public:
  struct Register {
    Cell cell = kNoCell;  // or it is free
    std::uint64_t used = 0;
    bool only_here = false;  // whether the cell itself does not have the float
  };

  void next_instruction() { ++now_; }
  /// The register of a cell, which the present instruction then uses, or nothing.
  Register* find(Cell cell) {
    const auto found =
        std::find_if(held_.begin(), held_.end(), [&](const Register& each) { return each.cell == cell; });
    if (found == held_.end()) return nullptr;
    found->used = now_;
    return &*found;
  }
  /// A free one, or that which was used the longest ago.
  Register& oldest() {
    return *std::min_element(held_.begin(), held_.end(),
                             [](const Register& a, const Register& b) { return a.used < b.used; });
  }
  void hold(Register& at, Cell cell, bool only_here) { at = {cell, now_, only_here}; }
  std::span<Register> all() { return held_; }
  /// Called functions may write to all registers.
  void forget() { held_.fill({}); }

  std::size_t number(const Register& at) const { return static_cast<std::size_t>(&at - held_.data()); }

 private:
  std::array<Register, 14> held_;
  std::uint64_t now_ = 1;
};

}  // namespace solitaire
