#pragma once
#include <optional>
#include <set>
#include <vector>

#include "engines/count/nested/nested_sampler.h"
#include "engines/count/xor_sampler.h"
#include "engines/solution_stream.h"
#include "engines/tuning.h"

namespace solitaire {

struct UniformOptions {
  /// The most that is listed of what a part of the choices can be.
  std::uint64_t most_listed = tuning::kMostListedToSample;
};

/// Draws solutions of a program, each that is left with nearly the same probability, whichever paths it
/// takes: as if all executions that are solutions stood in a list.
///
/// Every path is explored first. Choices that no condition ties to each other are drawn apart, each part
/// exactly uniformly if all that it can be was listed; the larger ones together, exactly uniformly where a
/// NestedSampler is fast enough, and else as CellSampler does, within a factor of 1.1 of uniform (but for one
/// in 20 seeds, at most). No solution comes twice: the first is drawn from all, the next one from those that
/// are left.
///
/// What comes next depends on the seed and on the solutions that came, and on nothing else.
class UniformEngine : public SolutionStream, public Exploring, public Timed {
 public:
  /// `options` must not have asserts relaxed.
  UniformEngine(const Program& program, ParamValues params, const TracingOptions& options,
                const UniformOptions& uniform = {});

  /// Returns the next solution, see SolutionStream::next. The ending is kUnexplored where
  /// TracedProgram::explore_fully returns false. Throws UnmatchedPin and UnequalSolutions, too.
  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }

  /// Takes a solution that came from an earlier engine for one of this. Throws as next(), and Interrupted.
  void exclude(const ChosenValues& choices);
  /// The last solution does not count as one that came: another is drawn in its place. It still does not come
  /// again.
  void pass_over() { passed_over_ = true; }
  /// Explores every path. Throws as next(), and Interrupted.
  void explore() override;
  std::size_t graph_size() const override { return program_.graph().size(); }
  EngineTimes times() const override { return program_.times(); }
  /// Makes a known solution. Throws NotASolution and Interrupted.
  Solution run(const ChosenValues& choices) { return program_.solution(program_.execution(choices)); }

 private:
  void prepare();
  VariableValues draw();
  Assignment completed(const VariableValues& values);
  void draw_rest(VariableValues& values);
  bool has_rest() const { return nested_ || cells_; }
  bool all_drawn() const;
  bool worth_listing() const;

  std::uint64_t seed_;
  StopSignal stop_;
  UniformOptions uniform_;
  TracedProgram program_;
  std::optional<SolutionSpace> space_;  // made when all is explored
  bool prepared_ = false;
  std::vector<std::vector<BitModel>> listed_;  // by part; empty for parts that are free, and for the rest
  std::uint64_t total_ = 1;              // the product over parts that are free or listed, at most UINT64_MAX
  std::optional<NestedSampler> nested_;  // for the rest, which is the last part, if it is large
  std::optional<CellSampler> cells_;     // for the rest where there is no other
  std::optional<std::vector<BitModel>> rest_;  // made when listing it is no more work than drawing
  std::set<VariableValues> drawn_;
  std::uint64_t came_ = 0;
  bool passed_over_ = false;
  std::optional<RandomStream> random_;  // for the solution that comes next
  std::uint64_t draws_ = 0;             // how often it was used
  Ending ending_ = Ending::kNone;
};

}  // namespace solitaire
