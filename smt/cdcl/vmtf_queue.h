#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace solitaire {

/// Keeps variables in the order in which they had a part in conflicts, the latest first (variable move to
/// front; Ryan 2004, Biere and Fröhlich 2015).
class VmtfQueue {
 public:
  /// Moves the variables to the front, and leaves their order among each other as it is.
  void move_to_front(std::span<const int> variables);
  /// Returns the first variable for which is_open(variable) holds, or 0 if there is none. From call to call
  /// it goes on where it stopped, unless open() was called for an earlier variable.
  template <class IsOpen>
  int first_open(IsOpen is_open) {
    while (next_ != 0 && !is_open(next_)) next_ = link(next_).behind;
    return next_;
  }
  /// Has to be called when a variable becomes open again.
  void open(int variable) {
    const auto at = static_cast<std::size_t>(variable);
    if (at >= links_.size()) return;
    if (links_[at].moved > (next_ == 0 ? 0 : link(next_).moved)) next_ = variable;
  }
  /// Forgets everything.
  void clear();

 private:
  /// The neighbours of a variable in the queue, which are 0 at its ends.
  struct Link {
    int ahead = 0, behind = 0;
    std::uint64_t moved = 0;  // the number of its last move to the front, counted from 1; 0: never moved
  };

  /// A variable that is to be moved. They are sorted by their last move, then by their place among those
  /// given.
  struct Moving {
    std::uint64_t moved;
    std::size_t place;
    int variable;
    friend auto operator<=>(const Moving&, const Moving&) = default;
  };

  Link& link(int variable) { return links_[static_cast<std::size_t>(variable)]; }
  void take_out(int variable);
  void put_first(int variable);

  std::vector<Link> links_;  // by variable
  int front_ = 0;
  int next_ = 0;  // the variables ahead of this one are not open
  std::uint64_t moves_ = 0;
  std::vector<Moving> moving_;
};

}  // namespace solitaire
