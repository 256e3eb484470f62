#include "engines/tiles/job/box_text.h"

#include <charconv>
#include <fmt/format.h>

#include "engines/tiles/request/request_error.h"

namespace solitaire::tiles {
namespace {

constexpr int kMostExtent = 1 << 20;

/// Reads two or three numbers with commas between them. Returns false if that is something else.
bool parse_point(const std::string& text, Point& point) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() < 2 || parts.size() > kAxes) return false;
  for (std::size_t axis = 0; axis < parts.size(); ++axis) {
    const char* const end = parts[axis].data() + parts[axis].size();
    const auto [stop, error] = std::from_chars(parts[axis].data(), end, point[axis]);
    const bool is_far = point[axis] < -kMostExtent || point[axis] > kMostExtent;
    if (error != std::errc{} || stop != end || is_far) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char letter : text) {
    if (letter == separator) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

PinEntry parse_box(const std::string& text) {
  const std::size_t colon = text.find(':');
  PinEntry box;
  bool fits = parse_point(text.substr(0, colon), box.from);
  box.to = box.from;
  if (colon != std::string::npos) fits = parse_point(text.substr(colon + 1), box.to) && fits;
  if (!fits) {
    throw RequestError(
        fmt::format("'{}' is no place of a map; write X,Y or X,Y:X,Y with whole numbers, as 3,4", text));
  }
  for (int& end : box.to) ++end;
  return box;
}

std::array<std::int64_t, 2> parse_far_point(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  std::array<std::int64_t, 2> point{};
  bool fits = parts.size() == point.size();
  for (std::size_t axis = 0; fits && axis < point.size(); ++axis) {
    const char* const end = parts[axis].data() + parts[axis].size();
    const auto [stop, error] = std::from_chars(parts[axis].data(), end, point.at(axis));
    fits = error == std::errc{} && stop == end;
  }
  if (!fits)
    throw RequestError(fmt::format("'{}' is no chunk; write X,Y with whole numbers, as 12,-3", text));
  return point;
}

PinEntry parse_pin(const std::string& text) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) {
    throw RequestError(fmt::format("'{}' is no pin; write X,Y=TILE, as 3,4=door", text));
  }
  PinEntry pin = parse_box(text.substr(0, sign));
  pin.tiles = split(text.substr(sign + 1), '|');
  return pin;
}

}  // namespace solitaire::tiles
