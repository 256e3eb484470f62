#include "tests/differential/differential.h"

#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

#include "tests/generator/program_generator.h"

namespace {

using namespace solitaire;

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Compares the engines on generated programs and counts them.
struct Sample {
  int compared = 0, with_solutions = 0, with_errors = 0, covered = 0, with_imports = 0;
  int skipped = 0;  // in all
  int refused = 0;  // of them, by the solver, which tests/reference holds against the reference interpreter

  void add(std::uint64_t seed) {
    ByteSource bytes(seed);
    const GeneratedProgram program = generate_program(bytes);
    const Comparison result = compare_engines(program, seed);
    const bool equal = result.outcome != Comparison::Outcome::kDifferent;
    CHECK_MESSAGE(equal, fmt::format("seed {}: {}\n{}", seed, result.report, to_text(program)));
    skipped += result.outcome == Comparison::Outcome::kSkipped ? 1 : 0;
    refused += result.refused ? 1 : 0;
    with_imports += program.files.size() > 1 ? 1 : 0;
    if (result.outcome != Comparison::Outcome::kEqual) return;
    ++compared;
    with_solutions += result.solutions > 0 ? 1 : 0;
    with_errors += result.errors > 0 ? 1 : 0;
    covered += result.incomplete ? 0 : 1;
  }
};

void compare_many(std::uint64_t first_seed) {
  Sample sample;
  for (std::uint64_t seed = first_seed; seed < first_seed + 110; ++seed) sample.add(seed);
  // Else the generator has become poor, and the comparison says little.
  CHECK(sample.compared >= 100);
  CHECK(sample.with_solutions >= 40);
  CHECK(sample.with_errors >= 2);
  CHECK(sample.covered >= 60);
  CHECK(sample.with_imports >= 20);
  CHECK(sample.refused <= 8);
  MESSAGE(fmt::format("{} compared, {} skipped, of which {} were refused by the solver", sample.compared,
                      sample.skipped, sample.refused));
}

}  // namespace

// In parts, which run side by side.
TEST_CASE("differential: generated programs have brute force's solutions, part 1 (slow)") {
  compare_many(100'000);
}
TEST_CASE("differential: generated programs have brute force's solutions, part 2 (slow)") {
  compare_many(200'000);
}
TEST_CASE("differential: generated programs have brute force's solutions, part 3 (slow)") {
  compare_many(300'000);
}

TEST_CASE("differential: programs that once went wrong have brute force's solutions (slow)") {
  const std::filesystem::path folder = SOLITAIRE_SOURCE_DIR "/tests/differential";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".sol") continue;
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    const Comparison result = compare_engines({{{name, read_file(entry.path())}}}, 1);
    const bool refused = name.rfind("refused_", 0) == 0;  // too much for the engine, which has to say so
    CHECK_MESSAGE(result.outcome == (refused ? Comparison::Outcome::kSkipped : Comparison::Outcome::kEqual),
                  result.report);
  }
}
