#pragma once
#include <vector>

#include "engines/tiles/model/global_rule.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// All tiles that are passable form one network: every one of them can be reached from every other one. Two
/// neighbours are linked if each is open towards the other. A map without such tiles keeps the rule.
class Connected : public GlobalRule {
 public:
  /// `open` has the open sides of each tile; 0 for those that are not passable.
  Connected(const Topology& topology, std::vector<Sides> open, std::string text)
      : topology_(topology), open_(std::move(open)), text_(std::move(text)) {}

  /// Returns how many components there are too many.
  std::uint64_t violation(const Grid& map) const override;
  std::string text() const override { return text_; }

 private:
  Topology topology_;
  std::vector<Sides> open_;
  std::string text_;
};

}  // namespace solitaire::tiles
