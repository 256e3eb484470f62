// The library by itself, as another program uses it: of all headers, only the public ones.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <map>
#include <set>
#include <solitaire/solitaire.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "tests/support/command.h"
#include "tests/support/text.h"

namespace solitaire::api {
namespace {

constexpr const char* kPairs =
    "x = range(0, 3);\ny = range(0, 3);\nassert(x + y == 3, \"three\");\nreturn [x, y];\n";
/// Has no solution that could be found or excluded in time.
constexpr const char* kHard =
    "n = range(0, 2000000000);\nm = range(0, 2000000000);\n"
    "assert(n > 1 and m > 1 and n <= m and n * m == 1000000016000000063 and n != 1000000007);\nreturn [n, "
    "m];\n";
constexpr const char* kScene =
    "x = range(0, 50);\ny = range(0, 50);\nassert(x + y > 20);\n"
    "place(\"chair\", at: [x, y], size: [1, 1]);\nreturn [x, y];\n";

/// Finds all solutions of a program and returns their values, sorted.
std::vector<std::string> values_of(const Program& program) {
  SearchOptions options;
  options.all = true;
  Search search(program, options);
  std::vector<std::string> values;
  for (const Solution& solution : search) values.push_back(solution.text);
  CHECK(search.ending() == Ending::kExhausted);
  std::sort(values.begin(), values.end());
  return values;
}

/// Does the work and returns the error that comes out of it, which there has to be.
template <class Work>
Error error_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error;
  }
  FAIL("no error");
  return {Error::Kind::kInternal, ""};
}

TEST_CASE("library: a program from a text, with a param, gives its solutions one after the other") {
  Program program = Program::from_text("text.sol", "param n = 1;\nx = range(1, n);\nreturn [n, x];\n");
  CHECK(program.params() == std::vector<std::string>{"n"});
  CHECK(values_of(program) == std::vector<std::string>{"[1, 1]"});
  Program other = program;
  other.set("n", "2");
  CHECK(values_of(other) == std::vector<std::string>{"[2, 1]", "[2, 2]"});
  CHECK(values_of(program).size() == 1);
}

TEST_CASE("library: a search ends after as many solutions as were wanted") {
  SearchOptions options;
  options.count = 2;
  Search search(Program::from_text("pairs.sol", kPairs), options);
  CHECK(search.next()->number == 1);
  CHECK(search.next()->number == 2);
  CHECK(!search.next());
  CHECK(search.ending() == Ending::kNone);
  CHECK(search.summary().solutions == 2);
  CHECK(search.summary().choice_distance == 1);  // no x and no y twice
}

TEST_CASE("library: solutions are structured values, and JSON") {
  const Program program = Program::from_text(
      "values.sol", "record P(a, b);\nf = flip();\nassert(f);\nreturn [P(3, nil), 0.5, \"t\", f];\n");
  Search search(program, {});
  const Solution solution = search.next().value();
  const auto& items = std::get<List>(solution.value.is).items;
  const auto& record = std::get<Record>(items.at(0).is);
  CHECK(record.type == "P");
  CHECK(record.fields.at(0).name == "a");
  CHECK(std::get<std::int64_t>(record.fields.at(0).value.is) == 3);
  CHECK(std::holds_alternative<Nil>(record.fields.at(1).value.is));
  CHECK(std::get<double>(items.at(1).is) == 0.5);
  CHECK(std::get<std::string>(items.at(2).is) == "t");
  CHECK(std::get<bool>(solution.choices.at(0).value));
  CHECK(to_json(solution) ==
        "{\"index\":1,\"value\":[{\"a\":3,\"b\":null},0.5,\"t\",true],\"choices\":[{\"at\":\"f\",\"value\":"
        "true}]}");
  CHECK(to_text(solution) == "solution 1: [P(a: 3, b: nil), 0.5, \"t\", true]\n  f = true\n");
}

TEST_CASE("library: imports come from buffers where there are any, and else from the disk") {
  const Workplace place;
  place.file("part.sol", "part = \"disk\";\n");
  const std::string script =
      place.file("main.sol", "import \"part.sol\";\nimport \"more.sol\";\nreturn [part, more];\n");
  Files files;
  files.buffer = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    if (path == std::filesystem::canonical(place.path()) / "more.sol") return "more = \"buffer\";\n";
    return std::nullopt;
  };
  CHECK(values_of(Program::load(script, files)) == std::vector<std::string>{"[\"disk\", \"buffer\"]"});
  CHECK(error_of([&] { Program::load(script); }).kind() == Error::Kind::kProgram);
}

TEST_CASE("library: a program is analyzed as far as it can be understood, without an exception") {
  const Workplace place;
  const std::string script = place.file("main.sol", "x = ;\ny = widht;\n");
  std::string text = "x = ;\ny = widht;\n";
  Files files;
  files.buffer = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    if (path.filename() == "main.sol") return text;
    return std::nullopt;
  };
  const Analysis wrong = analyze(script, files);
  CHECK(!wrong.program);
  REQUIRE(wrong.diagnostics.size() == 2);
  CHECK(wrong.diagnostics[0].line == 1);
  CHECK(wrong.diagnostics[1].severity == Severity::kError);
  CHECK(has(wrong.diagnostics[1].message, "widht"));
  text = "return 5;\n";
  CHECK(values_of(analyze(script, files).program.value()) == std::vector<std::string>{"5"});
  const Analysis missing = analyze(place / "none.sol");
  CHECK(missing.diagnostics.size() == 1);
  CHECK(!missing.program);
}

TEST_CASE("library: two searches in one process, on two threads with different programs") {
  std::vector<std::string> pairs, squares;
  std::thread first([&] {
    for (int i = 0; i < 5; ++i) pairs = values_of(Program::from_text("pairs.sol", kPairs));
  });
  std::thread second([&] {
    const Program program =
        Program::from_text("squares.sol", "x = range(-9, 9);\nassert(x * x == 16);\nreturn x;\n");
    for (int i = 0; i < 5; ++i) squares = values_of(program);
  });
  first.join();
  second.join();
  CHECK(pairs == std::vector<std::string>{"[0, 3]", "[1, 2]", "[2, 1]", "[3, 0]"});
  CHECK(squares == std::vector<std::string>{"-4", "4"});
}

TEST_CASE("library: threads may share a program") {
  const Program program = Program::from_text("pairs.sol", kPairs);
  std::array<std::vector<std::string>, 3> values;
  std::vector<std::thread> threads;
  for (auto& each : values) threads.emplace_back([&each, &program] { each = values_of(program); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& each : values) CHECK(each.size() == 4);
}

TEST_CASE("library: a search is cancelled from another thread") {
  for (const Solver solver : {Solver::kCadical, Solver::kZ3}) {
    const StopSource stop;
    SearchOptions options;
    options.solver = solver;
    options.stop = stop.token();
    Search search(Program::from_text("hard.sol", kHard), options);
    std::thread canceller([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      stop.request();
    });
    CHECK(!search.next());
    canceller.join();
    CHECK(search.ending() == Ending::kStopped);
    CHECK(search.stop_token().reason() == StopReason::kInterrupt);
  }
}

TEST_CASE("library: limits of time stop a search, and say which") {
  SearchOptions options;
  options.seconds_per_solution = 0.1;
  Search slow(Program::from_text("hard.sol", kHard), options);
  CHECK(!slow.next());
  CHECK(slow.stop_token().reason() == StopReason::kTimePerSolution);

  const StopSource stop;
  stop.set_deadline(std::chrono::steady_clock::now());
  options.stop = stop.token();
  Search late(Program::from_text("pairs.sol", kPairs), options);
  CHECK(!late.next());
  CHECK(late.ending() == Ending::kStopped);
  CHECK(late.stop_token().reason() == StopReason::kTime);
}

TEST_CASE("library: a stop holds although its deadline was moved afterwards") {
  const StopSource stop;
  const StopSource part(stop.token());
  part.set_deadline(std::chrono::steady_clock::now());
  part.set_deadline(std::chrono::steady_clock::time_point::max());
  CHECK(part.reason() == StopReason::kTime);
  CHECK(stop.reason() == StopReason::kNone);
  stop.request(StopReason::kMemory);
  stop.request(StopReason::kInterrupt);
  CHECK(stop.reason() == StopReason::kMemory);
  CHECK(StopToken().reason() == StopReason::kNone);
}

TEST_CASE("library: solutions are kept after their search is gone, and read on another thread") {
  std::vector<Solution> kept;
  {
    SearchOptions options;
    options.count = 3;
    Search search(Program::from_text("scene.sol", kScene), options);
    for (const Solution& solution : search) kept.push_back(solution);
  }
  std::string json;
  std::thread([&] {
    for (const Solution& solution : kept) json += to_json(solution);
  }).join();
  CHECK(has(json, "{\"index\":3,"));
  CHECK(kept.at(2).placements.at(0).choices.size() == 2);
}

TEST_CASE("library: other threads see how far a search is while it goes on") {
  SearchOptions options;
  options.all = true;
  Search search(Program::from_text("many.sol", "x = range(0, 3000);\nreturn x;\n"), options);
  std::atomic<bool> over = false;
  std::uint64_t seen = 0;
  std::thread watcher([&] {
    while (!over) seen = std::max(seen, search.summary().solutions);
  });
  std::uint64_t found = 0;
  while (search.next()) ++found;
  over = true;
  watcher.join();
  CHECK(found == 3001);
  CHECK(seen <= found);
}

class Events : public SearchObserver {
 public:
  void begun() override { ++begun_; }
  void explored(std::size_t nodes) override { nodes_ = nodes; }
  void improved(const Solution& best) override { costs_.push_back(best.quality.value().cost); }

  int begun_ = 0;
  std::size_t nodes_ = 0;
  std::vector<std::int64_t> costs_;
};

TEST_CASE("library: an observer is told how far a search is") {
  Events events;
  Search search(
      Program::from_text("best.sol", "x = range(0, 9);\nassert(x != 3);\nminimize(abs(x - 3));\nreturn x;\n"),
      {});
  search.observe(&events);
  const Solution best = search.next().value();
  CHECK(best.quality->cost == 1);
  CHECK(best.quality->proved_best);
  CHECK(quality_text(best) == "cost 1, proved the best left");
  CHECK(best.quality->least_cost == 1);
  Solution open = best;
  open.quality->proved_best = false;
  open.quality->least_cost = 0;
  CHECK(quality_text(open) == "cost 1, not proved the best left, but none costs less than 0");
  open.quality->cost = -37;
  open.quality->is_maximum = true;
  open.quality->least_cost = -48;
  CHECK(quality_text(open) == "maximum 37, not proved the best left, but none has more than 48");
  CHECK(events.begun_ == 1);
  CHECK(events.nodes_ > 0);
  CHECK(std::is_sorted(events.costs_.rbegin(), events.costs_.rend()));
  CHECK(!search.take_best_so_far());
}

/// Takes longer over the first solution than the time for one and for ending it.
class SlowReader : public SearchObserver {
 public:
  void improved(const Solution&) override {
    if (!std::exchange(slept_, true)) std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  }

 private:
  bool slept_ = false;
};

TEST_CASE("library: a solution that comes after its time leaves the next one all of its own") {
  SlowReader reader;
  SearchOptions options;
  options.seconds_per_solution = 2;
  options.count = 2;
  Search search(
      Program::from_text("best.sol", "x = range(0, 9);\nassert(x != 3);\nminimize(abs(x - 3));\nreturn x;\n"),
      options);
  search.observe(&reader);
  CHECK(search.next());
  CHECK(search.next());
  CHECK(search.stop_token().reason() == StopReason::kNone);
}

TEST_CASE("library: an error has its places and its text") {
  const Error error = error_of([] { Program::from_text("wrong.sol", "x = widht;\ny = hight;\n"); });
  CHECK(error.kind() == Error::Kind::kProgram);
  REQUIRE(error.diagnostics().size() == 2);
  const Diagnostic& first = error.diagnostics().front();
  CHECK(first.file == "wrong.sol");
  CHECK(first.line == 1);
  CHECK(first.column == 5);
  CHECK(first.end_column == 10);
  CHECK(has(first.message, "there is no 'widht' here"));
  CHECK(has(error.what(),
            "wrong.sol:1:5: error: there is no 'widht' here\n  1 | x = widht;\n    |     ^^^^^\n"));
  CHECK(has(error.what(), "2 errors\n"));
}

TEST_CASE("library: errors say what kind they are") {
  Program program = Program::from_text("seats.sol", "fun seat() { return range(0, 9); }\nreturn seat();\n");
  CHECK(error_of([&] { program.set("n", "1"); }).kind() == Error::Kind::kUsage);
  CHECK(error_of([] { Program::load("/nowhere/none.sol"); }).kind() == Error::Kind::kFile);
  CHECK(error_of([] { parse_pin("x", false, "the pin"); }).kind() == Error::Kind::kUsage);
  SearchOptions options;
  options.pins.push_back(parse_pin("saet/range=3", false, "the pin"));
  const Error unmatched = error_of([&] { Search(program, options).next(); });
  CHECK(unmatched.kind() == Error::Kind::kUsage);
  CHECK(has(unmatched.what(), "the nearest is seat/range"));
  SearchOptions wrong;
  wrong.explore = "everywhere";
  CHECK(error_of([&] { Search(program, wrong); }).kind() == Error::Kind::kUsage);
}

TEST_CASE("library: pins hold, also those of a file") {
  const Workplace place;
  const Program program = Program::from_text("pairs.sol", kPairs);
  SearchOptions options;
  options.pins.push_back({"x", std::int64_t{2}, false, "x=2"});
  const Solution liked = Search(program, options).next().value();
  CHECK(liked.text == "[2, 1]");
  SearchOptions same;
  same.all = true;
  same.pin_file = place.file("liked.json", to_json(liked));
  same.keep = {"y"};
  Search search(program, same);
  CHECK(search.next()->text == "[2, 1]");
  CHECK(!search.next());
}

TEST_CASE("library: a search goes on after solutions that are known") {
  const Program program = Program::from_text("pairs.sol", kPairs);
  SearchOptions options;
  options.count = 4;
  std::vector<std::vector<Choice>> known;
  std::set<std::string> all;
  Search first(program, options);
  for (int i = 0; i < 2; ++i) {
    const Solution solution = first.next().value();
    all.insert(solution.text);
    known.push_back(solution.choices);
  }
  Search second(program, options);
  CHECK(second.resume(known).size() == 2);
  for (const Solution& solution : second) all.insert(solution.text);
  CHECK(all.size() == 4);
  CHECK(second.summary().earlier == 2);
  known.front().front().value = std::int64_t{77};
  CHECK(error_of([&] { Search(program, options).resume(known); }).kind() == Error::Kind::kFile);
}

TEST_CASE("library: what the library places is said to come from the program's call") {
  const Program program = Program::from_text("room.sol",
                                             "import \"std/layout.sol\";\n"
                                             "fun seat(x) {\n"
                                             "  show(Thing(\"chair\", 1, 1, 0, x, 0));\n"
                                             "  place(\"lamp\", at: [x, 2]);\n"
                                             "}\n"
                                             "seat(range(1, 2));\n"
                                             "show_room(Rect(0, 0, 5, 5));\n");
  Search search(program, {});
  std::map<std::string, std::set<std::string>> places;
  const auto solution = search.next();
  REQUIRE(solution.has_value());
  for (const Placement& placement : solution->placements)
    places[placement.asset.empty() ? placement.name : placement.asset].insert(placement.source);
  CHECK(places.at("chair") == std::set<std::string>{"room.sol:3:3"});
  CHECK(places.at("lamp") == std::set<std::string>{"room.sol:4:3"});
  for (const auto& each : places) {
    CAPTURE(each.first);
    if (each.first != "chair" && each.first != "lamp")
      CHECK(each.second == std::set<std::string>{"room.sol:7:1"});
  }
  CHECK(places.size() > 2);
}

TEST_CASE("library: scenes, a page and what there is to say about a run go to a folder") {
  const Workplace place;
  const Program program = Program::from_text("scene.sol", kScene);
  SearchOptions options;
  options.count = 2;
  Search search(program, options);
  OutputFolder output(place / "out", program, options);
  for (const Solution& solution : search) output.add(solution, search.summary());
  CHECK(output.close(search.ending()) == place / "out/index.html");
  for (const char* file : {"scene-0001.glb", "scene-0002.json", "index.html", "scene-run.json"})
    CHECK(std::filesystem::exists(place / "out" / file));
  CHECK(has(bytes_of(place / "out/scene-run.json"), "\"ended\": \"enough\""));

  options.count = 3;
  Search more(program, options);
  OutputFolder again(place / "out", program, options);
  again.resume(more);
  CHECK(more.next()->number == 3);
}

TEST_CASE("library: a single scene goes to a file") {
  const Workplace place;
  const Program program = Program::from_text("scene.sol", kScene);
  const Solution solution = Search(program, {}).next().value();
  write_glb(solution, program, "one", place / "one.glb");
  CHECK(bytes_of(place / "one.glb").rfind("glTF", 0) == 0);
  Solution nothing = solution;
  nothing.placements.clear();
  CHECK(error_of([&] { write_glb(nothing, program, "none", place / "none.glb"); }).kind() ==
        Error::Kind::kFile);
  CHECK(!std::filesystem::exists(place / "none.glb"));
}

TEST_CASE("library: a program without solutions is explained") {
  const Program program = Program::from_text("none.sol", "x = range(0, 3);\nassert(x > 5, \"large\");\n");
  Explainer explainer(program, {});
  const Conflict conflict = explainer.next().value();
  CHECK(conflict.minimal);
  REQUIRE(conflict.members.size() == 2);
  CHECK(conflict.members[0].words == "x is at most 3");
  CHECK(conflict.members[1].kind == "assert");
  CHECK(conflict.members[1].place.line == 2);
  CHECK(conflict.members[1].message == "large");
  CHECK(has(conflict.text, "these 2 cannot hold together:\nnone.sol:1:5: range: x is at most 3\n"));
  CHECK(!explainer.next());
  CHECK(explainer.ending() == Ending::kExhausted);
}

TEST_CASE("library: solutions are counted") {
  Counter counter(Program::from_text("pairs.sol", kPairs), {});
  const Count count = counter.run().value();
  CHECK(count.digits == "4");
  CHECK(to_text(count) == "4 solutions");
  CHECK(to_json(count) == "{\"solutions\":4,\"exact\":true}");
}

TEST_CASE("library: a program is checked, and its trace shown") {
  const Program program = Program::from_text(
      "deep.sol", "x = range(0, 9);\nif x == 7 then { z = 1 + \"a\"; }\nif x == 8 then { z = x.w; }\n");
  CHECK(check(program, {}).errors.size() == 1);
  const Checked deep = check(program, {}, true);
  CHECK(deep.errors.size() == 2);
  CHECK(deep.complete);
  const std::string both = deep.errors.at(0).text + deep.errors.at(1).text;
  CHECK(has(both, "note: where x = 7"));
  CHECK(has(both, "note: where x = 8"));
  CHECK(has(trace(Program::from_text("pairs.sol", kPairs), {}), "assert"));
}

/// Puts a file in the place of standard output and standard error.
class Silence {
 public:
  explicit Silence(const std::string& file) {
    const int to = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
      saved_.push_back(dup(descriptor));
      dup2(to, descriptor);
    }
    close(to);
  }
  ~Silence() {
    for (const int descriptor : {STDERR_FILENO, STDOUT_FILENO}) {
      dup2(saved_.back(), descriptor);
      close(saved_.back());
      saved_.pop_back();
    }
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::vector<int> saved_;
};

TEST_CASE("library: nothing is written to standard output or standard error") {
  const Workplace place;
  std::vector<std::string> printed;
  {
    const Silence silence(place / "said");
    const Program program =
        Program::from_text("print.sol", "print(\"hello\");\nplace(\"chair\", at: [0, 0]);\n");
    SearchOptions options;
    options.all = true;
    Search search(program, options);
    OutputFolder output(place / "out", program, options);
    for (const Solution& solution : search) {
      printed = solution.printed;
      output.add(solution, search.summary());
    }
    output.close(search.ending());
    try {
      Program::from_text("wrong.sol", "x = ;\n");
    } catch (const Error&) {
      printed.emplace_back("an error");
    }
  }
  CHECK(bytes_of(place / "said").empty());
  CHECK(printed == std::vector<std::string>{"hello", "an error"});
}

}  // namespace
}  // namespace solitaire::api
