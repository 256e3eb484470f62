#include "engines/series.h"

#include <algorithm>
#include <fmt/format.h>

namespace solitaire {
namespace {

/// The number of solutions between two starts: few, so that little is to be repeated, but enough that the
/// search does not mainly start.
std::size_t after_start(std::size_t solutions) {
  constexpr std::size_t kLeast = 32;
  return solutions + std::max(kLeast, solutions / 4);
}

/// Whether the values are the same; the kinds are not written down everywhere.
bool same_choices(const KnownChoices& a, const KnownChoices& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const AnsweredChoice& x, const AnsweredChoice& y) {
                      return x.address == y.address && x.value == y.value;
                    });
}

}  // namespace

Series::Series(const Program& program, ParamValues params, const TracingOptions& tracing,
               const SeriesOptions& options)
    : program_(program), params_(std::move(params)), tracing_(tracing), options_(options) {
  start(0);
}

/// A new engine that knows the first of the solutions.
void Series::start(std::size_t solutions) {
  engine_ = std::make_unique<TracingEngine>(program_, params_, tracing_, solutions);
  if (told_) engine_->on_improvement(told_);
  for (std::size_t i = 0; i < solutions; ++i) {
    engine_->exclude(solutions_[i]);
    engine_->keep_away_from(solutions_[i]);
  }
  next_start_ = options_.restarts ? after_start(solutions) : SIZE_MAX;
}

std::vector<Solution> Series::resume(const std::vector<KnownChoices>& earlier) {
  std::vector<Solution> known;
  for (const KnownChoices& choices : earlier) {
    try {
      known.push_back(engine_->run(choices));
    } catch (const NotASolution& error) {
      throw NotASolution(
          fmt::format("solution {} is none of this program: {}", known.size() + 1, error.what()));
    }
  }
  std::size_t last_start = 0;
  while (options_.restarts && after_start(last_start) <= earlier.size()) last_start = after_start(last_start);
  if (!options_.restarts) last_start = earlier.size();
  for (std::size_t i = 0; i < last_start; ++i) results_.add(known[i].execution);
  const auto middle = earlier.begin() + static_cast<std::ptrdiff_t>(last_start);
  solutions_.assign(earlier.begin(), middle);
  to_repeat_.assign(middle, earlier.end());
  start(last_start);
  return known;
}

std::optional<Solution> Series::next() {
  if (!catch_up()) return std::nullopt;
  if (solutions_.size() >= next_start_) start(solutions_.size());
  std::optional<Solution> solution = next_different();
  if (solution) keep(solution->answers);
  return solution;
}

void Series::keep(KnownChoices solution) {
  engine_->keep_away_from(solution);
  solutions_.push_back(std::move(solution));
}

/// If something else comes, then the earlier solutions were found in another way, and the series goes on
/// without repeating any of them.
bool Series::catch_up() {
  while (!to_repeat_.empty()) {
    const std::optional<Solution> solution = next_different();
    if (!solution && ending() == Ending::kStopped) return false;
    if (solution && same_choices(solution->answers, to_repeat_.front())) {
      keep(std::move(to_repeat_.front()));
      to_repeat_.pop_front();
      continue;
    }
    solutions_.insert(solutions_.end(), to_repeat_.begin(), to_repeat_.end());
    to_repeat_.clear();
    results_ = {};
    for (const KnownChoices& choices : solutions_) results_.add(engine_->run(choices).execution);
    start(solutions_.size());
  }
  return true;
}

std::optional<Solution> Series::next_different() {
  while (true) {
    std::optional<Solution> solution = engine_->next();
    if (!solution || results_.add(solution->execution) || !options_.distinct_results) return solution;
    ++alike_;
  }
}

void Series::on_improvement(std::function<void(const Solution&)> told) {
  told_ = std::move(told);
  engine_->on_improvement(told_);
}

}  // namespace solitaire
