#include "app/large_stack.h"

#include <cstddef>
#include <cstdint>
#include <malloc.h>
#include <pthread.h>
#include <sys/resource.h>

namespace solitaire {
namespace {

void* call(void* work) {
  (*static_cast<const std::function<void()>*>(work))();
  return nullptr;
}

bool run_with(const std::function<void()>& work, std::size_t bytes) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, bytes);
  pthread_t thread = {};
  const bool started =
      pthread_create(&thread, &attributes, call, const_cast<std::function<void()>*>(&work)) == 0;
  pthread_attr_destroy(&attributes);
  if (started) pthread_join(thread, nullptr);
  return started;
}

/// The largest stack that leaves most of the address space to other things.
std::size_t most_bytes() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return SIZE_MAX;
  return limit.rlim_cur / 4;
}

}  // namespace

void run_on_large_stack(const std::function<void()>& work) {
  // One thread does the work: its memory is to grow in large steps, as the first thread's would.
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TOP_PAD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  // Only what is used of it takes memory; where address space is limited, less has to do.
  for (const std::size_t size : {1024 * kMiB, 256 * kMiB, 64 * kMiB}) {
    if (size <= most_bytes() && run_with(work, size)) return;
  }
  work();
}

}  // namespace solitaire
