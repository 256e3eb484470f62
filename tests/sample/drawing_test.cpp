// Numbers that are drawn against their distribution, far out, too.
#include "tracegraph/drawing.h"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <iterator>
#include <numbers>

namespace solitaire {
namespace {

TEST_CASE("drawing: normal numbers are as often far out as they should be") {
  RandomStream stream(3, Purpose::kSample, 8);
  constexpr double kDraws = 1'000'000;
  // The last but one lies where layers end and the tail begins (tracegraph/drawing.cpp).
  const double limits[] = {0.2, 1, 1.5, 2, 2.5, 3, 3.442619855899, 4};
  std::array<double, std::size(limits)> beyond{};
  for (int i = 0; i < kDraws; ++i) {
    const double x = draw_normal(stream);
    for (std::size_t k = 0; k < beyond.size(); ++k) beyond[k] += (i % 2 == 0 ? x : -x) > limits[k] ? 1 : 0;
  }
  for (std::size_t k = 0; k < beyond.size(); ++k) {
    CAPTURE(limits[k]);
    const double expected = kDraws * 0.5 * std::erfc(limits[k] / std::numbers::sqrt2);
    CHECK(std::abs(beyond[k] - expected) < 4 * std::sqrt(expected));
  }
}

TEST_CASE("drawing: a pick is as often each of the numbers, also where these are no part of all there are") {
  RandomStream stream(3, Purpose::kSample, 1);
  constexpr int kDraws = 30'000;
  constexpr std::uint32_t kMany = 3U << 30;
  std::array<int, 3> few{}, many{};
  for (int i = 0; i < kDraws; ++i) {
    ++few[stream.pick(3)];
    const std::uint64_t number = stream.pick(kMany);
    CHECK(number < kMany);
    ++many[number % 3];
  }
  for (const auto& counts : {few, many})
    for (const int count : counts) CHECK(std::abs(count - kDraws / 3) < 400);
  CHECK(stream.pick(1) == 0);
}

}  // namespace
}  // namespace solitaire
