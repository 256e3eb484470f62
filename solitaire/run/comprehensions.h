#pragma once
#include <span>

#include "solitaire/run/loops.h"

namespace solitaire {

/// The layer of the walk that runs comprehensions, which are loops that collect.
class Comprehensions : public Loops {
 protected:
  using Loops::Loops;

  Value comprehension(const ComprehensionExpr& node);
  Value map_list(const Value& function, const Value& list, const CallExpr& site) override;
  Value filter_list(const Value& function, const Value& list, const CallExpr& site) override;

 private:
  void clause(const ComprehensionExpr& node, std::size_t number, Value& collected);
  /// What turns run over, and what has to be kept where they end.
  struct Source {
    Iteration items;
    const Site& site;
    Span span;
    std::span<const Slot> assigned;
  };
  template <class Turn>
  void collect(Source source, Value& collected, Turn turn);
  template <class Turn>
  void run_turns(Source& source, Exits& ends, Value& collected, Turn turn);
  template <class Turn>
  void run_paths(Source& source, Exits& ends, Value& collected, Turn turn);
  void conditions(const ComprehensionExpr& node, std::size_t clause_number, std::size_t number,
                  Value& collected);
};

}  // namespace solitaire
