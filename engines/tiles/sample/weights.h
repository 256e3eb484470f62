#pragma once
#include <map>
#include <vector>

#include "engines/tiles/model/style.h"

namespace solitaire::tiles {

/// The soft factors of a style as multipliers, each raised to the same power: 0 switches all of them off, 1
/// is the style's own distribution, between them lies annealing.
class Weights {
 public:
  explicit Weights(const Style& style, double power = 1);

  void set_power(double power);
  /// Returns the multipliers of a shape by the patch's number, where the patch lies in these zones. They stay
  /// where they are, and change with the power.
  const std::vector<double>& of(std::size_t shape, ZoneSet zones);

 private:
  struct Table {
    ZoneSet zones;
    std::vector<double> multipliers;
  };

  void fill(std::size_t shape, Table& table) const;

  const Style* style_;
  double power_;
  std::vector<std::map<ZoneSet, Table>> tables_;  // by shape
};

}  // namespace solitaire::tiles
