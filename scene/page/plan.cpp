#include "scene/page/plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/text.h"

namespace solitaire {
namespace {

constexpr double kLongSide = 400;  // of the drawing, in its own units, which text sizes are measured in
constexpr double kMargin = 8;
constexpr double kBarHeight = 26;
constexpr double kLeastText = 6.5;
constexpr double kMostText = 14;

struct Point {
  double x, y;
};

struct Area {
  Point low, high;

  bool overlaps(const Area& other) const {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }
};

/// Returns the area along the axes that a turned rectangle around `center` takes up.
Area area_of(Point center, double width, double depth, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
  const double x = (c * width + s * depth) / 2, y = (s * width + c * depth) / 2;
  return {{center.x - x, center.y - y}, {center.x + x, center.y + y}};
}

/// Maps metres of the program to the drawing's units, in which y runs downward.
class Paper {
 public:
  explicit Paper(const Scene& scene) {
    for (const auto& object : scene.objects) include(object.box);
    const double width = high_.x - low_.x, depth = high_.y - low_.y;
    scale_ = kLongSide / std::max({width, depth, 1e-9});
    size_ = {std::max(width * scale_, 1.0), std::max(depth * scale_, 1.0)};
  }

  double scale() const { return scale_; }
  Point size() const { return size_; }
  Point place(Point metres) const { return {(metres.x - low_.x) * scale_, (high_.y - metres.y) * scale_}; }

 private:
  void include(const PlacedBox& box) {
    const Box3 area = bounds(box);
    low_ = {std::min(low_.x, area.low[0]), std::min(low_.y, area.low[1])};
    high_ = {std::max(high_.x, area.high[0]), std::max(high_.y, area.high[1])};
  }

  Point low_{Box3::kInfinity, Box3::kInfinity};
  Point high_{-Box3::kInfinity, -Box3::kInfinity};
  double scale_ = 1;
  Point size_{};
};

std::string number(double value) { return fmt::format("{}", rounded(value, 2)); }

Color ink_on(const Color& fill) { return luminance(fill) > 0.3 ? Color{0.08, 0.09, 0.11} : Color{1, 1, 1}; }

/// Draws one object: its shape in a frame of its own, with the centre at the origin and the front downward,
/// which is then turned as a whole.
class ObjectDrawing {
 public:
  ObjectDrawing(const SceneObject& object, const std::string& unique_name, const Paper& paper)
      : object_(object),
        unique_name_(unique_name),
        name_(plain_name(object)),
        center_(paper.place({object.box.center[0], object.box.center[1]})),
        width_(object.box.size[0] * paper.scale()),
        depth_(object.box.size[1] * paper.scale()) {}

  Area area() const { return area_of(center_, width_, depth_, object_.box.angle); }

  /// Returns the drawing. What lies `above` is drawn later and would hide a label below it.
  std::string svg(std::span<const Area> above) const {
    return fmt::format("<g data-address=\"{1}\"><title>{0}\n{1}</title><g{2}>{3}{4}</g>{5}</g>\n",
                       escape_markup(unique_name_), escape_markup(object_.thing.address),
                       moved(center_, object_.box.angle), rectangle(), front_mark(), label(above));
  }

 private:
  struct Line {
    double degrees;  // counter-clockwise, more than -90 and up to 90: never upside down
    double font_size;
  };

  static std::string moved(Point to, double degrees) {
    const double turn = rounded(-std::remainder(degrees, 360.0), 3);
    const std::string place = fmt::format("translate({} {})", number(to.x), number(to.y));
    return turn == 0 ? fmt::format(" transform=\"{}\"", place)
                     : fmt::format(" transform=\"{} rotate({})\"", place, turn);
  }

  std::string rectangle() const {
    const Color edge = mixed(object_.color, {0, 0, 0}, 0.45);
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\"/>",
                       number(-width_ / 2), number(-depth_ / 2), number(width_), number(depth_),
                       hex(object_.color), hex(edge));
  }

  /// Returns how far the mark reaches in from the front edge, or 0 for an object without a front.
  double mark_depth() const {
    const bool has_front = object_.asset && object_.asset->has_front;
    return has_front ? std::min({width_ / 4, depth_ / 4, 6.0}) : 0;
  }

  std::string front_mark() const {
    const double depth = mark_depth();
    if (depth == 0) return "";
    return fmt::format("<path d=\"M{} {}h{}l{} {}z\" fill=\"{}\" opacity=\".6\"/>", number(-depth),
                       number(depth_ / 2 - depth), number(2 * depth), number(-depth), number(depth),
                       hex(ink_on(object_.color)));
  }

  Line line_along(double degrees, double length, double thickness) const {
    double reading = std::remainder(degrees, 180.0);
    if (reading <= -89.999) reading += 180;
    return {reading, std::min({0.92 * length / text_width(name_), 0.8 * thickness, kMostText})};
  }

  /// Returns the line along the side that is nearer to level, unless the other side leaves much more room.
  Line best_line() const {
    const double free_depth = depth_ - 2 * mark_depth();
    Line line = line_along(object_.box.angle, width_, free_depth);
    Line other = line_along(object_.box.angle + 90, free_depth, width_);
    if (std::abs(other.degrees) < std::abs(line.degrees)) std::swap(line, other);
    return other.font_size > 1.3 * line.font_size ? other : line;
  }

  /// Returns the label in the middle or, if something hides that and the text is level, in a free corner.
  /// Returns "" where it would not be legible.
  std::string label(std::span<const Area> above) const {
    if (name_.empty()) return "";
    const Line line = best_line();
    if (line.font_size < kLeastText) return "";
    const double length = text_width(name_) * line.font_size;
    for (const Point& center : label_places(line, length)) {
      const Area area = area_of(center, length, line.font_size, line.degrees);
      if (std::any_of(above.begin(), above.end(), [&](const Area& each) { return each.overlaps(area); }))
        continue;
      return fmt::format("<text{} font-size=\"{}\" fill=\"{}\">{}</text>", moved(center, line.degrees),
                         number(std::floor(line.font_size * 10) / 10), hex(ink_on(object_.color)),
                         escape_markup(name_));
    }
    return "";
  }

  std::vector<Point> label_places(const Line& line, double length) const {
    std::vector<Point> places = {center_};
    if (std::abs(line.degrees) > 0.001) return places;
    const Area all = area();
    const double x = 0.3 * line.font_size + length / 2, y = 0.8 * line.font_size;
    for (const double at_y : {all.low.y + y, all.high.y - y}) {
      for (const double at_x : {all.low.x + x, all.high.x - x}) places.push_back({at_x, at_y});
    }
    return places;
  }

  const SceneObject& object_;
  const std::string& unique_name_;
  std::string name_;
  Point center_;
  double width_, depth_;
};

/// Returns the longest length that takes at most 30 % of the drawing and is 1, 2 or 5 times a power of ten.
double bar_metres(const Paper& paper) {
  const double most = 0.3 * std::max(paper.size().x, kLongSide / 3) / paper.scale();
  const double ten = std::pow(10, std::floor(std::log10(most)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * ten <= most) return digit * ten;
  }
  return ten;
}

std::string length_text(double metres) {
  if (metres >= 1000) return fmt::format("{:g} km", metres / 1000);
  if (metres >= 1) return fmt::format("{:g} m", metres);
  return metres >= 0.01 ? fmt::format("{:g} cm", metres * 100) : fmt::format("{:g} mm", metres * 1000);
}

std::string scale_bar(const Paper& paper) {
  const double metres = bar_metres(paper);
  const double y = paper.size().y + kMargin + 8;
  return fmt::format(
      "<path d=\"M.5 {}v6h{}v-6\" fill=\"none\" stroke=\"currentColor\"/>"
      "<text x=\"{}\" y=\"{}\" font-size=\"11\" fill=\"currentColor\" text-anchor=\"start\">{}</text>\n",
      number(y - 3), number(metres * paper.scale()), number(metres * paper.scale() + 6), number(y),
      length_text(metres));
}

double ground_taken(const PlacedBox& box) { return box.size[0] * box.size[1]; }

struct NamedObject {
  const SceneObject* object;
  const std::string* name;
};

/// Returns the objects in the order of drawing: floors first, then what stands in or on them.
std::vector<NamedObject> bottom_up(const Scene& scene) {
  std::vector<NamedObject> order;
  for (const SceneNode& node : scene.nodes) {
    if (node.object) order.push_back({&scene.objects[*node.object], &node.name});
  }
  std::stable_sort(order.begin(), order.end(), [](const NamedObject& a, const NamedObject& b) {
    const PlacedBox &first = a.object->box, &second = b.object->box;
    if (first.center[2] != second.center[2]) return first.center[2] < second.center[2];
    return ground_taken(first) > ground_taken(second);
  });
  return order;
}

}  // namespace

std::string svg_plan(const Scene& scene) {
  if (scene.objects.empty()) return "";
  const Paper paper(scene);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" role=\"img\" aria-label=\"Plan of "
      "{}: {} "
      "objects\" font-family=\"system-ui,sans-serif\" text-anchor=\"middle\" "
      "dominant-baseline=\"central\">\n",
      number(-kMargin), number(-kMargin), number(std::max(paper.size().x, kLongSide / 3) + 2 * kMargin),
      number(paper.size().y + 2 * kMargin + kBarHeight - kMargin), escape_markup(scene.title),
      scene.objects.size());
  std::vector<ObjectDrawing> drawings;
  for (const NamedObject& each : bottom_up(scene)) drawings.emplace_back(*each.object, *each.name, paper);
  std::vector<Area> areas;
  for (const ObjectDrawing& drawing : drawings) areas.push_back(drawing.area());
  for (std::size_t i = 0; i < drawings.size(); ++i) svg += drawings[i].svg(std::span(areas).subspan(i + 1));
  return svg + scale_bar(paper) + "</svg>";
}

}  // namespace solitaire
