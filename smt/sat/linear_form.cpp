#include "smt/sat/linear_form.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>

#include "smt/tuning.h"

namespace solitaire {
namespace {

constexpr std::int64_t kLargest = std::int64_t{1} << 30;
constexpr std::int64_t kLargestSum = std::int64_t{1} << 61;

class FormReader {
 public:
  FormReader(const Graph& graph, std::size_t most) : graph_(graph), most_(most) {}

  void add(NodeId node, std::int64_t factor) { factors_[node.index] += factor; }

  /// Takes apart the newest node first, as operands are older than what uses them.
  std::optional<LinearForm> read() {
    while (!factors_.empty()) {
      const auto [index, factor] = *factors_.begin();
      factors_.erase(factors_.begin());
      if (factor != 0 && !take_apart({index}, factor)) return std::nullopt;
    }
    return std::move(form_);
  }

 private:
  bool take_apart(NodeId id, std::int64_t factor) {
    const Graph::Node& node = graph_.node(id);
    if (std::abs(factor) > kLargest) return false;
    const auto is_constant = [&](std::size_t i) { return graph_.node(node.operands[i]).is_constant(); };
    if (node.op == Op::kAdd || node.op == Op::kSub) {
      add(node.operands[0], factor);
      add(node.operands[1], node.op == Op::kAdd ? factor : -factor);
    } else if (node.op == Op::kNeg) {
      add(node.operands[0], -factor);
    } else if (node.op == Op::kMul && (is_constant(0) || is_constant(1))) {
      const std::size_t constant = is_constant(0) ? 0 : 1;
      const std::int64_t times = graph_.node(node.operands[constant]).interval.lo;
      if (std::abs(times) > kLargest) return false;
      add(node.operands[1 - constant], factor * times);
    } else {
      return add_leaf(id, factor);
    }
    return factors_.size() + form_.terms.size() <= most_;
  }

  bool add_leaf(NodeId id, std::int64_t factor) {
    const Graph::Node& node = graph_.node(id);
    const std::int64_t largest = std::max(std::abs(node.interval.lo), std::abs(node.interval.hi));
    if (largest > kLargest || (total_ += std::abs(factor) * largest) > kLargestSum) return false;
    if (node.is_constant()) {
      form_.constant += factor * node.interval.lo;
    } else {
      form_.terms.emplace_back(id, factor);
    }
    return true;
  }

  const Graph& graph_;
  std::size_t most_;
  std::map<std::uint32_t, std::int64_t, std::greater<>> factors_;  // of nodes that are not taken apart yet
  LinearForm form_;
  std::int64_t total_ = 0;  // the most that the parts can come to, whatever their signs
};

bool is_arithmetic(Op op) { return op == Op::kAdd || op == Op::kSub || op == Op::kNeg || op == Op::kMul; }

/// Returns true for an int by itself, or with a constant added: it gives one term.
bool is_one_term(const Graph& graph, NodeId id) {
  const Graph::Node& node = graph.node(id);
  if (!is_arithmetic(node.op)) return true;
  return node.op == Op::kAdd && graph.node(node.operands[1]).is_constant() &&
         !is_arithmetic(graph.node(node.operands[0]).op);
}

}  // namespace

std::optional<LinearForm> difference_form(const Graph& graph, NodeId a, NodeId b, std::size_t most) {
  FormReader reader(graph, most);
  reader.add(a, -1);
  reader.add(b, 1);
  return reader.read();
}

bool may_have_form(const Graph& graph, NodeId a, NodeId b) {
  return !is_one_term(graph, a) || !is_one_term(graph, b);
}

std::optional<LinearForm> ordered_difference_form(const Graph& graph, NodeId a, NodeId b,
                                                  const std::function<OrderSize(NodeId)>& size) {
  if (!may_have_form(graph, a, b)) return std::nullopt;
  auto form = difference_form(graph, a, b, tuning::kMostLinearFormTerms);
  if (!form || form->terms.size() < tuning::kLeastLinearTerms) return std::nullopt;
  const auto has_order = [&](const auto& term) { return size(term.first).is_ordered(); };
  return std::ranges::all_of(form->terms, has_order) ? form : std::nullopt;
}

}  // namespace solitaire
