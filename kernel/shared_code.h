#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "kernel/places.h"
#include "kernel/score_program.h"

namespace solitaire {

/// Code of which some cells are named by their places in a table, so that code for other cells may be the
/// same but for its table.
struct SharedCode {
  std::vector<Instruction> code;
  std::vector<Cell> table;

  /// The same for code that is the same.
  std::vector<std::uint32_t> key() const {
    std::vector<std::uint32_t> made;
    for (const Instruction& step : code) {
      made.push_back(2 * static_cast<std::uint32_t>(step.op) + (step.lasts ? 1 : 0));
      made.push_back(step.result);
      made.insert(made.end(), step.operands.begin(), step.operands.end());
    }
    return made;
  }
};

class SharedCodeMaker {
 public:
  /// Cells below `shared_end` get places in the table, by the order in which they first come.
  SharedCode shared_of(std::vector<Instruction> code, Cell shared_end) {
    SharedCode made{std::move(code), {}};
    places_.clear();
    const auto name = [&](Cell& cell) {
      if (cell >= shared_end) return;
      const std::size_t* place = places_.find(cell);
      if (place == nullptr) {
        places_.set(cell, made.table.size());
        made.table.push_back(cell);
        place = places_.find(cell);
      }
      cell = static_cast<Cell>(*place);
    };
    for (Instruction& step : made.code) {
      for (std::size_t k = 0; k < operation(step.op).arity; ++k) name(step.operands[k]);
      name(step.result);
    }
    return made;
  }

 private:
  Places places_;
};

}  // namespace solitaire
