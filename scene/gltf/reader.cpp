#include "scene/gltf/reader.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "scene/gltf/check.h"
#include "scene/gltf/plain_model.h"
#include "scene/gltf/source_json.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 1u << 30;  // bytes; glTF's own limit for a .glb is four times that
constexpr int kDeepestJson = 200;                  // tinygltf recurses over extras

std::vector<unsigned char> read_bytes(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) throw SceneError("there is no such file");
  const std::uintmax_t size = fs::file_size(file, error);
  if (size > kLargestFile) throw SceneError("it is larger than 1 GiB");
  std::ifstream stream(file, std::ios::binary);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(size));
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (!stream || bytes.empty()) throw SceneError("it is empty or cannot be read");
  return bytes;
}

// tinygltf's own callbacks also search the working directory and anything an absolute path names.
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

constexpr std::size_t kHeaderBytes = 20;  // of a .glb, with those of its JSON

std::size_t json_bytes(const std::vector<unsigned char>& glb) {
  if (glb.size() < kHeaderBytes) throw SceneError("it is too short for a .glb");
  const std::size_t stated = glb[12] | glb[13] << 8 | glb[14] << 16 | static_cast<std::size_t>(glb[15]) << 24;
  return std::min(stated, glb.size() - kHeaderBytes);
}

void write_word(std::vector<unsigned char>& bytes, std::size_t at, std::size_t value) {
  for (unsigned i = 0; i < 4; ++i) bytes[at + i] = static_cast<unsigned char>(value >> (8 * i));
}

/// Returns the .glb with other JSON.
std::vector<unsigned char> with_json(const std::vector<unsigned char>& glb, std::string text) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::size_t rest = kHeaderBytes + json_bytes(glb);
  std::vector<unsigned char> made(kHeaderBytes + text.size() + glb.size() - rest);
  std::copy_n(glb.begin(), kHeaderBytes, made.begin());
  std::copy(text.begin(), text.end(), made.begin() + kHeaderBytes);
  std::copy_n(glb.end() - static_cast<std::ptrdiff_t>(glb.size() - rest), glb.size() - rest,
              made.end() - static_cast<std::ptrdiff_t>(glb.size() - rest));
  write_word(made, 8, made.size());
  write_word(made, 12, text.size());
  return made;
}

/// Returns the file as tinygltf can read it.
std::vector<unsigned char> prepared(std::vector<unsigned char> bytes, const fs::path& folder) {
  const std::size_t begin = is_binary(bytes) ? kHeaderBytes : 0;
  const std::size_t size = is_binary(bytes) ? json_bytes(bytes) : bytes.size();
  check_nesting(bytes.data() + begin, size);
  const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
  auto document = nlohmann::json::parse(first, first + static_cast<std::ptrdiff_t>(size), nullptr, false);
  if (document.is_discarded()) throw SceneError("it is no glTF file: its JSON cannot be read");
  if (!prepare_json(document, folder)) return bytes;
  std::string text = document.dump();
  return begin > 0 ? with_json(bytes, std::move(text)) : std::vector<unsigned char>(text.begin(), text.end());
}

/// Returns what a person reads of tinygltf's message, which can repeat whole files.
std::string beginning(const std::string& text) {
  constexpr std::size_t kMost = 200;
  return text.substr(0, std::min(text.find('\n'), kMost));
}

tinygltf::Model parse(const std::vector<unsigned char>& bytes, const fs::path& folder) {
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(confined_to(folder));
  reader.SetImageLoader(keep_image, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const auto size = static_cast<unsigned>(bytes.size());
  bool good = false;
  if (is_binary(bytes)) {
    good = reader.LoadBinaryFromMemory(&model, &error, &warning, bytes.data(), size, folder.string());
  } else {
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    good = reader.LoadASCIIFromString(&model, &error, &warning, text, size, folder.string());
  }
  if (!good) throw SceneError(error.empty() ? "it is no glTF file" : beginning(error));
  return model;
}

/// Returns what read() makes of the file, with an error that names it.
template <typename Read>
tinygltf::Model checked(const fs::path& file, const Read& read) {
  try {
    tinygltf::Model model = read(fs::absolute(file).parent_path());
    check_model(model);
    return model;
  } catch (const std::exception& reason) {  // tinygltf lets some of the standard library's through
    throw SceneError(fmt::format("cannot read {}: {}", file.string(), reason.what()));
  }
}

}  // namespace

tinygltf::Model read_gltf(const fs::path& file) {
  return checked(file, [&](const fs::path& folder) {
    tinygltf::Model model = parse(prepared(read_bytes(file), folder), folder);
    make_plain(model);
    return model;
  });
}

tinygltf::Model read_written_gltf(const fs::path& file) {
  return checked(file, [&](const fs::path& folder) { return parse(read_bytes(file), folder); });
}

}  // namespace solitaire
