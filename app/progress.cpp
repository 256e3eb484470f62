#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

namespace solitaire {

Progress::Progress(bool wanted, std::uint64_t goal)
    : shown_(wanted && isatty(STDERR_FILENO) != 0), goal_(goal) {
  if (shown_) thread_ = std::thread([this] { run(); });
}

Progress::~Progress() {
  if (!shown_) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_one();
  thread_.join();
  clear();
}

void Progress::update(std::uint64_t solutions, std::size_t nodes) {
  const std::lock_guard lock(mutex_);
  solutions_ = solutions;
  nodes_ = nodes;
}

void Progress::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  fmt::print(stderr, "{}{}\n", shown_ ? "\r\033[K" : "", line);
}

void Progress::clear() {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  fmt::print(stderr, "\r\033[K");
}

void Progress::run() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::milliseconds(200), [this] { return done_; })) show();
}

void Progress::show() {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const std::string count = goal_ > 0 ? fmt::format("{} of {} solutions", solutions_, goal_)
                                      : fmt::format("{} solutions", solutions_);
  const std::string graph = nodes_ > 0 ? fmt::format(", graph of {} nodes", nodes_) : "";
  fmt::print(stderr, "\r\033[K{}{}, {:.1f} s", count, graph, seconds);
}

}  // namespace solitaire
