#pragma once
#include <cstddef>
#include <cstdint>

namespace solitaire {

/// What decides how a generated program looks: the bytes of a fuzzer's input and then zeros, or as many
/// random ones as it takes.
class ByteSource {
 public:
  explicit ByteSource(std::uint64_t seed) : state_(seed) {}
  ByteSource(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  /// Returns 0 .. bound - 1. Zero bytes give zeros: a generator that puts its simplest case first comes to an
  /// end.
  std::uint32_t below(std::uint32_t bound);

 private:
  std::uint8_t next();

  const std::uint8_t* data_ = nullptr;
  std::size_t left_ = 0;
  std::uint64_t state_ = 0;
};

}  // namespace solitaire
