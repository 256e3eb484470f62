#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <solitaire/export.h>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace solitaire::api {

// Solutions are plain data: they refer to nothing, so any thread may keep them, for as long as it likes.

struct Value;
struct Field;

struct Nil {};
struct List {
  std::vector<Value> items;
};
struct Record {
  std::string type;
  std::vector<Field> fields;
};
struct Function {
  std::string name;  // "fun f", or of a record's constructor "record R"
};

/// A value of the language.
struct Value {
  std::variant<Nil, bool, std::int64_t, double, std::string, List, Record, Function> is;
};

struct Field {
  std::string name;
  Value value;
};

/// The answer to a choice. For choose(list) it is the position in the list, from 0.
using ChoiceValue = std::variant<bool, std::int64_t, double>;

struct Choice {
  std::string address;  // such as "wing[2]/room[0]/make_table/turn"
  ChoiceValue value;
  /// Of choose(list): what it chose as the language writes it, as "\"oven\"", if that is a number, a bool or
  /// a short string; else "".
  std::string element = "";
};

/// A thing that `place` put into the scene, in the program's own coordinates and units: x runs right, y into
/// the depth, z up.
struct Placement {
  std::string asset;            // a bundled model's name, a path to a .glb or .gltf, or "" for a box
  std::array<double, 3> at{};   // the lowest corner of its box after turning
  std::vector<double> size;     // before turning: none (the model's own), [w, d] or [w, d, h]
  int turn = 0;                 // quarter turns counter-clockwise seen from above, 0..3
  std::optional<double> angle;  // degrees counter-clockwise, in place of `turn`
  std::optional<std::array<double, 3>> color;  // red, green, blue, each 0..1
  std::string name;                            // as the program gave it, or ""
  std::string address;                         // of this call of place; unique within a solution
  std::vector<std::string> calls;              // that led to it, outermost first: "wing[2]", "room[0]"
  std::vector<Choice> choices;                 // that decide what it is and where it stands
  std::vector<std::pair<std::string, std::string>> extras;  // further named arguments: name, value as JSON
  std::string source;  // "file.sol:12:3": that call, or the program's call of what the library placed
  std::string folder;  // of the file with that call, relative to the script's; "" if it is the same
};

/// An assert that a near miss breaks.
struct BrokenAssert {
  std::string address;
  std::string source;                // "room.sol:3:8", without a folder
  std::string condition;             // its text
  std::string message;               // the author's, or ""
  std::vector<std::string> choices;  // the addresses of the choices that it depends on
};

/// A wish that costs the solution something.
struct UnmetWish {
  std::string address;
  std::string source;                // "room.sol:3:1", without a folder
  std::string text;                  // the call: "prefer(near, 5)"
  std::int64_t cost = 0;             // more than 0
  std::vector<std::string> choices;  // the addresses of the choices that it depends on
};

/// Says how good a solution is, where some are better than others. Fewer broken asserts are better, and of
/// those with as many the one that costs less.
struct Quality {
  std::size_t broken = 0;    // asserts
  std::size_t wishes = 0;    // that the solution met
  std::int64_t cost = 0;     // of these wishes
  bool proved_best = false;  // it is proved that no better solution was left
  bool is_maximum = false;   // all that is wished for is one maximum, the negative of the cost
  /// It is proved that no solution that was left costs less. It is not known of near misses.
  std::optional<std::int64_t> least_cost;
};

/// An execution of a program in which every assert holds, unless they may be broken.
struct Solution {
  std::uint64_t number = 0;  // from 1, in its search
  Value value;               // what the program returned
  std::string text;          // the value as the language writes it
  std::vector<Choice> choices;
  std::vector<Choice> auxiliary;  // those that make no solutions different; needed to run it again
  std::optional<Quality> quality;
  std::vector<BrokenAssert> broken;
  std::vector<UnmetWish> unmet;
  std::vector<Placement> placements;
  double unit = 1;                   // metres in one unit of the program
  std::vector<std::string> printed;  // the lines that it printed
};

/// Returns the solution as one JSON object on one line, without a newline; docs/formats.md describes it.
SOLITAIRE_API std::string to_json(const Solution& solution);
/// Returns the solution as text for people, on several lines: the value, how good it is, and the choices.
SOLITAIRE_API std::string to_text(const Solution& solution);
/// Returns the answer to a choice as the language writes it.
SOLITAIRE_API std::string to_text(const ChoiceValue& value);
/// Returns how good the solution is: "cost 5, proved the best left", "maximum 7, proved the best left" where
/// all that is wished for is a maximum, or "" where all are as good. Where the best is not proved, it tells
/// what is: "cost 5, not proved the best left, but none costs less than 3".
SOLITAIRE_API std::string quality_text(const Solution& solution);
/// Returns an unmet wish on a line: "room.sol:3:1: prefer(near, 5) (cost 5)".
SOLITAIRE_API std::string to_text(const UnmetWish& wish);
/// Returns a broken assert on a line: "room.sol:3:8: table.x < 4 (at room[2]/assert)".
SOLITAIRE_API std::string to_text(const BrokenAssert& broken);

}  // namespace solitaire::api
