#include "scene/gltf/reader.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

#include "scene/error.h"
#include "scene/gltf/check.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 1u << 30;  // bytes; glTF's own limit for a .glb is four times that
constexpr int kDeepestJson = 200;                  // tinygltf recurses over extras

std::vector<unsigned char> read_bytes(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) throw SceneError("there is no such file");
  if (fs::file_size(file, error) > kLargestFile) throw SceneError("it is larger than 1 GiB");
  std::ifstream stream(file, std::ios::binary);
  std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream || bytes.empty()) throw SceneError("it is empty or cannot be read");
  return bytes;
}

// tinygltf's own callbacks also search the working directory and anything an absolute path names.
bool lies_within(const fs::path& folder, const fs::path& file) {
  const fs::path relative = fs::weakly_canonical(file).lexically_relative(fs::canonical(folder));
  return !relative.empty() && *relative.begin() != "..";
}

tinygltf::FsCallbacks confined_to(const fs::path& folder) {
  tinygltf::FsCallbacks callbacks{};
  callbacks.user_data = const_cast<fs::path*>(&folder);
  callbacks.FileExists = [](const std::string& file, void* user_data) {
    std::error_code error;
    return fs::is_regular_file(file, error) && lies_within(*static_cast<const fs::path*>(user_data), file);
  };
  callbacks.ExpandFilePath = [](const std::string& file, void*) { return file; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& file,
                               void*) {
    *out = read_bytes(file);
    return true;
  };
  return callbacks;
}

// Keeps images compressed, for copying. Those in buffer views stay there: their ranges are not checked yet.
bool keep_image(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                int size, void*) {
  if (image->bufferView == -1) image->image.assign(bytes, bytes + size);
  image->as_is = true;
  return true;
}

void check_nesting(const unsigned char* text, std::size_t size) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < size; ++i) {
    const unsigned char c = text[i];
    if (in_string && c == '\\') {
      ++i;
    } else if (c == '"') {
      in_string = !in_string;
    } else if (!in_string && (c == '[' || c == '{')) {
      if (++depth > kDeepestJson) throw SceneError("its JSON is nested too deeply");
    } else if (!in_string && (c == ']' || c == '}')) {
      --depth;
    }
  }
}

bool is_binary(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view kMagic = "glTF";
  return bytes.size() >= 4 && std::equal(kMagic.begin(), kMagic.end(), bytes.begin());
}

std::size_t json_bytes(const std::vector<unsigned char>& glb) {
  if (glb.size() < 20) throw SceneError("it is too short for a .glb");
  const std::size_t stated = glb[12] | glb[13] << 8 | glb[14] << 16 | static_cast<std::size_t>(glb[15]) << 24;
  return std::min(stated, glb.size() - 20);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

tinygltf::Model parse(const std::vector<unsigned char>& bytes, const fs::path& folder) {
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(confined_to(folder));
  reader.SetImageLoader(keep_image, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const auto size = static_cast<unsigned>(bytes.size());
  bool good = false;
  if (is_binary(bytes)) {
    check_nesting(bytes.data() + 20, json_bytes(bytes));
    good = reader.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(), size, folder.string());
  } else {
    check_nesting(bytes.data(), bytes.size());
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    good = reader.LoadASCIIFromString(&model, &error, &warning, text, size, folder.string());
  }
  if (!good) throw SceneError(error.empty() ? "it is no glTF file" : first_line(error));
  check_model(model);
  return model;
}

}  // namespace

tinygltf::Model read_gltf(const fs::path& file) {
  try {
    const auto bytes = read_bytes(file);
    const fs::path folder = fs::absolute(file).parent_path();
    return parse(bytes, folder);
  } catch (const std::exception& reason) {  // tinygltf lets some of the standard library's through
    throw SceneError(fmt::format("cannot read {}: {}", file.string(), reason.what()));
  }
}

}  // namespace solitaire
