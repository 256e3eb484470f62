#include "library/search_state.h"

namespace solitaire::api {

SearchAccount::Compared SearchAccount::compared(const solitaire::Solution& solution, bool with_result) {
  if (!with_result) return {};
  return {choice_features(solution.choices), result_features(solution)};
}

void SearchAccount::count(const Compared& compared) {
  choice_distance_.add(compared.choices);
  nearest_choices_.add(compared.choices);
  result_distance_.add(compared.results);
  ++solutions_;
}

std::uint64_t SearchAccount::add(const solitaire::Solution& solution, bool with_result, bool earlier) {
  const Compared features = compared(solution, with_result);
  const std::lock_guard lock(mutex_);
  best_.reset();
  count(features);
  if (earlier) ++earlier_;
  return solutions_;
}

void SearchAccount::set_times(const EngineTimes& times) {
  const std::lock_guard lock(mutex_);
  times_ = times;
}

void SearchAccount::set_best(Solution best, const solitaire::Solution& solution) {
  Compared features = compared(solution, true);
  const std::lock_guard lock(mutex_);
  best.number = solutions_ + 1;
  best_.emplace(std::move(best), std::move(features));
}

void SearchAccount::forget_best() {
  const std::lock_guard lock(mutex_);
  best_.reset();
}

std::optional<Solution> SearchAccount::take_best() {
  const std::lock_guard lock(mutex_);
  if (!best_) return std::nullopt;
  std::optional<Solution> taken = std::move(best_->first);
  count(best_->second);
  best_.reset();
  return taken;
}

std::uint64_t SearchAccount::solutions() const {
  const std::lock_guard lock(mutex_);
  return solutions_;
}

Summary SearchAccount::summary(std::uint64_t alike, bool names_differed) const {
  const std::lock_guard lock(mutex_);
  return {solutions_,
          earlier_,
          alike,
          names_differed,
          choice_distance_.value(),
          nearest_choices_.value(),
          result_distance_.value(),
          {times_.explore, times_.encode, times_.solve, times_.replay, times_.replays}};
}

}  // namespace solitaire::api
