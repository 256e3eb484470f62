#pragma once
#include <memory>
#include <mutex>
#include <solitaire/search.h>

#include "engines/distance.h"
#include "engines/solution_stream.h"
#include "library/program_state.h"

namespace solitaire::api {

/// Keeps what came of a search so far, for any thread to see.
class SearchAccount {
 public:
  /// Takes a solution into the account, also one of an earlier run, and returns its number. Without the
  /// result, it is not known how much results differ.
  std::uint64_t add(const solitaire::Solution& solution, bool with_result, bool earlier = false);
  void set_times(const EngineTimes& times);
  /// Keeps the best solution so far, which will be the next one if it comes to that.
  void set_best(Solution best, const solitaire::Solution& solution);
  void forget_best();
  std::optional<Solution> take_best();
  std::uint64_t solutions() const;
  Summary summary(std::uint64_t alike, bool names_differed) const;

 private:
  /// Two solutions are compared by these.
  struct Compared {
    Features choices, results;
  };
  static Compared compared(const solitaire::Solution& solution, bool with_result);
  void count(const Compared& compared);

  mutable std::mutex mutex_;  // guards all members below
  std::uint64_t solutions_ = 0, earlier_ = 0;
  MeanDistance choice_distance_, result_distance_;
  NearestPair nearest_choices_;
  EngineTimes times_;
  std::optional<std::pair<Solution, Compared>> best_;
};

class Search::State {
 public:
  State(const Program& program, const SearchOptions& options);

  std::optional<Solution> next();
  Ending ending() const;
  StopToken stop_token() const { return stop_.token(); }
  void observe(SearchObserver* observer) { observer_ = observer; }
  std::vector<Solution> resume(const std::vector<std::vector<Choice>>& earlier);
  Summary summary() const { return account_.summary(alike(), names_differed()); }
  std::optional<Solution> take_best_so_far() { return account_.take_best(); }
  void write_formula(const std::filesystem::path& path);

 private:
  const SourceSet& sources() const { return program_.state().program.sources; }
  void start_clock();
  void end_clock(bool found);
  void begin();
  std::uint64_t alike() const;
  bool names_differed() const;
  void take_times();
  std::optional<solitaire::Solution> find();
  void improved(const solitaire::Solution& solution);
  void check_errors();
  bool wants_more() const { return options_.all || account_.solutions() < options_.count; }

  Program program_;
  SearchOptions options_;
  ParamValues params_;
  StopSource stop_;  // stops this search; the options' token does, too
  SearchObserver* observer_ = nullptr;
  std::unique_ptr<SolutionStream> stream_;
  SearchAccount account_;
  bool resumed_ = false;
  bool begun_ = false;
  bool extended_ = false;  // the time for this solution
  bool stopped_ = false;
  std::optional<std::chrono::steady_clock::time_point> deadline_;
};

}  // namespace solitaire::api
