#include "kernel/known_forms.h"

#include <algorithm>
#include <iterator>

#include "kernel/dependents.h"
#include "tracegraph/density.h"

namespace solitaire {
namespace {

/// To compare all values of a choice with more of them takes longer than to look for better ones.
constexpr std::uint64_t kMostValues = 64;
/// So many operations are looked at for a trace at most, which takes about a second. Judgement.
constexpr std::size_t kMostLooks = 2'000'000;

class FormsOfTrace {
 public:
  FormsOfTrace(Graph& graph, const Demands& demands)
      : graph_(graph), demands_(demands), dependents_(graph.size()) {
    std::vector<bool> live(graph.size(), false);
    for (const auto* needed : {&demands.terms, &demands.required, &demands.assumed})
      for (const NodeId node : *needed) live[node.index] = true;
    for (auto i = static_cast<std::uint32_t>(graph.size()); i-- > 0;) {
      if (!live[i]) continue;
      for (const NodeId operand : graph.node({i}).args()) {
        live[operand.index] = true;
        dependents_.add(operand.index, i);
      }
    }
  }

  KnownForm of(const TraceChoice& choice) {
    const NodeId variable = choice.variable;
    if (!is_choice(graph_.node(variable).op)) return {};
    Reach reach;
    reach.nodes = dependents_.closure(std::span(&variable.index, 1));
    reach.nodes.insert(reach.nodes.begin(), variable.index);
    looks_ += reach.nodes.size();
    if (looks_ > kMostLooks || meets(reach, demands_.assumed)) return {};
    reach.terms = those_in(reach, demands_.terms);
    reach.required = those_in(reach, demands_.required);
    std::erase(reach.required, in_support(graph_, choice.domain, choice.parameters, variable));
    const bool fixed = has_fixed_parameters(graph_, choice);
    if (choice.domain.is_finite()) return of_few(choice, fixed, reach);
    auto known = form_of_float(graph_, variable, choice.domain, fixed, reach);
    if (!known) return {};
    known->required = reach.required;
    return *known;
  }

 private:
  KnownForm of_few(const TraceChoice& choice, bool fixed, const Reach& reach) {
    const bool is_index =
        choice.domain.family == Distribution::Family::kFlip || !choice.domain.weights.empty();
    if (!(fixed || is_index) || choice.domain.size() > kMostValues) return {};
    return weights_of_values(graph_, choice.variable, choice.domain, reach).value_or(KnownForm{});
  }

  static bool in(const Reach& reach, NodeId node) {
    return std::binary_search(reach.nodes.begin(), reach.nodes.end(), node.index);
  }
  static bool meets(const Reach& reach, const std::vector<NodeId>& nodes) {
    return std::any_of(nodes.begin(), nodes.end(), [&](NodeId node) { return in(reach, node); });
  }
  /// In ascending order.
  static std::vector<NodeId> those_in(const Reach& reach, const std::vector<NodeId>& nodes) {
    std::vector<NodeId> found;
    std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(found),
                 [&](NodeId node) { return in(reach, node); });
    std::sort(found.begin(), found.end(), [](NodeId a, NodeId b) { return a.index < b.index; });
    return found;
  }

  Graph& graph_;
  const Demands& demands_;
  Dependents dependents_;
  std::size_t looks_ = 0;
};

}  // namespace

std::vector<KnownForm> known_forms(Graph& graph, const Trace& trace, const Demands& demands) {
  FormsOfTrace forms(graph, demands);
  std::vector<KnownForm> found;
  for (const TraceChoice& choice : trace.choices) found.push_back(forms.of(choice));
  return found;
}

bool has_fixed_parameters(const Graph& graph, const TraceChoice& choice) {
  return std::all_of(choice.parameters.begin(), choice.parameters.end(),
                     [&](NodeId each) { return graph.node(each).is_constant(); });
}

}  // namespace solitaire
