#include "app/watchdog.h"

#include <array>
#include <cstdio>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#include "app/report.h"

namespace solitaire {
namespace {

constexpr std::chrono::milliseconds kInterval(20);
/// The time to end in good order, then for a delivery that is going on. With the rest of the end the sum
/// stays under a second.
constexpr std::chrono::milliseconds kGrace(500);
constexpr std::chrono::milliseconds kPatience(300);
/// Memory may go on growing meanwhile.
constexpr std::chrono::milliseconds kGraceForMemory(100);

StopSignal::Clock::time_point after(std::optional<double> seconds) {
  if (!seconds) return StopSignal::Clock::time_point::max();
  const std::chrono::duration<double> length(std::min(*seconds, 1e8));  // more than the clock can count
  return StopSignal::Clock::now() + std::chrono::duration_cast<StopSignal::Clock::duration>(length);
}

constexpr double kMegabyte = 1e6;

/// What the process has in the machine's memory, in bytes. Takes none itself: there may be none.
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

}  // namespace

Watchdog::Watchdog(const Options& options)
    : options_(options),
      deadline_(after(options.timeout)),
      finish_([this] { return report_limit(options_); }) {
  look();  // a limit of nothing holds from the start
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
  while (!stop_.stopped()) {
    if (wake_.wait_for(lock, kInterval, done)) return;
    look();
  }
  const auto grace = stop_.reason() == StopReason::kMemory ? kGraceForMemory : kGrace;
  if (!wake_.wait_for(lock, grace, done)) end_process();
}

void Watchdog::look() {
  const auto now = Clock::now();
  if (now >= deadline_) stop_.request(StopReason::kTime);
  if (now >= solution_deadline_.load()) stop_.request(StopReason::kTimePerSolution);
  if (options_.memory && resident_memory() > *options_.memory * kMegabyte) stop_.request(StopReason::kMemory);
}

void Watchdog::end_process() {
  Lock lock(mutex_, std::defer_lock);
  if (!lock.try_lock_for(kPatience)) ::_exit(report_limit(options_));
  if (!status_) status_ = status_of(options_, finish_);
  ::_exit(*status_);
}

Watchdog::AtLimit::AtLimit(Watchdog& watchdog, Finish finish) : watchdog_(watchdog) {
  const Lock lock = watchdog_.delivering();
  former_ = std::exchange(watchdog_.finish_, std::move(finish));
}

Watchdog::AtLimit::~AtLimit() {
  const Lock lock = watchdog_.delivering();
  watchdog_.finish_ = std::move(former_);
}

Watchdog::SolutionTime::SolutionTime(Watchdog& watchdog) : watchdog_(watchdog) {
  const auto deadline = after(watchdog_.options_.per_solution);
  watchdog_.solution_deadline_ = deadline;
  if (Clock::now() >= deadline) watchdog_.stop_.request(StopReason::kTimePerSolution);  // no time at all
}

void Watchdog::SolutionTime::extend() {
  const auto deadline = watchdog_.solution_deadline_.load();
  if (extended_ || deadline == Clock::time_point::max()) return;
  extended_ = true;
  watchdog_.solution_deadline_ = deadline + kPatience;
}

Watchdog::SolutionTime::~SolutionTime() { watchdog_.solution_deadline_ = Clock::time_point::max(); }

}  // namespace solitaire
