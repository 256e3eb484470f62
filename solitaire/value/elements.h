#pragma once
#include <cstddef>

#include "solitaire/value/value.h"

namespace solitaire {

/// The elements of a list, of chosen length or not, with the conditions under which it has them. It looks at
/// the list, which has to live as long.
class Elements {
 public:
  /// Assumes: list.is_list().
  explicit Elements(const Value& list) : known_(list.as_list()), chosen_(list.object<ChosenList>()) {}

  std::size_t size() const { return known_ != nullptr ? known_->items.size() : chosen_->elements.size(); }
  const Value& value(std::size_t number) const {
    return known_ != nullptr ? known_->items[number] : chosen_->elements[number].value;
  }
  NodeId guard(std::size_t number) const {
    return known_ != nullptr ? kTrue : chosen_->elements[number].guard;
  }
  /// Returns true if an element's index is its place here.
  bool packed() const { return known_ != nullptr || chosen_->packed; }

 private:
  const List* known_;
  const ChosenList* chosen_;
};

}  // namespace solitaire
