#pragma once
#include <stdexcept>

namespace solitaire {

/// Solitaire itself is wrong: for example, a model of the formula is not an execution of the program.
class InternalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Choices that are known from before are not those of a solution of this program.
class NotASolution : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A pin matches none of the program's choices, and the message names those nearest; or it gives a choice a
/// value of another type.
class UnmatchedPin : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A program without a map of tiles, for an engine that draws these.
class NoTileMap : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Uniform sampling of a program whose solutions are not to be equally probable, since it prefers some.
class UnequalSolutions : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace solitaire
