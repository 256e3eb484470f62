#include "scene/outline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace solitaire {
namespace {

using GroundPoint = std::array<double, 2>;

/// Returns twice the area of the triangle, positive if it is counter-clockwise.
double turn(const GroundPoint& a, const GroundPoint& b, const GroundPoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double twice_area(const Outline& points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const GroundPoint &a = points[i], &b = points[(i + 1) % points.size()];
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

/// Returns true if p, which lies on the line through a and b, lies between them.
bool is_between(const GroundPoint& a, const GroundPoint& b, const GroundPoint& p) {
  return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) && std::min(a[1], b[1]) <= p[1] &&
         p[1] <= std::max(a[1], b[1]);
}

bool meet(const GroundPoint& a, const GroundPoint& b, const GroundPoint& c, const GroundPoint& d) {
  const double at_c = turn(a, b, c), at_d = turn(a, b, d), at_a = turn(c, d, a), at_b = turn(c, d, b);
  if (((at_c > 0 && at_d < 0) || (at_c < 0 && at_d > 0)) &&
      ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)))
    return true;
  return (at_c == 0 && is_between(a, b, c)) || (at_d == 0 && is_between(a, b, d)) ||
         (at_a == 0 && is_between(c, d, a)) || (at_b == 0 && is_between(c, d, b));
}

bool has_edges_that_meet(const Outline& points) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool next = j == i + 1, last = i == 0 && j == n - 1;
      if (!next && !last) {
        if (meet(points[i], points[(i + 1) % n], points[j], points[(j + 1) % n])) return true;
        continue;
      }
      // Neighbours share a corner, and must not run back over each other.
      const GroundPoint &shared = next ? points[j] : points[0], &one = next ? points[i] : points[1],
                        &other = next ? points[(j + 1) % n] : points[n - 1];
      const double along =
          (one[0] - shared[0]) * (other[0] - shared[0]) + (one[1] - shared[1]) * (other[1] - shared[1]);
      if (one == shared || other == shared || (turn(one, shared, other) == 0 && along > 0)) return true;
    }
  }
  return false;
}

bool is_in(const GroundPoint& p, const GroundPoint& a, const GroundPoint& b, const GroundPoint& c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// Cuts off ears, corners whose triangle holds no other corner, until a triangle is left (Meisters, 1975).
std::vector<std::array<std::size_t, 3>> triangles_of(const Outline& outline) {
  std::vector<std::size_t> left(outline.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<std::array<std::size_t, 3>> triangles;
  while (left.size() > 2) {
    const std::size_t n = left.size();
    std::size_t ear = 0;
    double flattest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
      const double area = turn(outline[a], outline[b], outline[c]);
      const bool is_ear =
          area >= 0 && std::ranges::none_of(left, [&](std::size_t k) {
            return k != a && k != b && k != c && is_in(outline[k], outline[a], outline[b], outline[c]);
          });
      if (is_ear && area < flattest) ear = i, flattest = area;  // flat corners first: they hide no other
    }
    if (flattest > 0) triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

}  // namespace

const char* fault_of(const Outline& points) {
  if (points.size() < 3) return "has fewer than three points";
  if (has_edges_that_meet(points)) return "has edges that cross or touch each other";
  if (twice_area(points) == 0) return "has no area";
  return "";
}

Outline in_unit_square(Outline points) {
  if (twice_area(points) < 0) std::ranges::reverse(points);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [low, high] =
        std::ranges::minmax(points, {}, [axis](const GroundPoint& p) { return p[axis]; });
    const double from = low[axis], size = high[axis] - from;
    for (GroundPoint& point : points) point[axis] = (point[axis] - from) / size - 0.5;
  }
  return points;
}

std::vector<std::vector<Vec3>> faces_over(const Outline& outline) {
  const auto corner = [&](std::size_t i, double height) {
    return Vec3{outline[i][0], height, -outline[i][1]};
  };
  std::vector<std::vector<Vec3>> faces;
  for (const auto& [a, b, c] : triangles_of(outline)) {
    faces.push_back({corner(a, 1), corner(b, 1), corner(c, 1)});
    faces.push_back({corner(c, 0), corner(b, 0), corner(a, 0)});
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    faces.push_back({corner(i, 0), corner(next, 0), corner(next, 1), corner(i, 1)});
  }
  return faces;
}

}  // namespace solitaire
