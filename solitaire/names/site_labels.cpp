#include "solitaire/names/site_labels.h"

#include <algorithm>
#include <fmt/format.h>

namespace solitaire {

void SiteLabels::count(Site& site, const std::string& name) {
  const int count = ++counts_[name];
  names_.insert(name);
  site.label = labels_.number(count == 1 ? name : fmt::format("{}#{}", name, count));
  sites_.push_back(&site);
}

bool SiteLabels::leave_out(Site& site, const std::set<std::string>& names) {
  const auto is_counted = [this](const std::string& name) { return counts_.contains(name); };
  if (is_counted("") || std::ranges::any_of(names, is_counted)) return false;
  counts_[""] = 1;
  names_.insert(names.begin(), names.end());
  site.label = kNoLabel;
  sites_.push_back(&site);
  return true;
}

void SiteLabels::at_place(Site& site, const std::string& kind, const std::string& place) {
  site.label = labels_.number(kind + '@' + place);
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
