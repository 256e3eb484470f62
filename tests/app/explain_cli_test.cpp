// explain and pins as a user has them: exit status, text, JSON.
#include <algorithm>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/support/command.h"
#include "tests/support/text.h"
#include "tracegraph/address_pattern.h"

namespace solitaire {
namespace {

using nlohmann::json;

constexpr const char* kRoom =
    "fun make_room(least) {\n"
    "  w = range(2, 6);\n"
    "  assert(w >= least and w != 4, \"wide enough\");\n"
    "  return w;\n"
    "}\n"
    "widths = [make_room(least) for least in [3, 5]];\n"
    "assert(sum(widths) < 8, \"the rooms fit\");\n";
constexpr const char* kTwice =
    "x, y = range(0, 9), range(0, 9);\nassert(x > 4);\nassert(y > 4);\nassert(x < 3);\nassert(y < 3);\n";
constexpr const char* kSolvable =
    "x = range(0, 9);\nlid = flip();\nassert(x < 20 and x > 2, \"not too small\");\nassert(lid or x > 9);\n";
constexpr const char* kSeats =
    "fun seat() { x, y = range(0, 9), range(0, 9); return x + y; }\n"
    "near = flip();\nreturn [seat() for i in 1..2], near;\n";

/// A workplace whose path does not show in what is reported.
std::string without(const Workplace& place, std::string text) {
  const std::string folder = place.path().string() + "/";
  for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
    text.erase(at, folder.size());
  return text;
}

TEST_CASE("cli: explain shows each member of a conflict with its place, and nothing else in that form") {
  const Workplace place;
  const Outcome outcome = run_solitaire({"explain", place.file("room.sol", kRoom)});
  CHECK(outcome.status == 1);
  CHECK(outcome.err == "");
  CHECK(without(place, outcome.out) ==
        "room.sol has no solution\n"
        "these 3 cannot hold together:\n"
        "room.sol:3:10: assert: w >= least\n"
        "  3 |   assert(w >= least and w != 4, \"wide enough\");\n"
        "    |          ^^^^^^^^^^\n"
        "  note: at make_room[0]/assert\n"
        "  note: where least = 3\n"
        "  note: message: wide enough\n"
        "room.sol:3:10: assert: w >= least\n"
        "  3 |   assert(w >= least and w != 4, \"wide enough\");\n"
        "    |          ^^^^^^^^^^\n"
        "  note: at make_room[1]/assert\n"
        "  note: where least = 5\n"
        "  note: message: wide enough\n"
        "room.sol:7:8: assert: sum(widths) < 8\n"
        "  7 | assert(sum(widths) < 8, \"the rooms fit\");\n"
        "    |        ^^^^^^^^^^^^^^^\n"
        "  note: message: the rooms fit\n");
}

TEST_CASE("cli: explain shows ranges and pins that take part") {
  const Workplace place;
  const std::string script =
      place.file("pinned.sol", "x = range(2, 9);\ny = range(0, x);\nassert(x * y > 20);\n");
  const Outcome outcome = run_solitaire({"explain", script, "--pin", "x=3"});
  CHECK(outcome.status == 1);
  CHECK(without(place, outcome.out) ==
        "pinned.sol has no solution\n"
        "these 3 cannot hold together:\n"
        "pinned.sol:1:5: pin: x is 3, by --pin 'x=3'\n"
        "  1 | x = range(2, 9);\n"
        "    |     ^^^^^^^^^^^\n"
        "pinned.sol:2:5: range: y is not above its range\n"
        "  2 | y = range(0, x);\n"
        "    |     ^^^^^^^^^^^\n"
        "pinned.sol:3:8: assert: x * y > 20\n"
        "  3 | assert(x * y > 20);\n"
        "    |        ^^^^^^^^^^\n");
  CHECK(run_solitaire({"explain", script, "--pin", "x=5"}).status == 0);
}

TEST_CASE("cli: explain --more shows as many independent conflicts as there are") {
  const Workplace place;
  const std::string script = place.file("twice.sol", kTwice);
  const std::string first = run_solitaire({"explain", script}).out;
  CHECK(!has(first, "independent"));
  const Outcome two = run_solitaire({"explain", script, "--more", "1"});
  CHECK(two.status == 1);
  CHECK(two.out.rfind(first, 0) == 0);
  CHECK(has(two.out, "independently, these 2 cannot hold together:\n"));
  CHECK(!has(two.out, "there is no further"));
  CHECK(has(run_solitaire({"explain", script, "--more", "9"}).out,
            "there is no further conflict that is independent of these\n"));
}

TEST_CASE("cli: a pin of a choice that no execution meets plays no part") {
  const Workplace place;
  const std::string other =
      place.file("other.sol", "c = flip();\nif c then x = range(0, 3) else x = 9;\nreturn x;\n");
  const Outcome outcome = run_solitaire({"solve", other, "--pin", "c=false", "--pin", "x=1", "--json"});
  CHECK(outcome.status == 0);
  CHECK(json::parse(outcome.out)["value"] == 9);
  const std::string closed = place.file(
      "closed.sol", "c = flip();\nassert(not c);\nif c then x = range(0, 3) else x = 9;\nreturn x;\n");
  CHECK(json::parse(run_solitaire({"solve", closed, "--pin", "x=1", "--json"}).out)["value"] == 9);
  CHECK(has(run_solitaire({"solve", other, "--pin", "c=false", "--pin", "y=1"}).err,
            "--pin 'y=1': no choice has such an address; the nearest are"));
  const std::string with_param = place.file("param.sol", "param n = 3;\nx = range(0, n);\nreturn x;\n");
  CHECK(run_solitaire({"solve", with_param, "--pin", "n=2"}).err ==
        "error: --pin 'n=2': n is a param: set it by --set n=VALUE\n");
}

TEST_CASE("cli: conflicts that share an end of a range are not independent") {
  const Workplace place;
  const std::string script = place.file("shared.sol", "x = range(0, 5);\nassert(x > 7);\nassert(x > 8);\n");
  const Outcome outcome = run_solitaire({"explain", script, "--more", "5"});
  CHECK(!has(outcome.out, "independently"));
  CHECK(has(outcome.out, "there is no further conflict that is independent of these\n"));
}

TEST_CASE("cli: a conflict tells what is alike once, and all of it with --full") {
  const Workplace place;
  const std::string script =
      place.file("many.sol",
                 "xs = [range(0, 9) for i in 1..20];\nfor x in xs: assert(x > 2, \"enough\");\n"
                 "assert(sum(xs) < 60);\n");
  const std::string told = run_solitaire({"explain", script}).out;
  CHECK(without(place, told) ==
        "many.sol has no solution\n"
        "these 21 cannot hold together:\n"
        "many.sol:2:21: assert: x > 2\n"
        "  2 | for x in xs: assert(x > 2, \"enough\");\n"
        "    |                     ^^^^^\n"
        "  note: 20 times, first at assert[0], assert[1], assert[2], last at assert[19]\n"
        "  note: message: enough\n"
        "many.sol:3:8: assert: sum(xs) < 60\n"
        "  3 | assert(sum(xs) < 60);\n"
        "    |        ^^^^^^^^^^^^\n"
        "the reason: added up, these conditions ask for 60 at least, and allow 59 at most\n");
  const std::string whole = run_solitaire({"explain", script, "--full"}).out;
  CHECK(has(whole, "  note: at assert[13]\n"));
  CHECK(json::parse(run_solitaire({"explain", script, "--json"}).out)["conflicts"][0]["members"].size() ==
        21);
  std::string lines;
  for (int i = 0; i < 30; ++i) lines += "assert(x != " + std::to_string(i) + ");\n";
  const std::string long_one = place.file("long.sol", "x = range(0, 29);\n" + lines);
  const std::string screen = run_solitaire({"explain", long_one}).out;
  CHECK(has(screen, "these 31 cannot hold together:\n"));
  CHECK(has(screen, "and 23 others; explain --full shows them all\n"));
  CHECK(std::count(screen.begin(), screen.end(), '\n') < 40);
}

TEST_CASE("cli: asserts that no path leads to are told") {
  const Workplace place;
  const std::string script = place.file("dead.sol",
                                        "x = range(1, 5);\nif x > 9 { assert(x == 2); }\nassert(x < 10);\n"
                                        "if x * x == 7 { assert(x == 3); }\nassert(x < 5);\nreturn x;\n");
  const std::string told = run_solitaire({"explain", script}).out;
  CHECK(has(told, "dead.sol:2:19: note: this rules nothing out: no execution comes to it\n"));
  CHECK(has(told, "dead.sol:3:8: note: this rules nothing out: it holds wherever the other conditions do\n"));
  CHECK(has(told, "dead.sol:4:24: note: this rules nothing out: no execution comes to it\n"));
  CHECK(!has(told, "dead.sol:5:8:"));
}

TEST_CASE("cli: nothing is told of the library's asserts, where solutions are explained") {
  const Workplace place;
  const std::string script = place.file("doors.sol",
                                        "import \"std/layout.sol\";\nimport \"std/rooms.sol\";\n"
                                        "a = Rect(range(0, 1), 0, 2, 2);\nb = Rect(range(2, 3), 0, 2, 2);\n"
                                        "assert(x2(a) == x1(b));\nassert(b.x > a.x);\n"
                                        "door = door_between(a, b);\nreturn door.y;\n");
  const std::string told = run_solitaire({"explain", script}).out;
  CHECK(has(told, "doors.sol:6:8: note: this rules nothing out"));
  CHECK(!has(told, "rooms.sol:"));  // "rooms with a door between them touch" holds wherever the others do
}

TEST_CASE("cli: explain of what has solutions says what rules nothing out and what never occurs") {
  const Workplace place;
  const std::string script = place.file("solvable.sol", kSolvable);
  const Outcome outcome = run_solitaire({"explain", script});
  CHECK(outcome.status == 0);
  CHECK(without(place, outcome.out) ==
        "solvable.sol has solutions\n"
        "solvable.sol:3:8: note: this rules nothing out: it holds wherever the other conditions do\n"
        "  3 | assert(x < 20 and x > 2, \"not too small\");\n"
        "    |        ^^^^^^\n"
        "x: 3..9; never 0..2\n"
        "lid: true; never false\n");
  const Outcome pinned = run_solitaire({"explain", script, "--pin", "x=5", "--choices"});
  CHECK(has(pinned.out, "x: 5; never 0..4, 6..9\nlid: true; never false\n"));
}

TEST_CASE("cli: explain tells bounds where a choice has many values") {
  const Workplace place;
  const std::string script =
      place.file("wide.sol", "x = range(0, 100000);\nassert(x > 70 and x % 5 == 1 and x < 5000);\n");
  CHECK(has(run_solitaire({"explain", script}).out, "x: from 71 to 4996, of 0 to 100000\n"));
}

TEST_CASE("cli: explain says which asserts no execution comes to") {
  const Workplace place;
  const std::string script =
      place.file("unmet.sol", "x = range(0, 3);\nif x * x == 2 then assert(x > 1);\nreturn x;\n");
  CHECK(has(run_solitaire({"explain", script}).out,
            "unmet.sol:2:27: note: this rules nothing out: no execution comes to it\n"));
}

TEST_CASE("cli: an assert that keeps executions from a mistake rules something out") {
  const Workplace place;
  const std::string script = place.file(
      "guard.sol", "x = range(0, 9);\nassert(x < 5);\nif x == 7 then return 1 + \"a\";\nreturn x;\n");
  CHECK(!has(run_solitaire({"explain", script}).out, "rules nothing out"));
}

TEST_CASE("cli: explain --json is one object with the conflicts") {
  const Workplace place;
  const std::string script = place.file("room.sol", kRoom);
  const Outcome outcome = run_solitaire({"explain", script, "--json", "--pin", "make_room[1]/w=9"});
  CHECK(outcome.status == 1);
  const json found = json::parse(outcome.out);
  CHECK(found["program"] == script);
  CHECK(found["solutions"] == false);
  REQUIRE(found["conflicts"].size() == 1);
  CHECK(found["conflicts"][0]["minimal"] == true);
  const json& members = found["conflicts"][0]["members"];
  REQUIRE(members.size() == 2);
  CHECK(members[0] == json{{"kind", "range"},
                           {"file", script},
                           {"line", 2},
                           {"column", 7},
                           {"text", "range(2, 6)"},
                           {"at", "make_room[1]/w"},
                           {"condition", "make_room[1]/w is at most 6"}});
  CHECK(members[1]["kind"] == "pin");
  CHECK(members[1]["pin"] == "--pin 'make_room[1]/w=9'");
  CHECK(members[1]["value"] == 9);
  const json plain = json::parse(run_solitaire({"explain", script, "--json"}).out);
  const json& assertion = plain["conflicts"][0]["members"][0];
  CHECK(assertion["kind"] == "assert");
  CHECK(assertion["text"] == "w >= least");
  CHECK(assertion["at"] == "make_room[0]/assert");
  CHECK(assertion["message"] == "wide enough");
}

TEST_CASE("cli: explain --json is one object with what a solvable program never does") {
  const Workplace place;
  const std::string script = place.file("solvable.sol", kSolvable);
  const Outcome outcome = run_solitaire({"explain", script, "--json"});
  CHECK(outcome.status == 0);
  const json found = json::parse(outcome.out);
  CHECK(found["solutions"] == true);
  CHECK(found["undecided"] == 0);
  REQUIRE(found["dead"].size() == 1);
  CHECK(found["dead"][0]["line"] == 3);
  CHECK(found["dead"][0]["text"] == "x < 20");
  CHECK(found["dead"][0]["met"] == true);
  REQUIRE(found["choices"].size() == 2);
  CHECK(found["choices"][0]["at"] == "x");
  CHECK(found["choices"][0]["never"] == json{0, 1, 2});
  CHECK(found["choices"][0]["values"].size() == 7);
  CHECK(found["choices"][1]["values"] == json{1});
}

TEST_CASE("cli: explain reports errors of the program as every command does") {
  const Workplace place;
  const Outcome outcome = run_solitaire({"explain", place.file("wrong.sol", "x = 1 + \"a\";\n")});
  CHECK(outcome.status == 3);
  CHECK(outcome.out == "");
  CHECK(has(outcome.err, "wrong.sol:1:5: error:"));
}

// ---- pins

/// The choices of a solution, by their addresses.
json choices_of(const std::string& text) {
  const json solution = json::parse(text);
  json values;
  for (const json& choice : solution["choices"]) values[choice["at"].get<std::string>()] = choice["value"];
  return values;
}

json choices_in(const std::filesystem::path& file) { return choices_of(bytes_of(file)); }

/// The choices of the first solution of a script, or of kSeats where none is named.
json solve(const Workplace& place, std::vector<std::string> options, const std::string& script = "") {
  options.insert(options.begin(),
                 {"solve", script.empty() ? place.file("seats.sol", kSeats) : script, "--json", "-q"});
  const Outcome outcome = run_solitaire(options);
  CHECK(outcome.status == 0);
  return choices_of(outcome.out);
}

TEST_CASE("cli: pins hold choices at a value, by address or pattern, and forbid keeps them from one") {
  const Workplace place;
  const json found = solve(place, {"--pin", "seat[*]/x=4", "--pin", "seat[1]/y=7", "--pin", "near=true",
                                   "--forbid", "seat[0]/y=0", "--forbid", "**/y=1"});
  CHECK(found["seat[0]/x"] == 4);
  CHECK(found["seat[1]/x"] == 4);
  CHECK(found["seat[1]/y"] == 7);
  CHECK(found["near"] == true);
  CHECK(found["seat[0]/y"] > 1);
  CHECK(run_solitaire({"solve", place.file("seats.sol", kSeats), "--pin", "seat[0]/x=10"}).status == 1);
}

TEST_CASE("cli: --pin-file keeps what was liked of a solution") {
  const Workplace place;
  const std::string script = place.file("seats.sol", kSeats);
  const std::string liked =
      place.file("liked.json", run_solitaire({"solve", script, "--json", "--pin", "seat[0]/x=3"}).out);
  CHECK(solve(place, {"--pin-file", liked, "--seed", "5"}) == choices_in(liked));
  const Outcome kept = run_solitaire(
      {"solve", script, "--all", "--json", "--pin-file", liked, "--keep", "seat[0]/**", "--keep", "near"});
  CHECK(kept.status == 0);
  CHECK(std::count(kept.out.begin(), kept.out.end(), '\n') == 100);
  const Outcome wrong = run_solitaire({"solve", script, "--pin-file", liked, "--keep", "seat[2]/x"});
  CHECK(wrong.status == 2);
  CHECK(has(wrong.err, "--keep 'seat[2]/x' matches no choice"));
  CHECK(has(wrong.err, "seat[0]/x"));
}

TEST_CASE("cli: --pin-file takes files in which earlier versions named choices otherwise") {
  const Workplace place;
  place.file("part.sol", "length = range(0, 9);\n");
  const std::string script =
      place.file("room.sol",
                 "import \"std/layout.sol\";\nimport \"part.sol\";\nrecord Spot(x, y);\n"
                 "fun sofa() { return anywhere(\"sofa\", 2, 1, 9, 9); }\n"
                 "desk = Spot(range(0, 9), range(0, 9));\nlamp = Spot(range(0, 9), range(0, 9));\nlamp.x = "
                 "range(0, 9);\n"
                 "seat = anywhere(\"chair\", 1, 1, 9, 9);\nsofas = repeat(2, sofa);\nassert(desk.x < "
                 "9);\nreturn nil;\n");
  // Of the same solution, in the order in which the program meets the choices.
  const std::vector<std::string> today = {"part.sol/length", "desk.x",        "desk.y",     "lamp.x",
                                          "lamp.y",          "lamp.x#2",      "seat/turn",  "seat/x",
                                          "seat/y",          "sofas[0]/turn", "sofas[0]/x", "sofas[0]/y",
                                          "sofas[1]/turn",   "sofas[1]/x",    "sofas[1]/y"};
  const auto renamed = [&](std::vector<std::pair<std::string, std::string>> changes) {
    json choices = json::array();
    for (std::size_t i = 0; i < today.size(); ++i) {
      std::string name = today[i];
      for (const auto& [from, to] : changes) {
        if (name.rfind(from, 0) == 0) {
          name = to + name.substr(from.size());
          break;
        }
      }
      choices.push_back({{"at", name}, {"value", i % 4}});
    }
    return place.file("earlier.json", json{{"value", nullptr}, {"choices", choices}}.dump());
  };
  json expected;
  for (std::size_t i = 0; i < today.size(); ++i) expected[today[i]] = i % 4;
  const std::string first = renamed({{"part.sol/", ""},
                                     {"desk.", ""},
                                     {"lamp.x#2", "x#3"},
                                     {"lamp.x", "x#2"},
                                     {"lamp.y", "y#2"},
                                     {"seat/", "anywhere/"},
                                     {"sofas[0]", "repeat/make[0]/anywhere"},
                                     {"sofas[1]", "repeat/make[1]/anywhere"}});
  CHECK(solve(place, {"--pin-file", first}, script) == expected);
  const std::string second = renamed({{"sofas[0]", "sofas[0]/anywhere"}, {"sofas[1]", "sofas[1]/anywhere"}});
  CHECK(solve(place, {"--pin-file", second, "--keep", "sofas[1]"}, script)["sofas[1]/turn"] == 0);
  CHECK(solve(place, {"--pin-file", second}, script) == expected);
  CHECK(solve(place, {"--pin-file", renamed({})}, script) == expected);
  const Outcome wrong = run_solitaire({"solve", script, "--pin-file", renamed({{"desk.", "chair."}})});
  CHECK(wrong.status == 2);
  CHECK(has(wrong.err, "no choice has such an address"));
}

// The tour of docs/explaining.md.
TEST_CASE("cli: a rough layout first, then variations of what was liked of it") {
  const Workplace place;
  const std::string script = SOLITAIRE_SOURCE_DIR "/examples/workspace.sol";
  const std::string rough = place / "rough";
  // Asked for now as well, so that some variation of what comes can be had.
  const std::vector<std::string> wishes = {"--set",       "groups=2", "--pin",
                                           "door/turn=2", "--forbid", "make_group[0]/make_sofa[*]/turn=1"};
  std::vector<std::string> first = {"generate", script, "-n", "2", "-o", rough};
  first.insert(first.end(), wishes.begin(), wishes.end());
  CHECK(run_solitaire(first).status == 0);
  const json liked = choices_in(place / "rough/workspace-0001.json");
  const std::vector<std::string> keeping = {
      "--pin-file", rough + "/workspace-0001.json",   "--keep", "room.w", "--keep", "room.d",
      "--keep",     "make_group[*]/make_table[*]/**",
  };
  std::vector<std::string> arguments = {"generate", script, "-n", "4", "-o", place / "final"};
  arguments.insert(arguments.end(), wishes.begin(), wishes.end());
  arguments.insert(arguments.end(), keeping.begin(), keeping.end());
  CHECK(run_solitaire(arguments).status == 0);
  const AddressPattern tables("make_group[*]/make_table[*]/**");
  const AddressPattern sofas("make_group[0]/make_sofa[*]/turn");
  for (const char* name : {"workspace-0001.json", "workspace-0004.json"}) {
    const json varied = choices_in(place / ("final/" + std::string(name)));
    CHECK(varied != liked);
    CHECK(varied["door/turn"] == 2);
    for (const auto& [address, value] : varied.items()) {
      const AddressPattern exact(address);
      if (address == "room.w" || address == "room.d" || tables.matches(exact.steps()))
        CHECK(value == liked[address]);
      if (sofas.matches(exact.steps())) CHECK(value != 1);
    }
  }
}

TEST_CASE("cli: a pin that matches nothing names the nearest addresses") {
  const Workplace place;
  const std::string script = place.file("seats.sol", kSeats);
  for (const char* command : {"solve", "explain"}) {
    const Outcome outcome = run_solitaire({command, script, "--pin", "seats[0]/x=3"});
    CHECK(outcome.status == 2);
    CHECK(outcome.out == "");
    CHECK(has(outcome.err, "--pin 'seats[0]/x=3': no choice has such an address"));
    CHECK(has(outcome.err, "seat[0]/x"));
  }
  CHECK(has(run_solitaire({"solve", script, "--pin", "saet[1]/**=3"}).err, "the nearest are seat[1]/**"));
  CHECK(has(run_solitaire({"solve", script, "--pin", "**/z=3"}).err, "**/x"));
}

TEST_CASE("cli: a pin of what stands behind a line that no execution passes is not called misspelled") {
  const Workplace place;
  const std::string refused =
      place.file("refused.sol", "xs = [1];\ny = xs[range(3, 5)];\nreturn range(0, 4);\n");
  const Outcome none = run_solitaire({"solve", refused, "--pin", "range=0"});
  CHECK(none.status == 1);
  CHECK(has(none.err, "the list must have such an element"));
  CHECK(has(run_solitaire({"solve", refused, "--pin", "rnage=0"}).err, "no choice has such an address"));
  const std::string wrong = place.file("wrong.sol", "y = 1 + \"a\";\nreturn range(0, 4);\n");
  const Outcome mistake = run_solitaire({"solve", wrong, "--pin", "range=0"});
  CHECK(mistake.status == 3);
  CHECK(has(mistake.err, "'+' does not go with"));
}

TEST_CASE("cli: a pin's value has the type of the choices that it matches") {
  const Workplace place;
  const std::string script =
      place.file("types.sol", "n = range(0, 3);\nb = flip();\nx = uniform(0, 8);\nreturn [n, b, x];\n");
  const auto pinned = [&](std::vector<std::string> pins) {
    std::vector<std::string> arguments = {"solve", script, "--all"};
    for (const std::string& pin : pins) arguments.insert(arguments.end(), {"--pin", pin});
    return run_solitaire(arguments);
  };
  CHECK(has(pinned({"n=2", "b=true", "x=2.5"}).out, "[2, true, 2.5]"));
  CHECK(has(pinned({"n=2", "b=0", "x=4"}).out, "[2, false, 4.0]"));
  CHECK(pinned({"x=9.5"}).status == 1);
  CHECK(has(pinned({"x=2.5", "n=true"}).err, "--pin 'n=true': n is an int"));
  CHECK(has(pinned({"x=2.5", "n=0.5"}).err, "--pin 'n=0.5': n is an int"));
  CHECK(has(pinned({"x=2.5", "b=2"}).err, "--pin 'b=2': b is a bool"));
  CHECK(has(pinned({"x=false"}).err, "--pin 'x=false'"));
  CHECK(pinned({"x=2.5", "b=2"}).status == 2);
  CHECK(has(run_solitaire({"solve", script, "--all", "--pin", "x=2.5", "--forbid", "**=0.5"}).err,
            "8 solutions"));
}

TEST_CASE("cli: of choose() a pin names the element, and a position where the list has no numbers") {
  const Workplace place;
  const std::string script = place.file("elements.sol",
                                        "fun f() { return 1; }\n"
                                        "a = choose([\"small\", \"a=b\", \"large\"]);\n"
                                        "b = choose([7, range(8, 9), 1]);\n"
                                        "c = choose([[1, 2], [3, 4]]);\n"
                                        "d = choose([f, fun() { return 2; }]);\n"
                                        "e = choose(if flip() then [\"x\", \"y\"] else [\"y\", \"z\"]);\n"
                                        "return a, b, c, d(), e;\n");
  const auto values = [&](std::vector<std::string> pins) {
    std::vector<std::string> arguments = {"solve", script, "--all", "--json", "--distinct", "value", "-q"};
    for (const std::string& pin : pins) arguments.insert(arguments.end(), {"--pin", pin});
    std::set<std::string> found;
    std::istringstream lines(run_solitaire(arguments).out);
    for (std::string line; std::getline(lines, line);) found.insert(json::parse(line)["value"].dump());
    return found;
  };
  using Values = std::set<std::string>;
  const std::vector<std::string> rest = {"b=7", "c=[1,2]", "d=f", "e=x"};
  const auto with_rest = [&](const std::string& pin) {
    std::vector<std::string> pins = rest;
    pins.push_back(pin);
    return values(pins);
  };
  CHECK(with_rest("a=small") == Values{R"(["small",7,[1,2],1,"x"])"});
  CHECK(with_rest("a=\"a=b\"") == Values{R"(["a=b",7,[1,2],1,"x"])"});
  CHECK(with_rest("a=2") == Values{R"(["large",7,[1,2],1,"x"])"});
  CHECK(values({"a=small", "b=1", "c=[3, 4]", "d=1", "e=y"}) == Values{R"(["small",1,[3,4],2,"y"])"});
  CHECK(values({"a=small", "b=9", "c=[3, 4]", "d=1", "e=z"}) == Values{R"(["small",9,[3,4],2,"z"])"});
  CHECK(has(run_solitaire({"solve", script, "--pin", "b=9", "--pin", "c=[1,2]", "--pin", "d=f"}).out,
            "  b = 9\n  c = [1, 2]\n  d = fun f\n"));
}

TEST_CASE("cli: a pin that no value fulfils is told with the values that there are") {
  const Workplace place;
  const std::string script = place.file(
      "few.sol", "size = choose([\"small\", \"large\"]);\nn = range(2, 6);\nx = uniform(0, 8);\nreturn n;\n");
  const auto told = [&](const std::string& pin) {
    const Outcome outcome = run_solitaire({"solve", script, "--pin", pin, "--pin", "x=1"});
    return outcome.out + outcome.err;
  };
  CHECK(has(told("size=medium"),
            "few.sol:1:8: pin: size is medium, by --pin 'size=medium'; it can be one of "
            "\"small\", \"large\"\n"));
  CHECK(has(told("size=7"), "size is 7, by --pin 'size=7'; it can be one of \"small\", \"large\"\n"));
  CHECK(has(told("n=9"), "few.sol:2:5: range: n is at most 6\n"));
  CHECK(has(told("n=9"), "few.sol:2:5: pin: n is 9, by --pin 'n=9'\n"));
  CHECK(has(told("n=true"), "error: --pin 'n=true': n is an int from 2 to 6, not true\n"));
  CHECK(has(told("n=many"), "error: --pin 'n=many': n is an int from 2 to 6, not 'many'\n"));
  CHECK(has(run_solitaire({"solve", script, "--pin", "x=false"}).err,
            "error: --pin 'x=false': x is a float from 0 to 8, not false\n"));
  CHECK(has(run_solitaire({"explain", script, "--pin", "x=9.5"}).out,
            "few.sol:3:5: pin: x is 9.5, by --pin 'x=9.5'; it can be from 0 to 8\n"));
  CHECK(has(run_solitaire({"explain", script, "--pin", "x=1", "--pin", "size=large", "--choices"}).out,
            "size: \"large\"; never \"small\"\n"));
  CHECK(
      has(run_solitaire({"explain", script, "--pin", "x=1", "--pin", "size=large", "--forbid", "size=1"}).out,
          "forbid: size is not \"large\", by --forbid 'size=1'\n"));
}

TEST_CASE("cli: an int that is compared with a bool is told of") {
  const Workplace place;
  const std::string script = place.file("kinds.sol", "b = range(1, 9);\nc = flip();\nassert(b == c);\n");
  CHECK(has(run_solitaire({"explain", script}).out,
            "kinds.sol:3:8: assert: b == c\n  3 | assert(b == c);\n    |        ^^^^^^\n"
            "  note: whatever is chosen, this fails: values of different kinds, such as an int and a bool, "
            "are never "
            "equal\n"));
  const std::string alike = place.file("lengths.sol", "xs = [1, 2];\nassert(length(xs) == 3);\n");
  CHECK(!has(run_solitaire({"explain", alike}).out, "different kinds"));
}

TEST_CASE("cli: members of many turns are told once, with the loops' variables") {
  const Workplace place;
  const std::string script = place.file("turns.sol",
                                        "xs = [[range(0, 9) for x in 1..3] for y in 1..3];\n"
                                        "for x, y in [[x, y] for y in 0..2 for x in 0..2] {\n"
                                        "  assert(xs[y][x] > 4, \"large\");\n"
                                        "}\n"
                                        "assert(sum([sum(row) for row in xs]) < 45);\n");
  CHECK(has(run_solitaire({"explain", script}).out,
            "turns.sol:3:10: assert: xs[y][x] > 4\n"
            "  3 |   assert(xs[y][x] > 4, \"large\");\n"
            "    |          ^^^^^^^^^^^^\n"
            "  note: 9 times, first at x = 0, y = 0; x = 1, y = 0; x = 2, y = 0; last at x = 2, y = 2\n"
            "  note: message: large\n"));
  CHECK(has(run_solitaire({"explain", script, "--full"}).out, "  note: where x = 1, y = 2\n"));
}

TEST_CASE("cli: pins that are not written as pins are wrong usage") {
  const Workplace place;
  const std::string script = place.file("seats.sol", kSeats);
  const std::string solution = place.file("s.json", run_solitaire({"solve", script, "--json"}).out);
  const std::vector<std::vector<std::string>> wrong = {
      {"--pin", "seat[0]/x"},
      {"--pin", "=3"},
      {"--pin", "seat[0]/x=many"},
      {"--pin", "seat[0]/x=1.5"},
      {"--forbid", "seat[0]/x"},
      {"--keep", "seat[0]/x"},
      {"--pin", "seat[0]/x=99999999999999999999"},
  };
  for (const auto& options : wrong) {
    std::vector<std::string> arguments = {"explain", script};
    arguments.insert(arguments.end(), options.begin(), options.end());
    CAPTURE(options.back());
    const Outcome outcome = run_solitaire(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out == "");
    CHECK(outcome.err != "");
  }
  CHECK(run_solitaire({"solve", script, "--pin-file", place / "none.json"}).status == 3);
  CHECK(run_solitaire({"solve", script, "--pin-file", script}).status == 3);
}

}  // namespace
}  // namespace solitaire
