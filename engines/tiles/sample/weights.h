#pragma once
#include <map>
#include <vector>

#include "engines/tiles/model/style.h"
#include "engines/tiles/sample/factor_rows.h"

namespace solitaire::tiles {

/// The soft factors of a style as multipliers, each raised to the same power: 0 switches all of them off, 1
/// is the style's own distribution, between them lies annealing.
class Weights {
 public:
  explicit Weights(const Style& style, double power = 1);
  Weights(const Weights&) = delete;
  Weights& operator=(const Weights&) = delete;

  void set_power(double power);
  /// Returns the multipliers of a shape's patches that lie in these zones, by the tile at one of its places.
  /// They stay where they are, and change with the power.
  FactorRows& rows(std::size_t shape, ZoneSet zones, std::size_t place) {
    if (zones != last_zones_[shape] || last_[shape] == nullptr) find(shape, zones);
    return last_[shape]->rows[place];
  }

 private:
  struct Table {
    std::vector<double> multipliers;  // by the patch's number
    std::vector<FactorRows> rows;     // by place of the shape
  };

  void find(std::size_t shape, ZoneSet zones);
  void fill(std::size_t shape, ZoneSet zones, Table& table) const;

  const Style* style_;
  double power_;
  std::vector<std::map<ZoneSet, Table>> tables_;  // by shape
  std::vector<ZoneSet> last_zones_;               // by shape: those that were asked for last
  std::vector<Table*> last_;                      // and their table
};

}  // namespace solitaire::tiles
