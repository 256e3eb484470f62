#include "engines/tiles/model/problem.h"

#include <fmt/format.h>
#include <stdexcept>

namespace solitaire::tiles {
namespace {

Topology checked(const Topology& topology) {
  std::size_t sites = 1;
  for (const int extent : topology.size.extent) {
    if (extent < 1 || sites > kMostSites / static_cast<std::size_t>(extent)) {
      throw std::length_error(fmt::format("a map has 1 to {} sites", kMostSites));
    }
    sites *= static_cast<std::size_t>(extent);
  }
  return topology;
}

std::vector<PairRules> rules_across_zones(const Style& style) {
  std::vector<PairRules> across;
  if (style.zones == 1) return across;
  for (std::size_t a = 0; a < style.zones; ++a) {
    for (std::size_t b = 0; b < style.zones; ++b) {
      across.push_back(style.pairs[a]);
      across.back().unite(style.pairs[b]);
    }
  }
  return across;
}

}  // namespace

Problem::Problem(std::shared_ptr<const Style> style, const Topology& topology)
    : style_(std::move(style)),
      topology_(checked(topology)),
      domains_(topology.size.volume(), TileMask::first(style_->tileset.size())),
      across_(rules_across_zones(*style_)) {}

void Problem::add(SiteRule rule) {
  for (const std::uint32_t site : rule.sites) domains_[site] &= rule.allowed;
  site_rules_.push_back(std::move(rule));
}

Problem Problem::without_soft_factors() const {
  auto style = std::make_shared<Style>(*style_);
  style->shapes.clear();
  Problem result = *this;
  result.style_ = std::move(style);
  return result;
}

Problem Problem::without_site_rules() const {
  Problem result = *this;
  result.site_rules_.clear();
  result.domains_.assign(sites(), TileMask::first(style_->tileset.size()));
  return result;
}

std::uint64_t Problem::violation(const Grid& map) const {
  std::uint64_t sum = 0;
  for (const auto& rule : global_rules_) sum += rule->violation(map);
  return sum;
}

}  // namespace solitaire::tiles
