#include "engines/solve/series.h"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "engines/resume.h"
#include "engines/seen.h"
#include "engines/solve/few_solutions.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Returns the choices as text, by which they are told apart.
std::string key(const ChosenValues& choices) {
  std::string text;
  for (const ChosenValue& choice : choices)
    text += fmt::format("{}={}\n", choice.address, to_text(choice.value));
  return text;
}

}  // namespace

Series::Series(const Program& program, ParamValues params, const TracingOptions& tracing,
               SeriesOptions options)
    : program_(program),
      params_(std::move(params)),
      tracing_(tracing),
      options_(std::move(options)),
      distance_(tracing.far_apart ? tuning::kNearFarApart : tuning::kNearSolutions, tuning::kMostAside),
      results_(options_.apart) {
  tracing_.one_of_alike = options_.apart != Apart::kChoices;
  tracing_.apart = options_.apart;
  engine_ = std::make_unique<TracingEngine>(program_, params_, tracing_);
}

void Series::explore() {
  engine_->explore();
  if (manner_ != Manner::kUnknown) return;
  if (!tracing_.diverse) {
    manner_ = Manner::kEnumeration;
  } else if (tracing_.relax || tracing_.min_distance.any() || engine_->traced().trace().has_costs()) {
    manner_ = Manner::kBestFirst;
  } else {
    manner_ = Manner::kBlocks;
  }
  block_ = {0, 0, size(0, 0)};
  start_searches();
}

/// Small blocks first, so that few solutions, too, are found side by side. Then few enough blocks that the
/// search does not mainly start.
std::size_t Series::size(std::size_t number, std::size_t start) const {
  using namespace tuning;
  switch (manner_) {
    case Manner::kUnknown:
    case Manner::kRest:
    case Manner::kEnumeration:
      return SIZE_MAX;
    case Manner::kBestFirst:
      return std::max(kUsualBlock, start / kBestFirstBlockShare);
    case Manner::kBlocks:
      break;
  }
  if (number < kSmallBlocks) return kFirstBlock << number;
  return std::max(kUsualBlock, start / kBlockShare);
}

Series::Block Series::block_after(const Block& block) const {
  return {block.number + 1, block.end, block.end + size(block.number + 1, block.end)};
}

/// Returns how many of the first solutions the engine of a block knows.
std::size_t Series::known_to(const Block& block) const {
  if (manner_ != Manner::kBlocks) return block.start;
  if (block.number <= tuning::kUnknownBlocks) return 0;
  Block last{0, 0, size(0, 0)};
  while (last.number + tuning::kUnknownBlocks + 1 < block.number) last = block_after(last);
  return last.end;
}

void Series::start(const Block& block) {
  const Block before = std::exchange(block_, block);
  distance_.start_block();
  if (lists_rest(before, block_)) {
    searches_.clear();
  } else if (in_background()) {
    past_times_ += searches_.front().second->times();
    searches_.pop_front();
    start_searches();
  } else {
    start_engine();
  }
}

/// Makes the engine of the block.
void Series::start_engine() {
  past_times_ += engine_->times();
  engine_ = std::make_unique<TracingEngine>(program_, params_, tracing_, block_.start);
  if (told_) engine_->on_improvement(told_);
  for (std::size_t i = 0; i < known_to(block_); ++i) {
    engine_->exclude(solutions_[i]);
    engine_->keep_away_from(solutions_[i]);
  }
}

/// Lists all solutions if most of them came before the block, which then is the last one.
bool Series::lists_rest(const Block& before, Block& block) {
  if (manner_ != Manner::kBlocks || options_.apart != Apart::kChoices || !tracing_.method->may_enumerate())
    return false;
  std::size_t look = tuning::kFirstLookForFew;
  while (look <= before.start) look *= tuning::kLookForFewGrowth;
  if (look > block.start) return false;
  auto all = few_solutions(engine_->traced(), tuning::kFewSolutions * block.start, tracing_.seed);
  if (!all) return false;
  rest_ = std::move(*all);
  manner_ = Manner::kRest;
  block.end = SIZE_MAX;
  return true;
}

/// Returns true if there is more than one block to work on, and may be more than one search.
bool Series::in_background() const {
  return manner_ == Manner::kBlocks && options_.jobs > 1 &&
         (options_.most == 0 || options_.most > size(0, 0));
}

/// Returns true if a solution can come from two engines that do not know each other.
bool Series::may_repeat() const { return manner_ == Manner::kBlocks || manner_ == Manner::kRest; }

/// Starts as many searches as there may be, of the blocks from the present one on. Where there are no
/// threads for them, fewer have to do, or the thread that asks does all.
void Series::start_searches() {
  try {
    while (in_background() && searches_.size() < std::min(options_.jobs, tuning::kUnknownBlocks + 1)) {
      const Block block = searches_.empty() ? block_ : block_after(searches_.back().first);
      const bool needed = options_.most == 0 || block.start < options_.most || searches_.empty();
      if (!needed) return;
      searches_.emplace_back(block, search(block));
    }
  } catch (const std::system_error&) {
    if (!searches_.empty()) return;
    options_.jobs = 1;
    start_engine();
  }
}

std::unique_ptr<BackgroundSearch> Series::search(const Block& block) const {
  const auto known = solutions_.begin() + static_cast<std::ptrdiff_t>(known_to(block));
  const std::size_t end = options_.most == 0 ? block.end : std::min<std::size_t>(block.end, options_.most);
  return std::make_unique<BackgroundSearch>(
      program_, options_.make_params ? options_.make_params() : ParamValues{}, tracing_, block.start,
      std::vector(solutions_.begin(), known), end - std::min(end, block.start));
}

std::vector<Solution> Series::resume(const std::vector<ChosenValues>& earlier) {
  explore();
  std::vector<Solution> known =
      run_all(earlier, [this](const ChosenValues& choices) { return engine_->run(choices); });
  Block block{0, 0, size(0, 0)};
  while (block.end <= earlier.size()) {
    for (std::size_t i = block.start; i < block.end; ++i) remember(known[i]);
    const Block before = std::exchange(block, block_after(block));
    distance_.start_block();
    lists_rest(before, block);
  }
  to_repeat_.assign(earlier.begin() + static_cast<std::ptrdiff_t>(block.start), earlier.end());
  if (block.number == 0) return known;
  searches_.clear();
  block_ = block;
  if (in_background()) {
    start_searches();
  } else if (manner_ != Manner::kRest) {
    start_engine();
  }
  return known;
}

void Series::remember(const Solution& solution) {
  distance_.add(solution);
  solutions_.push_back(all_choices(solution));
  choices_.insert(key(solution.choices));
  if (options_.apart != Apart::kChoices) results_.add(solution);
}

std::optional<Solution> Series::next() {
  if (!catch_up()) return std::nullopt;
  return next_new();
}

/// If something else comes, then the earlier solutions were found in another way, and the series goes on
/// without repeating any of them.
bool Series::catch_up() {
  explore();
  while (!to_repeat_.empty()) {
    const std::optional<Solution> solution = next_new();
    if (!solution && ending_ == Ending::kStopped) return false;
    if (solution && key(all_choices(*solution)) == key(to_repeat_.front())) {
      to_repeat_.pop_front();
      continue;
    }
    if (solution) {
      solutions_.pop_back();
      choices_.erase(key(solution->choices));
    }
    for (const ChosenValues& choices : std::exchange(to_repeat_, {})) remember(engine_->run(choices));
    ending_ = Ending::kNone;
    manner_ = Manner::kBestFirst;  // each block knows all before it
    searches_.clear();
    block_ = {block_.number + 1, solutions_.size(), SIZE_MAX};
    start_engine();
  }
  return true;
}

std::optional<Solution> Series::next_new() {
  while (true) {
    if (solutions_.size() >= block_.end) start(block_after(block_));
    std::optional<Solution> solution = next_far();
    if (!solution) {
      if (ending_ == Ending::kExhausted && options_.apart == Apart::kResult)
        names_are_chosen_ = chooses_names(engine_->traced().pass());
      return solution;
    }
    if (may_repeat()) choices_.insert(key(solution->choices));
    if (options_.apart != Apart::kChoices && !results_.add(*solution)) {
      ++alike_;
      if (!in_background()) engine_->hear_of_alike();
      continue;
    }
    const bool is_needed = manner_ != Manner::kEnumeration || !to_repeat_.empty();
    solutions_.push_back(is_needed ? all_choices(*solution) : ChosenValues{});
    distance_.add(*solution);
    engine_->keep_away_from(solution->choices);
    return solution;
  }
}

/// Returns a solution of the block that no other block has found, and that is far from those of other blocks
/// if such a one is soon found.
std::optional<Solution> Series::next_far() {
  const auto find = [this] {
    std::optional<Solution> solution = next_of_block();
    while (solution && may_repeat() && choices_.count(key(solution->choices)) != 0)
      solution = next_of_block();
    return solution;
  };
  if (manner_ != Manner::kBlocks) return find();
  std::optional<Solution> solution = distance_.next(find);
  if (!solution && ending_ == Ending::kExhausted) solution = distance_.take_aside();
  if (solution) ending_ = Ending::kNone;
  return solution;
}

std::optional<Solution> Series::next_of_rest() {
  TracedProgram& traced = engine_->traced();
  if (rest_.empty() || traced.stop().stopped()) {
    ending_ = rest_.empty() ? Ending::kExhausted : Ending::kStopped;
    return std::nullopt;
  }
  const Valuation values = std::move(rest_.back());
  rest_.pop_back();
  Assignment assignment = assignment_of(traced.graph(), values);
  ending_ = Ending::kNone;
  return traced.solution(traced.execution(assignment));
}

std::optional<Solution> Series::next_of_block() {
  if (manner_ == Manner::kRest) return next_of_rest();
  if (!in_background()) {
    std::optional<Solution> solution = engine_->next();
    ending_ = engine_->ending();
    return solution;
  }
  BackgroundSearch& search = *searches_.front().second;
  const std::optional<ChosenValues> choices = search.next();
  ending_ = choices ? Ending::kNone : search.ending();
  if (!choices) return std::nullopt;
  return engine_->run(*choices);
}

EngineTimes Series::times() const {
  EngineTimes times = past_times_;
  times += engine_->times();
  for (const auto& [block, search] : searches_) times += search->times();
  return times;
}

Formula Series::formula_of_rest() {
  if (manner_ != Manner::kBlocks && manner_ != Manner::kRest) return engine_->formula_of_rest();
  searches_.clear();
  engine_ = std::make_unique<TracingEngine>(program_, params_, tracing_, solutions_.size());
  for (const ChosenValues& choices : solutions_) engine_->exclude(choices);
  if (ending_ == Ending::kExhausted) engine_->next();
  engine_->traced().check();
  return engine_->formula_of_rest();
}

void Series::on_improvement(std::function<void(const Solution&)> told) {
  told_ = std::move(told);
  engine_->on_improvement(told_);
}

}  // namespace solitaire
