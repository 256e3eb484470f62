#pragma once
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace solitaire::app {

/// A line on standard error that says how far the work is, several times a second; only if that is a
/// terminal.
class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Sets what the line says; the time is added.
  void update(std::string line);
  /// Shows a line above the progress, terminal or not.
  void say(const std::string& line);
  /// Takes the line away until it is next shown.
  void clear();
  /// Takes the progress line away, for good.
  void end();

 private:
  void run();
  void show();

  bool shown_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::string line_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::thread thread_;
};

}  // namespace solitaire::app
