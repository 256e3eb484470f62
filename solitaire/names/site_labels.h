#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/name_table.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// Labels the sites of one function, so that those that can happen in the same execution differ: a name's
/// second use is "name#2". Exclusive branches start from the same counts, so that their sites share labels;
/// behind them the larger counts hold.
class SiteLabels {
 public:
  explicit SiteLabels(NameTable& labels) : labels_(labels) {}

  /// Labels a call or choice after its name and how often the name came before.
  void count(Site& site, const std::string& name);
  /// Leaves a call without a label, so that what happens in the called function has the address of this one;
  /// `names` are those of the sites there. Returns false, and does nothing, where a site that comes before it
  /// has one of these names, or no label either.
  bool leave_out(Site& site, const std::set<std::string>& names);
  /// Labels a branch after its kind and place, which no other branch of the function has.
  void at_place(Site& site, const std::string& kind, const std::string& place);
  /// Returns the names of all calls and choices, and of those in calls that were left out.
  const std::set<std::string>& names() const { return names_; }

  /// Runs two exclusive parts, which return true if they always return from the function. A part that does
  /// has no say in the counts behind it.
  template <class Then, class Else>
  void exclusive(Then then_part, Else else_part) {
    const Counts before = counts_;
    const bool then_returns = then_part();
    Counts after_then = std::move(counts_);
    counts_ = before;
    const bool else_returns = else_part();
    if (then_returns) return;
    counts_ = else_returns ? std::move(after_then) : larger(after_then, counts_);
  }

  /// Sets Site::shared; all sites have to be labelled.
  void mark_shared() const;

 private:
  using Counts = std::map<std::string, int>;

  static Counts larger(const Counts& a, const Counts& b);

  NameTable& labels_;
  Counts counts_;
  std::set<std::string> names_;
  std::vector<Site*> sites_;
};

}  // namespace solitaire
