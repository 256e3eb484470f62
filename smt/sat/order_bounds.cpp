#include "smt/sat/order_bounds.h"

namespace solitaire {

void OrderBounds::add(const OrderImplication& order_implication) {
  steps_.push_back({order_implication.guard, chain(order_implication.lower), chain(order_implication.upper),
                    order_implication.first, order_implication.base, order_implication.count});
}

/// Returns the number of a chain. A chain that was not seen before gets a new one.
std::uint32_t OrderBounds::chain(const std::vector<int>* literals) {
  const auto [at, is_new] = numbers_.try_emplace(literals, static_cast<std::uint32_t>(chains_.size()));
  if (is_new) chains_.push_back({*literals, 0, static_cast<std::uint32_t>(literals->size())});
  return at->second;
}

void OrderBounds::build(std::size_t variables) {
  built_ = steps_.size();
  const auto by_chain = [this](std::uint32_t Step::*chain) {
    return GroupedTable<std::uint32_t>(chains_.size(), [=, this](const auto& put) {
      for (std::uint32_t i = 0; i < built_; ++i) put(steps_[i].*chain, i);
    });
  };
  as_lower_ = by_chain(&Step::lower);
  as_upper_ = by_chain(&Step::upper);
  guarded_ = {variables, [this](const auto& put) {
                for (std::uint32_t i = 0; i < built_; ++i) put(steps_[i].guard, i);
              }};
  places_ = {variables, [this](const auto& put) {
               for (std::uint32_t i = 0; i < chains_.size(); ++i) {
                 const std::span<const int> literals = chains_[i].literals;
                 for (std::uint32_t at = 0; at < literals.size(); ++at) put(literals[at], Place{i, at});
               }
             }};
  numbers_ = {};
}

/// Takes note that the literal at a place holds. Returns true if that changes the bound.
bool OrderBounds::raise(Place place) {
  Chain& chain = chains_[place.chain];
  if (place.position < chain.reached) return false;
  changed_.push_back({place.chain, chain.reached, chain.limit});
  chain.reached = place.position + 1;
  return true;
}

/// Takes note that the literal at a place does not hold. Returns true if that changes the bound.
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
