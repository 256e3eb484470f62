#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <solitaire/solution.h>
#include <solitaire/stop.h>
#include <string>
#include <vector>

namespace solitaire::api {

enum class Solver : std::uint8_t {
  kCadical,  // the fastest
  kZ3,       // the reference
  kThesis,   // 16-bit ints and random exploration, as published, to measure against
  kShred,    // no solver: executions are drawn by how probable they are
  kTiles,    // maps of tiles are drawn as their exemplars look, from solutions that kCadical finds
};

/// Fixes the choices whose addresses match a pattern.
struct Pin {
  std::string pattern;  // such as "wing[*]/room[0]/x"; docs/command-line.md says what it can hold
  std::optional<ChoiceValue>
      value;               // of choose() the position, from 0; nothing if `element` is no such value
  bool forbidden = false;  // the choices must not have the value, rather than have it
  std::string source;      // how the user said it, for messages
  /// If it is not empty: what choose() is to have chosen, such as `oven`, `20` or `[1, 2]`. A number stands
  /// for a position all the same in a list without numbers.
  std::string element = "";

  SOLITAIRE_API std::string text() const;  // "x=3"
};

/// Reads "ADDRESS=VALUE", where a value of choose() is an element. Throws Error (kUsage), which calls the pin
/// by its source.
SOLITAIRE_API Pin parse_pin(const std::string& text, bool forbidden, const std::string& source);

/// The options of every question about a program. The defaults are those of the command line.
struct Options {
  std::uint64_t seed = 0;  // the same seed, program and options give the same answers
  Solver solver = Solver::kCadical;
  /// "demand" opens the paths that stand in the way of a solution, "random:N" those that N random executions
  /// take. "" stands for demand, and for random:100 with Solver::kThesis.
  std::string explore;
  std::uint64_t max_steps = 10'000'000;  // after which one execution counts as endless
  std::uint32_t max_depth = 4'000;       // calls within each other after which a recursion counts as endless
  std::vector<Pin> pins;
  /// The .json file of a solution, or a line of to_json, whose choices are pinned: those whose addresses
  /// match one of the patterns in `keep`, or all if there is none.
  std::filesystem::path pin_file;
  std::vector<std::string> keep;
  StopToken stop;

  /// Returns how paths are explored, with the default filled in.
  SOLITAIRE_API std::string exploration_name() const;
};

/// Returns what is wrong with a way to explore, or "".
SOLITAIRE_API std::string check_exploration(const std::string& text);

/// Says how hard a search tries for solutions that differ much.
enum class Diversity : std::uint8_t { kLow, kNormal, kHigh };
/// Says how solutions are chosen among all: as the search finds them, or each with the same probability.
enum class Sampling : std::uint8_t { kSearch, kUniform };
/// Says what makes two solutions different: their choices, or what they look like (value and placed things).
enum class Distinct : std::uint8_t { kChoices, kResult, kValue };
/// Says what is to be known of the things that a solution places.
enum class SceneDetail : std::uint8_t {
  kNone,        // nothing; then it is not known, either, how much results differ
  kPlacements,  // what they are, and where
  kProvenance,  // and the choices on which that depends
};

struct SearchOptions : Options {
  std::uint64_t count = 1;  // solutions that are wanted; next() gives no more
  bool all = false;         // all solutions, in place of `count`
  std::uint64_t jobs = 1;   // searches at work side by side; the solutions are the same for any number
  Distinct distinct = Distinct::kChoices;
  std::optional<Diversity> diversity;  // normal, and low for all solutions
  Sampling sampling = Sampling::kSearch;
  double min_distance =
      0;  // the share of choices, 0..1, in which each solution differs from every earlier one
  /// Every solution is run again before it is returned, which checks that the program accepts it. Without
  /// that, most are read off the trace, in about a tenth of the time: the first is run, and those with the
  /// numbers 16, 256, ...
  bool run_each = true;
  bool relax = false;                          // asserts may be broken, as few as possible
  std::optional<double> seconds_per_solution;  // after which the search for one further solution ends
  SceneDetail scene = SceneDetail::kProvenance;
};

}  // namespace solitaire::api
