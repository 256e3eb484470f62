// Uses the library from several threads of one process, as a server does. What is shared is a program that
// was loaded once; searches, explanations and folders belong to a thread each. Under ThreadSanitizer a data
// race ends the test with an error.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <solitaire/solitaire.h>
#include <thread>

#include "tests/support/command.h"

namespace solitaire::api {
namespace {

/// Uses what evaluations could share by mistake: params that are lists and strings, records, functions as
/// values, constants, library functions, texts of addresses.
constexpr const char* kScene =
    "import \"std/layout.sol\";\n"
    "param names = [\"oak\", \"elm\", \"ash\"];\nparam most = 12;\n"
    "record Tree(name, x, y);\n"
    "fun tree(i) { return Tree(names[i], range(0, most), range(0, most)); }\n"
    "trees = [tree(i) for i in 0..2];\nlean = fun(t) { return t.x - t.y; };\n"
    "for i in 0..1: assert(trees[i].x < trees[i + 1].x, \"in order\");\n"
    "assert(sum([lean(t) for t in trees]) > 0);\n"
    "for t in trees: place(\"chair\", at: [t.x, t.y], size: [1, 1], name: t.name);\n"
    "return [trees, choose([\"a\", \"b\"])];\n";

/// Has no solution.
constexpr const char* kCrowded =
    "xs = [range(1, 4) for i in 1..5];\nassert(distinct(xs), \"all seats differ\");\nreturn xs;\n";

/// What came of one session. Sessions with the same seed are equal.
struct Session {
  std::vector<std::string> solutions;
  std::string conflict;
  std::map<std::string, std::string> files;  // contents by name

  bool operator==(const Session&) const = default;
};

std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    files[entry.path().filename().string()].assign(std::istreambuf_iterator<char>(file), {});
  }
  return files;
}

SearchOptions search_options(std::uint64_t seed) {
  SearchOptions options;
  options.seed = seed;
  options.count = 6;
  options.jobs = 1 + seed % 2 * 2;  // some sessions have threads of their own
  return options;
}

/// Solves, explains, and generates into the folder.
Session run_session(const Program& scene, const Program& crowded, std::uint64_t seed,
                    const std::filesystem::path& folder) {
  Session session;
  Search search(scene, search_options(seed));
  for (const Solution& solution : search) session.solutions.push_back(to_json(solution));
  Options options;
  options.seed = seed;
  session.conflict = Explainer(crowded, options).next().value().text;
  Search generate(scene, search_options(seed + 10));
  OutputFolder output(folder, scene, search_options(seed + 10));
  while (const auto solution = generate.next()) output.add(*solution, generate.summary());
  output.close(generate.ending());
  session.files = files_in(folder);
  return session;
}

constexpr std::uint64_t kSessions = 4;

}  // namespace

TEST_CASE("threads: sessions of the library side by side come to what each comes to alone") {
  const Workplace place;
  const Program scene = Program::from_text("trees.sol", kScene);
  const Program crowded = Program::from_text("crowded.sol", kCrowded);
  std::vector<Session> alone, together(kSessions);
  for (std::uint64_t seed = 0; seed < kSessions; ++seed)
    alone.push_back(run_session(scene, crowded, seed, place / fmt::format("alone-{}", seed)));
  CHECK(alone[0].solutions.size() == 6);
  CHECK(alone[0].solutions != alone[1].solutions);
  CHECK(alone[0].files.size() > 12);
  CHECK(alone[0].conflict.find("all seats differ") != std::string::npos);
  std::vector<std::thread> threads;
  for (std::uint64_t seed = 0; seed < kSessions; ++seed) {
    threads.emplace_back([&, seed] {
      together[seed] = run_session(scene, crowded, seed, place / fmt::format("together-{}", seed));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::uint64_t seed = 0; seed < kSessions; ++seed) CHECK(together[seed] == alone[seed]);
}

TEST_CASE("threads: params of copies of one program are set on several threads") {
  const Program program = Program::from_text(
      "param.sol", "param n = 1;\nparam word = \"x\";\nx = range(n, n + 1);\nreturn [word, x];\n");
  std::vector<std::thread> threads;
  std::vector<std::string> found(kSessions);
  for (std::uint64_t i = 0; i < kSessions; ++i) {
    threads.emplace_back([&, i] {
      for (int turn = 0; turn < 20; ++turn) {
        Program own = program;
        own.set("n", fmt::format("{}", 10 * i));
        own.set("word", fmt::format("\"w{}\"", i));
        SearchOptions options;
        options.all = true;
        found[i].clear();
        for (const Solution& solution : Search(own, options)) found[i] += solution.text;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::uint64_t i = 0; i < kSessions; ++i)
    CHECK(found[i] == fmt::format("[\"w{0}\", {1}][\"w{0}\", {2}]", i, 10 * i, 10 * i + 1));
}

}  // namespace solitaire::api
