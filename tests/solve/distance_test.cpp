// How much solutions differ, and that further ones differ as much as was asked for.
#include "engines/distance.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>

#include "tests/support/program_run.h"

namespace solitaire {
namespace {

/// All solutions of a program, by running every execution.
std::vector<Solution> solutions_of(const std::string& text) {
  const Program program = program_of(text);
  ExhaustiveEngine engine(program, {}, {});
  std::vector<Solution> all;
  while (auto solution = engine.next()) all.push_back(std::move(*solution));
  return all;
}

Features features_of(const std::string& text) {
  const Program program = program_of(text);
  ExhaustiveEngine engine(program, {}, {});
  return result_features(*engine.next());
}

double results_distance(const std::string& a, const std::string& b) {
  return overlap_of(features_of(a), features_of(b)).distance();
}

/// What MeanDistance means.
double mean_of_pairs(const std::vector<Features>& all) {
  Overlap sum;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Overlap pair = overlap_of(all[i], all[j]);
      sum.shared += pair.shared;
      sum.all += pair.all;
    }
  }
  return sum.distance();
}

double mean_of(const std::vector<Features>& all) {
  MeanDistance mean;
  for (const Features& each : all) mean.add(each);
  return mean.value();
}

TEST_CASE("distance: of choices, the share of addresses that one lacks or has with another value") {
  using Choices = std::map<std::string, int>;
  const auto distance = [](const Choices& a, const Choices& b) {
    CHECK(overlap_of(a, b).distance() == overlap_of(b, a).distance());
    return overlap_of(a, b).distance();
  };
  CHECK(distance({}, {}) == 0);
  CHECK(distance({{"x", 1}}, {}) == 1);
  CHECK(distance({{"x", 1}, {"y", 2}}, {{"x", 1}, {"y", 2}}) == 0);
  CHECK(distance({{"x", 1}, {"y", 2}}, {{"x", 1}, {"y", 3}}) == 0.5);
  CHECK(distance({{"a", 1}, {"x", 1}, {"y", 2}}, {{"x", 1}, {"z", 2}}) == 0.75);
}

TEST_CASE("distance: of results, by things alike and by the value part by part") {
  const std::string chair = "place(\"chair\", at: [1, 1], size: [1, 1]);";
  const std::string desk = "place(\"desk\", at: [3, 1], size: [2, 1]);";
  CHECK(results_distance(chair, chair) == 0);
  CHECK(results_distance(chair, desk) == 1);
  CHECK(results_distance(chair + desk, desk + chair) == 0);
  CHECK(results_distance(chair, chair + chair) == 0.5);  // a second one that looks alike
  CHECK(results_distance(chair + desk, chair + desk + "return 5;") == doctest::Approx(1.0 / 3));
  CHECK(results_distance("return 5;", "return 6;") == 1);
  CHECK(results_distance("return nil;", "") == 0);
  CHECK(results_distance("return [1, 2, 3, 4];", "return [1, 2, 3, 5];") == 0.25);
  CHECK(results_distance("return [1, [2, 3]];", "return [1, [2]];") == doctest::Approx(1.0 / 3));
  CHECK(results_distance("return [];", "return [];") == 0);
  CHECK(results_distance("return [];", "return [nil];") == 1);
  const std::string record = "record P(a, b);";
  CHECK(results_distance(record + "return P(1, 2);", record + "return P(1, 3);") == 0.5);
  CHECK(results_distance("return 1;", "return \"1\";") == 1);
}

TEST_CASE("distance: the mean by counting is the mean over all pairs, in any order") {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<Features> all(random() % 12);
    for (Features& each : all) {
      const std::size_t names = random() % 6;
      for (std::size_t i = 0; i < names; ++i)
        each.emplace(std::to_string(random() % 8), std::to_string(random() % 3));
    }
    const double mean = mean_of(all);
    CHECK(mean == mean_of_pairs(all));
    std::reverse(all.begin(), all.end());
    CHECK(mean == mean_of(all));
  }
}

TEST_CASE("distance: of a program's solutions, with paths that differ and scenes") {
  const std::vector<Solution> all = solutions_of(
      "n = range(0, 2); for i in 1..n { place(\"chair\", at: [range(0, 2), 0], size: [1, 1]); } return n;");
  std::vector<Features> choices, results;
  Diversity diversity;
  for (const Solution& each : all) {
    diversity.add(each);
    choices.push_back(choice_features(each.choices));
    results.push_back(result_features(each));
  }
  CHECK(all.size() == 1 + 3 + 9);
  CHECK(diversity.of_choices() == mean_of_pairs(choices));
  CHECK(diversity.of_results() == mean_of_pairs(results));
  CHECK(diversity.of_choices() > 0.5);
  CHECK(diversity.of_results() < 1);
}

/// Returns the least distance of all pairs, by comparing each with each.
double least_of_pairs(const std::vector<Features>& all) {
  double least = 1;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, overlap_of(all[i], all[j]).distance());
  }
  return least;
}

TEST_CASE("distance: that of the nearest two, where names differ, too") {
  const std::vector<Solution> all =
      solutions_of("n = range(0, 3); return [range(0, 2) for i in 1..n], flip(), flip(), flip();");
  NearestPair nearest;
  std::vector<Features> choices;
  CHECK(!nearest.value());
  for (std::size_t i = 0; i < all.size(); i += 7) {
    choices.push_back(choice_features(all[i].choices));
    nearest.add(choices.back());
    CHECK(nearest.value().has_value() == (choices.size() > 1));
    if (nearest.value()) CHECK(*nearest.value() == least_of_pairs(choices));
  }
  CHECK(choices.size() > 20);
  nearest.add(choices.front());
  CHECK(nearest.value() == 0.0);
}

}  // namespace
}  // namespace solitaire
