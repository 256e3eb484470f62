#include "kernel/normal_block.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace solitaire {
namespace {

/// To draw so many together takes about as long as to draw each by itself; of more it takes longer.
/// Judgement.
constexpr std::size_t kMostTogether = 16;

/// A set of candidates, a bit for each.
using Set = std::uint32_t;
Set only(std::size_t candidate) { return Set{1} << candidate; }

/// The floats with a normal form, and how their forms depend on each other.
class Candidates {
 public:
  Candidates(Graph& graph, const Trace& trace, const std::vector<KnownForm>& forms) : graph_(graph) {
    for (std::size_t i = 0; i < forms.size(); ++i) {
      if (forms[i].form != Form::kNormal || !forms[i].required.empty()) continue;
      choices_.push_back(i);
      all_.push_back({trace.choices[i].variable, forms[i].numbers[0], forms[i].numbers[1]});
    }
    if (all_.size() > kMostTogether) all_.clear();
    find_slopes();
    find_dependencies();
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (fits(block_ | only(i))) block_ |= only(i);
  }

  NormalBlock block() const {
    NormalBlock made;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (!has(block_, i)) continue;
      made.choices.push_back(choices_[i]);
      for (std::size_t j = 0; j < i; ++j)
        if (has(block_, j)) made.mixed.push_back(*slopes_[i][j]);
    }
    return made;
  }

 private:
  struct Candidate {
    NodeId variable, linear, square;  // the choice, and the numbers of its form
  };

  static bool has(Set set, std::size_t candidate) { return (set & only(candidate)) != 0; }

  /// The second derivative along two floats is the slope along the one of what is linear in the other.
  void find_slopes() {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      slopes_.emplace_back();
      for (std::size_t j = 0; j < i; ++j) slopes_[i].push_back(slope(all_[i].linear, all_[j].variable));
    }
  }
  std::optional<NodeId> slope(NodeId of, NodeId along) {
    const Reach reach{between(along, of), {of}, {}};
    if (reach.nodes.empty()) return graph_.constant(0.0);
    return slope_of_line(graph_, along, reach);
  }
  /// What of a node depends on a choice, from the choice to the node; nothing where it does not.
  std::vector<std::uint32_t> between(NodeId choice, NodeId of) const {
    if (of.index < choice.index) return {};
    std::vector<bool> depends(of.index - choice.index + 1, false), read(depends.size(), false);
    const auto depend = [&](NodeId node) {
      return node.index >= choice.index && depends[node.index - choice.index];
    };
    depends[0] = true;
    for (std::uint32_t i = choice.index + 1; i <= of.index; ++i) {
      const auto& args = graph_.node({i}).args();
      depends[i - choice.index] = std::any_of(args.begin(), args.end(), depend);
    }
    read.back() = depends.back();
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = of.index + 1; i-- > choice.index;) {
      if (!read[i - choice.index]) continue;
      found.push_back(i);
      for (const NodeId operand : graph_.node({i}).args())
        if (depend(operand)) read[operand.index - choice.index] = true;
    }
    std::reverse(found.begin(), found.end());
    return found;
  }

  void find_dependencies() {
    depends_on_.assign(graph_.size(), 0);
    for (std::size_t i = 0; i < all_.size(); ++i) depends_on_[all_[i].variable.index] = only(i);
    for (std::uint32_t i = 0; i < graph_.size(); ++i)
      for (const NodeId operand : graph_.node({i}).args()) depends_on_[i] |= depends_on_[operand.index];
  }

  bool fits(Set block) const {
    const auto is_fixed = [&](NodeId node) { return (depends_on_[node.index] & block) == 0; };
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (!has(block, i)) continue;
      if (!is_fixed(all_[i].square)) return false;
      for (std::size_t j = 0; j < i; ++j)
        if (has(block, j) && (!slopes_[i][j] || !is_fixed(*slopes_[i][j]))) return false;
    }
    return true;
  }

  Graph& graph_;
  std::vector<std::size_t> choices_;
  std::vector<Candidate> all_;
  std::vector<std::vector<std::optional<NodeId>>> slopes_;  // of each, those along the ones before it
  std::vector<Set> depends_on_;                             // of the graph's nodes
  Set block_ = 0;
};

}  // namespace

NormalBlock normal_block(Graph& graph, const Trace& trace, const std::vector<KnownForm>& forms) {
  return Candidates(graph, trace, forms).block();
}

}  // namespace solitaire
