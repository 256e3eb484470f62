#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <solitaire/export.h>
#include <solitaire/options.h>
#include <solitaire/program.h>
#include <string>

namespace solitaire::api {

struct CountOptions : Options {
  enum class Way : std::uint8_t {
    kExactIfSmall,  // exactly where that takes no long time, else an estimate
    kExact,
    kApproximate,
  };
  Way way = Way::kExactIfSmall;
  double tolerance = 0.8;   // an estimate is within a factor of 1 + so much
  double confidence = 0.9;  // with at least this probability
};

/// The number of solutions.
struct Count {
  std::string digits;  // the number, if it is exact, or a bound from below
  double log10 = 0;    // its logarithm, also of an estimate
  enum class Kind : std::uint8_t { kExact, kEstimate, kAtLeast } kind = Kind::kExact;
  double tolerance = 0, confidence = 0;  // of an estimate
};

/// Returns the count on a line for people, or as one JSON object; without a newline.
SOLITAIRE_API std::string to_text(const Count& count);
SOLITAIRE_API std::string to_json(const Count& count);

/// Counts the solutions of a program without running them. Two solutions are different if they take different
/// paths, or if a choice that both meet has different values.
class SOLITAIRE_API Counter {
 public:
  Counter(const Program& program, const CountOptions& options);
  ~Counter();
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  /// Counts; tells `progress` what it does. Returns nothing if not all paths can be explored, as of a program
  /// with endlessly many. Throws Error: kStopped if a stop came first.
  std::optional<Count> run(const std::function<void(const std::string&)>& progress = {});
  /// Returns a number that there are at least, as far as it is known. Any thread may call this.
  Count at_least() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace solitaire::api
