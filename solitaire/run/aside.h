#pragma once
#include <vector>

#include "solitaire/run/effects.h"

namespace solitaire {

/// The effects of a side of a branch that is looked at beside the one that a traced execution takes, so that
/// executions that take either share a trace. Such a side may weigh executions; whatever else it does, it
/// does not do, and throws DoesMore.
class Aside : public Effects {
 public:
  struct DoesMore {};
  struct Factor {
    Span span;
    Value log_weight;
  };

  const std::vector<Factor>& factors() const { return factors_; }

  void choice(const TraceChoice&, const Value&) override { throw DoesMore{}; }
  void constraint(const Constraint&, const Value&) override { throw DoesMore{}; }
  bool wish(AddressId, Span, const Value&) override { throw DoesMore{}; }
  void factor(Span span, const Value& log_weight) override { factors_.push_back({span, log_weight}); }
  void placement(Placement, const BuiltinCall&) override { throw DoesMore{}; }
  void unit(double) override { throw DoesMore{}; }
  std::optional<double> unit() const override { return std::nullopt; }
  void print(std::span<const Value>) override { throw DoesMore{}; }
  void followed(const Value&, Span) override { throw DoesMore{}; }
  void blocked(const BranchSide&, Span) override { throw DoesMore{}; }
  void program_error(const Diagnostic&, AddressId) override { throw DoesMore{}; }
  void unsupported(const Diagnostic&, AddressId, TraceProgramError::Origin) override { throw DoesMore{}; }

 private:
  std::vector<Factor> factors_;
};

}  // namespace solitaire
