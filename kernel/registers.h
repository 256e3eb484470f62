#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/score_program.h"

namespace solitaire {

/// Which instructions of some code are the last to read a cell.
class LastReads {
 public:
  void look_at(std::span<const Instruction> code) {
    ++code_;
    for (std::size_t i = 0; i < code.size(); ++i)
      for (std::size_t k = 0; k < operation(code[i].op).arity; ++k) note(code[i].operands[k], i);
  }
  /// Returns true if an instruction behind that place reads the cell.
  bool come_after(std::size_t place, Cell cell) const {
    return cell < last_.size() && last_[cell].code == code_ && last_[cell].place > place;
  }

 private:
  struct Read {
    std::size_t code = 0;  // the number of the code that reads it; another one knows nothing of the cell
    std::size_t place = 0;
  };
  void note(Cell cell, std::size_t place) {
    if (cell >= last_.size()) last_.resize(2 * std::size_t{cell} + 1);
    last_[cell] = {code_, place};
  }

  std::vector<Read> last_;  // by the cells
  std::size_t code_ = 0;
};

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
