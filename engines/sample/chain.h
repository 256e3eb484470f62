#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "solitaire/value/plain_value.h"

namespace solitaire {

/// How often a kind of step was tried, and how often it was taken.
struct MoveCount {
  std::uint64_t tried = 0;
  std::uint64_t accepted = 0;
};
using MoveCounts = std::map<std::string, MoveCount>;

/// A Markov chain over the executions of a program, whose stationary distribution is the one that the program
/// denotes: an execution's density is the product of its choices' densities and of its factors, where wishes
/// are factors too, and is 0 where it is ruled out.
///
/// A chain belongs to one thread. Its functions throw ProgramError where an execution comes to a mistake, and
/// Interrupted.
class Chain {
 public:
  virtual ~Chain() = default;
  /// So many steps that each choice has its turn, on the average. How many that is must not depend on the
  /// state: looked at after longer and shorter times in different states, a chain shows some of them too
  /// often.
  virtual void sweep() = 0;
  /// Steps are tuned up to here, and never again: a chain that learns for ever has no known distribution.
  virtual void end_warmup() = 0;
  /// What the program returns in the present state.
  virtual PlainValue value() = 0;
  /// The steps since the warm-up ended.
  virtual const MoveCounts& moves() const = 0;
};

}  // namespace solitaire
