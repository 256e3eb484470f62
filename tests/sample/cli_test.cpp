// The command `solitaire sample` as its users meet it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/command.h"
#include "tests/support/text.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCoin =
    "p = beta(1, 1);\n"
    "for i in 1..7: observe(Flip(p), true);\n"
    "for i in 1..3: observe(Flip(p), false);\n"
    "return p, [p > 0.5];\n";

TEST_CASE("command: the summary as JSON has every field, and is right") {
  const Workplace place;
  const Outcome outcome =
      run_solitaire({"sample", place.file("coin.sol", kCoin), "-n", "4000", "--chains", "2", "--json"});
  REQUIRE(outcome.status == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  REQUIRE(json["parameters"].size() == 2);
  const auto& p = json["parameters"][0];
  CHECK(p["name"] == "p");
  CHECK(json["parameters"][1]["name"] == "[p > 0.5][0]");
  for (const char* field : {"mean", "sd", "mcse", "q5", "q50", "q95", "ess_bulk", "ess_tail", "rhat"})
    CHECK(p[field].is_number());
  // The posterior is a beta distribution with 8 and 4.
  CHECK(std::abs(p["mean"].get<double>() - 8.0 / 12) < 4 * p["mcse"].get<double>());
  CHECK(p["sd"].get<double>() == doctest::Approx(std::sqrt(8 * 4 / (144.0 * 13))).epsilon(0.1));
  CHECK(json["chains"] == 2);
  CHECK(json["draws"] == 4000);
  CHECK(json["steps"].get<int>() >= 4000);
  CHECK(json["steps_per_second"].get<double>() > 0);
  CHECK(json["acceptance"].get<double>() > 0.1);
  CHECK(json["warnings"].is_array());
  CHECK(outcome.err.find("4000 draws of 2 chains") != std::string::npos);
}

TEST_CASE("command: draws are the same for any number of jobs, and others for another seed") {
  const Workplace place;
  const std::string script = place.file("coin.sol", kCoin);
  const auto draws = [&](const std::string& jobs, const std::string& seed) {
    const fs::path file = place / ("draws" + jobs + "_" + seed + ".csv");
    const Outcome outcome = run_solitaire({"sample", script, "-n", "40", "--chains", "4", "--warmup", "20",
                                           "-q", "--jobs", jobs, "--seed", seed, "--draws", file});
    REQUIRE(outcome.status == 0);
    return bytes_of(file);
  };
  const std::string first = draws("1", "3");
  CHECK(first == draws("4", "3"));
  CHECK(first != draws("1", "4"));
  const auto lines = lines_of(first);
  REQUIRE(lines.size() == 41);
  CHECK(lines[0] == "chain,draw,p,[p > 0.5][0]");
  CHECK(lines[1].rfind("1,1,0.", 0) == 0);
  CHECK(lines[40].rfind("4,10,0.", 0) == 0);
}

TEST_CASE("command: draws are printed as they come, in the order of the table") {
  const Workplace place;
  const std::string script = place.file("coin.sol", kCoin);
  const auto streamed = [&](const std::string& format, const std::string& jobs, const std::string& file) {
    return run_solitaire({"sample", script, "-n", "12", "--warmup", "5", "--jobs", jobs, "--stream", format,
                          "--draws", place / file});
  };
  const Outcome table = streamed("csv", "4", "draws.csv");
  REQUIRE(table.status == 0);
  CHECK(table.out == bytes_of(place / "draws.csv"));
  CHECK(table.err.find("R-hat") != std::string::npos);
  const Outcome lines = streamed("jsonl", "1", "draws.jsonl");
  CHECK(lines.out == bytes_of(place / "draws.jsonl"));
  const auto all = lines_of(lines.out);
  REQUIRE(all.size() == 12);
  const auto fourth = nlohmann::json::parse(all[3]);
  CHECK(fourth["chain"] == 2);
  CHECK(fourth["draw"] == 1);
  const std::string row = lines_of(table.out)[4];
  CHECK(row.rfind("2,1,", 0) == 0);
  CHECK(std::stod(row.substr(4)) == fourth["values"]["p"].get<double>());
}

TEST_CASE("command: a streamed table has the numbers of its first draw, and says what it lacks") {
  const Workplace place;
  const std::string script = place.file("list.sol", "n = range(1, 3);\nreturn [i for i in 1..n];\n");
  const Outcome table =
      run_solitaire({"sample", script, "-n", "60", "--chains", "1", "--stream", "csv", "--seed", "3"});
  REQUIRE(table.status == 0);
  const auto rows = lines_of(table.out);
  REQUIRE(rows.size() == 61);
  for (const std::string& row : rows)
    CHECK(std::count(row.begin(), row.end(), ',') == std::count(rows[0].begin(), rows[0].end(), ','));
  CHECK((rows[0].find("[2]") != std::string::npos) ==
        (table.err.find("the table lacks") == std::string::npos));
}

TEST_CASE("command: an interrupt keeps what was drawn") {
  const Workplace place;
  const fs::path file = place / "draws.csv";
  Command command(solitaire_with({"sample", place.file("coin.sol", kCoin), "-n", "100000000", "--warmup",
                                  "10", "--thin", "2000", "--json", "--stream", "csv", "--draws", file}));
  const auto has_begun = [&] { return command.output().find('\n') != std::string::npos; };
  for (int i = 0; i < 600 && !has_begun(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  command.signal(SIGINT);
  const Outcome outcome = command.wait();
  CHECK(outcome.status == 4);
  const std::size_t begin = outcome.err.find('{');
  const auto json = nlohmann::json::parse(outcome.err.substr(begin, outcome.err.find('\n', begin) - begin));
  CHECK(json["draws"].get<int>() > 0);
  CHECK(json["warnings"][0].get<std::string>().find("stopped") == 0);
  CHECK(lines_of(bytes_of(file)).size() == json["draws"].get<std::size_t>() + 1);
}

TEST_CASE("command: what cannot be started from is an error at its place") {
  const Workplace place;
  const Outcome outcome =
      run_solitaire({"sample", place.file("never.sol", "x = uniform(0, 1);\nassert(x > 2);\nreturn x;\n")});
  CHECK(outcome.status == 3);
  CHECK(outcome.err.find("never.sol:2:8: error: none of 10000 executions") != std::string::npos);
}

TEST_CASE("command: where no execution that is drawn is possible, a solver finds one to start from") {
  const Workplace place;
  const std::string text =
      "xs = [range(0, 9) for i in 1..10];\nfor i in 0..8: assert(xs[i + 1] > xs[i]);\nreturn xs[3];\n";
  for (const char* engine : {"shred", "lightweight"}) {
    const Outcome outcome = run_solitaire({"sample", place.file("rising.sol", text), "-n", "40", "--chains",
                                           "1", "--json", "-q", "--engine", engine});
    REQUIRE(outcome.status == 0);
    CHECK(nlohmann::json::parse(outcome.out)["parameters"][0]["mean"] == 3);
  }
  const Outcome refused = run_solitaire({"sample", place.file("weighed.sol", "factor(0.5);\n" + text)});
  CHECK(refused.status == 3);
  CHECK(refused.err.find("weighed.sol:3:") != std::string::npos);
}

TEST_CASE("command: data come from tables and JSON, and a report shows the draws") {
  const Workplace place;
  const std::string script =
      place.file("mean.sol",
                 "param points = [];\nm = normal(0, 10);\n"
                 "for x, y in points: observe(Normal(m * x, 1), y);\nreturn m, points;\n");
  const std::string table = place.file("points.csv", "\xef\xbb\xbfx, \"the y\"\r\n1, 2.5\r\n2, -1e1\r\n");
  const std::string json = place.file("points.json", "[[1, 2.5], [2, -10.0]]");
  const std::string others[] = {place.file("tabs.csv", "x\tthe y\n1\t2.5\n2\t-1e1\n"),
                                place.file("semicolons.csv", "x; the y\n1; 2.5\n2; -1e1")};
  const fs::path report = place / "report.html";
  const Outcome of_table =
      run_solitaire({"sample", script, "-q", "--json", "-n", "100", "--warmup", "10", "--data",
                     "points=" + table, "--draws", place / "a.csv", "--report", report});
  REQUIRE(of_table.status == 0);
  const Outcome of_json = run_solitaire({"sample", script, "-q", "--json", "-n", "100", "--warmup", "10",
                                         "--data", "points=" + json, "--draws", place / "b.csv"});
  REQUIRE(of_json.status == 0);
  CHECK(bytes_of(place / "a.csv") == bytes_of(place / "b.csv"));
  for (const std::string& other : others) {
    REQUIRE(run_solitaire({"sample", script, "-q", "-n", "100", "--warmup", "10", "--data", "points=" + other,
                           "--draws", place / "c.csv"})
                .status == 0);
    CHECK(bytes_of(place / "c.csv") == bytes_of(place / "a.csv"));
  }
  const auto parameters = nlohmann::json::parse(of_table.out)["parameters"];
  REQUIRE(parameters.size() == 5);
  CHECK(parameters[4]["name"] == "points[1][1]");
  CHECK(parameters[4]["mean"] == -10);
  const std::string page = bytes_of(report);
  CHECK(page.find("<h2>m</h2>") != std::string::npos);
  CHECK(page.find("<polyline") != std::string::npos);
  CHECK(page.find("http") == std::string::npos);
}

TEST_CASE("command: data that cannot be read are named") {
  const Workplace place;
  const std::string script = place.file("any.sol", "param xs = [];\nreturn length(xs);\n");
  const auto complaint = [&](const std::string& name, const std::string& text) {
    const Outcome outcome = run_solitaire({"sample", script, "--data", "xs=" + place.file(name, text)});
    CHECK(outcome.status == 3);
    return outcome.err;
  };
  CHECK(complaint("ragged.csv", "1,2\n3\n").find("ragged.csv: row 2 of the data has 1 cells") !=
        std::string::npos);
  CHECK(complaint("object.json", "{\"a\": 1}").find("object.json: has an object") != std::string::npos);
  CHECK(complaint("broken.json", "[1, ").find("broken.json: is no JSON") != std::string::npos);
  CHECK(complaint("large.json", "[1e999]").find("large.json: is no JSON") != std::string::npos);
  CHECK(complaint("latin1.csv", "name\nSt\xfchle\n")
            .find("latin1.csv: is not UTF-8: line 2 has the byte \\xfc") != std::string::npos);
  CHECK(complaint("utf16.csv", "\xff\xfe").find("utf16.csv: is not UTF-8: line 1") != std::string::npos);
  const std::string words = place.file("words.csv", "value\ninf\nnan\n1e999\n");
  const Outcome of_words = run_solitaire({"solve", script, "--data", "xs=" + words});
  CHECK(of_words.out.find("solution 1: 3") == 0);
  CHECK(complaint("comma.csv", "x;y\n1;2\n1,5;2\n")
            .find("comma.csv: row 2 of the data has the number 1,5 with a comma") != std::string::npos);
  CHECK(
      complaint("mixed.csv", "1,5;2,5\n").find("mixed.csv: row 1 of the data has the cell 5;2; put either") !=
      std::string::npos);
  CHECK(complaint("data.txt", "1").find("data end in .json or .csv") != std::string::npos);
  CHECK(complaint("open.csv", "1\n\"2\n3\n").find("open.csv: a double quote in row 2 is never closed") !=
        std::string::npos);
  CHECK(complaint("latin.csv", "1\n\xe9\n").find("latin.csv: is not UTF-8: line 2") != std::string::npos);
  CHECK(complaint("huge.json", "[1e999]").find("huge.json: is no JSON: number overflow") !=
        std::string::npos);
  const std::string deep = complaint("deep.json", std::string(300, '[') + std::string(300, ']'));
  CHECK(deep.find("deep.json: has more than 200 lists within each other") != std::string::npos);
  fs::create_directory(place / "folder.csv");
  const Outcome of_folder =
      run_solitaire({"sample", script, "--data", "xs=" + (place / "folder.csv").string()});
  CHECK(of_folder.status == 3);
  CHECK(of_folder.err.find("folder.csv: is a folder") != std::string::npos);
}

TEST_CASE("command: what is no number in a table is a text, also after a byte order mark") {
  const Workplace place;
  const Outcome outcome =
      run_solitaire({"solve", place.file("any.sol", "param xs = [];\nreturn xs;\n"), "--json", "-q", "--data",
                     "xs=" + place.file("odd.csv",
                                        "\xef\xbb\xbf"
                                        "1,nan\ninf,-2.5\n")});
  REQUIRE(outcome.status == 0);
  CHECK(nlohmann::json::parse(outcome.out)["value"] ==
        nlohmann::json::parse(R"([[1, "nan"], ["inf", -2.5]])"));
}

TEST_CASE("command: a table that cannot be written leaves the summary") {
  const Workplace place;
  const Outcome outcome = run_solitaire({"sample", place.file("coin.sol", kCoin), "-n", "40", "--warmup",
                                         "20", "--json", "--draws", place / "nowhere/draws.csv"});
  CHECK(outcome.status == 3);
  CHECK(nlohmann::json::parse(outcome.out)["draws"] == 40);
  CHECK(outcome.err.find("nowhere/draws.csv") != std::string::npos);
}

TEST_CASE("command: streaming to nobody ends with a message, whichever chain draws") {
  const Workplace place;
  const std::string script = place.file("coin.sol", kCoin);
  for (const char* jobs : {"1", "3"}) {
    std::vector<std::string> line =
        solitaire_with({"sample", script, "-n", "4000", "--warmup", "20", "--stream", "csv", "--jobs", jobs});
    line.insert(line.begin(), {"sh", "-c", "exec \"$0\" \"$@\" > /dev/full"});
    const Outcome outcome = run(line);
    CHECK(outcome.status == 3);
    CHECK(outcome.err.find("standard output: No space left on device") != std::string::npos);
  }
}

TEST_CASE("command: a limit ends also chains that nobody has begun") {
  const Workplace place;
  const std::string script = place.file(
      "many.sol",
      "xs = [normal(0, 1) for i in 1..60];\nfor x in xs: observe(Normal(x, 1), 1);\nreturn sum(xs);\n");
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome =
      run_solitaire({"sample", script, "--chains", "100000", "--warmup", "1", "--timeout", "1", "--json"});
  CHECK(outcome.status == 4);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
}

TEST_CASE("command: what is observed and cannot be is named") {
  const Workplace place;
  const Outcome outcome = run_solitaire(
      {"sample", place.file("never.sol", "x = uniform(0, 1);\nobserve(Uniform(2, 3), x);\nreturn x;\n")});
  CHECK(outcome.status == 3);
  CHECK(outcome.err.find("never.sol:2:1: error: none of 10000 executions") != std::string::npos);
}

TEST_CASE("command: counts and weights beyond measure are errors of the program") {
  const Workplace place;
  const auto complaint = [&](const std::string& text) {
    const Outcome outcome = run_solitaire({"sample", place.file("huge.sol", text)});
    CHECK(outcome.status == 3);
    return outcome.err;
  };
  CHECK(complaint("return poisson(1e300);\n").find("huge.sol:1:16: error: the counts of 'poisson'") !=
        std::string::npos);
  CHECK(complaint("return geometric(1e-300);\n").find("huge.sol:1:18: error: the counts of 'geometric'") !=
        std::string::npos);
  CHECK(complaint("x = normal(0, 1);\nfactor(exp(1000 * (1 + x * x)));\nreturn x;\n")
            .find("huge.sol:2:1: error: 'factor' makes an execution infinitely probable") !=
        std::string::npos);
}

/// The likelihood is that of a logistic regression. Its priors are so wide that exp(-z) is infinite in most
/// of the executions that chains start from.
TEST_CASE("command: a logistic curve holds far from its middle") {
  const Workplace place;
  const std::string script =
      place.file("logistic.sol",
                 "b = normal(0, 500);\n"
                 "for x in [-3, -2, 2, 4]: observe(Flip(1 / (1 + exp(-b * x))), x > 0);\n"
                 "return b > 0, b < 400;\n");
  const Outcome outcome = run_solitaire({"sample", script, "-n", "4000", "--json", "-q"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto parameters = nlohmann::json::parse(outcome.out)["parameters"];
  CHECK(parameters[0]["mean"].get<double>() > 0.99);
  // Nearly half of a normal distribution, of which 0.5763 lies within 0.8 standard deviations.
  const double below = parameters[1]["mean"].get<double>();
  CHECK(std::abs(below - 0.5763) < 4 * parameters[1]["mcse"].get<double>() + 0.002);
}

TEST_CASE("command: solutions and scenes are drawn by how probable they are") {
  const Workplace place;
  const std::string script = place.file("row.sol",
                                        "n = poisson(3);\nobserve(Normal(n, 0.5), 2.0);\n"
                                        "for i in 1..n: place(\"chair\", at: [i, 0]);\nreturn n;\n");
  const Outcome solved = run_solitaire({"solve", script, "--engine", "shred", "-n", "60", "--json", "-q"});
  CAPTURE(solved.err);
  REQUIRE(solved.status == 0);
  int twos = 0;
  const auto lines = lines_of(solved.out);
  REQUIRE(lines.size() == 60);
  for (const std::string& line : lines) twos += nlohmann::json::parse(line)["value"] == 2 ? 1 : 0;
  // Of 1, 2 and 3 the densities are in the proportions .149 e^-2, .224 and .224 e^-2, so that 2 has .816 of
  // all.
  CHECK(twos > 40);
  CHECK(twos < 58);
  const Outcome generated =
      run_solitaire({"generate", script, "--engine", "shred", "-n", "2", "-o", place / "out"});
  CAPTURE(generated.err);
  CHECK(generated.status == 0);
  CHECK(generated.err.find("checked by 2 runs") != std::string::npos);
  CHECK(fs::exists(place / "out/row-0002.glb"));
  const Outcome pinned = run_solitaire({"solve", script, "--engine", "shred", "--pin", "n=2"});
  CHECK(pinned.status == 2);
}

TEST_CASE("command: a mistake that an execution comes to is reported") {
  const Workplace place;
  const Outcome outcome =
      run_solitaire({"sample", place.file("wrong.sol", "s = normal(0, 1);\nreturn normal(0, s);\n")});
  CHECK(outcome.status == 3);
  CHECK(outcome.err.find("wrong.sol:2:18: error: the sd of 'normal' is a positive number") !=
        std::string::npos);
}

/// The warnings of a program's summary, one after the other.
std::string warnings_of(const std::string& text) {
  const Workplace place;
  const Outcome outcome =
      run_solitaire({"sample", place.file("odd.sol", text), "-q", "--json", "--seed", "4"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out)["warnings"].dump();
}

TEST_CASE("command: densities that are no distributions, or too sharp to follow, are warned of") {
  const std::string improper = warnings_of("x = normal(0, 1);\nfactor(x * x);\nreturn x;\n");
  CHECK(improper.find("has no end along some choice") != std::string::npos);
  // Neal's funnel (2003, section 8).
  const std::string funnel =
      warnings_of("v = normal(0, 3);\nx = [normal(0, exp(v / 2)) for i in 1..9];\nreturn v;\n");
  CHECK(funnel.find("the No-U-Turn sampler diverged along") != std::string::npos);
  const std::string plain = warnings_of("v = normal(0, 3);\nx = normal(v, 1);\nreturn v + x;\n");
  CHECK(plain == "[]");
}

TEST_CASE("command: where a density is infinite the program is wrong, whichever engine comes there") {
  const Workplace place;
  const struct {
    const char* text;
    const char* error;
  } each[] = {{"s = range(0, 300);\nfactor(-log(1.0 * s));\nreturn s < 20;\n",
               "2:9: error: 'log' of 0.0 has no value"},
              {"s = range(0, 30);\nfactor(exp(24 * s));\nreturn s;\n",
               "2:1: error: 'factor' makes an execution infinitely probable"},
              {"x = normal(0, 1);\nfactor(cond(x > 2.5, exp(1000 * x), 0));\nreturn x;\n",
               "2:1: error: 'factor' makes an execution infinitely probable"}};
  for (const char* engine : {"shred", "lightweight"}) {
    for (const auto& wrong : each) {
      CAPTURE(wrong.text);
      const Outcome outcome = run_solitaire({"sample", place.file("pole.sol", wrong.text), "-q", "--engine",
                                             engine, "-n", "20000", "--seed", "4"});
      CHECK(outcome.status == 3);
      CHECK(outcome.err.find(wrong.error) != std::string::npos);
    }
  }
}

TEST_CASE("command: numbers that not all draws have are named") {
  const Workplace place;
  const Outcome outcome = run_solitaire(
      {"sample",
       place.file("many.sol", "n = range(1, 3);\nxs = [normal(0, 1) for i in 1..n];\nreturn n, xs;\n"),
       "--json", "-q"});
  REQUIRE(outcome.status == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["parameters"].size() == 2);
  CHECK(outcome.out.find("not all draws have xs[1], xs[2]") != std::string::npos);
}

}  // namespace
}  // namespace solitaire
