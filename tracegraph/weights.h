#pragma once
#include <memory>
#include <vector>

namespace solitaire {

/// A list of weights that never changes, or none. Copies share it, so that a distribution that has none, as
/// most do, is copied as fast as a few numbers; and copies may be in several threads.
class Weights {
 public:
  Weights() = default;
  explicit Weights(std::vector<double> weights)
      : weights_(std::make_shared<const std::vector<double>>(std::move(weights))) {}

  bool empty() const { return weights_ == nullptr; }
  std::size_t size() const { return empty() ? 0 : weights_->size(); }
  /// Not where it is empty.
  const std::vector<double>& list() const { return *weights_; }
  double operator[](std::size_t position) const { return (*weights_)[position]; }

  friend bool operator==(const Weights& a, const Weights& b) {
    return a.weights_ == b.weights_ || (!a.empty() && !b.empty() && *a.weights_ == *b.weights_);
  }

 private:
  std::shared_ptr<const std::vector<double>> weights_;
};

}  // namespace solitaire
