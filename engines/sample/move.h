#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace solitaire {

/// A kind of step of a chain.
enum class Move : std::uint8_t {
  kPrior,      // a value drawn anew from the choice's distribution
  kOther,      // one of the other values of a finite family, each alike
  kNeighbour,  // an int close by
  kWalk,       // a float close by, on a scale that is tuned
  kGibbs,      // a value drawn from its distribution given all other choices
  kSlice,      // a value that is about as probable as the present one, by slice sampling
  kJoint,      // all floats together, by the No-U-Turn sampler
  kRestart,    // another execution, all of whose choices are drawn anew
  kCount_
};

/// How often a kind of step was tried, and how often it was taken.
struct MoveCount {
  std::uint64_t tried = 0;
  std::uint64_t accepted = 0;
};
using MoveCounts = std::map<std::string, MoveCount>;

/// What makes draws doubtful, whatever they look like.
enum class Trouble : std::uint8_t {
  kDivergence,  // a trajectory whose steps are too long for how the density bends
  kUnbounded,   // along one choice, all others being what they are, the density has no distribution
  kCount_
};

/// How often there was trouble.
struct Troubles {
  std::uint64_t divergences = 0;
  std::uint64_t unbounded = 0;
  std::uint64_t infinities = 0;  // the density was infinite, which counts as impossible
};

class MoveTally {
 public:
  void add(Move move, bool accepted) {
    MoveCount& count = counts_[static_cast<std::size_t>(move)];
    ++count.tried;
    if (accepted) ++count.accepted;
  }
  void add(Trouble trouble) { ++troubles_[static_cast<std::size_t>(trouble)]; }
  void clear() { *this = {}; }
  Troubles troubles() const {
    return {troubles_[static_cast<std::size_t>(Trouble::kDivergence)],
            troubles_[static_cast<std::size_t>(Trouble::kUnbounded)], 0};
  }
  /// Those that were tried, by their names.
  MoveCounts named() const {
    constexpr std::array<const char*, kMoves> kNames = {"prior", "other value", "neighbour", "walk",
                                                        "gibbs", "slice",       "nuts",      "restart"};
    MoveCounts named;
    for (std::size_t i = 0; i < kMoves; ++i)
      if (counts_[i].tried > 0) named[kNames[i]] = counts_[i];
    return named;
  }

 private:
  static constexpr std::size_t kMoves = static_cast<std::size_t>(Move::kCount_);
  std::array<MoveCount, kMoves> counts_{};
  std::array<std::uint64_t, static_cast<std::size_t>(Trouble::kCount_)> troubles_{};
};

}  // namespace solitaire
