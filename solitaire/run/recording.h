#pragma once
#include "solitaire/run/effects.h"
#include "solitaire/run/path.h"
#include "solitaire/run/symbolic_pass.h"

namespace solitaire {

/// Writes down what one execution does.
class ExecutionEffects : public Effects {
 public:
  explicit ExecutionEffects(Execution& execution) : execution_(execution) {}

  void choosing_from(const Value& list) override { list_ = list; }
  void choice(const TraceChoice& choice, const Value& value) override;
  void constraint(const Constraint& constraint, const Value& condition) override;
  bool wish(AddressId address, Span span, const Value& cost) override;
  void factor(Span span, const Value& log_weight) override;
  void placement(Placement placement, const BuiltinCall& call) override;
  void unit(double metres) override { execution_.unit = metres; }
  std::optional<double> unit() const override { return execution_.unit; }
  void tile_map(std::int64_t width, std::int64_t height, const Value& source) override;
  void print(std::span<const Value> arguments) override;
  void followed(const Value&, Span) override {}
  void blocked(const BranchSide&, Span) override {}
  void program_error(const Diagnostic& diagnostic, AddressId) override { throw ProgramError(diagnostic); }
  void unsupported(const Diagnostic& diagnostic, AddressId, TraceProgramError::Origin) override {
    throw ProgramError(diagnostic);
  }

 protected:
  Execution& execution_;

 private:
  Value list_;  // of the next choice, if it is one among positions
};

/// Writes down what the output of an execution does, in which nothing is decided any more.
class OutputEffects : public ExecutionEffects {
 public:
  using ExecutionEffects::ExecutionEffects;

  void constraint(const Constraint& constraint, const Value& condition) override;
  bool wish(AddressId address, Span span, const Value& cost) override;
  void factor(Span span, const Value& log_weight) override;
};

/// Writes down what one execution does, and beside it how that comes from its choices.
class TracedEffects : public ExecutionEffects {
 public:
  TracedEffects(TracedExecution& traced, Graph& graph)
      : ExecutionEffects(traced.execution), traced_(traced), graph_(graph) {}

  void choice(const TraceChoice& choice, const Value& value) override;
  void constraint(const Constraint& constraint, const Value& condition) override;
  bool wish(AddressId address, Span span, const Value& cost) override;
  void factor(Span span, const Value& log_weight) override;
  void placement(Placement placement, const BuiltinCall& call) override;
  void followed(const Value& condition, Span span) override;

 private:
  TracedExecution& traced_;
  Graph& graph_;
};

/// Writes down what all executions do, each thing under the guard of its path.
class SymbolicEffects : public Effects {
 public:
  SymbolicEffects(SymbolicPass& pass, Graph& graph, const Path& path)
      : pass_(pass), graph_(graph), path_(path) {}

  void choosing_from(const Value& list) override { pass_.lists.push_back(list); }
  void choice(const TraceChoice& choice, const Value& value) override;
  void constraint(const Constraint& constraint, const Value& condition) override;
  bool wish(AddressId address, Span span, const Value& cost) override;
  void factor(Span, const Value&) override {}  // which such a pass refuses before it comes to this
  void placement(Placement placement, const BuiltinCall& call) override;
  void unit(double metres) override { pass_.unit = metres; }
  void unit_is_open() override;
  std::optional<double> unit() const override;
  void tile_neighbors(const Value& condition) override;
  void print(std::span<const Value>) override {}
  void needs_execution() override { pass_.complete = false; }
  void compared_unlike(Span span) override { pass_.unlike.insert(span); }
  void followed(const Value&, Span) override {}
  void blocked(const BranchSide& side, Span span) override;
  void program_error(const Diagnostic& diagnostic, AddressId address) override;
  void unsupported(const Diagnostic& diagnostic, AddressId address,
                   TraceProgramError::Origin origin) override;
  TraceRecorder* segments() override { return &recorder_; }

 private:
  SymbolicPass& pass_;
  Graph& graph_;
  const Path& path_;
  TraceRecorder recorder_;
};

}  // namespace solitaire
