// Runs the program in the ways in which threads work side by side: several searches, limits and interrupts
// that end them, and the watchdog that delivers while the search goes on. Under ThreadSanitizer (bin/test
// --sanitize-threads) a data race is reported on standard error, wherever it is met; without it, the outcomes
// are checked alone.
#include <chrono>
#include <csignal>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "tests/support/command.h"

namespace solitaire {
namespace {

using Arguments = std::vector<std::string>;

/// Has more solutions than anyone waits for, each with lists, records and strings: values that are counted
/// references.
constexpr const char* kRooms =
    "record Room(name, doors);\n"
    "fun room(i) { x = range(0, 40); y = range(0, 40); return Room(\"room \" + str(i), [x, [y, x * y]]); }\n"
    "rooms = [room(i) for i in 0..5];\n"
    "for i in 0..4 { assert(rooms[i].doors[0] != rooms[i + 1].doors[0]); }\n"
    "for r in rooms { place(r.name, at: [r.doors[0], r.doors[1][0]], size: [1, 1]); print(r); }\n"
    "return rooms;\n";

/// Gets better for longer than anyone waits: there is always a best solution so far, and a search at work.
constexpr const char* kEverBetter =
    "record Best(name, values);\n"
    "xs = [range(0, 9999) for i in 1..12];\nassert(distinct(xs));\n"
    "minimize(sum([abs(xs[i] * xs[i + 1] - 99997 * i) for i in 0..10]));\n"
    "print(\"values\", xs);\nreturn Best(\"best \" + str(xs[0]), [xs, [xs[1], \"a\"]]);\n";

/// Is one formula that a solver does not look up from for a long time.
constexpr const char* kLarge =
    "record Best(name, values);\nk = range(0, 3);\nminimize(3 - k);\n"
    "if k == 3 {\n  xs = [range(0, 1000000) for i in 1..700];\n"
    "  for x in xs { for y in xs { assert(x * y != 17 * x + 1); } }\n}\nreturn Best(\"k \" + str(k), [k, "
    "[k]]);\n";

/// Finds a solution at once. Better ones need paths of more than 200 calls, which are explored later, and
/// come with a formula that a solver does not look up from for a long time.
constexpr const char* kLaterLarge =
    "record Best(name, values);\nd = range(0, 260);\nminimize(260 - d);\n"
    "fun down(n) {\n  if n == d { return 0; }\n  if n == 230 {\n"
    "    xs = [range(0, 1000000) for i in 1..700];\n"
    "    for x in xs { for y in xs { assert(x * y != 17 * x + 1); } }\n  }\n  return down(n + 1);\n}\n"
    "return Best(\"best so far\", [d, [down(0)]]);\n";

void check_no_race(const Outcome& outcome) {
  const std::size_t report = outcome.err.find("ThreadSanitizer");
  const bool raced = report != std::string::npos;
  CHECK_MESSAGE(!raced, outcome.err.substr(raced ? report : 0, 20000));
}

/// Runs the program; a limit or an interrupt may end it.
Outcome run_checked(const Arguments& arguments) {
  const Outcome outcome = run_solitaire(arguments);
  check_no_race(outcome);
  return outcome;
}

void check_interrupted(const std::string& script, const Arguments& more, int milliseconds) {
  CAPTURE(milliseconds);
  Arguments arguments = {"solve", script, "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Command command(solitaire_with(arguments));
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  command.signal(SIGINT);
  const Outcome outcome = command.wait();
  check_no_race(outcome);
  CHECK((outcome.status == 4 || outcome.status == 0 || outcome.status == 128 + SIGINT));
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) CHECK(nlohmann::json::accept(line));
}

}  // namespace

TEST_CASE("threads: several chains side by side draw what one after the other draw") {
  const Workplace place;
  const std::string script = place.file("chains.sol",
                                        "record Point(x, name);\n"
                                        "n = range(1, 3);\nxs = [gamma(2, 1) for i in 1..n];\n"
                                        "for x in xs: observe(Poisson(x), 3);\n"
                                        "return n, Point(sum(xs), \"n \" + str(n));\n");
  for (const char* engine : {"shred", "lightweight"}) {
    const auto draws = [&](const std::string& jobs) {
      const std::filesystem::path file = place / (engine + jobs + ".csv");
      const Outcome outcome = run_checked({"sample", script, "-n", "200", "--warmup", "60", "--engine",
                                           engine, "--jobs", jobs, "--draws", file, "--json"});
      CHECK(outcome.status == 0);
      return bytes_of(file);
    };
    CHECK(draws("1") == draws("4"));
  }
}

TEST_CASE("threads: several jobs find what one job finds") {
  const Workplace place;
  const std::string script = place.file("rooms.sol", kRooms);
  const Outcome one = run_checked({"solve", script, "-n", "60", "--json", "--jobs", "1"});
  CHECK(one.status == 0);
  for (const char* jobs : {"2", "4"}) {
    const Outcome several = run_checked({"solve", script, "-n", "60", "--json", "--jobs", jobs});
    CHECK(several.out == one.out);
  }
}

TEST_CASE("threads: several jobs write scenes") {
  const Workplace place;
  const std::string script = place.file("rooms.sol", kRooms);
  const Outcome outcome =
      run_checked({"generate", script, "-n", "40", "--jobs", "4", "-o", (place / "out").string()});
  CHECK(outcome.status == 0);
}

TEST_CASE("threads: an interrupt ends several jobs at any moment") {
  const Workplace place;
  const std::string script = place.file("rooms.sol", kRooms);
  for (const int moment : {20, 60, 150, 400, 900}) {
    check_interrupted(script, {"-n", "100000", "--jobs", "4"}, moment);
  }
}

TEST_CASE("threads: a limit ends several jobs at any moment") {
  const Workplace place;
  const std::string script = place.file("rooms.sol", kRooms);
  for (const char* limit : {"0.05", "0.2", "0.6"}) {
    CHECK(run_checked({"solve", script, "-n", "100000", "--jobs", "4", "--timeout", limit}).status == 4);
  }
}

TEST_CASE("threads: a limit comes while the best solution so far is made better") {
  const Workplace place;
  const std::string script = place.file("better.sol", kEverBetter);
  for (const char* limit : {"0.3", "0.7", "1.5"}) {
    const Outcome outcome = run_checked({"solve", script, "--json", "--timeout", limit});
    CHECK((outcome.status == 4 || outcome.status == 0));
  }
  check_interrupted(script, {}, 500);
}

TEST_CASE("threads: the watchdog delivers the best solution so far while the search does not look up") {
  const Workplace place;
  const std::string script = place.file("large.sol", kLaterLarge);
  for (const char* engine : {"cadical", "z3"}) {
    CAPTURE(std::string(engine));
    const Outcome outcome = run_checked({"solve", script, "--json", "--timeout", "6", "--engine", engine});
    CHECK((outcome.status == 4 || outcome.status == 0));
    CHECK(outcome.out.find("\"best so far\"") != std::string::npos);
  }
}

TEST_CASE("threads: the memory limit is looked at while several jobs search") {
  const Workplace place;
  const std::string script = place.file("rooms.sol", kRooms);
  const Outcome outcome = run_checked({"solve", script, "-n", "100000", "--jobs", "4", "--memory", "60"});
  CHECK(outcome.status == 4);
}

TEST_CASE("threads: explaining and counting end at a limit") {
  const Workplace place;
  const std::string script = place.file("large.sol", kLarge);
  for (const char* command : {"explain", "count", "check"}) {
    CHECK(run_checked({command, script, "--timeout", "1"}).status == 4);
  }
}

}  // namespace solitaire
