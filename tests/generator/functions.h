#pragma once
#include <functional>
#include <string>

#include "tests/generator/draft.h"
#include "tests/generator/expressions.h"

namespace solitaire::generator {

/// Declares functions: recursive ones, with defaults, and such that read variables around them.
class Functions {
 public:
  /// `statement` writes a statement of a body.
  Functions(Draft& draft, Expressions& expressions, std::function<void()> statement)
      : draft_(draft), expressions_(expressions), statement_(std::move(statement)) {}

  void declare();

 private:
  std::string parameters(Declared& made);
  /// Writes the body. Of a recursive function the first argument gets smaller at each turn, and is small from
  /// the second on.
  void body(Declared& made);
  /// Makes what the function does depend on a variable around it, which sites of its calls change.
  void read_outer(Declared& made);

  Draft& draft_;
  Expressions& expressions_;
  std::function<void()> statement_;
};

}  // namespace solitaire::generator
