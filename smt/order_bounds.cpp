#include "smt/order_bounds.h"

#include <unordered_map>

namespace solitaire {

void OrderBounds::build(std::size_t variables) {
  std::unordered_map<const std::vector<int>*, std::uint32_t> numbers;
  const auto chain = [&](const std::vector<int>* literals) {
    const auto [at, is_new] = numbers.try_emplace(literals, static_cast<std::uint32_t>(chains_.size()));
    if (is_new) chains_.push_back({*literals, {}, {}, 0, static_cast<std::uint32_t>(literals->size())});
    return at->second;
  };
  std::vector<Step> steps;
  for (const auto& [guard, lower, upper, first, base, count] : ladders_) {
    steps.push_back({guard, chain(lower), chain(upper), first, base, count});
    chains_[steps.back().lower].as_lower.push_back(steps.back());
    chains_[steps.back().upper].as_upper.push_back(steps.back());
  }
  ladders_ = {};
  guarded_ = {variables, [&](const auto& put) {
                for (const Step& step : steps) put(step.guard, step);
              }};
  places_ = {variables, [&](const auto& put) {
               for (std::uint32_t i = 0; i < chains_.size(); ++i) {
                 const std::span<const int> literals = chains_[i].literals;
                 for (std::uint32_t at = 0; at < literals.size(); ++at) put(literals[at], Place{i, at});
               }
             }};
}

/// Takes note that the literal at a place holds; whether that is new.
bool OrderBounds::raise(Place place) {
  Chain& chain = chains_[place.chain];
  if (place.position < chain.reached) return false;
  changed_.push_back({place.chain, chain.reached, chain.limit});
  chain.reached = place.position + 1;
  return true;
}

/// The same of one that does not hold.
bool OrderBounds::lower(Place place) {
  Chain& chain = chains_[place.chain];
  if (place.position >= chain.limit) return false;
  changed_.push_back({place.chain, chain.reached, chain.limit});
  chain.limit = place.position;
  return true;
}

void OrderBounds::undo_to(std::size_t changes) {
  for (; changed_.size() > changes; changed_.pop_back()) {
    Chain& chain = chains_[changed_.back().chain];
    chain.reached = changed_.back().reached;
    chain.limit = changed_.back().limit;
  }
}

}  // namespace solitaire
