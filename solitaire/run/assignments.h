#pragma once
#include <span>
#include <vector>

#include "solitaire/run/comprehensions.h"

namespace solitaire {

/// The layer of the walk that assigns: to variables, and to elements and fields of what is in them.
class Assignments : public Comprehensions {
 protected:
  using Comprehensions::Comprehensions;

  /// The values are evaluated first, then the indices of the targets; both from left to right.
  void assignment(const AssignStmt& node);

 private:
  void assign(const Expr& target, Value value);
  void change(const Expr& target, const Change& change);
  void evaluate_indices(const Expr& target, std::vector<Value>& indices);
  void update(const Expr& target, std::span<const Value> indices, const Change& change);
};

}  // namespace solitaire
