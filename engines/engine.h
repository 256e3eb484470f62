#pragma once
#include <optional>
#include <string>

#include "solitaire/run/evaluator.h"

namespace solitaire {

/// How good a solution is, where the program has wishes or its asserts may be broken. Fewer broken asserts
/// are better, and of those with as many the one of less cost.
struct Quality {
  std::size_t broken = 0;  // asserts
  std::int64_t cost = 0;
  bool proved = false;  // that no better one is left
};

/// An execution in which every assert holds, unless asserts may be broken. The program was run with these
/// choices, or, where the engine was allowed to, what it does with them was read off its trace.
struct Solution {
  std::vector<MetChoice> choices;
  std::vector<AnsweredChoice> answers;  // the same in readable form
  Execution execution;
  std::optional<Quality> quality;
};

/// Why an engine has no further solution.
enum class Ending : std::uint8_t {
  kNone,        // it may have one
  kExhausted,   // proved that there is none
  kUnexplored,  // there is none on the paths that were explored; others were not looked at
  kWrapped,     // there is none for a solver whose ints wrap
  kStopped,     // a limit or an interrupt came first
};

/// Whatever finds solutions of a program, one after the other, each different from those before.
class Engine {
 public:
  virtual ~Engine() = default;
  /// The next solution, or nothing: then ending() says why.
  /// Throws ProgramError for mistakes in the program, InternalError if a solver's answer does not hold.
  virtual std::optional<Solution> next() = 0;
  virtual Ending ending() const = 0;
  /// The addresses that solutions' choices refer to.
  virtual const AddressTable& addresses() const = 0;
};

/// Solitaire itself is wrong: a model of the formula is not an execution of the program.
class InternalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A solution that is known from before is none of this program.
class NotASolution : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The choices in readable form.
std::vector<AnsweredChoice> readable(const std::vector<MetChoice>& choices, const AddressTable& addresses);

}  // namespace solitaire
