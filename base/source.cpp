#include "base/source.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <utf8.h>
#include <utility>

namespace solitaire {
namespace {

bool starts_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

}  // namespace

Source::Source(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), line_starts_{0} {
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') line_starts_.push_back(static_cast<std::uint32_t>(i + 1));
  }
  characters_.push_back(0);
  for (std::size_t start = 0; start + kBlock <= text_.size(); start += kBlock)
    characters_.push_back(characters_.back() + count_characters(this->text().substr(start, kBlock)));
}

std::size_t Source::characters_before(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const std::size_t block = offset / kBlock;
  return characters_[block] + count_characters(text().substr(block * kBlock, offset % kBlock));
}

Position Source::position(std::uint32_t offset) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const std::size_t line = static_cast<std::size_t>(after - line_starts_.begin());
  return {line, 1 + characters_before(offset) - characters_before(*(after - 1))};
}

std::optional<std::uint32_t> Source::offset(Position position) const {
  if (position.line < 1 || position.line > line_starts_.size()) return std::nullopt;
  const std::string_view text = line(position.line);
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (starts_character(text[at])) ++column;
    if (column == position.column) return line_starts_[position.line - 1] + static_cast<std::uint32_t>(at);
  }
  return std::nullopt;
}

std::string_view Source::line(std::size_t number) const {
  const std::size_t start = line_starts_[number - 1];
  std::size_t end = number < line_starts_.size() ? line_starts_[number] - 1 : text_.size();
  if (end > start && text_[end - 1] == '\r') --end;
  return text().substr(start, end - start);
}

std::uint32_t SourceSet::add(std::string name, std::string text) {
  sources_.emplace_back(std::move(name), std::move(text));
  return static_cast<std::uint32_t>(sources_.size() - 1);
}

std::string_view SourceSet::text(Span span) const {
  return sources_[span.source].text().substr(span.begin, span.end - span.begin);
}

std::string SourceSet::place(Span span) const {
  const Source& source = sources_[span.source];
  const Position at = source.position(span.begin);
  return fmt::format("{}:{}:{}", source.name(), at.line, at.column);
}

std::optional<Span> SourceSet::span_at(const std::string& place) const {
  const std::size_t column_sign = place.rfind(':');
  const std::size_t line_sign = place.rfind(':', column_sign - 1);
  if (column_sign == std::string::npos || line_sign == std::string::npos) return std::nullopt;
  Position position;
  const auto read = [&](std::size_t from, std::size_t to, std::size_t& number) {
    return std::from_chars(place.data() + from, place.data() + to, number).ptr == place.data() + to;
  };
  if (!read(line_sign + 1, column_sign, position.line) ||
      !read(column_sign + 1, place.size(), position.column))
    return std::nullopt;
  const std::string file = place.substr(0, line_sign);
  for (std::uint32_t number = 0; number < size(); ++number) {
    const std::string& name = sources_[number].name();
    if (name != file && std::filesystem::path(name).filename() != file) continue;
    if (const auto begin = sources_[number].offset(position)) return Span{number, *begin, *begin + 1};
  }
  return std::nullopt;
}

std::size_t count_characters(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), starts_character));
}

std::size_t find_broken_utf8(std::string_view text) {
  return static_cast<std::size_t>(utf8::find_invalid(text.begin(), text.end()) - text.begin());
}

std::string mended_utf8(std::string_view text) {
  std::string mended;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(mended));
  return mended;
}

}  // namespace solitaire
