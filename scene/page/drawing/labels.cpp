#include "scene/page/drawing/labels.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>

#include "scene/text.h"

namespace solitaire {
namespace {

constexpr double kSmallestName = 6.5;
constexpr double kLargestName = 12;

/// Returns the name of a shape, or "" where there is no room for it. `later` are the shapes drawn after it.
std::string name_of(const LabelledShape& shape, std::span<const LabelledShape> later) {
  if (shape.label.width() <= 0) return "";
  const std::string name = text_on(*shape.named.object);
  const double size = std::min({0.92 * shape.label.width() / std::max(text_width(name), 0.1),
                                0.8 * shape.label.height(), kLargestName});
  if (name.empty() || size < kSmallestName) return "";
  const Point center{(shape.label.low.x + shape.label.high.x) / 2,
                     (shape.label.low.y + shape.label.high.y) / 2};
  const Area area = area_of(center, text_width(name) * size, size);
  if (std::ranges::any_of(later, [&](const LabelledShape& each) { return each.covered.overlaps(area); }))
    return "";
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" fill=\"{}\">{}</text>", number(center.x),
                     number(center.y), number(std::floor(size * 10) / 10), hex(ink_on(shape.fill)),
                     escape_markup(name));
}

}  // namespace

std::string with_labels(const std::vector<LabelledShape>& shapes) {
  std::string content;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const LabelledShape& shape = shapes[i];
    content += thing_element(*shape.named.object, *shape.named.name,
                             shape.drawing + name_of(shape, std::span(shapes).subspan(i + 1)));
  }
  return content;
}

}  // namespace solitaire
