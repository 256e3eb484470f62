#include "kernel/combination.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <unordered_map>

namespace solitaire {
namespace {

using Factors = Combination::Factors;
using Part = Combination::Part;

/// A node that is a longer sum, or one of so many operations, counts as a whole.
constexpr std::size_t kMostParts = 16;
constexpr int kMostOperationsRead = 64;
/// A combination is kept apart up to so many parts.
constexpr std::size_t kMostPartsApart = 64;

std::size_t count(const Factors& factors) {
  return static_cast<std::size_t>(
      std::count_if(factors.begin(), factors.end(), [](auto each) { return each != 0; }));
}

std::optional<Factors> joined(const Factors& a, const Factors& b) {
  if (count(a) + count(b) > a.size()) return std::nullopt;
  Factors made = a;
  std::copy(b.end() - static_cast<std::ptrdiff_t>(count(b)), b.end(), made.begin());
  std::sort(made.begin(), made.end());
  return made;
}

/// Takes a node apart into the parts of a sum.
class SumReader {
 public:
  explicit SumReader(const Graph& graph) : graph_(graph) {}

  void read(NodeId id, double times, Combination& sum) {
    const Graph::Node& node = graph_.node(id);
    const auto [a, b, c] = node.operands;
    if (node.is_constant()) return sum.add_number(times * graph_.scalar(id).f);
    if (++operations_ > kMostOperationsRead) return add_whole(id, times, sum);
    switch (node.op) {
      case Op::kAddFloat:
        read(a, times, sum);
        return read(b, times, sum);
      case Op::kSubFloat:
        read(a, times, sum);
        return read(b, -times, sum);
      case Op::kNegFloat:
        return read(a, -times, sum);
      case Op::kMulFloat:
        return read_product(id, times, sum);
      case Op::kDivFloat:
        if (graph_.node(b).is_constant()) return read(a, times / graph_.scalar(b).f, sum);
        break;
      default:
        break;
    }
    add_whole(id, times, sum);
  }

 private:
  static void add_whole(NodeId id, double times, Combination& sum) {
    sum.add_part({{0, 0, 0, id.index}, times});
  }

  void read_product(NodeId id, double times, Combination& sum) {
    const auto [a, b, c] = graph_.node(id).operands;
    if (graph_.node(a).is_constant()) return read(b, times * graph_.scalar(a).f, sum);
    if (graph_.node(b).is_constant()) return read(a, times * graph_.scalar(b).f, sum);
    Combination first, second;
    read(a, 1, first);
    read(b, 1, second);
    first.settle();
    second.settle();
    const bool are_products = first.parts().size() == 1 && second.parts().size() == 1 &&
                              first.number() == 0 && second.number() == 0;
    if (!are_products) return add_whole(id, times, sum);
    const Part &x = first.parts()[0], &y = second.parts()[0];
    const std::optional<Factors> factors = joined(x.factors, y.factors);
    if (!factors) return add_whole(id, times, sum);
    sum.add_part({*factors, times * x.times * y.times});
  }

  const Graph& graph_;
  int operations_ = 0;
};

/// Writes sums of products as nodes.
class SumWriter {
 public:
  explicit SumWriter(Graph& graph) : graph_(graph) {}

  /// What many parts have in common is multiplied once.
  NodeId sum(std::vector<Part> parts, double number) {
    if (parts.empty()) return graph_.constant(number);
    if (const std::uint32_t factor = frequent_factor(parts)) return factored(factor, parts, number);
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.times < b.times; });
    std::vector<std::span<const Part>> alike;
    for (std::size_t i = 0, end = 0; i < parts.size(); i = end) {
      for (end = i; end < parts.size() && parts[end].times == parts[i].times;) ++end;
      alike.push_back({parts.data() + i, end - i});
    }
    const NodeId made = tree(0, alike.size(), [&](std::size_t i) { return multiple(alike[i]); });
    return number == 0 ? made : graph_.apply(Op::kAddFloat, {made, graph_.constant(number)});
  }

 private:
  /// Short chains of additions, since each addition waits for the one before it.
  template <class Leaf>
  NodeId tree(std::size_t first, std::size_t end, Leaf leaf) {
    if (end - first == 1) return leaf(first);
    const std::size_t middle = first + (end - first) / 2;
    const NodeId left = tree(first, middle, leaf);
    const NodeId right = tree(middle, end, leaf);
    return graph_.apply(Op::kAddFloat, {left, right});
  }

  NodeId product(const Factors& factors) {
    std::optional<NodeId> made;
    for (const std::uint32_t factor : factors) {
      if (factor == 0) continue;
      made = made ? graph_.apply(Op::kMulFloat, {*made, NodeId{factor}}) : NodeId{factor};
    }
    return made ? *made : graph_.constant(1.0);
  }
  NodeId multiple(std::span<const Part> alike) {
    const NodeId made = tree(0, alike.size(), [&](std::size_t i) { return product(alike[i].factors); });
    return alike[0].times == 1 ? made : graph_.apply(Op::kMulFloat, {made, graph_.constant(alike[0].times)});
  }

  /// A factor that at least a quarter of the parts have, and two of them; 0 if there is none.
  static std::uint32_t frequent_factor(const std::vector<Part>& parts) {
    if (parts.size() < 2) return 0;
    std::unordered_map<std::uint32_t, std::size_t> counts;
    std::uint32_t best = 0;
    std::size_t most = std::max<std::size_t>(2, parts.size() / 4) - 1;
    for (const Part& part : parts) {
      std::uint32_t last = 0;
      for (const std::uint32_t factor : part.factors) {
        if (factor != 0 && factor != last && ++counts[factor] > most) {
          most = counts[factor];
          best = factor;
        }
        last = factor;
      }
    }
    return best;
  }

  NodeId factored(std::uint32_t factor, const std::vector<Part>& parts, double number) {
    std::vector<Part> with, rest;
    double with_alone = 0;
    for (Part part : parts) {
      const auto found = std::find(part.factors.begin(), part.factors.end(), factor);
      if (found == part.factors.end()) {
        rest.push_back(part);
        continue;
      }
      *found = 0;
      std::sort(part.factors.begin(), part.factors.end());
      if (count(part.factors) == 0) {
        with_alone += part.times;
      } else {
        with.push_back(part);
      }
    }
    const NodeId made = graph_.apply(Op::kMulFloat, {NodeId{factor}, sum(std::move(with), with_alone)});
    if (rest.empty() && number == 0) return made;
    return graph_.apply(Op::kAddFloat, {made, sum(std::move(rest), number)});
  }

  Graph& graph_;
};

}  // namespace

Combination::Combination(const Graph& graph, NodeId node) {
  SumReader(graph).read(node, 1, *this);
  settle();
  if (parts_.size() > kMostParts) *this = atom(node);
  whole_ = node;
}

Combination Combination::atom(NodeId node) {
  Combination made;
  made.parts_.push_back({{0, 0, 0, node.index}, 1});
  made.whole_ = node;
  return made;
}

bool Combination::is_finite() const {
  return std::isfinite(number_) && std::all_of(parts_.begin(), parts_.end(),
                                               [](const Part& part) { return std::isfinite(part.times); });
}

void Combination::add(const Combination& more, double factor) {
  whole_.reset();
  if (factor == 0) return;
  number_ += factor * more.number_;
  for (const Part& part : more.parts_) parts_.push_back({part.factors, factor * part.times});
}

void Combination::add_number(double more) {
  whole_.reset();
  number_ += more;
}

void Combination::add_part(const Part& more) {
  whole_.reset();
  parts_.push_back(more);
}

void Combination::settle() {
  std::stable_sort(parts_.begin(), parts_.end(),
                   [](const Part& a, const Part& b) { return a.factors < b.factors; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < parts_.size();) {
    Part sum = parts_[i++];
    while (i < parts_.size() && parts_[i].factors == sum.factors) sum.times += parts_[i++].times;
    if (sum.times != 0) parts_[kept++] = sum;
  }
  parts_.resize(kept);
}

NodeId Combination::node(Graph& graph) const {
  return whole_ ? *whole_ : SumWriter(graph).sum(parts_, number_);
}

void Combination::bound(Graph& graph) {
  if (parts_.size() > kMostPartsApart) *this = atom(node(graph));
}

/// Nothing where some product would have too many factors.
std::optional<Combination> Combination::times(const Part& factor) const {
  Combination made;
  if (number_ != 0) made.parts_.push_back({factor.factors, factor.times * number_});
  for (const Part& part : parts_) {
    const std::optional<Factors> factors = joined(part.factors, factor.factors);
    if (!factors) return std::nullopt;
    made.parts_.push_back({*factors, part.times * factor.times});
  }
  made.settle();
  return made;
}

Combination Combination::product(Graph& graph, const Combination& a, const Combination& b) {
  Combination made;
  if (a.is_number() || b.is_number()) {
    if (a.is_number() && a.number() == 1) return b;
    if (b.is_number() && b.number() == 1) return a;
    made.add(a.is_number() ? b : a, a.is_number() ? a.number() : b.number());
    return made;
  }
  if (a.is_one_part())
    if (const auto found = b.times(a.parts_[0])) return *found;
  if (b.is_one_part())
    if (const auto found = a.times(b.parts_[0])) return *found;
  made.add_part({*joined({0, 0, 0, a.node(graph).index}, {0, 0, 0, b.node(graph).index}), 1});
  return made;
}

}  // namespace solitaire
