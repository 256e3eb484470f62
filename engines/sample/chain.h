#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "engines/sample/move.h"
#include "engines/sample/returned_numbers.h"

namespace solitaire {

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
  /// The numbers that the program returns in the present state, with their names.
  virtual void read(const ReturnedNumbers& returned, std::vector<std::string>& names,
                    std::vector<double>& numbers) = 0;
  /// The steps since the warm-up ended.
  virtual MoveCounts moves() const = 0;
  virtual Troubles troubles() const = 0;
  /// Why the chain takes slower steps than it could, if it does.
  virtual std::optional<Diagnostic> slowed_by() const { return std::nullopt; }
};

}  // namespace solitaire
