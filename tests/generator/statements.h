#pragma once
#include <string>

#include "tests/generator/draft.h"
#include "tests/generator/expressions.h"
#include "tests/generator/functions.h"

namespace solitaire::generator {

/// Writes statements, one a line.
class Statements {
 public:
  explicit Statements(Draft& draft) : draft_(draft) {}
  Statements(const Statements&) = delete;
  Statements& operator=(const Statements&) = delete;

  void statement();
  void declare_function();
  /// Writes things as an imported file of the library has them, and what holds of them. There has to be one.
  void use_library();
  void assign_new(Kind kind);
  Expressions& expressions() { return expressions_; }

 private:
  /// Writes the inside of a block. Variables that it declares may be unset behind it; now and then one stays
  /// in use all the same.
  void block(int most);
  void simple_statement();
  void wish();
  /// A condition to assert that is not too strong, or few programs would have a solution.
  std::string assertion();
  void assign_again();
  void assign_mixed();
  void write_element();
  void place();
  void swap();
  void optional_append();
  void auxiliary();
  /// Writes choices of bins for things, and that no bin holds too much.
  void pack();
  void connect();
  void map_of_tiles();
  void boxes();
  void boxes_in_space();
  void openings();
  void tasks();
  void shifts();
  void keep(const std::string& list);
  void if_statement();
  /// Writes calls of one function at sites that exclude each other, with arguments and outer variables that
  /// are the same or not: calls share what was found out about one of them.
  void same_calls();
  void exclusive_call(const Declared& callee, const std::string& name, const std::string& call);
  /// Writes calls of a function that another one made.
  void closure();
  void make_closures(const std::string& maker);
  /// Writes calls at exclusive sites of a function that calls one which reads a variable; the sites change
  /// it.
  void reads_below();
  void for_statement();
  void while_statement();
  /// Writes an early way out, for some executions.
  void leave();
  std::string returned();

  Draft& draft_;
  Expressions expressions_{draft_};
  Functions functions_{draft_, expressions_, [this] { statement(); }};
};

}  // namespace solitaire::generator
