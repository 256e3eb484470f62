#pragma once
#include <cstddef>
#include <vector>

#include "kernel/score_program.h"

namespace solitaire {

/// A place in some code for each cell of a few. To forget them all takes no time.
class Places {
 public:
  void clear() { ++code_; }
  void set(Cell cell, std::size_t place) {
    if (cell >= places_.size()) places_.resize(2 * std::size_t{cell} + 1);
    places_[cell] = {code_, place};
  }
  /// Nothing for a cell that has no place.
  const std::size_t* find(Cell cell) const {
    return cell < places_.size() && places_[cell].code == code_ ? &places_[cell].place : nullptr;
  }

 private:
  struct Place {
    std::size_t code = 0;  // the number of the code that it is a place of
    std::size_t place = 0;
  };

  std::vector<Place> places_;  // by the cells
  std::size_t code_ = 1;
};

}  // namespace solitaire
