#pragma once
#include <functional>
#include <mutex>
#include <solitaire/sample.h>
#include <vector>

namespace solitaire::api {

/// Hands on the draws of chains that run side by side in the order in which the chains would give them one
/// after the other. Draws whose turn has not come wait.
class DrawOrder {
 public:
  using Call = std::function<void(const SampledDraw&)>;

  DrawOrder(std::size_t chains, Call call)
      : waiting_(chains), ended_(chains, false), call_(std::move(call)) {}

  // From any thread; of one chain, one after the other.

  void add(std::size_t chain, const std::vector<std::string>& names, const std::vector<double>& numbers);
  /// The chain gives no more.
  void end(std::size_t chain);

 private:
  struct Waiting {
    std::uint64_t drawn = 0;
    std::vector<SampledDraw> draws;
  };

  std::mutex mutex_;
  std::vector<Waiting> waiting_;
  std::vector<bool> ended_;
  std::size_t turn_ = 0;  // the chain whose draws are handed on at once
  Call call_;
};

}  // namespace solitaire::api
