#pragma once
#include <string>
#include <string_view>

#include "scene/color.h"
#include "scene/geometry.h"

namespace solitaire {

/// A point of a drawing, or in metres of the plane that is drawn.
struct Point {
  double x = 0, y = 0;
};

struct Area {
  Point low{Box3::kInfinity, Box3::kInfinity}, high{-Box3::kInfinity, -Box3::kInfinity};

  void include(const Point& point);
  void include(const Area& other);
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  bool overlaps(const Area& other) const;
  bool contains(const Area& other) const;
};

/// Returns the area along the axes that a turned rectangle around `center` takes up.
Area area_of(const Point& center, double width, double height, double degrees = 0);

/// Maps metres, with y upward, to the units of a drawing, in which y runs downward and whose longer side is
/// 400 units. Sizes of text are measured in these units.
class Paper {
 public:
  explicit Paper(const Area& metres);

  double scale() const { return scale_; }
  Point size() const { return size_; }
  Point place(const Point& metres) const;
  Area place(const Area& metres) const;

  /// Returns the <svg> element around a drawing, with a viewBox and no size of its own, and with a scale bar
  /// in metres below. `label` says what it is, `left` is room to its left.
  std::string svg(std::string_view label, std::string_view content, double left = 0) const;

 private:
  std::string scale_bar() const;

  Area metres_;
  double scale_ = 1;
  Point size_;
};

/// Returns the number to two digits after the point.
std::string number(double value);

/// Returns a length for people: "2 m", "75 cm".
std::string length_text(double metres);

/// Returns the largest length of at most `most` metres that is 1, 2 or 5 times a power of ten.
double round_length(double most);

/// Returns the colour in which text and marks are seen on the fill.
Color ink_on(const Color& fill);

/// Returns the colour of the edges of what is filled so.
Color edge_of(const Color& fill);

}  // namespace solitaire
