#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/span.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// A choice that was left open, and when an execution meets it.
struct TraceChoice {
  NodeId guard;
  NodeId variable;  // a choice node, or a constant where only one value is possible
  AddressId address;
  Distribution domain;
  Span span;
  /// Where an execution is traced, the parameters of the distribution as of log_density() (density.h).
  std::vector<NodeId> parameters = {};
  bool auxiliary = false;       // solutions that differ in nothing but such choices are one
  std::size_t list = SIZE_MAX;  // of choose(list): which of the lists that the evaluation chose from
};

/// Why an execution is ruled out.
enum class ConstraintKind : std::uint8_t {
  kAssert,    // an assert of the program
  kLowEnd,    // a choice is not below its range
  kHighEnd,   // a choice is not above its range
  kStep,      // a choice is one of the values that its range steps to
  kNotEmpty,  // there is something to choose from
  kIndex,     // a list has an element at that index
  kDivisor,   // a divisor is not zero
};

/// One contribution to what makes an execution a solution, or a good or likely one. It counts in the
/// executions in which its guard holds.
struct Term {
  enum class Strength : std::uint8_t {
    kHard,       // the node is a bool, and holds in every solution
    kCost,       // the node is an int, and the sum of all costs should be small: prefer, minimize, maximize
    kLogWeight,  // the node is a float, and is added to the logarithm of the execution's probability density
  };

  Strength strength = Strength::kHard;
  NodeId guard;
  NodeId node;
  AddressId address;
  Span span;  // of the expression; where asserts are taken apart, of one conjunct of the condition

  // Hard terms have these in addition.
  ConstraintKind requirement = ConstraintKind::kAssert;
  Span whole;           // of the whole condition
  std::string message;  // the author's, or ""
  std::string turn =
      "";  // the known variables of the loops around it, "x = 3, y = 1"; where executions go on

  bool is_hard() const { return strength == Strength::kHard; }
};

/// A thing put into the scene, with the nodes on which its place, size and looks depend.
struct TracePlaced {
  NodeId guard;
  AddressId address;
  Span span;
  std::vector<NodeId> depends;
  std::size_t number = 0;  // among all that the evaluation placed
};

/// One side of an undecided branch, named by the branch's address; or, as a cut, a point where a pass ran out
/// of the steps it was granted.
struct BranchSide {
  enum class Kind : std::uint8_t { kThen, kElse, kCut };
  AddressId branch;
  Kind kind = Kind::kThen;
  friend bool operator==(const BranchSide&, const BranchSide&) = default;
};

/// An unexplored side: solutions are looked for where no blocker's guard holds.
struct TraceBlocker {
  NodeId guard;
  BranchSide side;
  Span span;
};

/// An error that a concrete execution would report, or something that the pass could not express.
struct TraceProgramError {
  enum class Origin : std::uint8_t {
    kProgram,  // every execution that comes here makes it
    kPass,     // the pass cannot go on, though executions can
    kSteps,    // some path that comes here takes too many steps, perhaps one that no execution takes
  };
  NodeId guard;
  AddressId address;
  Span span;
  std::string message;
  std::string help;
  Origin origin = Origin::kProgram;
};

/// All effects that one symbolic evaluation found, in program order. It is the trace graph of section 4.1.5,
/// seen from its effects.
struct Trace {
  std::vector<TraceChoice> choices;
  std::vector<Term> hard_terms;
  std::vector<Term> soft_terms;  // costs and weights
  std::vector<TracePlaced> placed;
  std::vector<TraceBlocker> blockers;
  std::vector<TraceProgramError> program_errors;
  std::vector<NodeId> returned;  // on which the program's value depends

  bool has_costs() const;
  void add(Term term) { (term.is_hard() ? hard_terms : soft_terms).push_back(std::move(term)); }
};

/// Collects a Trace during an evaluation. Effects go into the current segment with guards that are relative
/// to the segment's start. A call that several exclusive branches share is evaluated once, as a segment with
/// several callers; finish() makes every guard absolute: the segment's entry is the disjunction of its
/// callers'.
class TraceRecorder {
 public:
  using SegmentId = std::uint32_t;

  TraceRecorder();

  /// Starts a segment and makes it the current one; end_segment returns to the one before.
  SegmentId begin_segment();
  void end_segment();
  bool in_segment() const { return open_.size() > 1; }
  /// The current segment reaches `callee` under that guard (relative to the current segment).
  void enter_segment(SegmentId callee, NodeId guard);

  void add(TraceChoice choice) { current().choices.push_back(std::move(choice)); }
  void add(Term term) { current().add(std::move(term)); }
  void add(TracePlaced placed) { current().placed.push_back(std::move(placed)); }
  void add(TraceBlocker blocker) { current().blockers.push_back(std::move(blocker)); }
  void add(TraceProgramError error) { current().program_errors.push_back(std::move(error)); }

  Trace finish(Graph& graph);

 private:
  struct Caller {
    SegmentId segment;
    NodeId guard;
  };
  struct Segment {
    Trace trace;
    std::vector<Caller> callers;
  };
  Trace& current() { return segments_[open_.back()].trace; }
  std::vector<NodeId> entry_guards(Graph& graph) const;

  std::vector<Segment> segments_;
  std::vector<SegmentId> open_;
};

}  // namespace solitaire
