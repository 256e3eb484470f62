#include "scene/page/drawing/paper.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "scene/text.h"

namespace solitaire {
namespace {

constexpr double kLongSide = 400;
constexpr double kMargin = 8;
constexpr double kBarHeight = 26;

}  // namespace

void Area::include(const Point& point) {
  low = {std::min(low.x, point.x), std::min(low.y, point.y)};
  high = {std::max(high.x, point.x), std::max(high.y, point.y)};
}

void Area::include(const Area& other) {
  include(other.low);
  include(other.high);
}

bool Area::overlaps(const Area& other) const {
  return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
}

bool Area::contains(const Area& other) const {
  return low.x <= other.low.x && other.high.x <= high.x && low.y <= other.low.y && other.high.y <= high.y;
}

Area area_of(const Point& center, double width, double height, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
  const double x = (c * width + s * height) / 2, y = (s * width + c * height) / 2;
  return {{center.x - x, center.y - y}, {center.x + x, center.y + y}};
}

Paper::Paper(const Area& metres)
    : metres_(metres), scale_(kLongSide / std::max({metres.width(), metres.height(), 1e-9})) {
  size_ = {std::max(metres.width() * scale_, 1.0), std::max(metres.height() * scale_, 1.0)};
}

Point Paper::place(const Point& metres) const {
  return {(metres.x - metres_.low.x) * scale_, (metres_.high.y - metres.y) * scale_};
}

Area Paper::place(const Area& metres) const {
  Area area;
  area.include(place(metres.low));
  area.include(place(metres.high));
  return area;
}

std::string Paper::svg(std::string_view label, std::string_view content, double left) const {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{} {} {} {}\" role=\"img\" aria-label=\"{}\" "
      "font-family=\"system-ui,sans-serif\" text-anchor=\"middle\" "
      "dominant-baseline=\"central\">\n{}{}</svg>",
      number(-kMargin - left), number(-kMargin),
      number(std::max(size_.x, kLongSide / 3) + 2 * kMargin + left),
      number(size_.y + 2 * kMargin + kBarHeight - kMargin), escape_markup(label), content, scale_bar());
}

std::string Paper::scale_bar() const {
  const double metres = round_length(0.3 * std::max(size_.x, kLongSide / 3) / scale_);
  const double y = size_.y + kMargin + 8;
  return fmt::format(
      "<path d=\"M.5 {}v6h{}v-6\" fill=\"none\" stroke=\"currentColor\"/>"
      "<text x=\"{}\" y=\"{}\" font-size=\"11\" fill=\"currentColor\" text-anchor=\"start\">{}</text>\n",
      number(y - 3), number(metres * scale_), number(metres * scale_ + 6), number(y), length_text(metres));
}

std::string number(double value) { return fmt::format("{}", rounded(value, 2)); }

std::string length_text(double metres) {
  if (metres == 0) return "0 m";
  if (std::abs(metres) >= 1000) return fmt::format("{:g} km", rounded(metres / 1000, 2));
  if (std::abs(metres) >= 1) return fmt::format("{:g} m", rounded(metres, 2));
  if (std::abs(metres) >= 0.01) return fmt::format("{:g} cm", rounded(metres * 100, 1));
  return fmt::format("{:g} mm", rounded(metres * 1000, 2));
}

double round_length(double most) {
  const double ten = std::pow(10, std::floor(std::log10(most)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * ten <= most) return digit * ten;
  }
  return ten;
}

Color ink_on(const Color& fill) { return luminance(fill) > 0.3 ? Color{0.08, 0.09, 0.11} : Color{1, 1, 1}; }

Color edge_of(const Color& fill) { return mixed(fill, {0, 0, 0}, 0.45); }

}  // namespace solitaire
