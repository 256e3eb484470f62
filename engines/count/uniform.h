#pragma once
#include "engines/count/xor_sampler.h"

namespace solitaire {

/// The program has wishes, so that its solutions are not to be alike probable.
class UnequalSolutions : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct UniformOptions {
  /// The most that is listed of what a part of the choices can be.
  std::uint64_t most_listed = 10'000;
};

/// Draws solutions of a program, each that is left with nearly the same probability, whichever paths it
/// takes: as if all executions that are solutions stood in a list.
///
/// Every path is explored first. Choices that no condition ties to each other are drawn apart, each part
/// exactly uniformly if all that it can be was listed; the larger ones together as CellSampler does, within a
/// factor of 1.1 of uniform (but for one in 20 seeds, at most). No
/// solution comes twice: the first is drawn from all, the next one from those that are left.
///
/// What comes next depends on the seed and on the solutions that came, and on nothing else.
class UniformEngine : public Engine {
 public:
  /// `options` must not have asserts relaxed.
  UniformEngine(const Program& program, ParamValues params, const TracingOptions& options,
                const UniformOptions& uniform = {});

  /// As Engine::next; kUnexplored as for TracingEngine::explore_fully. Throws UnmatchedPin and
  /// UnequalSolutions.
  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }
  const AddressTable& addresses() const override { return engine_.addresses(); }

  /// Takes a solution that came from an earlier engine for one of this. Throws as next(), and Interrupted.
  void exclude(const KnownChoices& choices);
  /// The last solution does not count as one that came: another is drawn in its place. It still does not come
  /// again.
  void pass_over() { passed_over_ = true; }
  /// Explores every path. Throws as next(), and Interrupted.
  void explore();
  /// Whether each solution that is left has exactly the same probability.
  bool exact() const { return !sampler_; }
  /// Which explores and runs solutions.
  TracingEngine& tracing() { return engine_; }
  const TracingEngine& tracing() const { return engine_; }

 private:
  void prepare();
  VariableValues draw();
  BitModel draw_of_rest();
  bool all_drawn() const;
  bool worth_listing() const;

  std::uint64_t seed_;
  StopSignal stop_;
  UniformOptions uniform_;
  TracingEngine engine_;
  std::optional<SolutionSpace> space_;  // once it is explored
  bool prepared_ = false;
  std::vector<std::vector<BitModel>> listed_;  // by part; none of free ones, nor of the rest
  std::uint64_t total_ = 1;                    // of the parts that are free or listed; at most UINT64_MAX
  std::optional<CellSampler> sampler_;         // of the rest: the last part, if there is much of it
  std::optional<std::vector<BitModel>> rest_;  // once listing it is no more work than drawing
  std::set<VariableValues> drawn_;
  std::uint64_t came_ = 0;
  bool passed_over_ = false;
  std::optional<RandomStream> random_;  // for the solution that comes next
  std::uint64_t draws_ = 0;             // from it
  Ending ending_ = Ending::kNone;
};

}  // namespace solitaire
