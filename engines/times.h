#pragma once
#include <chrono>
#include <cstdint>

namespace solitaire {

/// Says on what an engine spent its time, in seconds, and how many solutions were run again.
struct EngineTimes {
  double explore = 0, encode = 0, solve = 0, replay = 0;
  std::uint64_t replays = 0;

  EngineTimes& operator+=(const EngineTimes& other) {
    explore += other.explore;
    encode += other.encode;
    solve += other.solve;
    replay += other.replay;
    replays += other.replays;
    return *this;
  }
};

/// Adds the time until its end to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace solitaire
