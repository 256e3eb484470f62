#include "base/large_stack.h"

#include <cstddef>
#include <cstdint>
#include <sys/resource.h>
#include <system_error>
#include <thread>

namespace solitaire {
namespace {

void* call(void* work) {
  (*static_cast<const std::function<void()>*>(work))();
  return nullptr;
}

bool start(pthread_t& thread, std::function<void()>& work, std::size_t bytes) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, bytes);
  const bool started = pthread_create(&thread, &attributes, call, &work) == 0;
  pthread_attr_destroy(&attributes);
  return started;
}

/// The largest stack that leaves most of the address space to other things.
std::size_t most_bytes() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return SIZE_MAX;
  return limit.rlim_cur / 4;
}

}  // namespace

LargeStackThread::LargeStackThread(std::function<void()> work) : work_(std::move(work)) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  // Only the part that is used takes memory. Where address space is limited, a smaller stack has to suffice.
  for (const std::size_t size : {1024 * kMiB, 256 * kMiB, 64 * kMiB}) {
    if (size <= most_bytes() && start(thread_, work_, size)) return;
  }
  throw std::system_error(EAGAIN, std::generic_category(), "no thread can be had");
}

LargeStackThread::~LargeStackThread() { pthread_join(thread_, nullptr); }

void run_on_large_stack(const std::function<void()>& work, const std::function<void()>& beside) {
  try {
    const LargeStackThread thread(work);
    if (beside) beside();
  } catch (const std::system_error&) {
    std::thread other;
    if (beside) other = std::thread(beside);
    work();
    if (other.joinable()) other.join();
  }
}

}  // namespace solitaire
