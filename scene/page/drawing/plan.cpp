#include "scene/page/drawing/plan.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "scene/page/drawing/paper.h"
#include "scene/page/drawing/thing.h"
#include "scene/text.h"

namespace solitaire {
namespace {

constexpr double kLeastText = 6.5;
constexpr double kMostText = 14;
constexpr double kFlat = 0.05;  // metres; of what is not higher, such as a floor, nobody asks the height
constexpr double kHeightText = 0.72;  // of the size of the name above it

Area ground_of(const PlacedBox& box) {
  const Box3 area = bounds(box);
  return {{area.low[0], area.low[1]}, {area.high[0], area.high[1]}};
}

Area ground_of(const Scene& scene) {
  Area area;
  for (const SceneObject& object : scene.objects) area.include(ground_of(object.box));
  return area;
}

/// Draws one object: its shape in a frame of its own, with the centre at the origin and the front downward,
/// which is then turned as a whole.
class ObjectDrawing {
 public:
  ObjectDrawing(const NamedObject& named, const Paper& paper)
      : object_(*named.object),
        unique_name_(*named.name),
        name_(text_on(object_)),
        height_(length_text(object_.box.size[2])),
        center_(paper.place(Point{object_.box.center[0], object_.box.center[1]})),
        width_(object_.box.size[0] * paper.scale()),
        depth_(object_.box.size[1] * paper.scale()) {}

  Area area() const { return area_of(center_, width_, depth_, object_.box.angle); }

  /// Returns the drawing. What lies `above` is drawn later and would hide a label below it.
  std::string svg(std::span<const Area> above) const {
    return thing_element(object_, unique_name_,
                         fmt::format("<g{}>{}{}</g>{}", moved(center_, object_.box.angle), ground(),
                                     front_mark(), label(above)));
  }

  /// Returns the outline of what hangs overhead.
  std::string outline() const {
    return thing_element(
        object_, unique_name_,
        fmt::format("<g{}><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\" "
                    "stroke-dasharray=\"4 3\"/></g>",
                    moved(center_, object_.box.angle), number(-width_ / 2), number(-depth_ / 2),
                    number(width_), number(depth_), hex(edge_of(object_.color))));
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

  std::string ground() const { return object_.outline.empty() ? rectangle() : polygon(); }

  std::string polygon() const {
    std::string points;
    for (const auto& [x, y] : object_.outline)
      points += fmt::format("{}{},{}", points.empty() ? "" : " ", number(x * width_), number(-y * depth_));
    return fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>", points, hex(object_.color),
                       hex(edge_of(object_.color)));
  }

  std::string rectangle() const {
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"{}\"/>",
                       number(-width_ / 2), number(-depth_ / 2), number(width_), number(depth_),
                       hex(object_.color), hex(edge_of(object_.color)));
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

  /// Returns the name, with the height below it where there is room, in the middle or, if something hides
  /// that and the text is level, in a free corner. Returns "" where it would not be legible.
  std::string label(std::span<const Area> above) const {
    if (name_.empty()) return "";
    const Line line = best_line();
    if (line.font_size < kLeastText) return "";
    const double length = text_width(name_) * line.font_size;
    for (const Point& center : label_places(line, length)) {
      const auto is_free = [&](double lines) {
        const Area area = area_of(center, length, lines * line.font_size, line.degrees);
        return std::ranges::none_of(above, [&](const Area& each) { return each.overlaps(area); });
      };
      if (!is_free(1)) continue;
      const bool has_height = room_for_height(line) && is_free(2);
      return fmt::format("<text{} font-size=\"{}\" fill=\"{}\">{}</text>", moved(center, line.degrees),
                         number(std::floor(line.font_size * 10) / 10), hex(ink_on(object_.color)),
                         has_height ? name_and_height() : escape_markup(name_));
    }
    return "";
  }

  /// Tells whether a second, smaller line fits into the shape.
  bool room_for_height(const Line& line) const {
    if (object_.box.size[2] < kFlat) return false;
    const bool along_width = std::abs(std::remainder(line.degrees - object_.box.angle, 180.0)) < 1;
    const double free_depth = depth_ - 2 * mark_depth();
    const double length = along_width ? width_ : free_depth, thickness = along_width ? free_depth : width_;
    const double size = kHeightText * line.font_size;
    return size >= kLeastText && text_width(height_) * size <= 0.92 * length &&
           2 * line.font_size <= thickness;
  }

  std::string name_and_height() const {
    return fmt::format(
        "<tspan x=\"0\" dy=\"-.42em\">{}</tspan><tspan x=\"0\" dy=\"1.35em\" font-size=\"{}em\" "
        "opacity=\".8\">"
        "{}</tspan>",
        escape_markup(name_), kHeightText, height_);
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
  std::string name_, height_;
  Point center_;
  double width_, depth_;
};

double ground_taken(const PlacedBox& box) { return box.size[0] * box.size[1]; }

/// Returns the objects in the order of drawing: floors first, then what stands in or on them.
std::vector<NamedObject> bottom_up(std::vector<NamedObject> objects) {
  std::stable_sort(objects.begin(), objects.end(), [](const NamedObject& a, const NamedObject& b) {
    const PlacedBox &first = a.object->box, &second = b.object->box;
    if (first.center[2] != second.center[2]) return first.center[2] < second.center[2];
    return ground_taken(first) > ground_taken(second);
  });
  return objects;
}

}  // namespace

std::string svg_plan(const Scene& scene) {
  if (scene.objects.empty()) return "";
  Level all;
  all.standing.resize(scene.objects.size());
  std::iota(all.standing.begin(), all.standing.end(), std::size_t{0});
  return svg_plan(scene, all);
}

std::string svg_plan(const Scene& scene, const Level& level) {
  const Paper paper(ground_of(scene));
  std::vector<ObjectDrawing> drawings;
  for (const NamedObject& each : bottom_up(named_objects(scene, level.standing)))
    drawings.emplace_back(each, paper);
  std::vector<Area> areas;
  for (const ObjectDrawing& drawing : drawings) areas.push_back(drawing.area());
  std::string content;
  for (std::size_t i = 0; i < drawings.size(); ++i)
    content += drawings[i].svg(std::span(areas).subspan(i + 1));
  for (const NamedObject& each : named_objects(scene, level.overhead))
    content += ObjectDrawing(each, paper).outline();
  return paper.svg(fmt::format("Plan of {}: {} objects", scene.title, drawings.size()), content);
}

}  // namespace solitaire
