#include "library/search_state.h"

#include <solitaire/error.h>

#include "engines/count/uniform_series.h"
#include "engines/sample/sample_stream.h"
#include "engines/solve/series.h"
#include "engines/tile_maps/tile_stream.h"
#include "library/endings.h"
#include "library/engine_options.h"
#include "library/formula.h"
#include "library/freeze.h"
#include "library/stop_access.h"
#include "library/translate.h"

namespace solitaire::api {
namespace {

using Clock = std::chrono::steady_clock;

/// Additional time for a search that has found a solution and makes it better. It should end by itself at the
/// deadline, and this is how long it may take to notice.
constexpr std::chrono::milliseconds kTimeToEnd(300);

SearchOptions with_stop(SearchOptions options, const StopToken& stop) {
  options.stop = stop;
  return options;
}

Apart apart_of(Distinct distinct) {
  switch (distinct) {
    case Distinct::kChoices:
      return Apart::kChoices;
    case Distinct::kResult:
      return Apart::kResult;
    case Distinct::kValue:
      break;
  }
  return Apart::kValue;
}

SeriesOptions series_options(const Program& program, const SearchOptions& options) {
  SeriesOptions series;
  series.apart = apart_of(options.distinct);
  if (!options.all) series.most = options.count;
  series.jobs = options.jobs;
  series.make_params = [program] { return values_of_params(program.state(), program.settings()); };
  return series;
}

std::unique_ptr<SolutionStream> samples_of(const Program& program, const ParamValues& params,
                                           const SearchOptions& options) {
  if (!options.pins.empty() || !options.pin_file.empty() || options.all || options.relax ||
      options.sampling == Sampling::kUniform || options.min_distance > 0) {
    throw Error(
        Error::Kind::kUsage,
        "--engine shred draws executions by how probable they are: it holds no choices fixed, breaks no "
        "asserts, and there is neither an end nor a distance");
  }
  return std::make_unique<SampleStream>(program.state().program, params,
                                        engine_options(program, options).limits, options.seed);
}

std::unique_ptr<SolutionStream> maps_of(const Program& program, const ParamValues& params,
                                        const SearchOptions& options) {
  if (options.all || options.relax || options.sampling == Sampling::kUniform || options.min_distance > 0) {
    throw Error(
        Error::Kind::kUsage,
        "--engine tiles draws maps as their exemplars look: it breaks no asserts, and there is neither "
        "an end nor a distance");
  }
  return std::make_unique<TileStream>(program.state().program, params, engine_options(program, options));
}

std::unique_ptr<SolutionStream> stream_of(const Program& program, const ParamValues& params,
                                          const SearchOptions& options) {
  if (options.solver == Solver::kShred) return samples_of(program, params, options);
  if (options.solver == Solver::kTiles) return maps_of(program, params, options);
  const TracingOptions tracing = engine_options(program, options);
  const solitaire::Program& parsed = program.state().program;
  if (options.sampling == Sampling::kUniform) {
    return std::make_unique<UniformSeries>(parsed, params, tracing, apart_of(options.distinct));
  }
  return std::make_unique<Series>(parsed, params, tracing, series_options(program, options));
}

Clock::time_point after(double seconds) {
  const std::chrono::duration<double> length(std::min(seconds, 1e8));  // more than the clock can count
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(length);
}

}  // namespace

Search::State::State(const Program& program, const SearchOptions& options)
    : program_(program),
      options_(options),
      params_(values_of_params(program.state(), program.settings())),
      stop_(options.stop),
      stream_(stream_of(program_, params_, with_stop(options, stop_.token()))) {
  if (auto* improving = ability_of<Improving>(*stream_))
    improving->on_improvement([this](const solitaire::Solution& solution) { improved(solution); });
}

std::optional<Solution> Search::State::next() {
  stopped_ = false;
  if (!wants_more()) return std::nullopt;
  try {
    const std::optional<solitaire::Solution> found = translated(sources(), [&] {
      // What repeats an earlier run does not count as a search for a further solution; exploring does.
      const bool repeats = resumed_ && !begun_;
      if (!repeats) start_clock();
      begin();
      if (repeats) start_clock();
      return find();
    });
    if (!found) return std::nullopt;
    take_times();
    return frozen(*found, account_.add(*found, options_.scene != SceneDetail::kNone), sources());
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::kStopped) throw;
    stopped_ = true;
    return std::nullopt;
  }
}

Ending Search::State::ending() const {
  if (stopped_) return Ending::kStopped;
  return wants_more() ? public_ending(stream_->ending()) : Ending::kNone;
}

void Search::State::start_clock() {
  if (!options_.seconds_per_solution) return;
  extended_ = false;
  deadline_ = after(*options_.seconds_per_solution);
  stop_.set_deadline(*deadline_, StopReason::kTimePerSolution);
}

/// Does what comes before the first solution.
void Search::State::begin() {
  if (std::exchange(begun_, true)) return;
  if (options_.relax) check_errors();
  auto* resumable = ability_of<Resumable>(*stream_);
  if (resumable != nullptr && !resumable->catch_up()) throw Interrupted();
}

std::uint64_t Search::State::alike() const {
  const auto* counting = ability_of<CountingAlike>(*stream_);
  return counting != nullptr ? counting->alike() : 0;
}

bool Search::State::names_differed() const {
  const auto* counting = ability_of<CountingAlike>(*stream_);
  return counting != nullptr && counting->names_differed();
}

void Search::State::take_times() {
  if (const auto* timed = ability_of<Timed>(*stream_)) account_.set_times(timed->times());
}

std::optional<solitaire::Solution> Search::State::find() {
  if (observer_ != nullptr) observer_->begun();
  if (auto* exploring = ability_of<Exploring>(*stream_)) {
    exploring->explore();
    if (observer_ != nullptr) observer_->explored(exploring->graph_size());
  }
  std::optional<solitaire::Solution> found = stream_->next();
  if (deadline_) end_clock(found.has_value());
  return found;
}

/// A solution that was found has its time behind it, even if that was over when it came: the time of a next
/// one begins anew.
void Search::State::end_clock(bool found) {
  if (!found) return stop_.set_deadline(Clock::time_point::max());
  StopAccess::replace_deadline(stop_, Clock::time_point::max(), solitaire::StopReason::kTimePerSolution);
}

void Search::State::improved(const solitaire::Solution& solution) {
  Solution best = frozen(solution, account_.solutions() + 1, sources());
  if (observer_ != nullptr) observer_->improved(best);
  account_.set_best(std::move(best), solution);
  if (!deadline_ || std::exchange(extended_, true)) return;
  StopAccess::replace_deadline(stop_, *deadline_ + kTimeToEnd, solitaire::StopReason::kTimePerSolution);
}

/// Executions that break asserts may come to errors from which the asserts protect the program. So it is
/// checked first that no execution comes to an error which breaks none.
void Search::State::check_errors() {
  SearchOptions strict = with_stop(options_, stop_.token());
  strict.relax = false;
  TracedProgram(program_.state().program, params_, engine_options(program_, strict)).check();
}

std::vector<Solution> Search::State::resume(const std::vector<std::vector<Choice>>& earlier) {
  resumed_ = true;
  std::vector<ChosenValues> known;
  for (const std::vector<Choice>& choices : earlier) known.push_back(known_choices(choices));
  std::vector<Solution> solutions;
  try {
    auto* resumable = ability_of<Resumable>(*stream_);
    if (resumable == nullptr)
      throw Error(Error::Kind::kUsage, "this engine cannot go on with an earlier run");
    for (const solitaire::Solution& solution :
         translated(sources(), [&] { return resumable->resume(known); }))
      solutions.push_back(frozen(solution, account_.add(solution, true, true), sources()));
  } catch (const NotASolution& error) {
    throw Error(Error::Kind::kFile, error.what());
  }
  take_times();
  return solutions;
}

void Search::State::write_formula(const std::filesystem::path& path) {
  auto* with_formula = ability_of<WithFormula>(*stream_);
  if (with_formula == nullptr) throw Error(Error::Kind::kUsage, "this engine has no formula");
  translated(sources(), [&] { solitaire::api::write_formula(with_formula->formula_of_rest(), path); });
}

}  // namespace solitaire::api
