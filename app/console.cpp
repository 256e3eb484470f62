#include "app/console.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <solitaire/error.h>
#include <unistd.h>

#include "app/signals.h"

namespace solitaire::app {
namespace {

/// A write waits so long for its reader once the run was stopped.
constexpr std::chrono::milliseconds kPatience(250);

class Stream {
 public:
  explicit Stream(int descriptor) : descriptor_(descriptor) {}

  /// Writes the text. Returns 0 or an error number, which is ECANCELED if nobody reads and the run was
  /// stopped.
  int write(std::string_view text) {
    while (!text.empty()) {
      if (!wait_until_ready()) return ECANCELED;
      // A pipe that is ready takes so much without waiting.
      const ssize_t written = ::write(descriptor_, text.data(), std::min<std::size_t>(text.size(), PIPE_BUF));
      if (written >= 0) {
        text.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno != EINTR && errno != EAGAIN) {
        return errno;
      }
    }
    return 0;
  }

 private:
  bool wait_until_ready() {
    using Clock = std::chrono::steady_clock;
    Clock::time_point given_up = Clock::time_point::max();
    const StopToken stop = stop_source().token();
    pollfd ready{descriptor_, POLLOUT, 0};
    while (::poll(&ready, 1, 20) <= 0) {
      if (!stop.stopped()) continue;
      const auto now = Clock::now();
      given_up = std::min(given_up, now + kPatience);
      if (now >= given_up) unread_ = true;
      if (unread_) return false;
    }
    return true;
  }

  int descriptor_;
  std::atomic<bool> unread_ = false;  // patience is spent only once
};

}  // namespace

void print_result(std::string_view text) {
  static Stream stream(STDOUT_FILENO);
  const int error = stream.write(text);
  if (error == ECANCELED) throw Error(Error::Kind::kStopped, "interrupted");
  if (error != 0) throw Error(Error::Kind::kFile, fmt::format("standard output: {}", std::strerror(error)));
}

void tell(std::string_view text) {
  static Stream stream(STDERR_FILENO);
  stream.write(text);
}

void reserve_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // The lowest free descriptor is taken; one that is open for reading only, so that writes to it fail.
    if (::fcntl(descriptor, F_GETFD) < 0) ::open("/dev/null", O_RDONLY);
  }
}

}  // namespace solitaire::app
