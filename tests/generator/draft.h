#pragma once
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/generator/byte_source.h"

namespace solitaire::generator {

/// What the generator knows about a value. kPairs is a list of lists of two ints, kNested a list of lists of
/// ints.
enum class Kind { kInt, kBool, kList, kPairs, kNested, kRecord, kString, kFloat, kFunction };

struct Variable {
  std::string name;
  Kind kind;
  bool fixed = false;  // never assigned again: a loop's counter, a function, what is imported
  int level = 0;       // of the function that it belongs to
};

/// A variable that is one thing or another, depending on a bool variable that does not change.
struct Mixed {
  std::string name, condition;
  Kind then_kind, else_kind;
};

/// A function that was declared.
struct Declared {
  std::string name;
  std::vector<std::pair<std::string, Kind>> parameters;
  std::size_t required = 0;
  Kind result = Kind::kInt;
  std::string reads = {};  // a variable around it
};

/// A file as far as it is written: its text, the names that can be used at this place, and what may still
/// come.
class Draft {
 public:
  using Maker = std::function<std::string()>;

  /// `letter` is part of all names that the file makes, so that names of files differ where they have to.
  Draft(ByteSource& bytes, std::string of_names) : letter(std::move(of_names)), bytes_(bytes) {}

  // ---- decisions

  std::uint32_t below(std::uint32_t bound) { return bytes_.below(bound); }
  bool one_in(std::uint32_t n) { return below(n) == n - 1; }
  template <class T>
  T any_of(const std::vector<T>& items) {
    return items[below(static_cast<std::uint32_t>(items.size()))];
  }
  int number(int lo, int hi) { return lo + static_cast<int>(below(static_cast<std::uint32_t>(hi - lo + 1))); }
  Kind any_kind();

  // ---- names

  std::string fresh(const char* stem) { return stem + letter + std::to_string(names_++); }
  void declare(std::string name, Kind kind, bool fixed = false);
  std::vector<Variable> visible(Kind kind, bool assignable) const;
  std::string variable_or(Kind kind, const Maker& otherwise);

  /// A list of all variables of this level.
  std::string everything() const;
  /// An int that depends on all variables. What a program returns comes from replays, so that a wrong value
  /// in the trace graph only shows where an assert looks at it.
  std::string digest() const;
  static std::string digest_of(const Variable& variable);

  // ---- the text

  void line(const std::string& content);
  void open(const std::string& head) { line(head + " {"); }
  void close() { line("}"); }

  std::string text;
  std::vector<Variable> variables;
  std::vector<Mixed> mixed;
  std::vector<Declared> functions;
  std::string letter;
  int level = 0;     // of functions
  int block = 0;     // of blocks, for the indentation
  int loops = 0;     // around the statement, in its function
  int choices = 0;   // that may still be made
  int mistakes = 0;  // that may still be made
  int statements = 0;
  bool is_part = false;             // whether it is a file that is imported
  bool wishes = false;              // whether it may have wishes
  std::set<std::string> libraries;  // that it imports

 private:
  ByteSource& bytes_;
  int names_ = 0;
};

}  // namespace solitaire::generator
