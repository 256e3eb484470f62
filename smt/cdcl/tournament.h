#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace solitaire {

/// Numbers at places, of which the least is known at any time. Changing a number takes time by the logarithm
/// of how many places there are: it plays again against the others on its way up a binary tree of winners.
class Tournament {
 public:
  /// The number of a place that was never set. A place with this number loses against all others.
  static constexpr std::size_t kOut = SIZE_MAX;

  void set(std::size_t place, std::size_t number) {
    if (place >= numbers_.size()) grow(place + 1);
    if (numbers_[place] == number) return;
    numbers_[place] = number;
    for (std::size_t match = (numbers_.size() + place) / 2; match > 0; match /= 2) play(match);
  }
  /// Returns the place of the least number, the first of several. Some place has to be set.
  std::size_t first() const { return winners_[1]; }
  /// Returns the least number.
  std::size_t least() const { return winners_.empty() ? kOut : numbers_[first()]; }

 private:
  void grow(std::size_t places) {
    std::size_t size = numbers_.empty() ? 2 : numbers_.size();
    while (size < places) size *= 2;
    numbers_.resize(size, kOut);
    winners_.resize(size);
    for (std::size_t match = size - 1; match > 0; --match) play(match);
  }

  /// Returns the place that plays at a node of the tree. Place i is the leaf numbers_.size() + i.
  std::size_t player(std::size_t at) const {
    return at < numbers_.size() ? winners_[at] : at - numbers_.size();
  }
  void play(std::size_t match) {
    const std::size_t a = player(2 * match);
    const std::size_t b = player(2 * match + 1);
    winners_[match] = numbers_[b] < numbers_[a] ? b : a;
  }

  std::vector<std::size_t> numbers_;  // by place; as many as a power of two
  std::vector<std::size_t> winners_;  // by match: the place of its winner; match 1 is the last one
};

}  // namespace solitaire
