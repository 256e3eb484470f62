#include "tests/generator/byte_source.h"

#include "base/hash.h"

namespace solitaire {

std::uint8_t ByteSource::next() {
  if (data_ != nullptr) {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  state_ = mix(state_, 1);
  return static_cast<std::uint8_t>(state_ >> 32);
}

std::uint32_t ByteSource::below(std::uint32_t bound) { return bound <= 1 ? 0 : next() % bound; }

}  // namespace solitaire
