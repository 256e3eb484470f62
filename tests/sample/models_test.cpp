// The models of examples/sampling/ have the exact answers that counting and numerical integration give,
// within four standard errors of drawing.
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/command.h"

namespace solitaire {
namespace {

struct Model {
  const char* script;
  std::vector<std::string> options;
  std::map<std::string, double> means;
};

void check(const Model& model) {
  INFO(model.script);
  const auto script = std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "examples/sampling" / model.script;
  std::vector<std::string> arguments = {"sample", script, "--json", "-q"};
  arguments.insert(arguments.end(), model.options.begin(), model.options.end());
  const Outcome outcome = run_solitaire(arguments);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto summary = nlohmann::json::parse(outcome.out);
  std::size_t found = 0;
  for (const auto& parameter : summary["parameters"]) {
    const auto expected = model.means.find(parameter["name"]);
    if (expected == model.means.end()) continue;
    ++found;
    CAPTURE(expected->first);
    const double mean = parameter["mean"];
    // What is rarer than one in thousands hardly shows, and then does not tell how exact its mean is.
    const bool rare = expected->second < 2e-3 || std::abs(1 - expected->second) < 2e-3;
    const double floor = rare ? 3e-3 : 0;
    CHECK(std::abs(mean - expected->second) <= std::max(4 * parameter["mcse"].get<double>(), floor));
    if (!rare) CHECK(parameter["ess_bulk"].get<double>() > 150);
  }
  CHECK(found == model.means.size());
}

TEST_CASE("models: exact answers, on traces") {
  const Model models[] = {
      {"regression.sol", {"-n", "4000"}, {{"slope", 2.00886}, {"intercept", 1.00034}}},
      {"mixture.sol",
       {"-n", "8000"},
       {{"kind[0] == kind[1]", 0.90658}, {"kind[0] == kind[2]", 0.000717}, {"kind[2] == kind[3]", 0.90658}}},
      {"infinite_mixture.sol",
       {"-n", "8000"},
       {{"seat[0] == seat[1]", 0.81397}, {"seat[0] == seat[2]", 0.000887}, {"number_of_kinds", 2.36984}}},
      {"citations.sol",
       {"-n", "2000"},
       {{"paper[0] == paper[1]", 0.99980},
        {"paper[3] == paper[4]", 0.99888},
        {"paper[0] == paper[3]", 4.91e-4}}},
      {"sum_or_product.sol", {"-n", "8000"}, {{"added", 0.70831}}},
      {"polynomial.sol",
       {"-n", "8000"},
       {{"degree == 2", 0.74827}, {"degree == 3", 0.19214}, {"degree == 4", 0.05959}}},
      {"ising.sol",
       {"-n", "4000", "--set", "n=20", "--set", "coupling=1.0"},
       {{"unequal", 19 / (1 + std::exp(1))}}},
  };
  for (const Model& model : models) check(model);
}

/// Samples a line through points far from 0, which hardly says anything about its slope and its intercept by
/// themselves. The first line of the program has their priors.
Outcome sample_line_far_away(const std::string& priors, const std::vector<std::string>& options) {
  const Workplace place;
  const std::string script = place.file(
      "far.sol", priors +
                     "\nfor i in 1..20 { x = 1000 + i; observe(Normal(a + b * (1.0 * x), 1), 3.0 * i); }\n"
                     "return a, b;\n");
  std::vector<std::string> arguments = {"sample", script, "-q"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_solitaire(arguments);
}

/// The summary of such a line, whose slope's mean is compared with the exact one.
nlohmann::json line_far_away(const std::string& priors, double precision_of_a, double precision_of_b) {
  const Outcome outcome = sample_line_far_away(priors, {"-n", "4000", "--json"});
  REQUIRE(outcome.status == 0);
  const auto summary = nlohmann::json::parse(outcome.out);
  // With X the points and P the precisions of the priors, the posterior's precision is X'X + P.
  const double xx = 20 * 1010.5 * 1010.5 + 665 + precision_of_b, x = 20 * 1010.5, n = 20 + precision_of_a;
  const double xy = 3 * (1010.5 * 210 + 665), y = 3 * 210;
  const double slope = (xy * n - x * y) / (xx * n - x * x);
  const auto& b = summary["parameters"][1];
  CHECK(std::abs(b["mean"].get<double>() - slope) < 4 * b["mcse"].get<double>());
  CHECK(b["rhat"].get<double>() < 1.03);
  return summary;
}
double effective(const nlohmann::json& summary) { return summary["parameters"][1]["ess_bulk"].get<double>(); }
bool by_trajectories(const nlohmann::json& summary) {
  return summary["moves"].dump().find("nuts") != std::string::npos;
}

TEST_CASE("models: a slope and an intercept that single steps can hardly move are drawn together") {
  const auto summary = line_far_away("a = normal(0, 1000); b = normal(0, 100);", 1e-6, 1e-4);
  CHECK(effective(summary) > 3000);
  CHECK(!by_trajectories(summary));
}

TEST_CASE("models: where their density has no known form, they move along its slopes") {
  const auto summary =
      line_far_away("a = normal(0, 1000); b = normal(0, 100); factor(-abs(b) / 1e6);", 1e-6, 1e-4);
  CHECK(effective(summary) > 300);
  CHECK(by_trajectories(summary));
}

TEST_CASE("models: a start where the density is tiny leaves no rounding in the score") {
  // At the end the density of a run is compared with the trace's.
  const Outcome outcome = sample_line_far_away("a = uniform(-10000, 10000); b = uniform(-1000, 1000);",
                                               {"-n", "4000", "--seed", "1"});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
}

TEST_CASE("models: where a trajectory comes to an infinite density the program is wrong") {
  // No start is near the line, and steps along one of the two hardly move on it.
  const Outcome outcome = sample_line_far_away(
      "a = normal(0, 1000); b = normal(0, 100); "
      "factor(cond(abs(a + 1010.5 * b - 31.5) < 5 and b > 2.95, exp(1000 * b), -abs(b) / 1e6));",
      {"-n", "400", "--seed", "1"});
  CHECK(outcome.status == 3);
  CHECK(outcome.err.find("1:42: error: 'factor' makes an execution infinitely probable") !=
        std::string::npos);
}

TEST_CASE("models: floats that hang together by their labels alone do not move together") {
  const auto script = std::filesystem::path(SOLITAIRE_SOURCE_DIR) / "examples/sampling/mixture.sol";
  const Outcome outcome = run_solitaire({"sample", script, "-n", "4000", "--json", "-q"});
  REQUIRE(outcome.status == 0);
  CHECK(nlohmann::json::parse(outcome.out)["moves"].dump().find("nuts") == std::string::npos);
}

TEST_CASE("models: the published answers for rats, on traces (slow)") {
  check({"rats.sol",
         {"-n", "1600", "--warmup", "4000"},
         {{"alpha_c", 242.65}, {"beta_c", 6.186}, {"1 / sqrt(tau)", 6.09}}});
}

TEST_CASE("models: exact answers, by running the program for each step") {
  check({"sum_or_product.sol", {"-n", "4000", "--engine", "lightweight"}, {{"added", 0.70831}}});
}

}  // namespace
}  // namespace solitaire
