#include "library/draw_order.h"

namespace solitaire::api {

void DrawOrder::add(std::size_t chain, const std::vector<std::string>& names,
                    const std::vector<double>& numbers) {
  const std::lock_guard lock(mutex_);
  Waiting& own = waiting_[chain];
  SampledDraw draw{chain + 1, ++own.drawn, names, numbers};
  if (chain == turn_) {
    call_(draw);
  } else {
    own.draws.push_back(std::move(draw));
  }
}

void DrawOrder::end(std::size_t chain) {
  const std::lock_guard lock(mutex_);
  ended_[chain] = true;
  while (turn_ < ended_.size() && ended_[turn_]) {
    if (++turn_ == ended_.size()) return;
    for (const SampledDraw& draw : waiting_[turn_].draws) call_(draw);
    waiting_[turn_].draws = {};
  }
}

}  // namespace solitaire::api
