#pragma once
#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engines/count/estimate.h"
#include "engines/tuning.h"

namespace solitaire {

struct CountOptions {
  enum class Way : std::uint8_t { kExactIfSmall, kExact, kApproximate };
  Way way = Way::kExactIfSmall;
  /// kExactIfSmall: the most that is listed of what a part of the choices can be. kApproximate lists a few.
  std::uint64_t most_listed = tuning::kMostListedToCount;
  Accuracy accuracy;
};

/// The number of solutions: the product of the factors and of the estimate, if there is one.
struct SolutionCount {
  std::vector<std::uint64_t> factors;
  std::optional<Estimate> estimate;

  /// Returns the product of the factors in decimal digits.
  std::string digits() const;
  double log10() const;
};

/// Counts the solutions of a program without running them. Two solutions are different if they take different
/// paths, or if a choice that both meet has different values. See SolutionSpace for what is counted.
class SolutionCounter {
 public:
  /// `options` must not have asserts relaxed.
  SolutionCounter(const Program& program, ParamValues params, const TracingOptions& options,
                  const CountOptions& count);

  /// Returns nothing if TracedProgram::explore_fully does not explore all paths. Throws ProgramError,
  /// UnmatchedPin and Interrupted. `progress` is told what the counter does.
  std::optional<SolutionCount> run(const std::function<void(const std::string&)>& progress);
  /// Returns a number that there are at least, as far as it is known. May be called from another thread.
  SolutionCount at_least() const;

 private:
  std::optional<std::uint64_t> count_part(std::size_t number);

  std::uint64_t seed_;
  StopSignal stop_;
  CountOptions count_;
  TracedProgram program_;
  std::optional<SolutionSpace> space_;
  std::vector<std::atomic<std::uint64_t>> found_;  // by part
  std::atomic<bool> explored_ = false;             // the parts are known
};

}  // namespace solitaire
