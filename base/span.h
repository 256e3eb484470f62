#pragma once
#include <compare>
#include <cstdint>

namespace solitaire {

/// A stretch of source text: bytes [begin, end) of the source with that number. What the trace graph
/// remembers of a program is only such spans; whoever owns the sources turns them into lines and carets.
struct Span {
  std::uint32_t source = 0;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend auto operator<=>(const Span&, const Span&) = default;
};

/// Returns the span from the start of `first` to the end of `last`.
constexpr Span cover(Span first, Span last) { return {first.source, first.begin, last.end}; }

}  // namespace solitaire
