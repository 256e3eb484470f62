#include "app/watchdog.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "app/report.h"
#include "app/signals.h"

namespace solitaire::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kInterval(20);
/// The time to end in good order, then for a delivery that is going on. With the rest of the end the sum
/// stays under a second.
constexpr std::chrono::milliseconds kGrace(500);
constexpr std::chrono::milliseconds kPatience(300);
/// Memory may go on growing meanwhile.
constexpr std::chrono::milliseconds kGraceForMemory(100);

Clock::time_point after(double seconds) {
  const std::chrono::duration<double> length(std::min(seconds, 1e8));  // more than the clock can count
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(length);
}

constexpr double kMegabyte = 1e6;

/// Returns what the process has in the machine's memory, in bytes. Takes none itself: there may be none.
double resident_memory() {
  std::array<char, 128> text{};
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  const ssize_t length = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  unsigned long pages = 0;
  if (length < 0 || std::sscanf(text.data(), "%*u %lu", &pages) != 1) return 0;
  return static_cast<double>(pages) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/// Looks now and then whether the lock can be had. A timed mutex would wait for it, but ThreadSanitizer does
/// not see how the standard library locks that, and reports races that are none.
bool lock_within(std::chrono::milliseconds patience, Watchdog::Lock& lock) {
  const Clock::time_point end = Clock::now() + patience;
  while (!lock.try_lock()) {
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace

Watchdog::Watchdog(const Options& options)
    : options_(options), finish_([this] { return report_limit(options_); }), stop_(stop_source().token()) {
  if (options.timeout) stop_source().set_deadline(after(*options.timeout));
}

void Watchdog::end() {
  // Notified under the lock: who watches may be gone as soon as it is free.
  const std::lock_guard lock(done_mutex_);
  done_ = true;
  wake_.notify_one();
}

ExitStatus Watchdog::conclude(ExitStatus status) {
  status_ = status;
  return status;
}

void Watchdog::watch() {
  std::unique_lock lock(done_mutex_);
  const auto done = [this] { return done_; };
  while (!stopped()) {
    if (wake_.wait_for(lock, kInterval, done)) return;
  }
  const auto grace = stop_.reason() == api::StopReason::kMemory ? kGraceForMemory : kGrace;
  if (!wake_.wait_for(lock, grace, done)) end_process();
}

bool Watchdog::stopped() {
  if (options_.memory && resident_memory() > *options_.memory * kMegabyte)
    stop_source().request(api::StopReason::kMemory);
  return stop_.stopped();
}

void Watchdog::end_process() {
  Lock lock(mutex_, std::defer_lock);
  if (!lock_within(kPatience, lock)) ::_exit(report_limit(options_, stop_.reason()));
  if (!status_) status_ = status_of(options_, finish_);
  ::_exit(*status_);
}

void Watchdog::set_stop(const StopToken& stop) {
  const std::lock_guard lock(done_mutex_);
  stop_ = stop;
}

Watchdog::AtLimit::AtLimit(Watchdog& watchdog, Finish finish, const StopToken& stop) : watchdog_(watchdog) {
  const Lock lock = watchdog_.delivering();
  former_ = std::exchange(watchdog_.finish_, std::move(finish));
  watchdog_.set_stop(stop);
}

Watchdog::AtLimit::AtLimit(Watchdog& watchdog, Finish finish)
    : AtLimit(watchdog, std::move(finish), stop_source().token()) {}

Watchdog::AtLimit::~AtLimit() {
  const Lock lock = watchdog_.delivering();
  watchdog_.finish_ = std::move(former_);
  watchdog_.set_stop(stop_source().token());
}

}  // namespace solitaire::app
