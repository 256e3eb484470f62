#include "scene/picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scene/error.h"
#include "scene/picture/cutaway.h"
#include "scene/picture/eye_view.h"
#include "scene/picture/lighting.h"
#include "scene/picture/ray_scene.h"
#include "scene/picture/rows.h"
#include "scene/picture/shading.h"

namespace solitaire {
namespace {

/// Where an edge runs through a pixel, it is looked at in so many places, no two of them in one row or
/// column.
constexpr std::array<std::array<float, 2>, 8> kPlaces{{{0.0625F, 0.4375F},
                                                       {0.1875F, 0.8125F},
                                                       {0.3125F, 0.1875F},
                                                       {0.4375F, 0.5625F},
                                                       {0.5625F, 0.0625F},
                                                       {0.6875F, 0.9375F},
                                                       {0.8125F, 0.3125F},
                                                       {0.9375F, 0.6875F}}};

/// The group of directions that each pixel of a square of 4 x 4 asks for. Any part of the square holds groups
/// that differ much (the matrix of Bayer, 1973).
constexpr std::array<std::array<std::size_t, 4>, 4> kGroupOf{
    {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};
/// Within rooms, which see little of the sky, light is sampled so many times as often, and is shown brighter
/// if there is less of it than usual: so many times at most.
constexpr std::size_t kIndoorRounds = 4;
constexpr double kUsualLight = 0.6;  // the mean on all that is seen, of that on open ground
constexpr double kMostExposure = 1.7;
constexpr int kMostPanes = 8;        // that one looks through
constexpr std::size_t kEnough = 14;  // pixels of a square that know about a surface

/// The eye of a camera in the frame of the ray tracer.
class Eye {
 public:
  Eye(const Camera& camera, const Vec3& middle, const PictureSize& size)
      : right_(to_vector(camera.right) * static_cast<float>(camera.half_height * camera.aspect)),
        up_(to_vector(camera.up) * static_cast<float>(camera.half_height)),
        forward_(to_vector(camera.forward)),
        width_(static_cast<float>(size.width)),
        height_(static_cast<float>(size.height)) {
    const Vec3& p = camera.position;
    origin_ = to_vector({p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]});
    pixel_ = 2 * static_cast<float>(camera.half_height) / height_;
  }

  /// Returns the ray through a place of the picture, in pixels from its upper left corner.
  Ray ray(float x, float y) const {
    const Vector across = right_ * (2 * x / width_ - 1), along = up_ * (1 - 2 * y / height_);
    return {origin_, normalized(forward_ + across + along)};
  }

  /// Returns how wide a pixel is at this distance.
  float pixel(float distance) const { return pixel_ * distance; }
  const Vector& origin() const { return origin_; }

 private:
  Vector origin_, right_, up_, forward_;
  float width_, height_;
  float pixel_ = 0;  // its width at a distance of 1
};

/// What is seen in one direction: an object, the ground or nothing.
struct Sight {
  static constexpr std::int32_t kGround = -1, kSky = -2;

  std::int32_t object = kSky;
  const Finish* finish = nullptr;  // of an object
  float distance = 0;
  Vector point, normal, flat_normal;
  float through = 1;             // share of its light that comes through clear surfaces before it
  Vector panes;                  // what a screen shows of those
  const Finish* pane = nullptr;  // of the first of them
};

/// The mean of light.
struct Mean {
  Light sum;
  std::size_t number = 0;

  void add(const Light& light) {
    sum.sun += light.sun;
    sum.ambient += light.ambient;
    ++number;
  }
  Light value() const {
    const float share = 1.0F / static_cast<float>(number);
    return {sum.sun * share, sum.ambient * share};
  }
};

class Drawing {
 public:
  Drawing(const RayScene& scene, const Camera& camera, const PictureSize& size, Viewpoint from)
      : scene_(scene),
        from_(from),
        lighting_(from == Viewpoint::kEye ? kIndoorRounds : 1),
        eye_(camera, scene.middle(), size),
        size_(size),
        sights_(size.width * size.height),
        lights_(size.width * size.height) {}

  Picture draw(std::size_t threads) {
    for_each_row(size_.height, threads, [&](std::size_t y) { look_at_row(y); });
    if (from_ == Viewpoint::kEye) exposure_ = adapted_exposure();
    Picture picture;
    picture.image = Image(size_.width, size_.height);
    for_each_row(size_.height, threads, [&](std::size_t y) { color_row(y, picture.image); });
    for (const Sight& sight : sights_) picture.objects.push_back(std::max(sight.object, Picture::kNothing));
    return picture;
  }

 private:
  /// As an eye gets used to the light around it.
  float adapted_exposure() const {
    const auto received = [](const Light& light, const Vector& normal) {
      const float facing = std::max(dot(normal, Lighting::to_sun()), 0.0F);
      return static_cast<double>(light.sun * facing * Lighting::sun_color().y + light.ambient.y);
    };
    double sum = 0, number = 0;
    for (std::size_t i = 0; i < sights_.size(); ++i) {
      if (sights_[i].object < 0) continue;
      sum += received(lights_[i], sights_[i].normal);
      ++number;
    }
    const double usual = number * kUsualLight * received(lighting_.in_the_open(), {0, 1, 0});
    return static_cast<float>(sum > 0 ? std::clamp(usual / sum, 1.0, kMostExposure) : 1);
  }

  std::size_t index(std::size_t x, std::size_t y) const { return y * size_.width + x; }

  // ---- the middle of each pixel

  void look_at_row(std::size_t y) {
    for (std::size_t x = 0; x < size_.width; ++x) {
      const Sight sight = look(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      sights_[index(x, y)] = sight;
      if (needs_light(sight)) lights_[index(x, y)] = light_at(sight, kGroupOf[y % 4][x % 4]);
    }
  }

  Sight look(float x, float y) const {
    const Ray ray = eye_.ray(x, y);
    Sight sight;
    std::optional<Hit> hit = scene_.trace(ray);
    for (int panes = 0; hit && hit->finish->opacity < 1 && panes < kMostPanes; ++panes) {
      if (!hit->from_behind) add_pane(*hit, ray, sight);
      // What is not clear is seen also where it lies in the plane of the pane: the table below a bottle.
      const float step = 0.01F * eye_.pixel(hit->distance);
      hit = scene_.trace(ray, hit->distance - step, hit->distance + step);
    }
    if (hit) {
      sight.object = static_cast<std::int32_t>(hit->object);
      sight.finish = hit->finish;
      sight.distance = hit->distance;
      sight.point = hit->point, sight.normal = hit->normal, sight.flat_normal = hit->flat_normal;
    } else if (ray.direction.y < 0) {
      look_at_ground(ray, sight);
    }
    return sight;
  }

  void look_at_ground(const Ray& ray, Sight& sight) const {
    const float distance = (scene_.ground() - ray.origin.y) / ray.direction.y;
    if (distance <= 0) return;
    sight.object = Sight::kGround;
    sight.distance = distance;
    sight.point = ray.origin + ray.direction * distance;
    sight.normal = sight.flat_normal = {0, 1, 0};
  }

  /// Takes up a clear surface, which is lit as in the open.
  void add_pane(const Hit& hit, const Ray& ray, Sight& sight) const {
    const Vector light = shaded(*hit.finish, lighting_.in_the_open(), hit.normal, -ray.direction);
    sight.panes += tone_mapped(light) * (hit.finish->opacity * sight.through);
    sight.through *= 1 - hit.finish->opacity;
    if (sight.pane == nullptr) sight.pane = hit.finish;
  }

  bool needs_light(const Sight& sight) const {
    return sight.object >= 0 || (sight.object == Sight::kGround && shadow_share(sight.point) > 0);
  }

  /// Returns how much of the shadows on the ground is shown at a place: all of it below the scene, and
  /// nothing far from it.
  float shadow_share(const Vector& point) const {
    const float away = std::sqrt(point.x * point.x + point.z * point.z) / scene_.radius();
    const float share = std::clamp((1.7F - away) / 0.7F, 0.0F, 1.0F);
    return share * share * (3 - 2 * share);
  }

  Light light_at(const Sight& sight, std::size_t group) const {
    // So far from the surface it does not shade itself where floats are coarse.
    const float lift = 0.02F * eye_.pixel(sight.distance) + 2e-6F * scene_.radius();
    return lighting_.sample(scene_, sight.point, sight.flat_normal, lift, group);
  }

  // ---- colours

  void color_row(std::size_t y, Image& image) const {
    for (std::size_t x = 0; x < size_.width; ++x) {
      const Vector color = has_edge(x, y) ? edge_color(x, y) : color_of(sights_[index(x, y)], x, y);
      std::uint8_t* pixel = image.pixel(x, y);
      pixel[0] = screen_byte(color.x), pixel[1] = screen_byte(color.y), pixel[2] = screen_byte(color.z);
    }
  }

  Vector edge_color(std::size_t x, std::size_t y) const {
    Vector sum;
    for (const auto& [right, down] : kPlaces)
      sum += color_of(look(static_cast<float>(x) + right, static_cast<float>(y) + down), x, y);
    return sum * (1.0F / kPlaces.size());
  }

  /// Returns what a screen shows, still as linear light, of what is seen through a pixel.
  Vector color_of(const Sight& sight, std::size_t x, std::size_t y) const {
    return sight.panes + color_behind_panes(sight, x, y) * sight.through;
  }

  Vector color_behind_panes(const Sight& sight, std::size_t x, std::size_t y) const {
    if (!needs_light(sight)) return background();
    const Light light = shared_light(sight, x, y);
    if (sight.object == Sight::kGround)
      return mixed(background(), ground_shown(light, lighting_.in_the_open()), shadow_share(sight.point));
    const Vector to_viewer = normalized(eye_.origin() - sight.point);
    return tone_mapped(shaded(*sight.finish, light, sight.normal, to_viewer) * exposure_);
  }

  /// Returns the mean of what the pixels around, each with another group of directions, know of this surface.
  /// Near the surface's edges few of them do, and so more of them are asked.
  Light shared_light(const Sight& sight, std::size_t x, std::size_t y) const {
    Mean mean;
    gather(sight, x, y, 1, mean);
    if (mean.number < kEnough) {
      mean = {};
      gather(sight, x, y, 3, mean);
    }
    if (mean.number == 0) {
      for (std::size_t group = 0; group < Lighting::kGroups; group += 5) mean.add(light_at(sight, group));
    }
    return mean.value();
  }

  /// Adds the light of this surface in the pixels from `reach` before the given one to `reach` + 1 behind it.
  void gather(const Sight& sight, std::size_t x, std::size_t y, std::size_t reach, Mean& mean) const {
    const std::size_t right = std::min(x + reach + 2, size_.width),
                      low = std::min(y + reach + 2, size_.height);
    for (std::size_t row = std::max(y, reach) - reach; row < low; ++row) {
      for (std::size_t column = std::max(x, reach) - reach; column < right; ++column) {
        const std::size_t i = index(column, row);
        if (is_same_surface(sight, sights_[i])) mean.add(lights_[i]);
      }
    }
  }

  bool is_same_surface(const Sight& sight, const Sight& other) const {
    if (other.object == Sight::kSky || (sight.object < 0) != (other.object < 0)) return false;
    if (dot(sight.normal, other.normal) < 0.9F) return false;
    return std::abs(dot(other.point - sight.point, sight.flat_normal)) < 1.5F * eye_.pixel(sight.distance);
  }

  bool has_edge(std::size_t x, std::size_t y) const {
    const Sight& here = sights_[index(x, y)];
    const auto differs = [&](std::size_t column, std::size_t row) {
      const Sight& there = sights_[index(column, row)];
      return here.object != there.object || here.finish != there.finish || here.pane != there.pane ||
             dot(here.normal, there.normal) < 0.97F;
    };
    return (x > 0 && differs(x - 1, y)) || (x + 1 < size_.width && differs(x + 1, y)) ||
           (y > 0 && differs(x, y - 1)) || (y + 1 < size_.height && differs(x, y + 1));
  }

  const RayScene& scene_;
  Viewpoint from_;
  Lighting lighting_;
  Eye eye_;
  PictureSize size_;
  std::vector<Sight> sights_;  // in the middle of each pixel
  std::vector<Light> lights_;  // there, each with its own group of directions
  float exposure_ = 1;
};

double aspect_of(const PictureSize& size) {
  if (!size.is_possible()) throw SceneError("a picture has at least one pixel and at most 16 million");
  return static_cast<double>(size.width) / static_cast<double>(size.height);
}

}  // namespace

Picture Painter::draw(const Scene& scene, const PictureSize& size, Viewpoint from) {
  if (from == Viewpoint::kEye) return draw_at_eye_height(scene, size);
  return draw(scene, size, default_camera(scene, aspect_of(size)));
}

Picture Painter::draw_at_eye_height(const Scene& scene, const PictureSize& size) {
  const double aspect = aspect_of(size);
  const RayScene traced(shapes_, scene, std::vector<std::optional<double>>(scene.objects.size()));
  return Drawing(traced, eye_view(scene, traced, aspect), size, Viewpoint::kEye).draw(threads_);
}

Picture Painter::draw(const Scene& scene, const PictureSize& size, const Camera& camera) {
  const Vec3 to_camera{-camera.forward[0], -camera.forward[1], -camera.forward[2]};
  const RayScene traced(shapes_, scene, cut_heights(scene, to_camera));
  return Drawing(traced, camera, size, Viewpoint::kAbove).draw(threads_);
}

}  // namespace solitaire
