// Models that consist of cubes.
#include "scene/voxel_asset.h"

#include "scene/gltf/asset_model.h"
#include "scene/gltf/verify.h"
#include "scene/gltf/writer.h"
#include "tests/scene/fixture.h"

namespace solitaire {
namespace {

constexpr Color kWood{0.5, 0.25, 0}, kLeaf{0, 0.75, 0};

/// Returns the triangles of each primitive.
std::vector<std::size_t> triangles_of(const Asset& asset) {
  std::vector<std::size_t> triangles;
  for (const auto& primitive : asset.model->gltf.meshes.front().primitives)
    triangles.push_back(asset.model->gltf.accessors[static_cast<std::size_t>(primitive.indices)].count / 3);
  return triangles;
}

}  // namespace

TEST_CASE("scene: cubes of a model have no faces between them, and each colour is a primitive") {
  CHECK(triangles_of(voxel_asset("one", {{{0, 0, 0}, kWood}}, 1)) == std::vector<std::size_t>{12});
  CHECK(triangles_of(voxel_asset("two", {{{0, 0, 0}, kWood}, {{0, 0, 1}, kWood}}, 1)) ==
        std::vector<std::size_t>{20});
  CHECK(triangles_of(voxel_asset("tree", {{{0, 0, 0}, kWood}, {{0, 0, 1}, kLeaf}}, 1)) ==
        std::vector<std::size_t>{10, 10});
}

TEST_CASE("scene: a model of cubes of many faces has several primitives") {
  std::vector<Voxel> apart;
  for (int at = 0; at < 3000; ++at) apart.push_back({{2 * at, 0, 0}, kWood});
  CHECK(triangles_of(voxel_asset("row", apart, 0.01)) == std::vector<std::size_t>{32000, 4000});
}

TEST_CASE("scene: models of cubes are placed, shared, and looked up by their names") {
  TemporaryFolder folder;
  AssetLibrary assets = bundled();
  const auto make = [] {
    return voxel_asset("stair", {{{0, 0, 0}, kWood}, {{1, 0, 0}, kWood}, {{1, 3, 1}, kLeaf}}, 0.25);
  };
  const Asset& stair = assets.made("stair", make);
  CHECK(stair.box.low == Vec3{0, 0, -1});
  CHECK(stair.box.high == Vec3{0.5, 0.5, 0});
  CHECK(&assets.made("stair", make) == &stair);
  CHECK(assets.find("stair") == &stair);
  CHECK(assets.notes().empty());

  const Scene scene =
      build_scene({placed("stair", {1, 2, 0}), placed("stair", {3, 2, 0})}, 1, "test", assets);
  CHECK(scene.objects[0].box.size == Vec3{0.5, 1, 0.5});
  for (const Nodes nodes : {Nodes::kOneEach, Nodes::kInstances}) {
    write_glb(scene, folder / "a.glb", nodes);
    verify_glb(folder / "a.glb", scene, nodes);
  }
}

}  // namespace solitaire
