#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <solitaire/export.h>
#include <solitaire/search.h>
#include <string>
#include <vector>

namespace solitaire::api {

/// A stretch of a program.
struct Place {
  std::string file;
  std::size_t line = 1, column = 1;  // both count from 1, columns in characters
  std::string text;                  // that part of the program on one line, cut off where it is long
};

/// A condition that takes part in a conflict: a conjunct of an assert, an end of a choice's range, a list
/// that must have an element, or a pin; of one call and loop turn.
struct Condition {
  std::string kind;  // "assert", "range", "choice", "index", "divisor", "pin" or "forbid"
  Place place;
  std::string address;
  std::string words;    // what must hold: "x > 5", "x is at most 3"
  std::string message;  // of the assert, or ""
  std::optional<Pin> pin;
};

/// Conditions that cannot hold together.
struct Conflict {
  bool minimal = true;  // it is proved that without any one of them the others can hold
  std::vector<Condition> members;
  std::string reason;  // "11 ints that all differ lie among 10 values"; "" where no short one is known
  std::string text;    // for people: what is alike is told once, and no more than a screen
  std::string whole;   // all of it for people, each member by itself
};

class ExplainObserver;

/// Says why a program has no solution. Use it from one thread at a time.
class SOLITAIRE_API Explainer {
 public:
  /// Unless it is `thorough`, it may leave members in a conflict of many that are not needed, and says so.
  Explainer(const Program& program, const Options& options, bool thorough = false);
  ~Explainer();
  Explainer(const Explainer&) = delete;
  Explainer& operator=(const Explainer&) = delete;

  /// Returns a conflict that shares no condition with those before; nothing if there is no further one, or if
  /// the work stopped: then ending() says so.
  std::optional<Conflict> next();
  Ending ending() const;
  /// Returns the smallest conflict that is known by now, while next() looks for a better one, and nothing
  /// where none is. Any thread may ask.
  std::optional<Conflict> best_so_far() const;
  /// Has the observer told of smaller conflicts; null tells nobody.
  void observe(ExplainObserver* observer);

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// An assert, or a conjunct of one, that rules nothing out.
struct DeadAssert {
  Place place;
  bool met = true;  // executions that fulfil the other conditions come to it
};

struct DeadAsserts {
  std::vector<DeadAssert> dead;  // in the order of the program's text
  std::size_t undecided = 0;     // asserts and conjuncts about which a limit came first
  std::string text;              // all of this for people
};

/// The values that a choice takes in the solutions of a program.
struct ReachableValues {
  std::string address;
  std::int64_t from = 0, to = 0, step = 1;  // its range over all paths; of flip() 0 to 1
  bool is_bool = false;
  std::vector<std::string>
      elements;          // of choose(): what stands at each position, where that has a short text
  bool listed = true;    // `values` are all that occur; else the least and the greatest of them
  bool complete = true;  // no limit came first
  bool pinned = false;
  bool restricted = false;            // some value of the range never occurs
  std::vector<std::int64_t> values;   // in order
  std::vector<std::int64_t> missing;  // of the range, where all that occur are listed
  std::string text;                   // all of this on a line, for people
};

/// All that explain() finds out.
struct Explanation {
  std::string program;            // the script, as it was named
  std::optional<bool> solutions;  // whether there are any; nothing where a limit came first
  std::vector<Conflict> conflicts;
  std::optional<DeadAsserts> asserts;
  std::vector<ReachableValues> choices;
};

/// Returns the explanation as one JSON object on one line; docs/formats.md describes it.
SOLITAIRE_API std::string to_json(const Explanation& explanation);

/// Is told what explain() finds out as it does, on the thread that called it.
class SOLITAIRE_API ExplainObserver {
 public:
  virtual ~ExplainObserver();
  /// Is told what is done next, such as "looking for values that never occur".
  virtual void begun(const std::string& work) = 0;
  virtual void solutions(bool any) = 0;
  virtual void conflict(const Conflict& conflict) = 0;
  /// Is told that a conflict is known which may get smaller: one that conflict() is to follow.
  virtual void smaller(const Conflict& conflict) = 0;
  virtual void asserts(const DeadAsserts& asserts) = 0;
  virtual void choice(const ReachableValues& choice) = 0;
};

struct ExplainOptions : Options {
  std::uint64_t more = 0;    // conflicts after the first, if there are no solutions
  bool all_choices = false;  // tell of every choice, and not only of those that lack values
  bool thorough = false;     // give no question up, however long it takes
};

/// Says why a program has no solution; and of one that has some, what rules nothing out and what never
/// occurs. Returns kNone if all was said, kExhausted if all was said and there is no further conflict, or why
/// not. Throws Error.
SOLITAIRE_API Ending explain(const Program& program, const ExplainOptions& options,
                             ExplainObserver& observer);

}  // namespace solitaire::api
