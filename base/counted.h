#pragma once
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace solitaire {

/// How many there are, in words: "1 map", "3 maps". The noun's plural has to end in s.
inline std::string counted(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace solitaire
