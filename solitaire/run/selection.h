#pragma once
#include <vector>

#include "solitaire/run/comparisons.h"

namespace solitaire {

/// The layer of an evaluation that takes one of several values that have all been evaluated.
class Selection : public Comparisons {
 public:
  /// `a` if the condition, a bool, holds, else `b`.
  Value select(const Value& condition, const Value& a, const Value& b, Span span) {
    if (const bool* known = condition.plain<bool>()) return *known ? a : b;
    return select_open(condition, a, b, span);
  }
  /// The value, for a use that depends on what exactly it is: a traced execution is one of those in which it
  /// is the same.
  const Value& fixed(const Value& value, Span span);

 protected:
  using Comparisons::Comparisons;

 private:
  Value select_open(const Value& condition, const Value& a, const Value& b, Span span);
  std::vector<Value> select_members(const Value& condition, const std::vector<Value>& a,
                                    const std::vector<Value>& b, Span span);
};

}  // namespace solitaire
