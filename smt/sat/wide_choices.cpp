#include "smt/sat/wide_choices.h"

#include <algorithm>
#include <cstdint>
#include <map>

#include "smt/sat/linear_form.h"
#include "smt/tuning.h"

namespace solitaire {
namespace {

/// Goes through nodes from the newest on, so that it knows of each how it is read when it comes to what that
/// reads in turn.
class Uses {
 public:
  Uses(const Graph& graph, std::uint32_t first, const std::function<OrderSize(NodeId)>& size)
      : graph_(graph), first_(first), size_(size), reads_(graph.size() - first) {}

  std::vector<std::size_t> in_bits() {
    for (auto i = static_cast<std::uint32_t>(graph_.size()); i-- > first_;) read_operands({i});
    std::vector<std::size_t> variables;
    for (const auto& [variable, reads] : of_choices_) {
      if (reads.in_bits >= reads.in_order) variables.push_back(variable);
    }
    return variables;
  }

 private:
  struct Reads {
    std::uint32_t in_bits = 0;
    std::uint32_t in_order = 0;
  };

  static bool is_wide(OrderSize size) { return size.most > tuning::kMostAlwaysOrdered; }

  void read_operands(NodeId id) {
    const Graph::Node& node = graph_.node(id);
    if (node.args().empty()) return note_choice(id);
    if (node.type() == Type::kInt) {
      const Reads reads = reads_[id.index - first_];
      for (const NodeId operand : node.args()) {
        if (reads.in_bits != 0) read(operand, &Reads::in_bits);
        if (reads.in_order != 0) read(operand, &Reads::in_order);
      }
    } else if (graph_.node(node.operands[0]).type() == Type::kInt) {
      compare(node.operands[0], node.operands[1]);
    }
  }

  void compare(NodeId a, NodeId b) {
    if (const auto form = ordered_difference_form(graph_, a, b, size_)) {
      for (const auto& [term, factor] : form->terms) read(term, &Reads::in_order);
      return;
    }
    const bool by_order = size_(a).is_ordered() && size_(b).is_ordered();
    for (const NodeId operand : {a, b}) read(operand, by_order ? &Reads::in_order : &Reads::in_bits);
  }

  void read(NodeId node, std::uint32_t Reads::*way) {
    if (node.index >= first_) ++(reads_[node.index - first_].*way);
  }

  void note_choice(NodeId id) {
    if (graph_.node(id).op != Op::kChoice || !is_wide(size_(id))) return;
    Reads& reads = of_choices_[graph_.node(id).payload];
    reads.in_bits += reads_[id.index - first_].in_bits;
    reads.in_order += reads_[id.index - first_].in_order;
  }

  const Graph& graph_;
  std::uint32_t first_;
  const std::function<OrderSize(NodeId)>& size_;
  std::vector<Reads> reads_;                 // by node, from `first_` on
  std::map<std::size_t, Reads> of_choices_;  // of those with many values, by variable
};

bool has_wide_choice(const Graph& graph, std::uint32_t first, const std::function<OrderSize(NodeId)>& size) {
  for (std::uint32_t i = first; i < graph.size(); ++i) {
    if (graph.node({i}).op == Op::kChoice && size({i}).most > tuning::kMostAlwaysOrdered) return true;
  }
  return false;
}

}  // namespace

std::vector<std::size_t> wide_choices_in_bits(const Graph& graph, std::uint32_t first,
                                              const std::function<OrderSize(NodeId)>& size) {
  if (!has_wide_choice(graph, first, size)) return {};
  return Uses(graph, first, size).in_bits();
}

}  // namespace solitaire
