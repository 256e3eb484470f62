#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "scene/page/drawing/labels.h"
#include "scene/page/drawing/paper.h"
#include "scene/page/drawing/solids.h"
#include "scene/page/drawing/thing.h"
#include "scene/picture/cutaway.h"

namespace solitaire {
namespace {

constexpr double kRoomForHeights = 34;  // to the left of the drawing
constexpr std::size_t kMostWallPairs = 20'000'000;

/// An object as it is seen from a side.
struct Face {
  NamedObject named;
  Area metres;         // across and up
  double near, far;    // how far behind the front of everything, in metres
  bool hides = false;  // a wall with something behind it
};

Face face_of(const NamedObject& named, Side side) {
  const Box3 box = bounds(named.object->box);
  if (side == Side::kFront)
    return {named, {{box.low[0], box.low[2]}, {box.high[0], box.high[2]}}, box.low[1], box.high[1]};
  return {named, {{box.low[1], box.low[2]}, {box.high[1], box.high[2]}}, -box.high[0], -box.low[0]};
}

void find_hiding_walls(std::vector<Face>& faces) {
  std::vector<bool> walls;
  for (const Face& face : faces) walls.push_back(is_like_wall(*face.named.object));
  if (static_cast<std::size_t>(std::ranges::count(walls, true)) * faces.size() > kMostWallPairs) return;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t j = 0; walls[i] && !faces[i].hides && j < faces.size(); ++j) {
      faces[i].hides =
          !walls[j] && faces[j].near >= faces[i].far - 0.01 && faces[i].metres.overlaps(faces[j].metres);
    }
  }
}

/// Returns the faces from the farthest to the nearest.
std::vector<Face> faces_of(const Scene& scene, Side side) {
  std::vector<Face> faces;
  for (const NamedObject& named : named_objects(scene)) faces.push_back(face_of(named, side));
  find_hiding_walls(faces);
  std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.near > b.near; });
  return faces;
}

std::string rectangle(const Area& area, const SceneObject& object, bool outlined) {
  const std::string edge = hex(edge_of(object.color));
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>", number(area.low.x),
                     number(area.low.y), number(area.width()), number(area.height()),
                     outlined ? fmt::format("fill=\"none\" stroke=\"{}\" stroke-dasharray=\"4 3\"", edge)
                              : fmt::format("fill=\"{}\" stroke=\"{}\"", hex(object.color), edge));
}

/// Returns lines at round heights, each with its height.
std::string height_lines(const Paper& paper, const Area& metres) {
  const double step = round_length(std::max(metres.height(), 1e-3) / 2.5);
  std::string lines;
  for (double at = std::ceil(metres.low.y / step) * step; at <= metres.high.y + step * 1e-6; at += step) {
    const double y = paper.place(Point{metres.low.x, at}).y;
    lines += fmt::format(
        "<path d=\"M-4 {0}H{1}\" stroke=\"currentColor\" opacity=\".25\"/>"
        "<text x=\"-7\" y=\"{0}\" font-size=\"9\" fill=\"currentColor\" text-anchor=\"end\">{2}</text>\n",
        number(y), number(paper.size().x), length_text(rounded(at, 6)));
  }
  return lines;
}

}  // namespace

std::string svg_elevation(const Scene& scene, Side side) {
  const std::vector<Face> faces = faces_of(scene, side);
  Area metres;
  for (const Face& face : faces) metres.include(face.metres);
  const Paper paper(metres);
  std::vector<LabelledShape> shapes;
  for (const Face& face : faces) {
    const Area area = paper.place(face.metres);
    const SceneObject& object = *face.named.object;
    shapes.push_back({face.named, rectangle(area, object, face.hides), face.hides ? Area() : area,
                      face.hides ? Area() : area, object.color});
  }
  const char* from = side == Side::kFront ? "From the front" : "From the right";
  return paper.svg(fmt::format("{}: {}", from, scene.title),
                   height_lines(paper, metres) + with_labels(shapes), kRoomForHeights);
}

}  // namespace solitaire
