#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>
#include <vector>

#include "scene/camera.h"
#include "scene/page/drawing/labels.h"
#include "scene/page/drawing/paper.h"
#include "scene/page/drawing/solids.h"
#include "scene/page/drawing/thing.h"
#include "scene/picture/cutaway.h"

namespace solitaire {
namespace {

constexpr std::size_t kMostSorted = 3000;  // objects whose order is found pair by pair
constexpr Color kCutFill{0.23, 0.24, 0.26};

/// Returns where a point of the program's space is seen from the front, the right and above, in metres.
Point projected(const Vec3& point) {
  const double across = (point[0] + point[1]) / std::numbers::sqrt2;
  return {across, point[2] * std::sqrt(2.0 / 3) + (point[1] - point[0]) / std::sqrt(6.0)};
}

/// An upright block in space.
struct Block {
  NamedObject named;
  std::vector<Point> corners;  // of its ground, counter-clockwise seen from above
  Box3 box;
  bool is_cut = false;
  Area seen;  // where it is seen, in metres
};

std::vector<Point> corners_of(const SceneObject& object) {
  const PlacedBox& box = object.box;
  const double angle = box.angle * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  std::vector<Point> corners;
  const Outline square{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  for (const auto& [across, along] : object.outline.empty() ? square : object.outline) {
    const double x = across * box.size[0], y = along * box.size[1];
    corners.push_back({box.center[0] + c * x - s * y, box.center[1] + s * x + c * y});
  }
  return corners;
}

Block block_of(const NamedObject& named, const std::optional<double>& cut) {
  const PlacedBox& placed = named.object->box;
  Block block{named, corners_of(*named.object), bounds(placed), false, {}};
  if (cut && *cut < block.box.high[2]) {
    block.box.high[2] = std::max(*cut, block.box.low[2]);
    block.is_cut = true;
  }
  for (const Point& corner : block.corners) {
    for (const double z : {block.box.low[2], block.box.high[2]})
      block.seen.include(projected({corner.x, corner.y, z}));
  }
  return block;
}

/// Tells whether `a` lies behind `b` where both are seen. Of two that lie in each other, such as a thing that
/// stands in its floor, the one that does not reach as high is behind.
bool lies_behind(const Block& a, const Block& b) {
  if (!a.seen.overlaps(b.seen)) return false;
  const auto before = [](const Block& first, const Block& second) {
    constexpr double kTouch = 1e-9;
    return first.box.high[2] <= second.box.low[2] + kTouch ||
           first.box.high[0] <= second.box.low[0] + kTouch || second.box.high[1] <= first.box.low[1] + kTouch;
  };
  const bool is_before = before(a, b), is_after = before(b, a);
  return is_before != is_after ? is_before : a.box.high[2] < b.box.high[2];
}

double nearness(const Block& block) {
  return block.box.low[0] + block.box.high[0] - block.box.low[1] - block.box.high[1] + block.box.low[2] +
         block.box.high[2];
}

/// Puts the blocks into an order in which each is drawn after those that lie behind it.
class BackToFront {
 public:
  explicit BackToFront(std::vector<Block> blocks) : blocks_(std::move(blocks)), visited_(blocks_.size()) {}

  std::vector<Block> sorted() {
    std::stable_sort(blocks_.begin(), blocks_.end(),
                     [](const Block& a, const Block& b) { return nearness(a) < nearness(b); });
    if (blocks_.size() > kMostSorted) return std::move(blocks_);
    for (std::size_t i = 0; i < blocks_.size(); ++i) visit(i);
    return std::move(order_);
  }

 private:
  void visit(std::size_t index) {
    if (visited_[index]) return;
    visited_[index] = true;  // beforehand: blocks that lie in each other have no order
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
      if (i != index && !visited_[i] && lies_behind(blocks_[i], blocks_[index])) visit(i);
    }
    order_.push_back(blocks_[index]);
  }

  std::vector<Block> blocks_, order_;
  std::vector<bool> visited_;
};

std::string polygon(const Paper& paper, const std::vector<Vec3>& points, const Color& fill,
                    const Color& edge) {
  std::string list;
  for (const Vec3& point : points) {
    const Point at = paper.place(projected(point));
    list += fmt::format("{}{},{}", list.empty() ? "" : " ", number(at.x), number(at.y));
  }
  return fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-linejoin=\"round\"/>", list,
                     hex(fill), hex(edge));
}

/// Returns the sides that one sees, darker the more they turn to the right, and the top.
std::string drawing_of(const Block& block, const Paper& paper) {
  const Color& color = block.named.object->color;
  const Color edge = edge_of(color);
  const double low = block.box.low[2], high = block.box.high[2];
  std::string drawing;
  std::vector<Vec3> top;
  for (std::size_t i = 0; i < block.corners.size(); ++i) {
    const Point &from = block.corners[i], &to = block.corners[(i + 1) % block.corners.size()];
    top.push_back({from.x, from.y, high});
    const double x = to.y - from.y, y = from.x - to.x, length = std::hypot(x, y);  // the outward direction
    if (length == 0 || x - y <= 1e-9) continue;
    const Color shade = mixed(color, {0, 0, 0}, 0.12 + 0.18 * std::max(x / length, 0.0));
    drawing +=
        polygon(paper, {{from.x, from.y, low}, {to.x, to.y, low}, {to.x, to.y, high}, {from.x, from.y, high}},
                shade, edge);
  }
  return drawing + polygon(paper, top, block.is_cut ? kCutFill : color, edge);
}

/// Tells whether the point is on a convex shape whose corners go round clockwise on paper.
bool is_on(const std::array<Point, 4>& shape, const Point& point) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Point &from = shape[i], &to = shape[(i + 1) % 4];
    if ((to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x) > 0) return false;
  }
  return true;
}

/// Returns where a name fits onto the top, in its middle; nothing on tops that are too narrow.
Area room_on_top(const Block& block, const Paper& paper) {
  if (block.is_cut || !block.named.object->outline.empty()) return {};
  std::array<Point, 4> top;
  Area around;
  for (std::size_t i = 0; i < 4; ++i) {
    top[i] = paper.place(projected({block.corners[i].x, block.corners[i].y, block.box.high[2]}));
    around.include(top[i]);
  }
  const Point center{(around.low.x + around.high.x) / 2, (around.low.y + around.high.y) / 2};
  for (const double share : {0.48, 0.36, 0.24}) {
    const Area room = area_of(center, share * around.width(), share * around.height());
    const bool fits = is_on(top, room.low) && is_on(top, room.high) &&
                      is_on(top, {room.low.x, room.high.y}) && is_on(top, {room.high.x, room.low.y});
    if (fits) return room;
  }
  return {};
}

}  // namespace

std::string svg_isometric(const Scene& scene) {
  const auto cuts = cut_heights(scene, three_quarter_view());
  std::vector<Block> blocks;
  Area metres;
  for (const NamedObject& named : named_objects(scene)) {
    blocks.push_back(block_of(named, cuts[static_cast<std::size_t>(named.object - scene.objects.data())]));
    metres.include(blocks.back().seen);
  }
  const Paper paper(metres);
  std::vector<LabelledShape> shapes;
  for (const Block& block : BackToFront(std::move(blocks)).sorted()) {
    shapes.push_back({block.named, drawing_of(block, paper), paper.place(block.seen),
                      room_on_top(block, paper), block.named.object->color});
  }
  return paper.svg(fmt::format("Isometric view of {}: {} objects", scene.title, shapes.size()),
                   with_labels(shapes));
}

}  // namespace solitaire
