#include "scene/page/deflate.h"

#include <algorithm>
#include <cstdint>
#include <new>
#include <zlib.h>

namespace solitaire {
namespace {

constexpr int kThorough = 6, kQuick = 1;              // levels of zlib
constexpr std::size_t kLarge = std::size_t{8} << 20;  // bytes for which thoroughness would take seconds

std::string deflated(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), bytes.size() < kLarge ? kThorough : kQuick);
  if (result != Z_OK) throw std::bad_alloc();  // the buffer is large enough, so nothing else can fail
  packed.resize(size);
  return packed;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t taken = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i)
      group = group << 8U | (i < taken ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) text += i <= taken ? kDigits[group >> (18 - 6 * i) & 63U] : '=';
  }
  return text;
}

}  // namespace

std::string deflated_base64(std::string_view bytes) { return base64(deflated(bytes)); }

}  // namespace solitaire
