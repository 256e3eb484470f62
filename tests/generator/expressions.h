#pragma once
#include <string>
#include <vector>

#include "tests/generator/draft.h"

namespace solitaire::generator {

/// Makes expressions of every kind of value. The deeper an expression stands in another, the simpler it is.
class Expressions {
 public:
  explicit Expressions(Draft& draft) : draft_(draft) {}

  std::string expression(Kind kind, int depth = 0);
  std::string integer(int depth);
  std::string boolean(int depth);
  std::string list(int depth);
  std::string pairs(int depth);
  std::string nested(int depth);
  std::string text(int depth);
  std::string literal();
  /// An index, mostly in range of a short list.
  std::string index(int depth);
  std::string either(Kind kind, int depth);
  /// A call of `range`, `flip` or `choose`, as long as choices are left.
  std::string choice(const std::string& call, Kind kind = Kind::kInt);
  std::string call_of(const Declared& callee, int depth, const std::string& first = "");
  /// Takes so many of the choices that are left, where that many are and no loop or function makes more of
  /// them.
  bool take_choices(int number);
  /// Whether some nodes of a small graph hang together.
  std::string connection(int depth);
  /// The bins of things.
  std::string packed(int depth);
  /// An int for each node of a small graph: distances, or a tree.
  std::string of_graph(int depth);
  /// Some cells of a small grid.
  std::string of_grid(int depth);

 private:
  struct Weighted {
    std::uint32_t weight;
    Draft::Maker make;
  };

  /// The first maker is the simplest one; beyond the deepest level it is the only one.
  std::string pick(int depth, const std::vector<Weighted>& makers);
  std::string divisor(int depth);
  std::string flip();
  /// A choice among ints with weights.
  std::string weighted(int depth);
  std::string comparison_of_texts(int depth);
  /// A bool for each node of a small graph.
  std::string nodes(int depth);
  std::string small_graph();
  std::string small_grid(int depth);
  /// Whether a small grid looks like something.
  std::string pattern(int depth);
  std::string boxes(int depth);
  /// A comparison of two numbers that are made of two each, as y * w + x is for the square at x and y.
  std::string codes();
  /// Whether bools that follow each other are as a schedule has them.
  std::string turns(int depth);
  std::string list_of(Kind kind, int depth, int count);
  std::string comprehension(int depth);
  std::string record(int depth);
  /// A float. The solver has to be told no condition on it, so that most often it is only shown.
  std::string real(int depth);
  /// A function of one int.
  std::string function(int depth);
  std::string lambda(int depth);
  std::string function_of_record();
  template <class Body>
  std::string lambda(Body body);
  std::string predicate(int depth);
  std::string choice_of_int(int depth);
  std::string call(Kind result, int depth);
  std::string use_mixed(Kind kind, int depth);
  /// Something that is wrong, most often where only some executions come.
  std::string mistaken(Kind kind, int depth);

  Draft& draft_;
};

}  // namespace solitaire::generator
