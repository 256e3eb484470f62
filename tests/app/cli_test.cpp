// The command line as a user has it: the built program, its exit status, its output and its files.
#include <algorithm>
#include <chrono>
#include <doctest/doctest.h>
#include <fcntl.h>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/file.h>
#include <unistd.h>
#include <z3++.h>

#include "scene/gltf/reader.h"
#include "tests/support/command.h"
#include "tests/support/program_run.h"
#include "tests/support/text.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kPairs = "x = range(0, 3);\ny = range(0, 3);\nassert(x + y == 3);\nreturn [x, y];\n";
constexpr const char* kNone = "x = range(0, 3);\nassert(x > 5);\n";
constexpr const char* kScene =
    "x = range(0, 50);\ny = range(0, 50);\nassert(x + y > 20);\n"
    "place(\"chair\", at: [x, y], size: [1, 1]);\nreturn [x, y];\n";
constexpr const char* kWrong = "x = 1 + \"a\";\n";

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_CASE("cli: the exit status says whether what was asked for was delivered") {
  const Workplace place;
  const std::string pairs = place.file("pairs.sol", kPairs);
  const std::string none = place.file("none.sol", kNone);
  const std::string wrong = place.file("wrong.sol", kWrong);
  CHECK(run_solitaire({"solve", pairs}).status == 0);
  CHECK(run_solitaire({"solve", pairs, "-n", "4"}).status == 0);
  CHECK(run_solitaire({"solve", pairs, "-n", "5"}).status == 1);
  CHECK(run_solitaire({"solve", pairs, "--all"}).status == 0);
  CHECK(run_solitaire({"solve", none}).status == 1);
  CHECK(run_solitaire({"solve", none, "--all"}).status == 1);
  CHECK(run_solitaire({"solve", wrong}).status == 3);
  CHECK(run_solitaire({"check", wrong}).status == 3);
  CHECK(run_solitaire({"check", pairs}).status == 0);
  CHECK(run_solitaire({"check", none}).status == 0);
  CHECK(run_solitaire({"generate", none, "-o", place / "none"}).status == 1);
  CHECK(run_solitaire({"--help"}).status == 0);
  CHECK(run_solitaire({"--version"}).status == 0);
  CHECK(run_solitaire({"solve", "--help"}).status == 0);
}

TEST_CASE("cli: wrong usage is status 2, said on standard error") {
  const Workplace place;
  const std::string pairs = place.file("pairs.sol", kPairs);
  const std::string with_param = place.file("param.sol", "param n = 3;\nreturn n;\n");
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"frobnicate", pairs},
      {"solve"},
      {"solve", pairs, "-n", "0"},
      {"solve", pairs, "-n", "many"},
      {"solve", pairs, "-n", "1", "--all"},
      {"solve", pairs, "--explore", "random"},
      {"solve", pairs, "--explore", "random:0"},
      {"solve", pairs, "--distinct", "colour"},
      {"solve", pairs, "--timeout", "-1"},
      {"solve", pairs, "--per-solution", "-1"},
      {"check", pairs, "--per-solution", "1"},
      {"solve", pairs, "--memory", "0"},
      {"solve", pairs, "--max-steps", "0"},
      {"solve", pairs, "--set", "n"},
      {"solve", pairs, "--set", "n=1"},
      {"solve", with_param, "--set", "m=1"},
      {"solve", with_param, "--set", "n=true"},
      {"trace", pairs, "--format", "png"},
      {"solve", pairs, pairs},
  };
  for (const auto& arguments : wrong) {
    const Outcome outcome = run_solitaire(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out == "");
    CHECK(outcome.err != "");
  }
}

TEST_CASE("cli: --json prints solutions to standard output and nothing else, whatever the program prints") {
  const Workplace place;
  const std::string script = place.file("print.sol",
                                        "record P(a, b);\nx = range(1, 3);\nf = flip();\nprint(\"x\", x);\n"
                                        "return [P(x, nil), 0.5, \"\\\"\", f];\n");
  const Outcome outcome = run_solitaire({"solve", script, "--all", "--json"});
  CHECK(outcome.status == 0);
  CHECK(lines_in(outcome.out) == 6);
  std::istringstream lines(outcome.out);
  std::size_t index = 0;
  for (std::string line; std::getline(lines, line);) {
    const json solution = json::parse(line);
    CHECK(solution["index"] == ++index);
    CHECK(solution["value"][0]["a"] == solution["choices"][0]["value"]);
    CHECK(solution["value"][0]["b"] == nullptr);
    CHECK(solution["value"][3] == solution["choices"][1]["value"]);
    CHECK(solution["choices"][0]["at"] == "x");
    CHECK(solution["choices"][1]["value"].is_boolean());
  }
  CHECK(has(outcome.err, "x 3\n"));
  CHECK(has(outcome.err, "proved that there is no other"));
}

TEST_CASE("cli: the text of a solution shows its value and its choices") {
  const Workplace place;
  const std::string script =
      place.file("text.sol", "fun f() { a = range(4, 4); return a; }\nreturn [f(), flip() or true];\n");
  const Outcome outcome = run_solitaire({"solve", script, "--distinct", "result", "--all"});
  const std::string expected = "solution 1: [4, true]\n  f/a = 4\n  flip = ";
  CHECK((outcome.out == expected + "true\n" || outcome.out == expected + "false\n"));
  CHECK(has(outcome.err, "1 solution in "));
  CHECK(has(outcome.err, "not counting 1 that look like others"));
  CHECK(run_solitaire({"solve", script, "-q"}).err == "");
}

TEST_CASE("cli: generate runs the program with every solution, and so does solve where that is asked for") {
  const Workplace place;
  const std::string script = place.file("runs.sol", "x = range(1, 60);\nreturn x;\n");
  const std::string solving = run_solitaire({"solve", script, "--all"}).err;
  CHECK(has(run_solitaire({"solve", script, "--check"}).err, ", checked by 1 run\n"));
  CHECK(has(solving, "60 solutions in "));
  CHECK(!has(solving, "checked by"));
  CHECK(has(run_solitaire({"solve", script, "--all", "--check"}).err, ", checked by 60 runs: proved"));
  const auto generate = [&](const char* folder, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"generate", script, "-o", place / folder};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_solitaire(arguments).err;
  };
  CHECK(has(generate("a", {"--all"}), ", checked by 60 runs: proved"));
  CHECK(has(generate("b", {"-n", "30", "--sample", "uniform"}), ", checked by 30 runs\n"));
  CHECK(has(generate("b", {"-n", "40", "--sample", "uniform", "--resume"}), ", checked by 40 runs\n"));
}

TEST_CASE("cli: params are set on the command line") {
  const Workplace place;
  const std::string script =
      place.file("param.sol", "param n = 3;\nparam name = \"x\";\nreturn [n, name];\n");
  const Outcome outcome =
      run_solitaire({"solve", script, "--json", "--set", "n=-4", "--set", "name=two words=2"});
  CHECK(outcome.out == "{\"index\":1,\"value\":[-4,\"two words=2\"],\"choices\":[]}\n");
  const Outcome wrong = run_solitaire({"solve", script, "--set", "m=4"});
  CHECK(has(wrong.err, "the program has no param 'm'"));
}

std::map<std::string, std::string> files_in(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = bytes_of(entry.path());
  }
  return files;
}

TEST_CASE("cli: generate writes the same bytes for the same seed, and other scenes for another") {
  const Workplace place;
  const std::string script = place.file("scene.sol", kScene);
  const auto generate = [&](const std::string& seed, const std::string& folder) {
    const Outcome outcome =
        run_solitaire({"generate", script, "-n", "3", "--seed", seed, "-o", place / folder});
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "");
    return files_in(place / folder);
  };
  const auto first = generate("7", "a");
  const auto beside_page = std::count_if(first.begin(), first.end(),
                                         [](const auto& file) { return file.first.rfind("page/", 0) == 0; });
  CHECK(beside_page == 2 * 3 + 4);
  CHECK(first.size() == 8 + 2 * 3 + 4);
  CHECK(first.count("scene-run.json") == 1);
  CHECK(first.count("scene-0003.glb") == 1);
  CHECK(first.count("scene-0003.json") == 1);
  CHECK(first.count("index.html") == 1);
  CHECK(first == generate("7", "b"));
  CHECK(first.at("scene-0001.json") != generate("8", "c").at("scene-0001.json"));
  const json solution = json::parse(first.at("scene-0002.json"));
  CHECK(solution["index"] == 2);
  CHECK(solution["seed"] == 7);
  CHECK(solution["choices"].size() == 2);
  CHECK(solution["value"].size() == 2);
}

TEST_CASE("cli: a run of several solutions says how much they differ, and generate how it ended") {
  const Workplace place;
  const std::string pairs = place.file("pairs.sol", kPairs);
  const auto manifest = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments = {"generate", pairs, "-o", place / "out"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_solitaire(arguments);
    CHECK(has(outcome.err, "mean distance of choices") == (outcome.err[0] > '1'));
    return json::parse(bytes_of(place / "out/pairs-run.json"));
  };
  const json all = manifest({"--all", "--seed", "9"});
  CHECK(all["ended"] == "exhausted");
  CHECK(all["solutions"] == 4);
  CHECK(all["mean_distance"]["choices"] == 1);  // no x and no y twice
  CHECK(all["mean_distance"]["results"] == 1);
  CHECK(all["options"]["all"] == true);
  CHECK(all["program"] == "pairs.sol");
  CHECK(all["seed"] == 9);
  CHECK(all["engine"] == "tracing/cadical");
  CHECK(!all.contains("timings"));
  CHECK(has(bytes_of(place / "out/index.html"), "mean distance of choices"));
  const json one = manifest({"-n", "1", "--timings"});
  CHECK(one["ended"] == "enough");
  CHECK(one["options"]["n"] == 1);
  CHECK(!one.contains("mean_distance"));
  CHECK(one["timings"].contains("solve"));
  CHECK(manifest({"-n", "4", "--timeout", "0"})["ended"] == "timeout");
  place.file("pairs.sol", kNone);
  CHECK(manifest({})["ended"] == "exhausted");
  CHECK(has(run_solitaire({"solve", place.file("same.sol", "x = range(1, 2);\nreturn 7;\n"), "--all"}).err,
            "mean distance of choices 1.00, of results 0.00\n"));
}

TEST_CASE("cli: solve prints the same for the same seed, by every way to explore and every solver") {
  const Workplace place;
  const std::string script = place.file("scene.sol", kScene);
  for (const auto& options :
       std::vector<std::vector<std::string>>{{}, {"--explore", "random:20"}, {"--engine", "z3"}}) {
    std::vector<std::string> arguments = {"solve", script, "-n", "5", "--json", "-q", "--seed", "3"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome first = run_solitaire(arguments);
    CHECK(first.status == 0);
    CHECK(first.out == run_solitaire(arguments).out);
    CHECK(lines_in(first.out) == 5);
  }
}

TEST_CASE("cli: random exploration says that it did not look everywhere") {
  const Workplace place;
  const std::string script =
      place.file("rare.sol", "x = range(0, 100000);\nif x == 77 { return \"rare\"; }\nassert(false);\n");
  const Outcome outcome = run_solitaire({"solve", script, "--explore", "random:3"});
  CHECK(outcome.status == 4);
  CHECK(has(outcome.err, "the paths that were explored"));
  CHECK(run_solitaire({"solve", script}).status == 0);
}

TEST_CASE("cli: a program that runs forever is an error with its place, by limits that can be set") {
  const Workplace place;
  const std::string loop = place.file("loop.sol", "x = range(0, 1);\nwhile x < 2 { y = x; }\n");
  const Outcome outcome = run_solitaire({"solve", loop, "--max-steps", "5000"});
  CHECK(outcome.status == 3);
  CHECK(has(outcome.err, "loop.sol:2:13: error: this runs for more than 5000 steps"));
  const std::string recursion = place.file("recursion.sol", "fun f(n) { return f(n + 1); }\nf(0);\n");
  const Outcome deep = run_solitaire({"check", recursion, "--max-depth", "100"});
  CHECK(deep.status == 3);
  CHECK(has(deep.err, "calls nest more than 100 deep"));
  const Outcome usual = run_solitaire({"check", recursion});
  CHECK(usual.status == 3);
  CHECK(has(usual.err, "calls nest more than 4000 deep"));
}

TEST_CASE("cli: files that cannot be read or written are said by name") {
  const Workplace place;
  const std::string scene = place.file("scene.sol", kScene);
  const Outcome missing = run_solitaire({"solve", place / "none.sol"});
  CHECK(missing.status == 3);
  CHECK(has(missing.err, "none.sol"));
  const Outcome folder = run_solitaire({"solve", place.path()});
  CHECK(folder.status == 3);
  CHECK(has(folder.err, place.path()));
  if (geteuid() != 0) {  // root may read everything
    const std::string secret = place.file("secret.sol", kPairs);
    fs::permissions(secret, fs::perms::none);
    CHECK(run_solitaire({"solve", secret}).status == 3);
  }
  const std::string in_the_way = place.file("taken", "a file");
  for (const std::string& output : {in_the_way, in_the_way + "/below"}) {
    const Outcome blocked = run_solitaire({"generate", scene, "-o", output});
    CHECK(blocked.status == 3);
    CHECK(has(blocked.err, "taken"));
    CHECK(bytes_of(in_the_way) == "a file");
  }
  fs::create_directories(place / "out/scene-0001.glb/full");
  const Outcome scene_blocked = run_solitaire({"generate", scene, "-o", place / "out"});
  CHECK(scene_blocked.status == 3);
  CHECK(has(scene_blocked.err, "scene-0001.glb"));
  const std::string asset = place.file("asset.sol", "place(\"gone.glb\", at: [0, 0]);\n");
  const Outcome no_asset = run_solitaire({"generate", asset, "-o", place / "assets"});
  CHECK(no_asset.status == 3);
  CHECK(has(no_asset.err, "gone.glb"));
}

TEST_CASE("cli: the trace as text, for Graphviz and for solvers") {
  const Workplace place;
  const std::string script =
      place.file("example.sol", bytes_of(fs::path(SOLITAIRE_SOURCE_DIR) / "tests/programs/example.sol"));
  const Outcome text = run_solitaire({"trace", script});
  CHECK(text.status == 0);
  CHECK(has(text.out, "range(0, 4)"));
  CHECK(has(text.out, "assert"));
  const Outcome dot = run_solitaire({"trace", script, "--format", "dot"});
  CHECK(dot.status == 0);
  CHECK(dot.out.rfind("digraph", 0) == 0);
  if (run({"dot", "-V"}).status == 0) {
    CHECK(run({"dot", "-Tplain", "-o", place / "plain", place.file("graph.dot", dot.out)}).status == 0);
  }
  for (const auto& [name, satisfiable] :
       {std::pair(script, true),
        {place.file("none.sol", "x = range(0, 3);\nassert(x * x == 2);\n"), false}}) {
    const Outcome smt2 = run_solitaire({"trace", name, "--format", "smt2"});
    CHECK(smt2.status == 0);
    z3::context context;
    z3::solver solver(context);
    solver.from_string(smt2.out.c_str());
    CHECK(solver.check() == (satisfiable ? z3::sat : z3::unsat));
  }
}

TEST_CASE("cli: the trace of section 4.2.2's example reads as its figures do, explored or not") {
  const std::string script = (fs::path(SOLITAIRE_SOURCE_DIR) / "tests/programs/example.sol").string();
  CHECK(run_solitaire({"trace", script}).out ==
        "x0 <- range(0, 4);                   // range\n"
        "x1 <- x0 % 2;\n"
        "x2 <- x1 == 0;\n"
        "x3 <- if(x2, 10, -5);\n"
        "x4 <- range(0, 1);                   // range#2\n"
        "x5 <- x4 % 2;\n"
        "x6 <- x5 == 0;\n"
        "x7 <- if(x6, 10, -5);\n"
        "x8 <- x3 + x7;\n"
        "x9 <- 0 < x8;\n"
        "assert(x9);                          // assert\n"
        "return x8;\n");
  CHECK(run_solitaire({"trace", script, "--explore", "random:1"}).out ==
        "x0 <- range(0, 4);                   // range\n"
        "x1 <- x0 % 2;\n"
        "x2 <- x1 == 0;\n"
        "x3 <- not x2;\n"
        "x4 <- range(0, 1);                   // range#2\n"
        "x5 <- x4 % 2;\n"
        "x6 <- x5 == 0;\n"
        "x7 <- not x6;\n"
        "x8 <- x2 and x7;\n"
        "if x3: ---;                          // F/if@2:5 not explored: else side\n"
        "if x8: ---;                          // F#2/if@2:5 not explored: else side\n"
        "return 20;\n");
}

TEST_CASE("cli: a program's mistakes are shown with their line and a caret, all of them") {
  const Workplace place;
  const std::string script = place.file("wrong.sol", "x = widht;\ny = hight;\n");
  const Outcome outcome = run_solitaire({"solve", script});
  CHECK(outcome.status == 3);
  CHECK(outcome.out == "");
  CHECK(has(outcome.err,
            "wrong.sol:1:5: error: there is no 'widht' here\n  1 | x = widht;\n    |     ^^^^^\n"));
  CHECK(has(outcome.err, "wrong.sol:2:5: error: there is no 'hight' here"));
  CHECK(has(outcome.err, "2 errors\n"));
}

TEST_CASE("cli: a script is found, and its imports and assets, from any folder") {
  const Workplace place;
  fs::create_directory(place / "sub");
  place.file("sub/part.sol", "part = 5;\n");
  const std::string script =
      place.file("sub/main.sol", "import \"part.sol\";\nimport \"std/layout.sol\";\nreturn part;\n");
  CHECK(run({"sh", "-c", "cd / && \"$0\" solve \"$1\" -q", SOLITAIRE_PROGRAM, script}).out ==
        "solution 1: 5\n");
  CHECK(run({"sh", "-c", "cd \"$1/sub\" && \"$0\" solve main.sol -q", SOLITAIRE_PROGRAM, place.path()}).out ==
        "solution 1: 5\n");
}

constexpr const char* kTight =
    "a = range(0, 3);\nb = range(0, 3);\nassert(a + b > 8, \"roomy\");\nassert(a != b);\n"
    "place(\"chair\", at: [a, 0], size: [1, 1]);\nplace(\"desk\", at: [0, 9], size: [2, 1]);\nreturn [a, "
    "b];\n";

TEST_CASE("cli: a search that finds nothing says which conditions cannot hold together") {
  const Workplace place;
  const std::string tight = place.file("tight.sol", kTight);
  const Outcome outcome = run_solitaire({"solve", tight});
  CHECK(outcome.status == 1);
  CHECK(outcome.out == "");
  CHECK(has(outcome.err, "proved that there is none"));
  CHECK(has(outcome.err, "tight.sol:3:8: assert: a + b > 8"));
  CHECK(has(outcome.err, "range: a is at most 3"));
  CHECK(!has(outcome.err, "a != b"));
  CHECK(run_solitaire({"solve", tight, "-q"}).err == "");
}

TEST_CASE("cli: --relax says nothing is proved where solvers cannot follow some executions") {
  const Workplace place;
  const std::string some = place.file(
      "some.sol",
      "x = range(0, 5);\nassert(x > 3, \"far\");\nassert(x < 3);\nif x == 3 then factor(1.0);\nreturn x;\n");
  const Outcome outcome = run_solitaire({"solve", some, "--relax", "--all"});
  CHECK(outcome.status == 4);
  CHECK(has(outcome.out, "not proved the best left"));
  CHECK_FALSE(has(outcome.out, "proved the best left\n  x = 3"));
  CHECK(has(outcome.err, "5 solutions"));
  CHECK(has(outcome.err, "; there is no other among those that solvers can express, which leaves some out"));
  const std::string all = place.file(
      "all.sol", "x = range(0, 5);\nassert(x > 3);\nassert(x < 3);\nif x > 7 then factor(1.0);\nreturn x;\n");
  const Outcome whole = run_solitaire({"solve", all, "--relax", "--all"});
  CHECK(whole.status == 0);
  CHECK_FALSE(has(whole.out, "not proved"));
  CHECK(has(whole.err, "6 solutions"));
  CHECK(has(whole.err, "proved that there is no other"));
}

TEST_CASE("cli: --relax gives near misses, and says and shows what is broken") {
  const Workplace place;
  const std::string tight = place.file("tight.sol", kTight);
  const Outcome outcome = run_solitaire({"solve", tight, "--relax"});
  CHECK(outcome.status == 0);
  CHECK(has(outcome.out, "1 assert broken, proved the best left"));
  CHECK(has(outcome.out, "broken: tight.sol:3:8: a + b > 8 (at assert): roomy"));

  CHECK(run_solitaire({"generate", tight, "--relax", "-n", "1", "-o", place / "near"}).status == 0);
  const json file = json::parse(bytes_of(place / "near/tight-0001.json"));
  CHECK(file["optimal"] == true);
  REQUIRE(file["broken"].size() == 1);
  CHECK(file["broken"][0]["source"] == "tight.sol:3:8");
  CHECK(file["broken"][0]["message"] == "roomy");
  // The chair stands where the broken assert's choice says, the desk does not.
  const tinygltf::Model scene = read_gltf(place / "near/tight-0001.glb");
  std::size_t marked = 0;
  for (const tinygltf::Node& node : scene.nodes) {
    if (!node.extras.IsObject() || !node.extras.Has("address")) continue;
    const bool is_chair = node.extras.Get("address").Get<std::string>() == "place";
    CHECK(node.extras.Has("broken") == is_chair);
    marked += node.extras.Has("broken") ? 1 : 0;
  }
  CHECK(marked == 1);
  CHECK(has(bytes_of(place / "near/index.html"), "broken: tight.sol:3:8"));
}

TEST_CASE("cli: near misses break few conjuncts, and come near in comparisons") {
  const Workplace place;
  const auto nearest = [&](const std::string& text, const char* engine) {
    const std::string script = place.file("near.sol", text);
    return json::parse(run_solitaire({"solve", script, "--relax", "--json", "-q", "--engine", engine}).out);
  };
  for (const char* engine : {"cadical", "z3"}) {
    CAPTURE(engine);
    CHECK(nearest("x = range(0, 9);\nassert(x * x == 50);\nreturn x;\n", engine)["value"] == 7);
    CHECK(nearest("x = range(0, 9);\nassert(x * x > 50 and x * x < 60);\nreturn x;\n", engine)["value"] == 7);
    CHECK(nearest("x = range(0, 9);\nassert(x * x == 40 or x * x == 51);\nreturn x;\n", engine)["value"] ==
          7);
    CHECK(nearest("x = range(0, 9);\nassert(not (x * x < 50 or x * x > 60));\nreturn x;\n",
                  engine)["value"] == 7);
    // No value of the ranges holds, and the nearest is looked for all the same.
    const auto value = [&](const std::string& text) { return nearest(text, engine)["value"]; };
    CHECK(value("x = range(0, 5);\nassert(x == 10);\nreturn x;\n") == 5);
    CHECK(value("x = range(0, 5);\nassert(x == -100000);\nreturn x;\n") == 0);
    CHECK(value("x, y = range(0, 50), range(0, 9);\nassert(x + y > 70);\nassert(x < 30);\nreturn x, y;\n") ==
          json{29, 9});
    CHECK(value("x, y = range(0, 5), range(0, 5);\nassert(any(x > 1000, all(y > 20, x == 3)));\nreturn x, "
                "y;\n") == json{3, 5});
    CHECK(value("import \"std/layout.sol\";\nt = Rect(range(0, 9), range(2, 9), range(6, 9), 2);\n"
                "assert(inside(t, Rect(1, 1, 4, 4)));\nreturn t.x, t.w;\n") == json{1, 6});
    CHECK(value("fun f(n) { if n <= 0 then return true; return n != 7 and f(n - 1); }\n"
                "x = range(0, 4);\nassert(x >= 9 and f(x));\nreturn x;\n") == 4);
    // Five in four places: one pair has to share one, and only these two are to blame.
    const json five =
        nearest("xs = [range(0, 3) for i in 1..5];\nassert(distinct(xs));\nreturn xs;\n", engine);
    std::map<int, int> taken;
    for (const json& x : five["value"]) ++taken[x.get<int>()];
    CHECK(taken.size() == 4);
  }
}

TEST_CASE("cli: only things that a broken conjunct is about are marked") {
  const Workplace place;
  const std::string script = place.file(
      "row.sol",
      "import \"std/layout.sol\";\nts = [Thing(\"table\", 1, 1, 0, range(0, 3), 0) for i in 1..5];\n"
      "assert(all_apart(ts), \"apart\");\nshow_all(ts);\n");
  CHECK(run_solitaire({"generate", script, "--relax", "-n", "1", "-o", place / "near"}).status == 0);
  const tinygltf::Model scene = read_gltf(place / "near/row-0001.glb");
  CHECK(std::count_if(scene.nodes.begin(), scene.nodes.end(), [](const tinygltf::Node& node) {
          return node.extras.IsObject() && node.extras.Has("broken");
        }) == 2);
}

TEST_CASE("cli: of a program with wishes the best come first, with their cost") {
  const Workplace place;
  const std::string script =
      place.file("wish.sol", "x = range(0, 9);\nassert(x != 3);\nminimize(abs(x - 3));\nreturn x;\n");
  const Outcome outcome = run_solitaire({"solve", script, "--all", "--json"});
  std::istringstream lines(outcome.out);
  std::vector<int> costs;
  for (std::string line; std::getline(lines, line);) {
    const json solution = json::parse(line);
    CHECK(solution["optimal"] == true);
    CHECK(solution["least_cost"] == solution["cost"]);
    costs.push_back(solution["cost"]);
  }
  CHECK(costs == std::vector<int>{1, 1, 2, 2, 3, 3, 4, 5, 6});
  const Outcome generated = run_solitaire({"generate", script, "-n", "2", "-o", place / "out"});
  CHECK(has(generated.err, "wish-0001: cost 1, proved the best left"));
  CHECK(has(bytes_of(place / "out/index.html"), "cost 1, proved the best left"));
}

TEST_CASE("cli: check --deep finds the mistakes that some choices lead to, and says which") {
  const Workplace place;
  const std::string script = place.file("deep.sol",
                                        "x = range(0, 9);\nf = flip();\nassert(x > 3);\n"
                                        "if x == 7 and f then { z = 1 + \"a\"; }\n"
                                        "if x == 2 then { z = 1 + nil; }\n"
                                        "if x > 8 then { z = x.w; }\n");
  const Outcome outcome = run_solitaire({"check", script, "--deep"});
  CHECK(outcome.status == 3);
  CHECK(has(outcome.err, "deep.sol:4:28: error: '+' does not go with an int and a string"));
  CHECK(has(outcome.err, "note: where x = 7, f = true"));
  CHECK(has(outcome.err, "deep.sol:6:23: error: an int has no fields"));
  CHECK(has(outcome.err, "note: where x = 9"));
  CHECK(has(outcome.err, "2 errors"));  // the one under x == 2 cannot be reached
  const std::string fine = place.file("fine.sol", "n = range(0, 50);\nwhile n > 0 { n -= 1; }\n");
  CHECK(run_solitaire({"check", fine, "--deep"}).status == 0);
}

TEST_CASE("cli: check shows warnings, which change nothing about the status") {
  const Workplace place;
  const std::string script = place.file("odd.sol", "fun f() { return 1; return 2; }\nreturn f();\n");
  const Outcome outcome = run_solitaire({"check", script});
  CHECK(outcome.status == 0);
  CHECK(has(outcome.err, "odd.sol:1:21: warning: this is never reached"));
  CHECK(has(outcome.err, "odd.sol:1:11: control does not come past this"));
  CHECK(run_solitaire({"check", script, "--quiet"}).err == "");
  CHECK(!has(run_solitaire({"solve", script}).err, "warning"));
}

TEST_CASE("cli: --resume goes on with an earlier run, and refuses one that was another") {
  const Workplace place;
  const std::string script = place.file("scene.sol", kScene);
  const auto generate = [&](const char* folder, const char* count, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"generate", script, "-n", count, "-o", place / folder};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_solitaire(arguments);
  };
  CHECK(generate("whole", "40", {}).status == 0);
  CHECK(generate("parts", "7", {"--resume"}).status == 0);  // nothing to go on with yet
  const Outcome second = generate("parts", "40", {"--resume"});
  CHECK(second.status == 0);
  CHECK(has(second.err, "40 solutions (7 of them earlier)"));
  CHECK(run({"diff", "-r", place / "whole", place / "parts"}).out == "");
  CHECK(generate("parts", "12", {"--resume"}).status == 0);  // more than that is there already

  const std::string page = bytes_of(place / "parts/index.html");
  const Outcome other_seed = generate("parts", "50", {"--resume", "--seed", "4"});
  CHECK(other_seed.status == 3);
  CHECK(has(other_seed.err, "scene-0001.json: comes from a run with another seed: 0 and not 4"));
  const std::vector<std::pair<std::vector<std::string>, std::string>> others = {
      {{"--forbid", "x=3"}, "another option forbid: null and not [\"x=3\"]"},
      {{"--min-distance", "0.5"}, "another option min_distance: null and not 0.5"},
      {{"--relax"}, "another option relax: null and not true"},
      {{"--distinct", "choices"}, "another option distinct: \"result\" and not \"choices\""},
      {{"--diversity", "high"}, "another option diversity: \"normal\" and not \"high\""},
      {{"--explore", "random:9"}, "another option explore: \"demand\" and not \"random:9\""}};
  for (const auto& [options, why] : others) {
    std::vector<std::string> with = {"--resume"};
    with.insert(with.end(), options.begin(), options.end());
    const Outcome other = generate("parts", "50", with);
    CHECK(other.status == 2);
    CHECK(has(other.err, "scene-0001.json: comes from a run with " + why));
  }
  place.file("scene.sol", std::string("assert(range(0, 1) == 1);\n") + kScene);
  const Outcome other_program = generate("parts", "50", {"--resume"});
  CHECK(other_program.status == 3);
  CHECK(has(other_program.err, "has the program changed?"));
  place.file("parts/scene-0002.json", "{");
  CHECK(
      has(generate("parts", "50", {"--resume"}).err, "scene-0002.json: is not the .json file of a solution"));
  CHECK(bytes_of(place / "parts/index.html") == page);
}

TEST_CASE("cli: --resume makes scenes again that were removed or cut short") {
  const Workplace place;
  const std::string script = place.file("scene.sol", kScene);
  const auto generate = [&](const char* folder, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"generate", script, "-n", "5", "-o", place / folder};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_solitaire(arguments);
  };
  CHECK(generate("whole", {}).status == 0);
  CHECK(generate("parts", {}).status == 0);
  fs::remove(place / "parts/scene-0002.glb");
  fs::resize_file(place / "parts/scene-0004.glb", 100);
  CHECK(generate("parts", {"--resume"}).status == 0);
  CHECK(run({"diff", "-r", place / "whole", place / "parts"}).out == "");
}

TEST_CASE("cli: two runs do not write into one folder at once") {
  const Workplace place;
  const std::string script = place.file("scene.sol", kScene);
  const std::string out = place / "out";
  fs::create_directory(out);
  const int folder = ::open(out.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  REQUIRE(::flock(folder, LOCK_EX) == 0);
  const Outcome kept_out = run_solitaire({"generate", script, "-n", "1", "-o", out});
  CHECK(kept_out.status == 3);
  CHECK(has(kept_out.err, "out: another run writes into this folder"));
  ::close(folder);
  CHECK(run_solitaire({"generate", script, "-n", "1", "-o", out}).status == 0);
}

TEST_CASE("cli: a script without a command, and values that are none, get a line that says so") {
  const Workplace place;
  const std::string script = place.file("x.sol", "x = range(0, 9);\nreturn x;\n");
  const auto told = [](const std::vector<std::string>& arguments) {
    const Outcome outcome = run_solitaire(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out == "");
    return outcome.err;
  };
  CHECK(has(told({script}), "is no command; the commands are generate, solve,"));
  CHECK(has(told({script}), "to find solutions: solitaire solve " + script));
  for (const std::string seed : {"-1", "", "100000000000000000000", "1.5", "nan"}) {
    CAPTURE(seed);
    CHECK(has(told({"solve", script, "--seed", seed}), "'" + seed + "' is not a whole number from 0"));
  }
  for (const std::string count : {"0", "", "100000000000000000000"})
    CHECK(has(told({"solve", script, "-n", count}), "'" + count + "' is not a whole number from 1"));
  for (const std::string seconds : {"nan", "inf", "", "1e400", "-1"})
    CHECK(has(told({"solve", script, "--timeout", seconds}), "'" + seconds + "' is not a number of seconds"));
  CHECK(has(run_solitaire({"solve", script, "--pin-file", place / "."}).err,
            "is a folder, not the .json file"));
}

TEST_CASE("cli: what a thing asks for and cannot have is told at its place call") {
  const Workplace place;
  const std::string script =
      place.file("ä.sol",
                 "// Tür\nfun thing(material) { place(\"chair\", material: material); }\n"
                 "thing(choose([\"oak\", \"wood\"]));\n");
  for (const char* command : {"solve", "check", "generate"}) {
    const Outcome outcome = run_solitaire({command, script});
    CHECK(outcome.status == 3);
    CHECK(has(outcome.err,
              "ä.sol:2:48: error: place: 'material' has no 'wood'; there are oak, walnut, birch, pine,"));
    CHECK(has(outcome.err, "  2 | fun thing(material) { place(\"chair\", material: material); }\n"));
  }
  const std::string near = place.file("near.sol", "place(\"chair\", material: \"marbel\");\n");
  CHECK(has(run_solitaire({"solve", near}).err, "'material' has no 'marbel'; did you mean 'marble'?"));
  place.file("broken.glb", "glTF");
  const std::string broken =
      place.file("broken.sol", "x = range(0, 1); place(\"broken.glb\", at: [x, 0]);\n");
  const Outcome outcome = run_solitaire({"generate", broken, "-n", "1", "-o", place / "out"});
  CHECK(outcome.status == 3);
  CHECK(has(outcome.err, "broken.sol:1:18: error: cannot read "));
  CHECK(has(outcome.err, "  1 | x = range(0, 1); place(\"broken.glb\", at: [x, 0]);\n"));
  CHECK(has(outcome.err, "  note: at place\n"));
}

TEST_CASE("cli: a name that is too long for a file is one that no model has") {
  const Workplace place;
  const std::string name(300, 'a');
  const std::string script = place.file("x.sol", "place(\"" + name + "\");\n");
  const Outcome outcome = run_solitaire({"generate", script, "-n", "1", "-o", place / "out"});
  CHECK(outcome.status == 0);
  CHECK(has(outcome.err, "aaa...: no model is called so, and boxes stand there\n"));
  CHECK(!has(outcome.err, name));
}

TEST_CASE("cli: SOLITAIRE_DATA that names no folder is told") {
  const Workplace place;
  const std::string script = place.file("x.sol", "return 1;\n");
  const Outcome outcome = run(
      {"/usr/bin/env", "SOLITAIRE_DATA=" + (place / "none").string(), SOLITAIRE_PROGRAM, "solve", script});
  CHECK(outcome.status == 3);
  CHECK(outcome.err == "error: SOLITAIRE_DATA names no folder: '" + (place / "none").string() + "'\n");
}

TEST_CASE("cli: a param that the program does not have is told, whichever option names it") {
  const Workplace place;
  const std::string script = place.file("x.sol", "param groups = 3;\nreturn groups;\n");
  const std::string list = place.file("list.json", "[1, 2]");
  const auto told = [&](const std::string& option, const std::string& setting) {
    const Outcome outcome = run_solitaire({"solve", script, option, setting});
    CHECK(outcome.status == 2);
    return outcome.err;
  };
  const std::string unknown = "error: the program has no param 'group'; did you mean 'groups'?\n";
  CHECK(told("--set", "group=4") == unknown);
  CHECK(told("--data", "group=" + list) == unknown);
  CHECK(told("--data", "group=" + (place / "none.json").string()) == unknown);
  CHECK(told("--data", "groups=" + list) ==
        "error: " + list + ": the param 'groups' is a number, not a list\n");
}

TEST_CASE("cli: a check that had nothing to look at says so") {
  const Workplace place;
  const std::string script = place.file("x.sol", "fun f() { return 1 + \"a\"; }\n");
  CHECK(
      has(run_solitaire({"check", script}).err, "nothing was met that chooses, requires or places anything"));
}

TEST_CASE("cli: what choose() chose is shown, and not its position alone") {
  const Workplace place;
  const std::string script = place.file(
      "kind.sol",
      "kinds = [\"sink\", \"oven\", 3, [1, 2]];\nn = range(4, 5);\nassert(n == 5);\n"
      "k = choose(kinds + [n]);\nassert(k != \"sink\");\nw = choose([\"a\", \"b\"], weights: [1, 3]);\n"
      "assert(w == \"b\");\nreturn 0;\n");
  for (const char* how : {"-q", "--check"}) {  // read off the trace, and from a run of the program
    std::map<int, json> elements;
    std::istringstream lines(run_solitaire({"solve", script, "--all", "--json", how}).out);
    for (std::string line; std::getline(lines, line);) {
      const json solution = json::parse(line);
      for (const json& choice : solution["choices"]) {
        if (choice["at"] == "k") elements[choice["value"]] = choice.value("element", json());
        if (choice["at"] == "w") CHECK(choice["element"] == "b");
      }
    }
    CHECK(elements == std::map<int, json>{{1, "oven"}, {2, 3}, {3, {1, 2}}, {4, 5}});
  }
  const std::string text = run_solitaire({"solve", script, "--pin", "k=oven"}).out;
  CHECK(has(text, "  k = \"oven\"\n"));
  CHECK(has(run_solitaire({"solve", script, "--pin", "k=3"}).out, "  k = 3\n"));
}

TEST_CASE("cli: solutions say what each wish came to") {
  const Workplace place;
  const std::string best = place.file(
      "wish.sol", "x = range(0, 9);\nassert(x < 5);\nprefer(x > 7, 3);\nprefer(x != 1);\nreturn x;\n");
  const std::string text = run_solitaire({"solve", best}).out;
  CHECK(has(text, "cost 3, proved the best left\n  unmet: wish.sol:3:1: prefer(x > 7, 3) (cost 3)\n"));
  CHECK(!has(text, "x != 1"));
  const std::string most = place.file("most.sol", "x = range(0, 9);\nmaximize(3 * x);\nreturn x;\n");
  CHECK(has(run_solitaire({"solve", most}).out, "maximum 27, proved the best left\n"));
}

TEST_CASE("cli: --per-solution holds while the program is explored (slow)") {
  const Workplace place;
  const std::string script = place.file(
      "lists.sol",
      "xs = [];\nfor i in 1..400 { if flip() { xs = xs + [range(0, 9)]; } }\nassert(sum(xs) == 777);\n");
  const auto start = std::chrono::steady_clock::now();
  run_solitaire({"solve", script, "--per-solution", "1"});
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(4));
}

/// What `solve --all --json` prints of solutions, sorted, and what brute force finds.
void check_all_by_brute_force(const std::string& text, const std::vector<std::string>& options) {
  CAPTURE(text);
  const Workplace place;
  std::vector<std::string> arguments = {"solve", place.file("all.sol", text), "--all", "--json", "-q"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  std::istringstream lines(run_solitaire(arguments).out);
  std::vector<std::string> printed;
  for (std::string line; std::getline(lines, line);) {
    const json solution = json::parse(line);
    printed.push_back(solution["choices"].dump() + solution["value"].dump());
  }
  std::sort(printed.begin(), printed.end());

  const Program program = program_of(text);
  ExhaustiveEngine engine(program, {}, {});
  std::vector<std::string> expected;
  while (const auto solution = engine.next()) {
    json choices = json::array();
    for (const ChosenValue& choice : solution->choices) {
      const bool is_bool = choice.family == Distribution::Family::kFlip;
      choices.push_back(
          {{"at", choice.address},
           {"value", is_bool ? json(choice.value.as_int() != 0) : json(choice.value.as_int())}});
      if (!choice.element.empty()) choices.back()["element"] = json::parse(choice.element);
    }
    expected.push_back(choices.dump() + json::parse(to_json(solution->value)).dump());
  }
  std::sort(expected.begin(), expected.end());
  CHECK(printed == expected);
}

TEST_CASE("cli: --all prints what brute force finds, and nothing twice") {
  for (const std::string engine : {"cadical", "z3"}) {
    for (const char* text :
         {kPairs, kNone, kScene, kTight, "x = range(1, 3);\nf = flip();\nreturn [x, nil, 0.5, f];\n",
          "x = range(0, 9);\nassert(x != 3);\nminimize(abs(x - 3));\nreturn x;\n",
          "n = range(0, 3);\nreturn [choose([1, 2, 3]) for i in 1..n];\n"}) {
      check_all_by_brute_force(text, {"--engine", engine});
    }
  }
  check_all_by_brute_force(kScene, {});
}

}  // namespace
}  // namespace solitaire
