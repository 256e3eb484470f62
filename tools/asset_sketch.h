#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/color.h"
#include "scene/gltf/mesh_builder.h"

namespace solitaire {

struct Surface {
  std::string name;
  Color color;  // as screens show it
  double roughness = 0.8;
  double metallic = 0;
  double glow = 0;  // share of its colour that it emits
};

/// A model put together from solids. Lengths are metres along glTF's axes: x right, y up, z to the front.
class AssetSketch {
 public:
  AssetSketch(std::string name, std::string front) : name_(std::move(name)), front_(std::move(front)) {}

  const std::string& name() const { return name_; }

  /// States that a size of its ground alone does not change the model's proportions.
  AssetSketch& keep_proportions();
  /// States what walls take the model for: "wall" or "opening".
  AssetSketch& role(const std::string& role);

  /// What follows is made of this. The first surface used is the primary one, which a program's color
  /// replaces.
  AssetSketch& of(const Surface& surface);

  AssetSketch& block(const Vec3& low, const Vec3& high, const Affine& map = {});
  /// A block whose edges are cut off by `bevel`.
  AssetSketch& soft_block(const Vec3& low, const Vec3& high, double bevel, const Affine& map = {});
  /// An upright post around (x, z): w0 × d0 at y0, w1 × d1 at y1, where its centre is moved by (dx, dz).
  AssetSketch& post(double x, double z, double y0, double w0, double d0, double y1, double w1, double d1,
                    double dx = 0, double dz = 0);
  /// A round upright solid through (radius, height) rings from below, closed by flat ends where the radius is
  /// not 0.
  AssetSketch& turned(double x, double z, const std::vector<std::array<double, 2>>& rings, int sides = 16,
                      const Affine& map = {});
  /// An outline of (x, y) corners, convex and counter-clockwise seen from the front, drawn out from z0 to z1.
  AssetSketch& extruded(const std::vector<std::array<double, 2>>& outline, double z0, double z1,
                        const Affine& map = {});
  /// A pointed leaf from `root`, bent at `middle`, to `tip`; seen from both sides.
  AssetSketch& leaf(const Vec3& root, const Vec3& middle, const Vec3& tip, double width);

  /// Writes the .glb, moved so that its box is centred over the origin and stands on the ground.
  void write(const std::filesystem::path& file);

 private:
  struct Part {
    Surface surface;
    MeshBuilder mesh;
  };

  MeshBuilder& mesh() { return parts_[current_].mesh; }
  Box3 box() const;
  void center();

  std::string name_;
  std::string front_;  // "+Z" or "none"
  bool keeps_proportions_ = false;
  std::string role_;
  std::vector<Part> parts_;
  std::size_t current_ = 0;
};

}  // namespace solitaire
