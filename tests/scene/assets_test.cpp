// Assets: the bundled ones, and files that are broken or mean harm.
#include <map>
#include <random>

#include "scene/gltf/accessor_view.h"
#include "scene/gltf/asset_model.h"
#include "scene/gltf/writer.h"
#include "tests/scene/fixture.h"

namespace solitaire {

TEST_CASE("scene: broken asset files are errors that name the file") {
  TemporaryFolder folder;
  AssetLibrary assets(kAssets, folder.path());
  const auto check_refused = [&](const std::string& name) {
    CAPTURE(name);
    const std::string error = error_of([&] { assets.find(name); });
    CHECK(error.find(name) != std::string::npos);
  };
  const std::string chair = read_file(kAssets / "chair.glb");

  check_refused("missing.glb");
  write_file(folder / "empty.glb", "");
  check_refused("empty.glb");
  write_file(folder / "text.glb", "hello");
  check_refused("text.glb");
  fs::create_directory(folder / "folder.glb");
  check_refused("folder.glb");
  for (const std::size_t length : {3u, 12u, 19u, 40u, 2000u}) {
    write_file(folder / "short.glb", chair.substr(0, length));
    check_refused("short.glb");
  }
  write_file(folder / "short.glb", chair.substr(0, chair.size() - 4));
  check_refused("short.glb");
  write_file(folder / "deep.gltf", R"({"asset":{"version":"2.0"},"extras":)" + std::string(100000, '['));
  check_refused("deep.gltf");
  write_file(folder / "nothing.gltf", R"({"asset":{"version":"2.0"}})");
  check_refused("nothing.gltf");

  const std::map<std::string, std::function<void(json&)>> damages = {
      {"accessor", [](json& f) { f["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 999; }},
      {"negative accessor", [](json& f) { f["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = -5; }},
      {"index accessor", [](json& f) { f["meshes"][0]["primitives"][0]["indices"] = 999; }},
      {"indices of points", [](json& f) { f["meshes"][0]["primitives"][0]["indices"] = 0; }},
      {"points of indices", [](json& f) { f["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 2; }},
      {"material", [](json& f) { f["meshes"][0]["primitives"][0]["material"] = 77; }},
      {"mode", [](json& f) { f["meshes"][0]["primitives"][0]["mode"] = 9; }},
      {"no position", [](json& f) { f["meshes"][0]["primitives"][0]["attributes"].erase("POSITION"); }},
      {"no primitives", [](json& f) { f["meshes"][0]["primitives"] = json::array(); }},
      {"count", [](json& f) { f["accessors"][0]["count"] = 100000; }},
      {"huge count", [](json& f) { f["accessors"][0]["count"] = 18446744073709551615u; }},
      {"zero count", [](json& f) { f["accessors"][0]["count"] = 0; }},
      {"offset", [](json& f) { f["accessors"][0]["byteOffset"] = 1u << 31; }},
      {"fewer vertices", [](json& f) { f["accessors"][0]["count"] = f["accessors"][1]["count"] = 3; }},
      {"component type", [](json& f) { f["accessors"][0]["componentType"] = 5124; }},
      {"view", [](json& f) { f["accessors"][0]["bufferView"] = 500; }},
      {"sparse",
       [](json& f) {
         const json part = {{"bufferView", 0}, {"componentType", 5123}};
         f["accessors"][0]["sparse"] = {{"count", 1}, {"indices", part}, {"values", part}};
       }},
      {"buffer", [](json& f) { f["bufferViews"][0]["buffer"] = 3; }},
      {"negative buffer", [](json& f) { f["bufferViews"][0]["buffer"] = -3; }},
      {"view's offset", [](json& f) { f["bufferViews"][0]["byteOffset"] = 18446744073709551615u; }},
      {"view's length", [](json& f) { f["bufferViews"][0]["byteLength"] = 1u << 30; }},
      {"buffer's length", [](json& f) { f["buffers"][0]["byteLength"] = 1u << 30; }},
      {"mesh", [](json& f) { f["nodes"][0]["mesh"] = 4; }},
      {"child", [](json& f) { f["nodes"][0]["children"] = {7}; }},
      {"own child", [](json& f) { f["nodes"][0]["children"] = {0}; }},
      {"root", [](json& f) { f["scenes"][0]["nodes"] = {-2}; }},
      {"root twice",
       [](json& f) {
         f["scenes"][0]["nodes"] = {0, 0};
       }},
      {"no root", [](json& f) { f["scenes"][0]["nodes"] = json::array(); }},
      {"scene", [](json& f) { f["scene"] = 5; }},
      {"transform",
       [](json& f) {
         f["nodes"][0]["scale"] = {1, 2};
       }},
      {"texture",
       [](json& f) {
         f["materials"][0]["normalTexture"] = {{"index", 3}};
       }},
      {"extension's texture",
       [](json& f) {
         f["materials"][0]["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"] = {{"index", 3}};
       }},
      {"image",
       [](json& f) {
         f["images"] = {{{"bufferView", 99}, {"mimeType", "image/png"}}};
       }},
      {"extension", [](json& f) { f["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }},
      {"a chain of nodes", [](json& f) {
         for (int i = 1; i <= 5000; ++i) {
           f["nodes"][static_cast<std::size_t>(i - 1)]["children"] = {i};
           f["nodes"].push_back({{"mesh", 0}});
         }
       }}};
  for (const auto& [name, damage] : damages) {
    json file = json_of(chair);
    damage(file);
    write_file(folder / (name + ".glb"), with_json(chair, file));
    check_refused(name + ".glb");
  }
}

TEST_CASE("scene: a .gltf needs its files, and gets none from outside its folder") {
  TemporaryFolder folder;
  fs::create_directory(folder / "in");
  json file = triangle_file(folder / "in");
  fs::copy(folder / "in/triangle.bin", folder / "triangle.bin");
  AssetLibrary assets(kAssets, folder.path());
  const auto error = [&](const std::string& name, const json& changed) {
    write_file(folder / ("in/" + name), changed.dump());
    return error_of([&] { assets.find("in/" + name); });
  };
  CHECK(error("good.gltf", file) == "");
  file["buffers"][0]["uri"] = "lost.bin";
  CHECK(error("lost.gltf", file).find("lost.bin") != std::string::npos);
  file["buffers"][0]["uri"] = "../triangle.bin";
  CHECK(error("outside.gltf", file) != "");
  file["buffers"][0]["uri"] = (folder / "triangle.bin").string();
  CHECK(error("absolute.gltf", file) != "");
  file["buffers"][0]["uri"] = "triangle.bin";
  file["images"][0]["uri"] = "lost.png";
  CHECK(error("image.gltf", file).find("lost.png") != std::string::npos);
}

TEST_CASE("scene: damaged bytes anywhere never do more than fail") {
  TemporaryFolder folder;
  const std::string chair = read_file(kAssets / "chair.glb");
  const std::size_t json_end = 20 + word(chair, 12);
  std::mt19937 random(1);
  std::size_t refused = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string damaged = chair;
    for (int k = 0; k < 3; ++k)
      damaged[random() % (k == 2 ? chair.size() : json_end)] = static_cast<char>(random() % 128);
    write_file(folder / "chair.glb", damaged);
    AssetLibrary assets(kAssets, folder.path());
    const std::string error = error_of([&] {
      PlacedThing placement = placed("chair.glb", {0, 0, 0});
      placement.color = {{1, 0, 0}};
      glb_bytes(build_scene({placement}, 1, "test", assets));
    });
    refused += error.empty() ? 0 : 1;
  }
  CHECK(refused > 500);
}

TEST_CASE("scene: bundled assets are what their extras say, centred, small, and closed to the outside") {
  AssetLibrary assets = bundled();
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(kAssets)) {
    if (entry.path().extension() != ".glb") continue;
    ++count;
    CAPTURE(entry.path().filename().string());
    CHECK(entry.file_size() < 100 * 1024);
    const Asset* asset = assets.find(entry.path().stem().string());
    REQUIRE(asset != nullptr);
    const json extras = json_of(read_file(entry.path()))["nodes"][0]["extras"];
    check_point(asset->box.size(), {extras["footprint"][0], extras["height"], extras["footprint"][1]}, 1e-4);
    CHECK(std::abs(asset->box.low[0] + asset->box.high[0]) < 1e-5);
    CHECK(std::abs(asset->box.low[1]) < 1e-6);
    CHECK(std::abs(asset->box.low[2] + asset->box.high[2]) < 1e-5);
    CHECK(asset->front_turns == 0);

    const tinygltf::Model& model = asset->model->gltf;
    for (const auto& primitive : model.meshes[0].primitives) {
      const AccessorView points(model, primitive.attributes.at("POSITION"));
      const AccessorView normals(model, primitive.attributes.at("NORMAL")), indices(model, primitive.indices);
      std::size_t turned_away = 0;
      for (std::size_t i = 0; i + 2 < indices.count(); i += 3) {
        const Vec3 a = points.point(indices.index(i)), b = points.point(indices.index(i + 1));
        const Vec3 c = points.point(indices.index(i + 2)), n = normals.point(indices.index(i));
        const Vec3 u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
        const Vec3 cross{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        turned_away += cross[0] * n[0] + cross[1] * n[1] + cross[2] * n[2] > 0 ? 0 : 1;
      }
      CHECK(turned_away == 0);
    }
  }
  CHECK(count >= 20);
}

}  // namespace solitaire
