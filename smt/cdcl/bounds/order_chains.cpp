#include "smt/cdcl/bounds/order_chains.h"

namespace solitaire {

std::uint32_t OrderChains::number(const std::vector<int>* literals) {
  const auto [at, is_new] = numbers_.try_emplace(literals, static_cast<std::uint32_t>(chains_.size()));
  if (is_new) chains_.push_back({*literals, 0, static_cast<std::uint32_t>(literals->size())});
  return at->second;
}

void OrderChains::build(std::size_t variables) {
  places_ = {variables, [this](const auto& put) {
               for (std::uint32_t i = 0; i < chains_.size(); ++i) {
                 const std::span<const int> literals = chains_[i].literals;
                 for (std::uint32_t at = 0; at < literals.size(); ++at) put(literals[at], Place{i, at});
               }
             }};
  numbers_ = {};
}

bool OrderChains::raise(Place place) {
  Chain& chain = chains_[place.chain];
  if (place.position < chain.reached) return false;
  changed_.push_back({place.chain, chain.reached, chain.limit});
  chain.reached = place.position + 1;
  return true;
}

bool OrderChains::lower(Place place) {
  Chain& chain = chains_[place.chain];
  if (place.position >= chain.limit) return false;
  changed_.push_back({place.chain, chain.reached, chain.limit});
  chain.limit = place.position;
  return true;
}

std::pair<std::uint32_t, OrderChains::Chain> OrderChains::undo_last() {
  const Bounds before = changed_.back();
  changed_.pop_back();
  Chain& chain = chains_[before.chain];
  const Chain after = chain;
  chain.reached = before.reached;
  chain.limit = before.limit;
  return {before.chain, after};
}

}  // namespace solitaire
