// Whatever a model's file holds, it is placed or refused with a SceneError, and what is written is valid. The
// first bytes say whether it is a .glb.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "scene/assets.h"
#include "scene/build_scene.h"
#include "scene/error.h"
#include "scene/gltf/verify.h"
#include "scene/gltf/writer.h"

namespace {

namespace fs = std::filesystem;

/// The folder of this process. It stays, as libFuzzer ends without a word.
const fs::path& folder() {
  static const fs::path made = [] {
    std::string name = (fs::temp_directory_path() / "solitaire-gltf-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    return fs::path(name);
  }();
  return made;
}

solitaire::PlacedThing thing_of(const std::string& model) {
  solitaire::PlacedThing thing;
  thing.asset = model;
  thing.address = "place";
  thing.source = "fuzz.sol:1:1";
  thing.color = {{1, 0, 0}};
  return thing;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string model = bytes.rfind("glTF", 0) == 0 ? "model.glb" : "model.gltf";
  std::ofstream(folder() / model, std::ios::binary) << bytes;
  solitaire::AssetLibrary assets(folder() / "none", folder());
  solitaire::Scene scene;
  try {
    scene = solitaire::build_scene({thing_of(model)}, 1, "fuzz", assets);
  } catch (const solitaire::SceneError&) {
    return 0;
  }
  const fs::path written = folder() / "written.glb";
  solitaire::write_glb(scene, written);
  solitaire::verify_glb(written, scene);
  return 0;
}
