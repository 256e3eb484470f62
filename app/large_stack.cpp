#include "app/large_stack.h"

#include <cstddef>
#include <pthread.h>

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

}  // namespace

void run_on_large_stack(const std::function<void()>& work) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  // Only what is used of it takes memory; where address space is limited, less has to do.
  for (const std::size_t size : {1024 * kMiB, 256 * kMiB, 64 * kMiB}) {
    if (run_with(work, size)) return;
  }
  work();
}

}  // namespace solitaire
