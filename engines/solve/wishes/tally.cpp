#include "engines/solve/wishes/tally.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace solitaire {

/// The parts are halved again and again, so that the tree is as deep as the logarithm of their number.
Tally::Tally(std::vector<std::unique_ptr<Tally>> parts) {
  if (parts.size() == 1) {
    *this = std::move(*parts.front());
    return;
  }
  const auto middle = parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 2);
  const auto half = [](auto begin, auto end) {
    return std::make_unique<Tally>(
        std::vector<std::unique_ptr<Tally>>(std::move_iterator(begin), std::move_iterator(end)));
  };
  one_ = half(parts.begin(), middle);
  other_ = half(middle, parts.end());
  most_ = one_->most() + other_->most();
}

std::unique_ptr<Tally> Tally::of(const std::vector<NodeId>& conditions) {
  std::vector<std::unique_ptr<Tally>> parts;
  for (const NodeId condition : conditions)
    parts.push_back(std::make_unique<Tally>(std::vector{kTrue, condition}));
  return std::make_unique<Tally>(std::move(parts));
}

NodeId Tally::at_least(Graph& graph, std::size_t number) {
  while (reached_.size() <= number) reached_.push_back(next(graph));
  return reached_[number];
}

/// Makes the condition of the next number: some of it comes together in the one half, the rest in the other.
NodeId Tally::next(Graph& graph) {
  const std::size_t number = reached_.size();
  NodeId any = kFalse;
  for (std::size_t i = number - std::min(number, other_->most()); i <= std::min(number, one_->most()); ++i)
    any = graph.disjunction(any,
                            graph.conjunction(one_->at_least(graph, i), other_->at_least(graph, number - i)));
  return any;
}

}  // namespace solitaire
