#include "engines/solve/conclusions/symmetry.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <numeric>
#include <set>

#include "engines/seen.h"
#include "engines/tuning.h"
#include "tracegraph/cone.h"

namespace solitaire {
namespace {

/// Maps each variable to the one in whose place it stands.
using Renaming = std::vector<std::size_t>;

/// Gives numbers to expressions: equal ones to those that are the same up to the order of operands, and for
/// conjunctions and disjunctions also up to how they are nested.
class Shapes {
 public:
  explicit Shapes(const Graph& graph) : graph_(graph) {}

  /// Returns the numbers of all nodes, with the variables renamed. Operands have smaller numbers than what is
  /// made of them.
  std::vector<std::uint32_t> of_all(const Renaming& renaming) {
    std::vector<std::uint32_t> shapes;
    shapes.reserve(graph_.size());
    for (std::uint32_t i = 0; i < graph_.size(); ++i) shapes.push_back(shape({i}, renaming, shapes));
    return shapes;
  }

 private:
  using Key = std::pair<Op, std::vector<std::uint64_t>>;

  std::uint32_t shape(NodeId id, const Renaming& renaming, const std::vector<std::uint32_t>& shapes) {
    const Graph::Node& node = graph_.node(id);
    if (node.is_constant()) return intern({node.op, {id.index}});
    if (node.op == Op::kChoice) return intern({node.op, {renaming[node.payload]}});
    Key key{node.op, {}};
    for (const NodeId operand : node.args()) append(key, shapes[operand.index]);
    if (operation(node.op).commutative) std::sort(key.second.begin(), key.second.end());
    if (is_connective(node.op))
      key.second.erase(std::unique(key.second.begin(), key.second.end()), key.second.end());
    return intern(std::move(key));
  }

  static bool is_connective(Op op) { return op == Op::kAnd || op == Op::kOr; }

  void append(Key& key, std::uint32_t operand) const {
    const Key& nested = *keys_[operand];
    if (is_connective(key.first) && nested.first == key.first) {
      key.second.insert(key.second.end(), nested.second.begin(), nested.second.end());
    } else {
      key.second.push_back(operand);
    }
  }

  std::uint32_t intern(Key key) {
    const auto [entry, added] =
        numbers_.try_emplace(std::move(key), static_cast<std::uint32_t>(keys_.size()));
    if (added) keys_.push_back(&entry->first);
    return entry->second;
  }

  const Graph& graph_;
  std::map<Key, std::uint32_t> numbers_;
  std::vector<const Key*> keys_;  // by number
};

/// Describes what a program requires, returns and shows, as text in terms of shapes.
class Meaning {
 public:
  Meaning(const SymbolicPass& pass, const std::vector<NodeId>& conditions)
      : pass_(pass), conditions_(conditions) {}

  /// Returns true if texts tell all that there is to it.
  bool is_clear() const {
    const auto clear = [](const TracePlaced& placed, const SymbolicPass& pass) {
      return std::ranges::all_of(look_arguments(pass.placements[placed.number]), is_sayable);
    };
    return pass_.complete && is_sayable(pass_.value) &&
           std::ranges::all_of(pass_.trace.placed,
                               [&](const TracePlaced& each) { return clear(each, pass_); });
  }

  std::vector<std::string> texts(const std::vector<std::uint32_t>& shapes) const {
    const NodeName name = [&](NodeId node) { return fmt::format("#{}", shapes[node.index]); };
    std::vector<std::string> texts;
    for (const NodeId condition : conditions_) texts.push_back(name(condition));
    for (const TracePlaced& placed : pass_.trace.placed) {
      std::string text = name(placed.guard);
      for (const Value& argument : look_arguments(pass_.placements[placed.number]))
        text += ' ' + to_text(argument, name);
      texts.push_back(std::move(text));
    }
    texts.push_back(to_text(pass_.value, name));
    std::sort(texts.begin(), texts.end());
    return texts;
  }

 private:
  const SymbolicPass& pass_;
  const std::vector<NodeId>& conditions_;
};

/// The choices below one turn of a loop, by the rest of their addresses.
using Row = std::map<std::string, std::size_t>;
/// The rows of a loop, by turn.
using Rows = std::map<std::uint32_t, Row>;

/// Returns the rows of all loops, by where the loop is: for each site in it, and for all sites below the same
/// call together.
std::map<std::string, Rows> rows_of(const Graph& graph, const AddressTable& addresses) {
  std::map<std::string, Rows> all;
  for (std::size_t variable = 0; variable < graph.variables().size(); ++variable) {
    const std::vector<std::string> steps = addresses.steps(graph.variables()[variable].address);
    std::string before;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::size_t bracket = steps[i].rfind('[');
      if (bracket != std::string::npos) {
        std::uint32_t turn = 0;
        std::from_chars(steps[i].data() + bracket + 1, steps[i].data() + steps[i].size(), turn);
        std::string rest = steps[i].substr(0, bracket);
        const std::string site = before + rest;
        for (std::size_t k = i + 1; k < steps.size(); ++k) rest += '/' + steps[k];
        all[site][turn].emplace(rest, variable);
        all[before + "*"][turn].emplace(rest, variable);
      }
      before += steps[i] + '/';
    }
  }
  return all;
}

/// A swap of the choices of two rows, one variable of the first and one of the second each; nothing if these
/// do not correspond, or not all of the first come before those of the second.
using Swap = std::vector<std::pair<std::size_t, std::size_t>>;
Swap swap_of(const Graph& graph, const Row& first, const Row& second) {
  Swap swap;
  if (first.size() != second.size()) return swap;
  for (auto a = first.begin(), b = second.begin(); a != first.end(); ++a, ++b) {
    const bool alike = a->first == b->first && a->second < b->second &&
                       graph.variables()[a->second].domain == graph.variables()[b->second].domain;
    if (!alike) return {};
    swap.emplace_back(a->second, b->second);
  }
  std::sort(swap.begin(), swap.end());
  return swap;
}

Renaming renaming_of(const Graph& graph, const Swap& swap) {
  Renaming renaming(graph.variables().size());
  std::iota(renaming.begin(), renaming.end(), std::size_t{0});
  for (const auto& [a, b] : swap) std::swap(renaming[a], renaming[b]);
  return renaming;
}

/// Returns the condition that the first variables come before the second ones, or are the same.
NodeId in_order(Graph& graph, const Swap& swap) {
  NodeId in_order = kTrue;
  for (auto pair = swap.rbegin(); pair != swap.rend(); ++pair) {
    const NodeId a = graph.variable_node(pair->first), b = graph.variable_node(pair->second);
    const NodeId rest = graph.conjunction(graph.apply(Op::kEqInt, {a, b}), in_order);
    in_order = graph.disjunction(graph.apply(Op::kLtInt, {a, b}), rest);
  }
  return in_order;
}

}  // namespace

std::vector<NodeId> symmetry_breaking(Graph& graph, const AddressTable& addresses, const SymbolicPass& pass,
                                      const std::vector<NodeId>& conditions) {
  const std::vector<NodeId> required = conjuncts(graph, conditions);
  const Meaning meaning(pass, required);
  if (!meaning.is_clear()) return {};
  Shapes shapes(graph);
  const auto texts = [&](const Swap& swap) { return meaning.texts(shapes.of_all(renaming_of(graph, swap))); };
  const std::vector<std::string> as_it_is = texts({});
  std::set<Swap> tried, swaps;
  std::size_t looked_at = graph.size();
  for (const auto& [loop, rows] : rows_of(graph, addresses)) {
    for (auto row = rows.begin(); row != rows.end() && std::next(row) != rows.end(); ++row) {
      Swap swap = swap_of(graph, row->second, std::next(row)->second);
      if (swap.empty() || !tried.insert(swap).second) continue;
      looked_at += graph.size();
      if (looked_at > tuning::kMostNodesForSymmetry) break;
      if (texts(swap) == as_it_is) swaps.insert(std::move(swap));
    }
  }
  std::vector<NodeId> breaking;
  for (const Swap& swap : swaps) breaking.push_back(in_order(graph, swap));
  return breaking;
}

}  // namespace solitaire
