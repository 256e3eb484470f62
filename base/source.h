#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"

namespace solitaire {

/// A position as editors show it: both counted from 1, columns in characters rather than bytes.
struct Position {
  std::size_t line = 1;
  std::size_t column = 1;
};

/// One text of a program: the script itself or a file it imports.
class Source {
 public:
  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  /// Returns the position of a byte; an offset behind the text is at its end.
  Position position(std::uint32_t offset) const;
  /// Returns the offset of the character at a position; nothing if there is none.
  std::optional<std::uint32_t> offset(Position position) const;
  /// Returns a line's text without its end; lines count from 1.
  std::string_view line(std::size_t number) const;

 private:
  /// Counting the characters of a line starts at a block, so that long lines take no longer than others.
  static constexpr std::size_t kBlock = 256;

  std::size_t characters_before(std::size_t offset) const;

  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_starts_;
  std::vector<std::size_t> characters_;  // how many there are before each block of kBlock bytes
};

/// All sources of a program; spans refer to them by number.
class SourceSet {
 public:
  std::uint32_t add(std::string name, std::string text);
  const Source& operator[](std::uint32_t number) const { return sources_[number]; }
  std::size_t size() const { return sources_.size(); }

  std::string_view text(Span span) const;
  /// Returns where a span starts: "file.sol:12:3".
  std::string place(Span span) const;
  /// Returns the span of the character at such a place, whose file may be named without its folder; nothing
  /// if there is none.
  std::optional<Span> span_at(const std::string& place) const;

 private:
  std::deque<Source> sources_;  // a deque, so that views of the texts stay valid
};

/// Counts the characters, not the bytes, of UTF-8 text; broken bytes count as one each.
std::size_t count_characters(std::string_view utf8);

/// Returns where the first byte stands that makes a text no UTF-8; the text's length if there is none.
std::size_t find_broken_utf8(std::string_view text);

/// Returns the text with U+FFFD in the place of what is no UTF-8.
std::string mended_utf8(std::string_view text);

}  // namespace solitaire
