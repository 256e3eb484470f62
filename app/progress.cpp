#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "app/console.h"

namespace solitaire::app {
namespace {

constexpr const char* kClearLine = "\r\033[K";

}  // namespace

Progress::Progress(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {
  if (shown_) thread_ = std::thread([this] { run(); });
}

Progress::~Progress() {
  end();
  if (shown_) thread_.join();
}

void Progress::update(std::string line) {
  const std::lock_guard lock(mutex_);
  line_ = std::move(line);
}

void Progress::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  tell(fmt::format("{}{}\n", shown_ ? kClearLine : "", line));
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (shown_ && !done_) tell(kClearLine);
}

void Progress::end() {
  const std::lock_guard lock(mutex_);
  if (shown_ && !done_) tell(kClearLine);
  done_ = true;
  wake_.notify_one();
}

void Progress::run() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, std::chrono::milliseconds(200), [this] { return done_; })) {
    try {
      show();
    } catch (const std::bad_alloc&) {  // the search will meet it, too, and knows what to do
    }
  }
}

void Progress::show() {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  tell(fmt::format("{}{}, {:.1f} s", kClearLine, line_, seconds));
}

}  // namespace solitaire::app
