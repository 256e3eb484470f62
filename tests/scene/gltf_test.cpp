// Forms of glTF that models come in: compact ones that are placed like others, and ones that are refused,
// each with its reason.
#include <cstring>
#include <string>
#include <vector>

#include "scene/gltf/writer.h"
#include "tests/scene/fixture.h"

namespace solitaire {
namespace {

template <typename T>
std::string bytes_of(const std::vector<T>& numbers) {
  std::string bytes(numbers.size() * sizeof(T), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

/// A folder with the triangle of the fixture, which is 2 wide, 1 deep and 3 high, and what tests change in
/// it.
class Models {
 public:
  Models() : file(triangle_file(folder_.path())) {}

  /// Puts data into a file of its own and returns the number of the accessor of it.
  std::size_t add_data(const std::string& bytes, int component, const std::string& type, std::size_t count) {
    const std::string name = fmt::format("data{}.bin", file["buffers"].size());
    write_file(folder_ / name, bytes);
    file["buffers"].push_back({{"uri", name}, {"byteLength", bytes.size()}});
    file["bufferViews"].push_back(
        {{"buffer", file["buffers"].size() - 1}, {"byteOffset", 0}, {"byteLength", bytes.size()}});
    file["accessors"].push_back({{"bufferView", file["bufferViews"].size() - 1},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    return file["accessors"].size() - 1;
  }

  /// Returns the size of the model, after a scene with it was written and read back.
  Vec3 size() {
    const Asset* asset = find();
    REQUIRE(asset != nullptr);
    write_glb(build_scene({placed("model.gltf", {0, 0, 0})}, 1, "test", assets_), folder_ / "out.glb");
    return asset->box.size();
  }

  /// Returns why the model is refused; "" if it is not.
  std::string refusal() {
    return error_of([&] { find(); });
  }

  const Asset* find() {
    write_file(folder_ / "model.gltf", file.dump());
    assets_ = AssetLibrary(kAssets, folder_.path());
    return assets_.find("model.gltf");
  }

  std::vector<std::string> notes() const { return assets_.notes(); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  AssetLibrary assets_{kAssets, folder_.path()};

 public:
  json file;
};

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("scene: sparse accessors are filled in") {
  Models models;
  models.add_data(bytes_of<std::uint16_t>({2}), 5123, "SCALAR", 1);
  models.add_data(bytes_of<float>({1, 9, -4.5F}), 5126, "VEC3", 1);
  const std::size_t views = models.file["bufferViews"].size();
  models.file["accessors"][0]["sparse"] = {{"count", 1},
                                           {"indices", {{"bufferView", views - 2}, {"componentType", 5123}}},
                                           {"values", {{"bufferView", views - 1}}}};
  check_point(models.size(), {2, 9, 5});
  models.file["accessors"][0].erase("bufferView");  // what is not replaced is zero
  check_point(models.size(), {1, 9, 4.5});
  models.file["accessors"][0]["sparse"]["count"] = 2;
  CHECK(says(models.refusal(), "reaches out of its buffer"));
  models.file["accessors"][0]["sparse"]["count"] = 1;
  models.file["accessors"][0]["count"] = 2;
  CHECK(says(models.refusal(), "replaces an element that it does not have"));
}

TEST_CASE("scene: quantized attributes become floats") {
  Models models;
  const auto positions = models.add_data(
      bytes_of<std::int16_t>({-32767, 0, 0, 0, 32767, 0, 0, 0, 0, 32767, 16384, 0}), 5122, "VEC3", 3);
  models.file["accessors"][positions]["normalized"] = true;
  models.file["bufferViews"].back()["byteStride"] = 8;
  models.file["extensionsRequired"] = models.file["extensionsUsed"] = {"KHR_mesh_quantization"};
  models.file["nodes"][0]["scale"] = {3, 3, 3};
  for (json& primitive : models.file["meshes"][0]["primitives"])
    primitive["attributes"]["POSITION"] = positions;
  check_point(models.size(), {6, 3, 1.5}, 1e-4);
  models.file["accessors"][positions]["normalized"] = false;
  check_point(models.size(), {3.0 * 65534, 3.0 * 32767, 3.0 * 16384}, 1e-4);
}

TEST_CASE("scene: instances are placed, each in its place") {
  Models models;
  const auto moved = models.add_data(bytes_of<float>({0, 0, 0, 10, 0, 0, 20, 0, 0}), 5126, "VEC3", 3);
  models.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = moved;
  models.file["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  check_point(models.size(), {22, 3, 1});
  const auto scaled = models.add_data(bytes_of<float>({1, 1, 1, 1, 2, 1, 1, 1, 1}), 5126, "VEC3", 3);
  models.file["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = scaled;
  check_point(models.size(), {22, 6, 1});
  models.file["accessors"][scaled]["count"] = 2;
  CHECK(says(models.refusal(), "the attributes of its instances have different lengths"));
}

TEST_CASE("scene: URIs name files as they are written, and decoded") {
  for (const std::string name : {"a+b.bin", "model 10%.bin", "100%25.bin"}) {
    CAPTURE(name);
    Models models;
    fs::rename(models.folder() / "triangle.bin", models.folder() / name);
    models.file["buffers"][0]["uri"] = name;
    check_point(models.size(), {2, 3, 1});
  }
  Models models;
  fs::rename(models.folder() / "triangle.bin", models.folder() / "a b+c%.bin");
  models.file["buffers"][0]["uri"] = "a%20b%2Bc%25.bin";
  check_point(models.size(), {2, 3, 1});
}

TEST_CASE("scene: data URIs may have parameters, and are not repeated in errors") {
  Models models;
  // Three corners and three indices, as the fixture has them.
  const std::string data =
      "AACAvwAAAAAAAAA/AACAPwAAAAAAAAA/AACAPwAAQEAAAAC/AAAAAAAAAAAAAIA/AAAAAAAAgD8AAIA/AAABAAIAAAA=";
  models.file["buffers"][0]["uri"] = "data:application/octet-stream;charset=utf-8;base64," + data;
  check_point(models.size(), {2, 3, 1});
  models.file["buffers"][0]["uri"] =
      "data:application/octet-stream;charset=utf-8," + std::string(100'000, 'A');
  CHECK(says(models.refusal(), "its data URI is not base64: data:application"));
  CHECK(models.refusal().size() < 300);
  models.file["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA" + std::string(100'000, 'A');
  CHECK(models.refusal() != "");
  CHECK(models.refusal().size() < 500);
}

TEST_CASE("scene: a model that cannot be read says why") {
  const auto refusal = [](const std::function<void(Models&)>& change) {
    Models models;
    change(models);
    return models.refusal();
  };
  CHECK(says(refusal([](Models& m) { m.file["asset"]["version"] = "1.0"; }), "it is a file of glTF 1.0"));
  CHECK(says(refusal([](Models& m) {
               m.file = {{"asset", {{"version", "1.0"}}}, {"scene", "s"}, {"nodes", {{"n", json::object()}}}};
             }),
             "it is a file of glTF 1.0"));
  CHECK(says(refusal([](Models& m) { m.file["images"][0]["uri"] = "../textures/t.png"; }),
             "../textures/t.png lies outside of the model's folder"));
  for (const std::string extension : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    CAPTURE(extension);
    const std::string why = refusal([&](Models& m) {
      m.file["extensionsRequired"] = {extension};
      m.file["accessors"][0].erase("bufferView");  // it would hold what the extension unpacks
      m.file["buffers"].push_back({{"byteLength", 40}});
    });
    CHECK(says(why, "it needs the extension " + extension + ", which is not supported"));
  }
  CHECK(says(refusal([](Models& m) {
               m.file["nodes"][0]["translation"] = {"a", 0, 0};
             }),
             "a translation in its nodes is no list of numbers"));
  CHECK(says(refusal([](Models& m) {
               m.file["nodes"][0]["translation"] = {nullptr, 0, 0};
             }),
             "a translation in its nodes is no list of numbers"));
  CHECK(says(refusal([](Models& m) { m.file["bufferViews"][0]["byteOffset"] = -4; }),
             "a byteOffset in its bufferViews is no whole number from 0"));
  CHECK(says(refusal([](Models& m) {
               m.file["nodes"][0]["translation"] = {1e308, 0, 0};
             }),
             "it reaches further than 10,000 km"));
  CHECK(says(refusal([](Models& m) {
               write_file(m.folder() / "a picture.png", std::string("RIFF\x10\0\0\0WEBPVP8 ", 16));
             }),
             "image 0 is WebP, and images have to be PNG or JPEG"));
  CHECK(says(refusal([](Models& m) { m.file["buffers"][0]["uri"] = "lost.bin"; }),
             "there is no file lost.bin"));
  CHECK(says(refusal([](Models& m) {
               fs::create_directory(m.folder() / "in");
               m.file["buffers"][0]["uri"] =
                   "../" + m.folder().path().filename().string() + "/in/../../x.bin";
               write_file(m.folder().path().parent_path() / "x.bin", "outside");
             }),
             "lies outside of the model's folder"));
  fs::remove(fs::temp_directory_path() / "x.bin");
}

TEST_CASE("scene: what a model has and its thing does not show is told, and which names became boxes") {
  Models models;
  models.file["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}}};
  models.file["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "red"}}};
  models.file["meshes"][0]["weights"] = {1.0};
  CHECK(models.find()->left_out ==
        "its lights, its further variants of materials, the shape that its morph targets give it");
  CHECK(models.notes() ==
        std::vector<std::string>{
            "model.gltf is shown without its lights, its further variants of materials, the "
            "shape that its morph targets give it"});
  AssetLibrary assets = bundled();
  for (const char* name : {"chair", "chiar", "Chair", "models/chair.obj", "box", ""}) assets.find(name);
  CHECK(assets.notes() ==
        std::vector<std::string>{"Chair (did you mean chair?), chiar (did you mean chair?), "
                                 "models/chair.obj: no model is called so, and boxes stand "
                                 "there"});
  CHECK(assets.find(std::string(300, 'a')) == nullptr);
}

TEST_CASE("scene: a file that places a model has it beside itself, or beside the script") {
  TemporaryFolder folder;
  fs::create_directories(folder / "shop/models");
  fs::copy(kAssets / "chair.glb", folder / "shop/models/stall.glb");
  fs::copy(kAssets / "table.glb", folder / "own.glb");
  AssetLibrary assets(kAssets, folder.path());
  CHECK(assets.find("models/stall.glb", "shop")->name == "stall");
  CHECK(assets.find("own.glb", "shop")->name == "own");
  CHECK(says(error_of([&] { assets.find("models/stall.glb"); }), "No such file"));
}

}  // namespace
}  // namespace solitaire
