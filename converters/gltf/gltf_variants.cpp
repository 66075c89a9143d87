#include "converters/gltf/gltf_variants.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "converters/wording.h"

namespace convert {
namespace {

using tinygltf::Value;

constexpr const char* Variants = "KHR_materials_variants";

/// Returns a member of an object that is an array, or an empty array.
Value::Array list_of(const Value& object, const char* name) {
  if (!object.IsObject() || !object.Has(name) || !object.Get(name).IsArray()) return {};
  return object.Get(name).Get<Value::Array>();
}

std::vector<std::string> names_of(const tinygltf::Model& model) {
  std::vector<std::string> names;
  const auto extension = model.extensions.find(Variants);
  if (extension == model.extensions.end()) return names;
  for (const Value& variant : list_of(extension->second, "variants")) {
    const bool has_name = variant.IsObject() && variant.Has("name") && variant.Get("name").IsString();
    names.push_back(has_name ? variant.Get("name").Get<std::string>() : std::string());
  }
  return names;
}

/// Returns the material of a mapping that lists the variant, or -1.
int material_of(const Value& mapping, int variant) {
  const Value::Array variants = list_of(mapping, "variants");
  const bool is_listed = std::any_of(variants.begin(), variants.end(), [variant](const Value& each) {
    return each.IsInt() && each.Get<int>() == variant;
  });
  if (!is_listed || !mapping.Has("material") || !mapping.Get("material").IsInt()) return -1;
  return mapping.Get("material").Get<int>();
}

void assign_variant(tinygltf::Primitive& primitive, int variant) {
  const auto extension = primitive.extensions.find(Variants);
  if (extension == primitive.extensions.end()) return;
  for (const Value& mapping : list_of(extension->second, "mappings")) {
    const int material = material_of(mapping, variant);
    if (material >= 0) primitive.material = material;
  }
}

}  // namespace

bool choose_variant(GltfFile& file, const std::string& name, grf::Diagnostics& diagnostics) {
  const std::vector<std::string> names = names_of(file.model);
  const grf::SourceLocation location = grf::whole_file(file.path);
  if (name.empty()) {
    if (!names.empty()) {
      diagnostics.note(location, fmt::format("the file has {} of its materials, {}; the default one is read",
                                             counted(names.size(), "variant", "variants"), listed(names)));
    }
    return true;
  }
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    diagnostics.error(
        location, names.empty() ? fmt::format("the file has no variants, expected '{}'", name)
                                : fmt::format("the file has no variant '{}', only {}", name, listed(names)));
    return false;
  }
  for (tinygltf::Mesh& mesh : file.model.meshes) {
    for (tinygltf::Primitive& primitive : mesh.primitives) {
      assign_variant(primitive, static_cast<int>(found - names.begin()));
    }
  }
  return true;
}

}  // namespace convert
