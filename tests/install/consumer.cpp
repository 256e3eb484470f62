// Uses an installed Solitaire: solves a script from a buffer, writes a scene, cancels a search.
#include <iostream>
#include <solitaire/solitaire.h>
#include <thread>

namespace sol = solitaire::api;

namespace {

constexpr const char* kScene =
    "import \"std/layout.sol\";\nx = range(1, 9);\nassert(x > 8);\n"
    "place(\"chair\", at: [x, 0]);\nreturn x;\n";
constexpr const char* kHard =
    "n = range(0, 2000000000);\nm = range(0, 2000000000);\n"
    "assert(n > 1 and m > 1 and n <= m and n * m == 1000000016000000063 and n != 1000000007);\n";

void solve(const std::string& glb) {
  const sol::Program program = sol::Program::from_text("scene.sol", kScene);
  sol::Search search(program, {});
  for (const sol::Solution& solution : search) {
    std::cout << sol::to_json(solution) << '\n';
    sol::write_glb(solution, program, "scene", glb);
  }
}

void cancel() {
  const sol::StopSource stop;
  sol::SearchOptions options;
  options.stop = stop.token();
  sol::Search search(sol::Program::from_text("hard.sol", kHard), options);
  std::thread canceller([&] { stop.request(); });
  const bool found = search.next().has_value();
  canceller.join();
  std::cout << (!found && search.ending() == sol::Ending::kStopped ? "cancelled" : "not cancelled") << '\n';
}

/// Takes the modules that are loaded only when they are needed.
void sample() {
  sol::SearchOptions options;
  options.sampling = sol::Sampling::kUniform;
  const sol::Program program = sol::Program::from_text(
      "large.sol",
      "x, y, z = range(0, 90), range(0, 90), range(0, 90);\nassert(x + y < z + 60 and x * y > z);\n");
  std::cout << (sol::Search(program, options).next() ? "sampled" : "not sampled") << '\n';
  options = {};
  options.solver = sol::Solver::kZ3;
  std::cout << (sol::Search(program, options).next() ? "by Z3" : "not by Z3") << '\n';
}

}  // namespace

int main(int, char** argv) {
  try {
    solve(argv[1]);
    cancel();
    sample();
  } catch (const sol::Error& error) {
    std::cout << "error: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
