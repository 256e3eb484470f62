#include "solitaire/names/site_labels.h"

#include <algorithm>
#include <fmt/format.h>

namespace solitaire {

void SiteLabels::count(Site& site, const std::string& name) {
  const int count = ++counts_[name];
  site.label = labels_.number(count == 1 ? name : fmt::format("{}#{}", name, count));
  sites_.push_back(&site);
}

void SiteLabels::at_place(Site& site, const std::string& kind, Position place) {
  site.label = labels_.number(fmt::format("{}@{}:{}", kind, place.line, place.column));
}

void SiteLabels::mark_shared() const {
  std::map<LabelId, int> uses;
  for (const Site* site : sites_) ++uses[site->label];
  for (Site* site : sites_) site->shared = uses[site->label] > 1;
}

SiteLabels::Counts SiteLabels::larger(const Counts& a, const Counts& b) {
  Counts result = a;
  for (const auto& [name, count] : b) result[name] = std::max(result[name], count);
  return result;
}

}  // namespace solitaire
