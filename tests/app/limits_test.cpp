// What ends a run before it is done: whenever it comes, the command ends soon, what was found is kept, and no
// file is there by halves.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "scene/gltf/reader.h"
#include "tests/support/command.h"
#include "tests/support/text.h"

#if defined(__SANITIZE_ADDRESS__)
#define SOLITAIRE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SOLITAIRE_SANITIZED
#endif
#endif

namespace solitaire {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::chrono::milliseconds;
using Arguments = std::vector<std::string>;

/// What a run may compute after its limit, in seconds of one processor. The promise is one second on the
/// clock, but the clock also runs while the machine does other things.
constexpr double kPromptly = 2;
/// What a run that hangs takes by the clock, in seconds.
constexpr double kHangs = 60;

/// Has a few solutions that are found at once and no further one that could be found in time.
constexpr const char* kHard =
    "n = range(0, 2000000000);\nm = range(0, 2000000000);\n"
    "if n > 1 { assert(m > 1 and n <= m and n * m == 1000000016000000063 and n != 1000000007); }\n"
    "else { assert(m < 3); }\nplace(\"chair\", at: [n, m], size: [1, 1]);\n";

/// Has three solutions that are found at once; to look for a fourth takes a formula that is too large.
constexpr const char* kLarge =
    "k = range(0, 3);\nplace(\"chair\", at: [k, 0], size: [1, 1]);\nif k == 3 {\n"
    "  i = 0;\n  while i < 100000 { i = i + 1; }\n"
    "  xs = [range(0, 1000000) for i in 1..1000];\n"
    "  for x in xs { for y in xs { assert(x * y != 17 * x + 1); } }\n}\n";

/// Takes long wherever one looks at it, for more of them the longer.
constexpr const char* kWide =
    "param n = 400;\nxs = [range(0, 1000000) for i in 1..n];\n"
    "for x in xs { for y in xs { assert(x * y != 17 * x + 1); } }\n";

/// Has a scene a millisecond.
constexpr const char* kMany =
    "x = range(0, 9000);\ny = range(0, 9000);\nassert(x + y > 20);\n"
    "place(\"chair\", at: [x, y], size: [1, 1]);\nreturn [x, y];\n";

/// One of its ten scenes is much larger than the others.
constexpr const char* kUneven =
    "k = range(0, 9);\nplace(\"chair\", at: [k, 0], size: [1, 1]);\n"
    "if k == 5 { for i in 0..9000 { place(\"box\", at: [i, 3], size: [1, 1]); } }\n";

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Checks that a run, which took so many seconds by the clock, ended soon after its limit.
void check_prompt(const Outcome& outcome, double seconds, double limit) {
  CHECK(seconds < limit + kHangs);
  CHECK(outcome.cpu_seconds < (limit + kPromptly) * std::max(2U, std::thread::hardware_concurrency()));
}

/// Runs the program, which has to end soon after a limit of so many seconds.
Outcome run_promptly(double limit, const std::function<Outcome()>& run) {
  Outcome outcome;
  const double seconds = seconds_of([&] { outcome = run(); });
  check_prompt(outcome, seconds, limit);
  return outcome;
}

std::vector<fs::path> entries(const fs::path& folder) {
  if (!fs::exists(folder)) return {};
  return {fs::directory_iterator(folder), fs::directory_iterator()};
}

/// What is said about the run as a whole.
bool is_manifest(const fs::path& file) { return has(file.filename().string(), "-run.json"); }

std::size_t solutions_in(const fs::path& folder) {
  const std::vector<fs::path> files = entries(folder);
  return static_cast<std::size_t>(std::count_if(files.begin(), files.end(), [](const fs::path& file) {
    return file.extension() == ".json" && !is_manifest(file);
  }));
}

/// The files that a page leads to.
std::set<std::string> links_of(const std::string& page) {
  constexpr std::string_view kLink = "href=\"./";
  std::set<std::string> links;
  for (std::size_t at = page.find(kLink); at != std::string::npos; at = page.find(kLink, at)) {
    at += kLink.size();
    links.insert(page.substr(at, page.find('"', at) - at));
  }
  return links;
}

/// What the page loads is whole, too: scripts end their one call, drawings their element.
void check_beside_page(const fs::path& folder) {
  for (const fs::path& file : entries(folder)) {
    CAPTURE(file.string());
    const std::string bytes = bytes_of(file);
    const std::string end = file.extension() == ".svg"   ? "</svg>"
                            : file.extension() == ".css" ? "}\n"
                                                         : ";\n";
    CHECK((file.extension() == ".part" || bytes.substr(bytes.size() - end.size()) == end));
  }
}

/// Every file is whole, under a name of its own.
void check_whole(const fs::path& folder) {
  for (const fs::path& file : entries(folder)) {
    CAPTURE(file.string());
    if (file.extension() == ".glb") {
      CHECK_NOTHROW(read_gltf(file));
    } else if (file.extension() == ".json") {
      CHECK(json::accept(bytes_of(file)));
    } else if (file.filename() == "index.html") {
      const std::string page = bytes_of(file);
      CHECK(page.rfind("</html>\n") + 8 == page.size());
      for (const std::string& link : links_of(page)) CHECK(fs::exists(folder / link));
    } else if (file.filename() == "page") {
      check_beside_page(file);
    } else {
      CHECK(file.extension() == ".part");
    }
  }
}

/// Nothing is left over, and the page shows every solution.
void check_ended_in_order(const fs::path& folder) {
  check_whole(folder);
  const std::size_t solutions = solutions_in(folder);
  const std::set<std::string> links = links_of(bytes_of(folder / "index.html"));
  std::size_t manifests = 0;
  for (const fs::path& file : entries(folder)) {
    CAPTURE(file.string());
    const bool is_page = file.filename() == "index.html" || file.filename() == "page";
    CHECK((is_page || is_manifest(file) || links.count(file.filename().string()) == 1));
    if (!is_manifest(file)) continue;
    ++manifests;
    const json manifest = json::parse(bytes_of(file));
    CHECK(manifest["solutions"] == solutions);
    CHECK(manifest["ended"] != "exhausted");
    CHECK(manifest.contains("mean_distance") == (solutions > 1));
  }
  CHECK(manifests == 1);
  CHECK(links.size() == (solutions > 0 ? 2 * solutions + 1 : 0));  // with the style sheet
  CHECK(fs::exists(folder / "index.html") == (solutions > 0));
}

void wait_for_solution(const fs::path& folder) {
  for (int i = 0; i < 1000 && solutions_in(folder) == 0; ++i) std::this_thread::sleep_for(milliseconds(10));
  CHECK(solutions_in(folder) > 0);
}

Outcome run_in_shell(const std::string& line, Arguments arguments) {
  arguments.insert(arguments.begin(), {"sh", "-c", line, SOLITAIRE_PROGRAM});
  return run(arguments);
}

/// Whoever writes to it comes to wait: it is open and nobody reads.
class FullPipe {
 public:
  explicit FullPipe(const fs::path& path) {
    REQUIRE(mkfifo(path.c_str(), 0600) == 0);
    descriptor_ = open(path.c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(descriptor_ >= 0);
  }
  ~FullPipe() { close(descriptor_); }
  FullPipe(const FullPipe&) = delete;
  FullPipe& operator=(const FullPipe&) = delete;

 private:
  int descriptor_ = -1;
};

void check_time_limit(const std::string& engine, const std::string& program) {
  const Workplace place;
  const std::string script = place.file("p.sol", program);
  const Outcome outcome = run_promptly(0.7, [&] {
    return run_solitaire({"generate", script, "-n", "20", "--engine", engine, "--timeout", "0.7", "-o",
                          (place / "out").string()});
  });
  CAPTURE(outcome.err);
  CHECK(outcome.status == 4);
  CHECK(has(outcome.err, "the time limit came first"));
  CHECK(has(outcome.err, std::to_string(solutions_in(place / "out")) + " solution"));
  check_ended_in_order(place / "out");
}

TEST_CASE("limits: --timeout holds while CaDiCaL searches") { check_time_limit("cadical", kHard); }
TEST_CASE("limits: --timeout holds while Z3 searches") { check_time_limit("z3", kHard); }
TEST_CASE("limits: --timeout holds while a large formula goes to CaDiCaL") {
  check_time_limit("cadical", kLarge);
}
TEST_CASE("limits: --timeout holds while a large formula goes to Z3") { check_time_limit("z3", kLarge); }

TEST_CASE("limits: a timeout of nothing is one") {
  const Workplace place;
  CHECK(run_solitaire({"solve", place.file("p.sol", "return range(0, 3);\n"), "--timeout", "0"}).status == 4);
}

TEST_CASE("limits: --timeout holds for check, explain and trace") {
  const Workplace place;
  const std::string script = place.file("wide.sol", kWide);
  for (const Arguments& arguments :
       {Arguments{"check", script}, Arguments{"check", script, "--set", "n=3000"},
        Arguments{"explain", script}, Arguments{"explain", script, "--engine", "z3"},
        Arguments{"trace", script, "--set", "n=3000"},
        Arguments{"trace", script, "--set", "n=3000", "--format", "smt2"}}) {
    Arguments limited = arguments;
    limited.insert(limited.end(), {"--timeout", "0.3"});
    const Outcome outcome = run_promptly(0.3, [&] { return run_solitaire(limited); });
    CAPTURE(outcome.err);
    CHECK(outcome.status == 4);
    CHECK(outcome.out == "");
    CHECK(has(outcome.err, "the time limit came first"));
  }
}

void check_signal(const std::string& engine, const std::string& program, int signal) {
  const Workplace place;
  const std::string script = place.file("p.sol", program);
  Command command(
      solitaire_with({"generate", script, "-n", "20", "--engine", engine, "-o", (place / "out").string()}));
  wait_for_solution(place / "out");
  std::this_thread::sleep_for(milliseconds(300));
  command.signal(signal);
  const Outcome outcome = run_promptly(0.3, [&] { return command.wait(); });
  CAPTURE(outcome.err);
  CHECK(outcome.status == 4);
  CHECK(has(outcome.err, "interrupted"));
  check_ended_in_order(place / "out");
}

TEST_CASE("limits: Ctrl-C ends a search of CaDiCaL") { check_signal("cadical", kHard, SIGINT); }
TEST_CASE("limits: Ctrl-C ends a search of Z3") { check_signal("z3", kHard, SIGINT); }
TEST_CASE("limits: a request to terminate ends a large formula for CaDiCaL") {
  check_signal("cadical", kLarge, SIGTERM);
}
TEST_CASE("limits: a request to terminate ends a large formula for Z3") {
  check_signal("z3", kLarge, SIGTERM);
}

TEST_CASE("limits: Ctrl-C ends a wait for the script, a second one does so at once") {
  const Workplace place;
  const FullPipe script(place / "script.sol");
  for (const bool twice : {false, true}) {
    Command command(solitaire_with({"check", (place / "script.sol").string()}));
    std::this_thread::sleep_for(milliseconds(300));
    command.wait_for_handler(SIGINT);
    command.signal(SIGINT);
    if (twice) {
      command.wait_for_handler(SIGINT, false);
      command.signal(SIGINT);
    }
    const Outcome outcome = run_promptly(0, [&] { return command.wait(); });
    CHECK(outcome.status == (twice ? 128 + SIGINT : 4));
    CHECK(outcome.err == (twice ? "" : "error: interrupted\n"));
  }
}

void check_per_solution(const std::string& engine, const std::string& program) {
  const Workplace place;
  const std::string script = place.file("p.sol", program);
  const Outcome outcome = run_promptly(10, [&] {  // for all of its solutions
    return run_solitaire({"generate", script, "-n", "20", "--engine", engine, "--per-solution", "0.8", "-o",
                          (place / "out").string()});
  });
  CAPTURE(outcome.err);
  CHECK(outcome.status == 4);
  CHECK(has(outcome.err, "no further solution within 0.8 s"));
  check_ended_in_order(place / "out");
}

TEST_CASE("limits: --per-solution ends a search of CaDiCaL") { check_per_solution("cadical", kHard); }
TEST_CASE("limits: --per-solution ends a large formula for Z3") { check_per_solution("z3", kLarge); }

TEST_CASE("limits: the time of --per-solution starts anew with each solution") {
  const Workplace place;
  const std::string script = place.file("p.sol", "x = range(0, 8000);\nreturn x;\n");
  const auto solve = [&](const Arguments& limit) {
    Arguments arguments = {"solve", script, "--all", "--json"};
    arguments.insert(arguments.end(), limit.begin(), limit.end());
    return run_solitaire(arguments);
  };
  const double seconds = seconds_of([&] { CHECK(solve({}).status == 0); });
  CHECK(solve({"--per-solution", std::to_string(seconds)}).status == 0);
  CHECK(solve({"--per-solution", "0"}).status == 4);
}

void check_memory(const std::string& engine) {
  const Workplace place;
  const std::string script = place.file("p.sol", kLarge);
  const Outcome outcome = run_solitaire({"generate", script, "-n", "20", "--engine", engine, "--memory",
                                         "350", "-o", (place / "out").string()});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 4);
  CHECK(has(outcome.err, "the memory limit came first"));
  check_ended_in_order(place / "out");
}

TEST_CASE("limits: --memory holds for CaDiCaL (slow)") { check_memory("cadical"); }
TEST_CASE("limits: --memory holds for Z3") { check_memory("z3"); }

#ifndef SOLITAIRE_SANITIZED  // the sanitizers take all addresses there are
TEST_CASE("limits: where there is no more memory, what was found is kept (slow)") {
  for (const char* engine : {"cadical", "z3"}) {
    const Workplace place;
    const std::string script = place.file("p.sol", kLarge);
    const Outcome outcome = run_in_shell("ulimit -v 200000 && exec \"$0\" \"$@\"",
                                         {"generate", script, "-n", "20", "--engine", engine, "--jobs", "4",
                                          "-o", (place / "out").string()});  // none of the four gets a thread
    CAPTURE(outcome.err);
    CHECK(outcome.status == 4);
    CHECK(has(outcome.err, "3 solutions"));
    CHECK(has(outcome.err, "out of memory"));
    check_ended_in_order(place / "out");
  }
}

TEST_CASE("limits: check and trace say that there is no more memory (slow)") {
  const Workplace place;
  const std::string script = place.file("wide.sol", kWide);
  for (const Arguments& arguments :
       {Arguments{"check", script}, Arguments{"trace", script, "--set", "n=3000", "--format", "smt2"}}) {
    const Outcome outcome = run_in_shell("ulimit -v 120000 && exec \"$0\" \"$@\"", arguments);
    CHECK(outcome.status == 4);
    CHECK(outcome.out == "");
    CHECK(outcome.err == "error: out of memory\n");
  }
}
#endif

TEST_CASE("limits: an output that nobody takes does not keep the command from ending") {
  const Workplace place;
  const FullPipe pipe(place / "pipe");
  const std::string script = place.file("many.sol", kMany);
  const std::string to_pipe = "exec \"$0\" \"$@\" > " + (place / "pipe").string();
  Outcome outcome = run_promptly(0.5, [&] {
    return run_in_shell(to_pipe, {"generate", script, "-n", "100000", "--json", "--timeout", "0.5", "-o",
                                  (place / "out").string()});
  });
  CHECK(outcome.status == 4);
  CHECK(has(outcome.err, "the time limit came first"));
  check_ended_in_order(place / "out");
  outcome = run_promptly(0.5, [&] {
    return run_in_shell(to_pipe + " 2>&1", {"solve", script, "-n", "100000", "--timeout", "0.5"});
  });
  CHECK(outcome.status == 4);
}

TEST_CASE("limits: a closed or full standard output is an error by name, and files stay") {
  const Workplace place;
  const std::string script = place.file("many.sol", kMany);
  const std::string folder = (place / "out").string();
  for (const Arguments& arguments :
       {Arguments{"solve", script}, Arguments{"solve", script, "--json"}, Arguments{"trace", script},
        Arguments{"explain", script}, Arguments{"trace", script, "--format", "dot"},
        Arguments{"trace", script, "--format", "smt2"}, Arguments{"generate", script, "--json", "-o", folder},
        Arguments{"--help"}, Arguments{"--version"}}) {
    CAPTURE(arguments.front());
    const Outcome unread = Command(solitaire_with(arguments), true).wait();
    CHECK(unread.status == 3);
    CHECK(has(unread.err, "error: standard output: Broken pipe\n"));
    const Outcome full = run_in_shell("exec \"$0\" \"$@\" > /dev/full", arguments);
    CHECK(full.status == 3);
    CHECK(has(full.err, "error: standard output: No space left on device\n"));
    const Outcome closed = run_in_shell("exec \"$0\" \"$@\" >&-", arguments);
    CHECK(closed.status == 3);
    CHECK(has(closed.err, "error: standard output: Bad file descriptor\n"));
  }
  CHECK(solutions_in(folder) == 1);
  check_ended_in_order(folder);
}

TEST_CASE("limits: a standard error that nobody reads changes nothing") {
  const Workplace place;
  const std::string script = place.file("p.sol", "print(\"x\");\nreturn 5;\n");
  for (const char* line : {"exec \"$0\" \"$@\" 2>&-", "exec \"$0\" \"$@\" 2> /dev/full"}) {
    const Outcome outcome = run_in_shell(line, {"solve", script});
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "solution 1: 5\n");
  }
}

TEST_CASE("limits: a file that may not grow so much ends the run, and the solutions before it stay") {
  const Workplace place;
  const std::string script = place.file("uneven.sol", kUneven);
  const Outcome outcome = run_in_shell("ulimit -f 1600 && exec \"$0\" \"$@\"",
                                       {"generate", script, "--all", "-o", (place / "out").string()});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 3);
  CHECK(has(outcome.err, ".glb: File too large\n"));
  check_ended_in_order(place / "out");
}

TEST_CASE("limits: so does a full disk") {
  const Workplace place;
  const std::string script = place.file("many.sol", kMany);
  const std::string disk = (place / "disk").string();
  fs::create_directory(disk);
  constexpr const char* kMount = "mount -t tmpfs -o size=1600k tmpfs ";
  if (run({"unshare", "-rm", "sh", "-c", kMount + disk}).status != 0) return;  // not allowed here
  // The disk goes with the shell that has it.
  const Outcome outcome = run({"unshare", "-rm", "sh", "-c",
                               kMount + disk + " && \"$0\" generate \"$1\" -n 1000 -o " + disk +
                                   "; status=$?; cp -r " + disk + " \"$2\"; exit $status",
                               SOLITAIRE_PROGRAM, script, (place / "out").string()});
  CAPTURE(outcome.err);
  CHECK(outcome.status == 3);
  CHECK(has(outcome.err, "/many-"));
  CHECK(has(outcome.err, ": No space left on device\n"));
  CHECK(solutions_in(place / "out") > 0);
  check_whole(place / "out");
  for (const fs::path& file : entries(place / "out")) CHECK(file.extension() != ".part");
}

/// Runs generate and stops it so many milliseconds later.
Outcome stopped_after(int delay, int signal, const std::string& script, const fs::path& folder) {
  const std::string engine = delay % 80 == 0 ? "z3" : "cadical";
  Command command(solitaire_with({"generate", script, "-n", "100000", "--seed", std::to_string(delay),
                                  "--engine", engine, "-o", folder.string()}));
  std::this_thread::sleep_for(milliseconds(delay));
  command.signal(signal);
  return command.wait();
}

TEST_CASE("limits: killed at any moment, a run leaves whole files only, over those of earlier runs") {
  const Workplace place;
  const std::string script = place.file("many.sol", kMany);
  REQUIRE(run_solitaire({"generate", script, "-n", "3", "-o", (place / "out").string()}).status == 0);
  for (int delay = 10; delay <= 300; delay += 25) {
    CHECK(stopped_after(delay, SIGKILL, script, place / "out").status == 128 + SIGKILL);
  }
  check_whole(place / "out");
}

TEST_CASE("limits: interrupted at any moment, a run shows what it has (slow)") {
  const Workplace place;
  const std::string script = place.file("many.sol", kMany);
  for (int delay = 20; delay <= 300; delay += 28) {
    const fs::path folder = place / std::to_string(delay);
    const Outcome outcome = stopped_after(delay, delay % 4 == 0 ? SIGTERM : SIGINT, script, folder);
    CAPTURE(outcome.err);
    if (!fs::exists(folder)) continue;  // it had hardly started
    CHECK(outcome.status == 4);
    check_ended_in_order(folder);
  }
}

TEST_CASE("limits: so does one whose time is over at any moment (slow)") {
  const Workplace place;
  const std::string script = place.file("many.sol", kMany);
  for (int delay = 0; delay <= 300; delay += 30) {
    const fs::path folder = place / std::to_string(delay);
    const Outcome outcome = run_solitaire({"generate", script, "-n", "100000", "--timeout",
                                           std::to_string(delay / 1000.0), "-o", folder.string()});
    CAPTURE(outcome.err);
    CHECK(outcome.status == 4);
    check_ended_in_order(folder);
  }
}

/// Interrupts a run by the signal, at the moment, again and again until it comes to its end, and compares
/// what is there then with a run that was left in peace.
void check_resumed(int signal, int milliseconds_each) {
  const Workplace place;
  const std::string script = place.file("many.sol", kMany);
  const Arguments whole = {"generate", script, "-n", "150", "-o", place / "whole"};
  const Arguments parts = {"generate", script, "-n", "150", "-o", place / "parts", "--resume"};
  REQUIRE(run_solitaire(whole).status == 0);
  for (int i = 0; i < 6; ++i) {
    Command command(solitaire_with(parts));
    std::this_thread::sleep_for(milliseconds(milliseconds_each * (1 + i % 3)));
    command.signal(signal);
    const int status = command.wait().status;
    CHECK((status == 0 || status == 4 || status == 128 + signal));
    check_whole(place / "parts");
  }
  CHECK(run_solitaire(parts).status == 0);
  for (const fs::path& folder : {place / "parts", place / "parts/page"}) {
    for (const fs::path& file : entries(folder)) {
      if (file.extension() == ".part") fs::remove(file);
    }
  }
  CHECK(run({"diff", "-r", place / "whole", place / "parts"}).out == "");
}

TEST_CASE("limits: a run that was killed again and again goes on to what it would have come to") {
  check_resumed(SIGKILL, 40);
}
TEST_CASE("limits: so does one that was interrupted again and again") { check_resumed(SIGINT, 60); }

TEST_CASE("limits: of a search for the best, the best so far is kept (slow)") {
  const Workplace place;
  const std::string script = place.file("best.sol",
                                        "xs = [range(0, 199) for i in 1..10];\nassert(distinct(xs));\n"
                                        "minimize(sum([abs(xs[i] * xs[i + 1] - 997 * i) for i in 0..8]));\n"
                                        "place(\"chair\", at: [xs[0], xs[1]], size: [1, 1]);\nreturn xs;\n");
  for (const std::string engine : {"cadical", "z3"}) {
    CAPTURE(engine);
    const fs::path out = place / engine;
    const Outcome outcome = run_promptly(1.5, [&] {
      return run_solitaire(
          {"generate", script, "-n", "1", "--engine", engine, "--timeout", "1.5", "-o", out});
    });
    CHECK((outcome.status == 4 || outcome.status == 0));  // with the limit as the solution came
    CHECK(has(outcome.err, "not proved the best left"));
    CHECK(solutions_in(out) == 1);
    check_ended_in_order(out);
  }
  // With a time for each solution, the search for others goes on.
  const Outcome outcome = run_solitaire({"solve", script, "-n", "2", "--per-solution", "3"});
  CHECK(outcome.status == 0);
}

}  // namespace
}  // namespace solitaire
