#include "scene/gltf/writer.h"

#include <fmt/format.h>
#include <map>
#include <ostream>
#include <streambuf>
#include <tiny_gltf.h>

#include "scene/atomic_file.h"
#include "scene/error.h"
#include "scene/gltf/asset_model.h"
#include "scene/gltf/box_mesh.h"
#include "scene/gltf/extras.h"
#include "scene/gltf/merged_mesh.h"
#include "scene/gltf/mesh_builder.h"
#include "scene/gltf/mesh_copy.h"
#include "scene/gltf/staging.h"
#include "scene/gltf/verify.h"
#include "scene/names.h"
#include "scene/openings.h"

namespace solitaire {
namespace {

constexpr std::size_t kLargestGlb = 0x7fffffff;  // bytes; tinygltf writes offsets as 32-bit ints

bool shows_something(const tinygltf::Model& model, int index) {
  const auto& node = model.nodes[static_cast<std::size_t>(index)];
  if (node.mesh != -1) return true;
  for (const int child : node.children) {
    if (shows_something(model, child)) return true;
  }
  return false;
}

void set_transform(tinygltf::Node& node, const Transform& transform) {
  const Transform none;
  const auto set = [](std::vector<double>& member, const auto& value, const auto& standard) {
    if (value != standard) member.assign(value.begin(), value.end());
  };
  set(node.translation, transform.translation, none.translation);
  set(node.rotation, transform.rotation, none.rotation);
  set(node.scale, transform.scale, none.scale);
}

class ModelBuilder {
 public:
  ModelBuilder(const Scene& scene, Nodes nodes) : scene_(scene), nodes_(nodes) {
    for (const SceneNode& node : scene.nodes) names_.take(node.name);  // before any node within an asset
  }

  tinygltf::Model build() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Solitaire";
    model_.buffers.emplace_back();
    tinygltf::Scene shown;
    shown.name = scene_.nodes.front().name;
    shown.nodes.push_back(add(scene_.nodes.front()));
    add_stage(model_, shown, scene_, names_);
    if (nodes_ == Nodes::kChunks) remove_unused_meshes(model_);
    model_.scenes.push_back(std::move(shown));
    model_.defaultScene = 0;
    if (model_.buffers.front().data.empty()) model_.buffers.clear();
    return std::move(model_);
  }

 private:
  int add(const SceneNode& source) {
    tinygltf::Node node;
    node.name = source.name;
    if (source.object) fill(node, scene_.objects[*source.object]);
    const int index = append(std::move(node));
    for (const std::vector<std::size_t>& part : parts_of(scene_, source, nodes_)) {
      const int child_index = part.size() == 1           ? add(scene_.nodes[part.front()])
                              : nodes_ == Nodes::kChunks ? add_merged(part)
                                                         : add_instances(part);
      model_.nodes[static_cast<std::size_t>(index)].children.push_back(child_index);
    }
    return index;
  }

  int add_instances(const std::vector<std::size_t>& instances) {
    const SceneObject& first = scene_.objects[*scene_.nodes[instances.front()].object];
    tinygltf::Node node;
    fill(node, first);
    node.translation.clear(), node.rotation.clear(), node.scale.clear();
    node.name = names_.take(plain_name(first) + " instances");
    make_instances(model_, node, scene_, instances, nodes_);
    return append(std::move(node));
  }

  int add_merged(const std::vector<std::size_t>& alike) {
    const SceneObject& first = scene_.objects[*scene_.nodes[alike.front()].object];
    tinygltf::Node pattern;
    fill(pattern, first);
    std::vector<Transform> transforms;
    for (const std::size_t each : alike)
      transforms.push_back(scene_.objects[*scene_.nodes[each].object].node_transform);
    tinygltf::Node node;
    node.name = names_.take(plain_name(first) + " chunk");
    node.mesh = merged_mesh(model_, pattern.mesh, transforms);
    return append(std::move(node));
  }

  void fill(tinygltf::Node& node, const SceneObject& object) {
    set_transform(node, object.node_transform);
    node.extras = make_extras(object.thing);
    if (!object.openings.empty()) {
      node.mesh = wall_with_openings(object, node.name);
    } else if (!object.outline.empty()) {
      node.mesh = body_over_outline(object, node.name);
    } else if (!object.asset) {
      node.mesh = boxes_.mesh(*object.paint);
    } else if (const AssetModel& model = *object.asset->model; model.is_single_mesh()) {
      const auto& root = model.gltf.nodes[static_cast<std::size_t>(model.roots.front())];
      node.mesh = copier(*object.asset).mesh(root.mesh, object.paint);
    } else {
      node.children = copy_nodes(*object.asset, model.roots, object.paint);
    }
  }

  /// A wall with openings has a mesh of its own, made of blocks.
  int wall_with_openings(const SceneObject& object, const std::string& name) {
    MeshBuilder builder;
    for (const Box3& part : solid_parts(object.asset ? object.asset->box : unit_box(), object.openings))
      builder.add_box(part);
    return append(
        builder, name,
        object.asset ? copier(*object.asset).primary_material(object.paint) : boxes_.material(*object.paint));
  }

  int body_over_outline(const SceneObject& object, const std::string& name) {
    MeshBuilder builder;
    for (const std::vector<Vec3>& face : faces_over(object.outline)) builder.face(face);
    return append(builder, name, boxes_.material(*object.paint));
  }

  int append(const MeshBuilder& builder, const std::string& name, int material) {
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(builder.write(model_));
    mesh.primitives.back().material = material;
    model_.meshes.push_back(std::move(mesh));
    return static_cast<int>(model_.meshes.size()) - 1;
  }

  std::vector<int> copy_nodes(const Asset& asset, const std::vector<int>& nodes,
                              const std::optional<Paint>& paint) {
    std::vector<int> copies;
    for (const int index : nodes) {
      if (shows_something(asset.model->gltf, index)) copies.push_back(copy_node(asset, index, paint));
    }
    return copies;
  }

  int copy_node(const Asset& asset, int index, const std::optional<Paint>& paint) {
    const auto& source = asset.model->gltf.nodes[static_cast<std::size_t>(index)];
    tinygltf::Node copy;
    copy.name = names_.take(source.name.empty() ? asset.name + " part" : source.name);
    copy.translation = source.translation;
    copy.rotation = source.rotation;
    copy.scale = source.scale;
    copy.matrix = source.matrix;
    copy.extras = source.extras;
    if (source.mesh != -1) copy.mesh = copier(asset).mesh(source.mesh, paint);
    copy.children = copy_nodes(asset, source.children, paint);
    return append(std::move(copy));
  }

  MeshCopier& copier(const Asset& asset) {
    return copiers_.try_emplace(&asset, *asset.model, asset.name, model_).first->second;
  }

  int append(tinygltf::Node node) {
    model_.nodes.push_back(std::move(node));
    return static_cast<int>(model_.nodes.size()) - 1;
  }

  const Scene& scene_;
  Nodes nodes_;
  tinygltf::Model model_;
  UniqueNames names_;
  BoxMeshes boxes_{model_};
  std::map<const Asset*, MeshCopier> copiers_;  // looked up only: its order never shows
};

/// Appends what is written to a text. A string stream would double its buffer again and again, and with it
/// the memory that a large scene takes.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string& text) : text_(text) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize size) override {
    text_.append(bytes, static_cast<std::size_t>(size));
    return size;
  }
  int_type overflow(int_type byte) override {
    if (!traits_type::eq_int_type(byte, traits_type::eof())) text_.push_back(traits_type::to_char_type(byte));
    return traits_type::not_eof(byte);
  }

 private:
  std::string& text_;
};

}  // namespace

std::string glb_bytes(const Scene& scene, Nodes nodes) {
  tinygltf::Model model = ModelBuilder(scene, nodes).build();
  std::string bytes;
  TextBuffer buffer(bytes);
  std::ostream stream(&buffer);
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, stream, /*prettyPrint=*/false, /*writeBinary=*/true) ||
      !stream) {
    throw SceneError("tinygltf could not write the scene");
  }
  if (bytes.size() > kLargestGlb) throw SceneError("the scene is too large for a .glb");
  return bytes;
}

std::string write_glb(const Scene& scene, const std::filesystem::path& path, Nodes nodes) {
  try {
    std::string bytes = glb_bytes(scene, nodes);
    write_file_atomically(path, bytes,
                          [&](const std::filesystem::path& written) { verify_glb(written, scene, nodes); });
    return bytes;
  } catch (const SceneError& error) {
    const std::string_view reason = error.what();
    if (reason.find(path.string()) != std::string_view::npos) throw;
    throw SceneError(fmt::format("cannot write {}: {}", path.string(), reason));
  }
}

}  // namespace solitaire
