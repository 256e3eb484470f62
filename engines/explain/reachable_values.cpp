#include "engines/explain/reachable_values.h"

#include <algorithm>
#include <unordered_map>

#include "engines/tuning.h"

namespace solitaire {
namespace {

using Outcome = ExecutionSolver::Outcome;

class Survey {
 public:
  Survey(const Program& program, const ParamValues& params, const TracingOptions& options,
         AddressTable& addresses)
      : pins_(options.pins, addresses),
        choices_(pins_),
        solver_(program, params, options, choices_, graph_, addresses, [](const Term&) { return true; }) {}

  void run(bool with_auxiliary, const std::function<void(const ReachableValues&)>& told) {
    for (std::uint64_t i = 0; i < tuning::kSamplesOfValues; ++i) {
      solver_.suggest_random_values(i);
      if (!find([] { return kTrue; })) break;
    }
    for (std::size_t i = 0; i < found_.size(); ++i) {  // grows while more is explored
      if (found_[i].auxiliary && !with_auxiliary) continue;
      if (found_[i].listed) {
        list_values(i);
      } else {
        find_end(i, false);
        find_end(i, true);
      }
      told(found_[i]);
    }
  }

 private:
  /// Looks for a solution with that condition, and takes note of all its choices.
  bool find(const std::function<NodeId()>& condition) {
    last_ = solver_.find([&] {
      meet_pass();
      std::vector<NodeId> nodes{graph_.disjunction(condition(), solver_.unexplored())};
      for (const PinnedChoice& pinned : pinned_choices(graph_, solver_.pass(), pins_))
        nodes.push_back(pinned.holds);
      return nodes;
    });
    if (last_ != Outcome::kFound) return false;
    Assignment assignment = solver_.assignment();
    for (const auto& [address, value] : solver_.met(assignment).values)
      found_[index_.at(address)].values.insert(value.as_int());
    return true;
  }

  void meet_pass() {
    for (const TraceChoice& choice : solver_.trace().choices) {
      const auto [it, added] = index_.try_emplace(choice.address, found_.size());
      if (added) {
        found_.push_back({choice.address, choice.span, choice.domain, {}});
        found_.back().auxiliary = choice.auxiliary;
        found_.back().pinned = pins_.fixing(choice.address) != nullptr;
      }
      note_elements(found_[it->second], choice);
      Distribution& domain = found_[it->second].domain;
      domain.lo = std::min(domain.lo, choice.domain.lo);
      domain.hi = std::max(domain.hi, choice.domain.hi);
      found_[it->second].listed = domain.size() <= tuning::kMostValuesListed;
    }
  }

  /// On other paths the same choice may choose among others: then both are told.
  void note_elements(ReachableValues& found, const TraceChoice& choice) {
    if (choice.domain.family != Distribution::Family::kIndex ||
        choice.domain.size() > tuning::kMostValuesListed)
      return;
    found.elements.resize(std::max(found.elements.size(), choice.domain.size()));
    for (std::uint64_t i = 0; i < choice.domain.size(); ++i) {
      const std::string text = element_at(solver_.pass(), choice, static_cast<std::int64_t>(i));
      std::string& known = found.elements[i];
      if (known.find(text) == std::string::npos) known += (known.empty() ? "" : " or ") + text;
    }
  }

  /// Returns the condition that the choice is met with a value for which `so` holds.
  NodeId with_value(std::size_t number, const std::function<NodeId(NodeId variable)>& so) {
    NodeId any = kFalse;
    for (const TraceChoice& choice : solver_.trace().choices) {
      if (choice.address != found_[number].address) continue;
      any = graph_.disjunction(any, graph_.conjunction(choice.guard, so(choice.variable)));
    }
    return any;
  }

  void list_values(std::size_t number) {
    const auto another = [&](NodeId variable) {
      NodeId all = kTrue;
      for (const std::int64_t value : found_[number].values) {
        const NodeId equal = graph_.apply(Op::kEqInt, {variable, graph_.constant(value)});
        all = graph_.conjunction(all, graph_.negation(equal));
      }
      return all;
    };
    while (found_[number].values.size() < found_[number].domain.size() &&
           find([&] { return with_value(number, another); })) {
    }
    note_limit(number);
  }

  /// Bisects between the outermost value known and the end of the domain.
  void find_end(std::size_t number, bool upper) {
    if (found_[number].values.empty() &&
        !find([&] { return with_value(number, [](NodeId) { return kTrue; }); })) {
      return note_limit(number);
    }
    std::int64_t end = upper ? found_[number].domain.hi : found_[number].domain.lo;
    while (true) {
      const auto& values = found_[number].values;
      const std::int64_t known = upper ? *values.rbegin() : *values.begin();
      if (known == end) break;
      const std::int64_t target = upper ? known + (end - known + 1) / 2 : known - (known - end + 1) / 2;
      const auto beyond = [&](NodeId variable) {
        const NodeId bound = graph_.constant(target);
        return upper ? graph_.apply(Op::kLeInt, {bound, variable})
                     : graph_.apply(Op::kLeInt, {variable, bound});
      };
      if (find([&] { return with_value(number, beyond); })) continue;
      if (last_ != Outcome::kNone) break;
      end = upper ? target - 1 : target + 1;
    }
    note_limit(number);
  }

  void note_limit(std::size_t number) {
    if (last_ == Outcome::kStopped || last_ == Outcome::kUnexplored) found_[number].complete = false;
  }

  Pins pins_;
  PinnedChoices choices_;
  Graph graph_;
  ExecutionSolver solver_;
  std::vector<ReachableValues> found_;
  std::unordered_map<AddressId, std::size_t> index_;
  Outcome last_ = Outcome::kFound;
};

}  // namespace

bool ReachableValues::restricted() const {
  if (listed) return values.size() < domain.size();
  return values.empty() || *values.begin() > domain.lo || *values.rbegin() < domain.hi;
}

void find_reachable_values(const Program& program, const ParamValues& params, const TracingOptions& options,
                           AddressTable& addresses, bool with_auxiliary,
                           const std::function<void(const ReachableValues&)>& told) {
  Survey(program, params, options, addresses).run(with_auxiliary, told);
}

}  // namespace solitaire
