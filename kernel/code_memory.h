#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sys/mman.h>
#include <vector>

namespace solitaire {

/// Memory for machine code, of which functions stand one behind the other: each page that a step comes to
/// costs the processor a look-up. It is never written and executed at the same time.
class CodeMemory {
 public:
  CodeMemory() = default;
  CodeMemory(const CodeMemory&) = delete;
  CodeMemory& operator=(const CodeMemory&) = delete;
  ~CodeMemory() {
    for (const Chunk& chunk : chunks_) munmap(chunk.start, chunk.size);
  }

  /// Room for so many bytes, to be written before take() is called; nothing where the system gives none.
  /// Until then no function can be called.
  std::uint8_t* room(std::size_t bytes) {
    const bool fits = !chunks_.empty() && chunks_.back().size - used_ >= bytes + kAlignment;
    if (!(fits ? protect(PROT_READ | PROT_WRITE) : add(std::max(bytes, kUsualSize)))) return nullptr;
    return chunks_.back().start + used_;
  }
  /// Makes a function of the first bytes of that room. Returns false where the system does not let memory be
  /// executed that was written.
  bool take(std::size_t bytes) {
    used_ += (bytes + kAlignment - 1) / kAlignment * kAlignment;
    return protect(PROT_READ | PROT_EXEC);
  }

 private:
  struct Chunk {
    std::uint8_t* start;
    std::size_t size;
  };
  static constexpr std::size_t kUsualSize = std::size_t{1} << 18;
  static constexpr std::size_t kAlignment = 16;  // of functions

  bool add(std::size_t size) {
    size += kAlignment;
    void* const made = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (made == MAP_FAILED) return false;
    chunks_.push_back({static_cast<std::uint8_t*>(made), size});
    used_ = 0;
    return true;
  }
  bool protect(int mode) const { return mprotect(chunks_.back().start, chunks_.back().size, mode) == 0; }

  std::vector<Chunk> chunks_;
  std::size_t used_ = 0;  // of the last one
};

}  // namespace solitaire
