#pragma once
#include <memory>
#include <string>
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// A rule about single sites, in the words of whoever made it: "(3,4) is pinned to crossroad".
struct SiteRule {
  std::string text;
  std::vector<std::uint32_t> sites;
  TileMask allowed;
};

/// A map that is wanted: which places it has, and what holds at each.
class Problem {
 public:
  /// Throws std::length_error if there are more than kMostSites sites.
  Problem(std::shared_ptr<const Style> style, const Topology& topology);

  const Style& style() const { return *style_; }
  const std::shared_ptr<const Style>& shared_style() const { return style_; }
  const Topology& topology() const { return topology_; }
  const Size& size() const { return topology_.size; }
  std::size_t sites() const { return domains_.size(); }
  /// Returns the tiles that the rules about single sites leave to a site.
  const TileMask& domain(std::size_t site) const { return domains_[site]; }
  std::size_t zone(std::size_t site) const { return zones_.empty() ? 0 : zones_[site]; }

  void add(SiteRule rule);
  void add(std::shared_ptr<const GlobalRule> rule) { global_rules_.push_back(std::move(rule)); }
  /// Gives each site a zone, below the style's number of zones.
  void set_zones(std::vector<std::uint8_t> zones) { zones_ = std::move(zones); }
  const std::vector<SiteRule>& site_rules() const { return site_rules_; }
  const std::vector<std::shared_ptr<const GlobalRule>>& global_rules() const { return global_rules_; }
  /// Returns the same problem for maps that are all worth the same.
  Problem without_soft_factors() const;
  /// Returns the same problem without its rules about single sites.
  Problem without_site_rules() const;
  /// Returns the sum of what the global rules find wrong with a map.
  std::uint64_t violation(const Grid& map) const;

  /// Returns whether two tiles may be beside each other: `b` at the site after that of `a` along the axis.
  bool allowed(std::size_t axis, std::size_t site_a, Tile a, std::size_t site_b, Tile b) const {
    const std::size_t zone_a = zone(site_a), zone_b = zone(site_b);
    return style_->pairs[zone_a].allowed(axis, a, b) ||
           (zone_a != zone_b && style_->pairs[zone_b].allowed(axis, a, b));
  }
  /// Returns the rules of pairs between sites of two zones.
  const PairRules& pairs(std::size_t zone_a, std::size_t zone_b) const {
    return zone_a == zone_b ? style_->pairs[zone_a] : across_[zone_a * style_->zones + zone_b];
  }

 private:
  std::shared_ptr<const Style> style_;
  Topology topology_;
  std::vector<TileMask> domains_;
  std::vector<std::uint8_t> zones_;  // by site; empty: all are of zone 0
  std::vector<PairRules> across_;    // by two zones, where there are several
  std::vector<SiteRule> site_rules_;
  std::vector<std::shared_ptr<const GlobalRule>> global_rules_;
};

}  // namespace solitaire::tiles
