#pragma once
#include "solitaire/run/loops.h"

namespace solitaire {

/// The layer of the walk that runs comprehensions, which are loops that collect.
class Comprehensions : public Loops {
 protected:
  using Loops::Loops;

  Value comprehension(const ComprehensionExpr& node);

 private:
  void clause(const ComprehensionExpr& node, std::size_t number, Value& collected);
  void run_turns(const ComprehensionExpr& node, std::size_t number, Iteration& items, Exits& ends,
                 Value& collected);
  void run_paths(const ComprehensionExpr& node, std::size_t number, Iteration& items, Exits& ends,
                 Value& collected);
  void conditions(const ComprehensionExpr& node, std::size_t clause_number, std::size_t number,
                  Value& collected);
};

}  // namespace solitaire
