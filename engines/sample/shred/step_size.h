#pragma once
#include <cmath>
#include <cstdint>

namespace solitaire {

/// Learns how long the steps of trajectories are, by dual averaging (Hoffman and Gelman 2014, section 3.2):
/// until the mean acceptance is the wanted one.
class StepSize {
 public:
  explicit StepSize(double first)
      : first_(first), goal_(std::log(10 * first)), log_size_(std::log(first)), log_mean_(log_size_) {}

  double size() const { return std::exp(log_size_); }
  void learn(double acceptance) {
    told_ += 1;
    error_ += (kWanted - acceptance - error_) / (told_ + kSlowStart);
    log_size_ = goal_ - std::sqrt(told_) / kShrinkage * error_;
    log_mean_ += std::pow(told_, -kForgetting) * (log_size_ - log_mean_);
  }
  /// From now on the size is the mean of those that were tried, or the first one where few were.
  void settle() { log_size_ = std::log(learned()); }
  double learned() const { return told_ < kFew ? first_ : std::exp(log_mean_); }

 private:
  // The authors' constants.
  static constexpr double kWanted = 0.8;
  static constexpr double kSlowStart = 10;
  static constexpr double kShrinkage = 0.05;
  static constexpr double kForgetting = 0.75;
  static constexpr double kFew = 20;

  double first_;
  double goal_;
  double log_size_, log_mean_;
  double error_ = 0;  // the mean of how much the acceptance was too low
  double told_ = 0;
};

}  // namespace solitaire
