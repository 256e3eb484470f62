#include "engines/tiles/model/global_rule.h"

namespace solitaire::tiles {
namespace {

/// Looks at the whole map each time.
class WholeMapWatch : public RuleWatch {
 public:
  explicit WholeMapWatch(const GlobalRule& rule) : rule_(rule) {}
  std::uint64_t after(const Grid& map, const Change& /*change*/) override { return rule_.violation(map); }
  void keep() override {}

 private:
  const GlobalRule& rule_;
};

}  // namespace

std::unique_ptr<RuleWatch> GlobalRule::watch(const Grid& /*map*/) const {
  return std::make_unique<WholeMapWatch>(*this);
}

}  // namespace solitaire::tiles
