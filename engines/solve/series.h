#pragma once
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "engines/distinct.h"
#include "engines/solution_stream.h"
#include "engines/solve/background_search.h"
#include "engines/solve/series_distance.h"
#include "tracegraph/valuation.h"

namespace solitaire {

struct SeriesOptions {
  Apart apart = Apart::kChoices;  // leave out solutions that are no others
  std::uint64_t most = 0;         // so many will be asked for at most; 0: nobody knows
  /// How many searches may be at work beside each other, on threads of their own. With 1, all is done on the
  /// thread that asks.
  std::size_t jobs = 1;
  /// Makes values of the params that nobody else holds, as each thread needs them. Null if there are none.
  std::function<ParamValues()> make_params;
};

/// The solutions that TracingEngines find, block by block. Each block has an engine of its own, and a stream
/// of random numbers. It knows the solutions of the blocks before, but not of the last few, so that several
/// can be worked on at a time, with the same result however many these are; what other blocks have found,
/// too, is left out, and of the first solutions also what is near it. A series that was interrupted repeats
/// the search from the start of its block on.
///
/// Where most solutions have come, those that are left are listed, and come in a random order. When that is
/// looked at depends on the number of solutions alone, so that it is at the same place after an interruption.
///
/// Where the best solutions come first, or none may be near another, a block has to know all before it, and
/// one follows the other. Where all are gone through in order, there is one block.
class Series : public SolutionStream,
               public Resumable,
               public Improving,
               public Exploring,
               public WithFormula,
               public CountingAlike,
               public Timed {
 public:
  Series(const Program& program, ParamValues params, const TracingOptions& tracing, SeriesOptions options);

  std::vector<Solution> resume(const std::vector<ChosenValues>& earlier) override;
  /// Finds again what came of the block in which the series was interrupted.
  bool catch_up() override;
  void explore() override;
  std::optional<Solution> next() override;
  void on_improvement(std::function<void(const Solution&)> told) override;

  Ending ending() const override { return ending_; }
  EngineTimes times() const override;
  std::size_t graph_size() const override { return engine_->graph_size(); }
  /// The formula of one engine that knows all solutions that came, and at the end that there are no others.
  Formula formula_of_rest() override;
  std::uint64_t alike() const override { return alike_; }
  bool names_differed() const override { return names_are_chosen_ || results_.names_differed(); }

 private:
  struct Block {
    std::size_t number = 0;
    std::size_t start = 0;  // its first solution
    std::size_t end = 0;
  };
  enum class Manner : std::uint8_t { kUnknown, kBlocks, kRest, kBestFirst, kEnumeration };

  Block block_after(const Block& block) const;
  std::size_t size(std::size_t number, std::size_t start) const;
  std::size_t known_to(const Block& block) const;
  bool in_background() const;
  bool may_repeat() const;
  void start(const Block& block);
  void start_engine();
  bool lists_rest(const Block& before, Block& block);
  std::optional<Solution> next_of_rest();
  void start_searches();
  std::unique_ptr<BackgroundSearch> search(const Block& block) const;
  std::optional<Solution> next_new();
  std::optional<Solution> next_far();
  std::optional<Solution> next_of_block();
  void remember(const Solution& solution);

  const Program& program_;
  ParamValues params_;
  TracingOptions tracing_;
  SeriesOptions options_;
  Manner manner_ = Manner::kUnknown;
  std::unique_ptr<TracingEngine> engine_;  // of the block, if that is not worked on in the background
  std::deque<std::pair<Block, std::unique_ptr<BackgroundSearch>>>
      searches_;            // the block's, and of the next ones
  EngineTimes past_times_;  // what finished engines and searches took
  std::function<void(const Solution&)> told_;
  Block block_;
  SeriesDistance distance_;
  std::vector<Valuation> rest_;  // with Manner::kRest, what is still to come, and some that came already
  DistinctResults results_;
  std::unordered_set<std::string> choices_;  // of all solutions so far, where they may come again
  std::vector<ChosenValues> solutions_;      // those of one engine that knows them all are empty
  std::deque<ChosenValues> to_repeat_;       // solutions of the block that came already
  std::atomic<std::uint64_t> alike_ = 0;
  std::atomic<bool> names_are_chosen_ =
      false;  // where solutions that differ in these alone are not looked for
  Ending ending_ = Ending::kNone;
};

}  // namespace solitaire
