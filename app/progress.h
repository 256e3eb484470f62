#pragma once
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace solitaire {

/// A line on standard error that says how far the work is, several times a second; only if that is a
/// terminal.
class Progress {
 public:
  Progress(bool wanted, std::uint64_t goal);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::uint64_t solutions, std::size_t nodes);
  /// Shows a line above the progress, terminal or not.
  void say(const std::string& line);
  /// Takes the progress line away, for good.
  void end();

 private:
  void run();
  void show();

  bool shown_;
  std::uint64_t goal_;  // 0: as many as there are
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::uint64_t solutions_ = 0;
  std::size_t nodes_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::thread thread_;
};

}  // namespace solitaire
