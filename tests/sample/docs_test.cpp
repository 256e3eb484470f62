// Runs the programs of the documentation that are fenced as ```sol samples, where comments of the form
//
//     // mean: NAME NUMBER
//
// say what the mean of a returned number is. It has to be so to the digits given, or to four times the
// standard error of drawing, whichever is wider.
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/command.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

struct Sampled {
  std::string place;
  std::string text;
  std::vector<std::pair<std::string, std::string>> means;  // name and number
};

std::vector<Sampled> sampled_programs(const fs::path& page) {
  std::vector<Sampled> programs;
  std::ifstream stream(page);
  bool inside = false;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::string mark = "// mean: ";
    if (line == "```sol samples") {
      inside = true;
      programs.push_back({page.filename().string() + ":" + std::to_string(number), "", {}});
    } else if (line == "```") {
      inside = false;
    } else if (inside && line.rfind(mark, 0) == 0) {
      const std::size_t last = line.rfind(' ');
      programs.back().means.emplace_back(line.substr(mark.size(), last - mark.size()), line.substr(last + 1));
    } else if (inside) {
      programs.back().text += line + "\n";
    }
  }
  return programs;
}

/// Half of a unit of the last digit.
double precision(const std::string& number) {
  const std::size_t point = number.find('.');
  return 0.5 * std::pow(10, point == std::string::npos ? 0 : -static_cast<double>(number.size() - point - 1));
}

void check(const Sampled& sampled) {
  INFO(sampled.place);
  REQUIRE(!sampled.means.empty());
  const Workplace place;
  const Outcome outcome =
      run_solitaire({"sample", place.file("program.sol", sampled.text), "-n", "8000", "--json", "-q"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  std::map<std::string, nlohmann::json> found;
  const auto summary = nlohmann::json::parse(outcome.out);
  for (const auto& parameter : summary["parameters"]) found[parameter["name"]] = parameter;
  for (const auto& mean : sampled.means) {
    const auto& name = mean.first;
    const auto& expected = mean.second;
    CAPTURE(name);
    REQUIRE(found.contains(name));
    const double error = 4 * found[name]["mcse"].get<double>();
    CHECK(std::abs(found[name]["mean"].get<double>() - std::stod(expected)) <=
          std::max(error, precision(expected)));
  }
}

TEST_CASE("docs: the sampled programs of the pages have the means that they are said to have") {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SOLITAIRE_SOURCE_DIR) / "docs")) {
    if (entry.path().extension() != ".md") continue;
    for (const Sampled& sampled : sampled_programs(entry.path())) {
      check(sampled);
      ++count;
    }
  }
  CHECK(count >= 3);
}

}  // namespace
}  // namespace solitaire
