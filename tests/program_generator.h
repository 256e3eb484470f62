#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace solitaire {

/// What decides how a generated program looks: the bytes of a fuzzer's input and then zeros, or as many
/// random ones as it takes.
class ByteSource {
 public:
  explicit ByteSource(std::uint64_t seed) : state_(seed) {}
  ByteSource(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  /// 0 .. bound - 1. Zero bytes give zeros: a generator that puts its simplest case first comes to an end.
  std::uint32_t below(std::uint32_t bound);

 private:
  std::uint8_t next();

  const std::uint8_t* data_ = nullptr;
  std::size_t left_ = 0;
  std::uint64_t state_ = 0;
};

/// A program that ends in every execution and uses all of the language, with so few choices that most often
/// all executions can be run. One statement a line, so that a program that fails can be made smaller by
/// lines.
std::string generate_program(ByteSource& bytes);

}  // namespace solitaire
