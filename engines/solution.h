#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/span.h"
#include "solitaire/value/placed_item.h"
#include "solitaire/value/plain_value.h"
#include "tracegraph/distribution.h"
#include "tracegraph/scalar.h"

namespace solitaire {

// The types in which engines hand out results. All of it is plain data that shares nothing with the engine
// that made it or with any program, so that any thread may keep it for as long as it likes, while the engine
// goes on.

/// A choice of an execution, in readable form.
struct ChosenValue {
  std::string address;  // such as "wing[2]/room[0]/make_table/rot"
  Distribution::Family family = Distribution::Family::kRange;
  TypedScalar value;  // of choose(): the position in the list, from 0
  /// Of choose(): what it chose as the language writes it, if that is short (short_text.h): "oven", 3. It
  /// follows from the others, and is not known of choices that come from files.
  std::string element = "";

  friend bool operator==(const ChosenValue& a, const ChosenValue& b) {
    return a.address == b.address && a.family == b.family && a.value == b.value;
  }
};

/// The choices that an execution meets. They say all about it: whoever answers a program's choices with them
/// runs that execution.
using ChosenValues = std::vector<ChosenValue>;

/// A thing in the scene of a solution.
struct PlacedObject : PlacedItem {
  ChosenValues choices;  // the choices that decide what it is and where it stands
};

/// A conjunct of an assert that a solution breaks, where solutions may.
struct BrokenAssert {
  Span span;   // of the conjunct
  Span whole;  // of the whole condition
  std::string address;
  std::string message;               // the author's, or ""
  std::vector<std::string> choices;  // the addresses of the choices on which it depends, sorted
};

/// A wish of the program that costs a solution something.
struct UnmetWish {
  Span span;
  std::string address;
  std::int64_t cost = 0;             // more than 0
  std::vector<std::string> choices;  // the addresses of the choices on which it depends, sorted
};

/// Says how good a solution is, where the program has wishes or its asserts may be broken. Fewer broken
/// asserts are better; among solutions with equally many, a lower cost is better.
struct Quality {
  std::size_t broken = 0;  // the number of broken asserts
  std::size_t wishes = 0;  // the number of wishes that the execution met
  std::int64_t cost = 0;   // the sum of the costs of all wishes
  bool proved = false;     // it is proved that no better one is left
  /// It is proved that no solution that is left costs less. It is not known of near misses.
  std::optional<std::int64_t> least_cost;
};

/// What makes two solutions different.
enum class Apart : std::uint8_t {
  kChoices,  // their choices, but for auxiliary ones
  kResult,   // what they look like: the value, and the scene
  kValue,    // what the program returned, before its output if it has one
};

/// A result that an engine found. Of a program it is an execution in which every assert holds, unless asserts
/// may be broken: the program was run with these choices, or, where the engine was allowed to, what it does
/// with them was read off its trace. An engine without a program fills in what it knows.
struct Solution {
  PlainValue value;                         // what the program returned
  std::optional<PlainValue> before_output;  // what it had returned before its output, if it has one
  ChosenValues choices;                     // in the order in which the execution meets them
  ChosenValues auxiliary;  // likewise, those that make no solutions different; needed to run it again
  std::vector<PlacedObject> placements;
  std::vector<BrokenAssert> broken;
  std::vector<UnmetWish> unmet;
  std::optional<Span> only_wish;     // the call, where the execution met a single wish
  std::optional<Quality> quality;    // nothing where solutions are all as good
  double unit = 1;                   // metres in one unit of the program
  std::vector<std::string> printed;  // lines
};

/// Returns what runs the solution again.
ChosenValues all_choices(const Solution& solution);

}  // namespace solitaire
