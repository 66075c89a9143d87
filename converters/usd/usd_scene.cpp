#include "converters/usd/usd_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "converters/text_encoding.h"
#include "converters/usd/usd_material.h"
#include "converters/usd/usd_mesh.h"
#include "converters/usd/usd_text.h"
#include "converters/usd/usd_view.h"
#include "grf/keywords.h"
#include "grf/unique_names.h"
#include "grf/visit.h"

namespace convert {
namespace {

using grf::Vec3d;

const std::string World = "/World";

grf::Mesh parallelogram_of(const grf::AreaLight& light) {
  grf::MeshDraft mesh;
  mesh.positions = {light.corner, light.corner + light.edge1, light.corner + light.edge1 + light.edge2,
                    light.corner + light.edge2};
  mesh.surfaces.front().colour = light.radiance.value_or(grf::Colour(1));
  mesh.add_face(std::array<std::uint32_t, 4>{0, 1, 2, 3}, 0);
  return mesh;
}

bool is_rectangle(const grf::AreaLight& light) {
  const Vec3d a(light.edge1);
  const Vec3d b(light.edge2);
  return a.length() > 0 && b.length() > 0 && std::abs(a.dot(b)) <= 1e-6 * a.length() * b.length();
}

/// The prim that children are put into.
struct UsdParent {
  std::string path;
  grf::UniqueNames names;
};

/// A mesh definition, which instances refer to.
struct UsdPrototype {
  std::string path;
  std::vector<std::pair<std::string, std::size_t>> subsets;  ///< paths below it, and their materials
};

/// Writes the blocks of a scene as prims.
class UsdSceneWriter {
 public:
  explicit UsdSceneWriter(UsdScene& result) : result_(result) {}

  bool write(const grf::Scene& scene, const std::string& path, const WriteOptions* options,
             grf::Diagnostics& diagnostics);

 private:
  void put_blocks(const grf::BlockList& list, UsdParent& parent);
  void put(const grf::Shared<grf::Mesh>& mesh, UsdParent& parent);
  void put(const grf::MeshLight& light, UsdParent& parent);
  void put(const grf::AreaLight& light, UsdParent& parent);
  void put(const grf::Include&, UsdParent&) {}  // the scene has none
  void put(const grf::Transform& transform, UsdParent& parent);
  void put(const grf::DefinitionScope& scope, UsdParent& parent);
  void put(const grf::Params& params, UsdParent&) { result_.losses.add(Loss::Observer, params.views.size()); }
  void put(const grf::Use& use, UsdParent& parent);
  void put_lamp(const grf::Mesh& mesh, UsdParent& parent);
  void put_prototype(const grf::Definition& definition, const grf::Mesh& mesh);
  std::vector<std::size_t> materials_of(const grf::Mesh& mesh);
  void assign(const std::string& path, const std::vector<std::pair<std::string, std::size_t>>& subsets);
  void put_looks(UsdText& text, const std::string& parent, const std::set<std::size_t>& materials);
  std::string header(const std::string& body) const;

  UsdScene& result_;
  UsdText world_;
  UsdText prototypes_;
  grf::UniqueNames prototype_names_;
  std::map<const grf::Definition*, UsdPrototype> prototype_of_;
  std::set<std::size_t> used_materials_;  ///< of meshes that are no prototypes
  grf::ScopeStack scope_;
};

void UsdSceneWriter::put_blocks(const grf::BlockList& list, UsdParent& parent) {
  for (const grf::Block& block : list.blocks)
    std::visit([&](const auto& content) { put(content, parent); }, block.content);
}

std::vector<std::size_t> UsdSceneWriter::materials_of(const grf::Mesh& mesh) {
  std::vector<std::size_t> faces(mesh.surfaces.size());
  for (const std::uint32_t surface : *mesh.surface_of_face) ++faces[surface];
  std::vector<std::size_t> materials(mesh.surfaces.size());
  const grf::Geometry& geometry = *mesh.geometry;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i] == 0) continue;
    const bool is_coloured = !geometry.colours.empty();
    materials[i] =
        result_.materials.index_of(mesh.surfaces[i], scope_.scope(), is_coloured, faces[i], result_.losses);
    const ShadedSurface& shaded = result_.materials.all()[materials[i]].shaded;
    if (is_coloured && !shaded.texture.empty()) result_.losses.add(Loss::BrdfVertexColour, faces[i]);
  }
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    if (mesh.irradiance->has(i)) result_.losses.add(Loss::Irradiance);
  }
  ++result_.meshes;
  return materials;
}

void UsdSceneWriter::assign(const std::string& path,
                            const std::vector<std::pair<std::string, std::size_t>>& subsets) {
  for (const auto& [name, material] : subsets) result_.assignments.emplace_back(material, path + "/" + name);
}

void UsdSceneWriter::put(const grf::Shared<grf::Mesh>& mesh, UsdParent& parent) {
  if (mesh->face_count() == 0) return;
  const UsdMesh usd_mesh = {&*mesh, parent.names.take(to_prim_name(mesh->name, "mesh")), to_utf8(mesh->name),
                            World + "/Looks", materials_of(*mesh)};
  const auto subsets = put_usd_mesh(world_, usd_mesh, result_.materials, result_.losses);
  for (const auto& [name, material] : subsets) used_materials_.insert(material);
  assign(parent.path + "/" + usd_mesh.name, subsets);
}

// The colour of a mesh light is its radiance.
void UsdSceneWriter::put_lamp(const grf::Mesh& mesh, UsdParent& parent) {
  if (mesh.face_count() == 0) return;
  const std::vector<bool> used = grf::used_surfaces(mesh);
  UsdMesh usd_mesh = {&mesh, parent.names.take("light"), {}, World + "/Looks", {}};
  usd_mesh.materials.resize(mesh.surfaces.size());
  for (std::size_t i = 0; i < mesh.surfaces.size(); ++i) {
    if (!used[i]) continue;
    usd_mesh.materials[i] =
        result_.materials.index_of_lamp(grf::resolve(mesh.surfaces[i], scope_.scope()).colour);
    used_materials_.insert(usd_mesh.materials[i]);
  }
  ++result_.meshes;
  assign(parent.path + "/" + usd_mesh.name,
         put_usd_mesh(world_, usd_mesh, result_.materials, result_.losses));
}

void UsdSceneWriter::put(const grf::MeshLight& light, UsdParent& parent) { put_lamp(*light.mesh, parent); }

// A `RectLight` is about its origin and emits towards -z. It has no other parallelograms.
void UsdSceneWriter::put(const grf::AreaLight& light, UsdParent& parent) {
  if (!is_rectangle(light)) return put_lamp(parallelogram_of(light), parent);
  const Vec3d a(light.edge1);
  const Vec3d b(light.edge2);
  const Vec3d x = a.normalized();
  const Vec3d z = -a.cross(b).normalized();
  const Vec3d y = z.cross(x);
  const Vec3d centre = Vec3d(light.corner) + (a + b) / 2;
  const grf::Matrix44d to_parent(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, centre.x, centre.y,
                                 centre.z, 1);
  const grf::Colour radiance = light.radiance.value_or(grf::Colour(1));
  const float intensity = std::max({radiance.x, radiance.y, radiance.z, 0.0F});
  world_.begin(fmt::format("def RectLight \"{}\"", parent.names.take("light")));
  world_.line("float inputs:width = " + usd_number(a.length()));
  world_.line("float inputs:height = " + usd_number(b.length()));
  world_.line("float inputs:intensity = " + usd_number(intensity));
  world_.line("color3f inputs:color = " + usd_tuple(intensity > 0 ? radiance / intensity : grf::Colour(0)));
  world_.line("bool inputs:normalize = 0");
  world_.line("matrix4d xformOp:transform = " + usd_matrix(to_parent));
  world_.line("uniform token[] xformOpOrder = [\"xformOp:transform\"]");
  world_.end();
}

// Matrices of USD are for row vectors, as those of GRF, and fronts stay fronts where they mirror.
void UsdSceneWriter::put(const grf::Transform& transform, UsdParent& parent) {
  UsdParent inside;
  const std::string name = parent.names.take("transform");
  inside.path = parent.path + "/" + name;
  world_.begin(fmt::format("def Xform \"{}\"", name));
  world_.line("matrix4d xformOp:transform = " + usd_matrix(grf::matrix_of(transform.steps)));
  world_.line("uniform token[] xformOpOrder = [\"xformOp:transform\"]");
  put_blocks(transform.body, inside);
  world_.end();
}

// What a reference brings must not lead out of the prototype, so that it has its own materials.
void UsdSceneWriter::put_prototype(const grf::Definition& definition, const grf::Mesh& mesh) {
  if (mesh.face_count() == 0) return;
  const std::string& own = mesh.name;
  const std::string original = own.empty() ? grf::from_identifier(definition.name) : own;
  const std::string name = prototype_names_.take(to_prim_name(original, "mesh"));
  UsdPrototype& prototype = prototype_of_[&definition];
  prototype.path = World + "/Prototypes/" + name;
  prototypes_.begin(fmt::format("def Xform \"{}\"", name));
  const UsdMesh usd_mesh = {&mesh, "mesh", to_utf8(original), prototype.path + "/Looks", materials_of(mesh)};
  std::set<std::size_t> materials;
  for (const auto& [subset, material] :
       put_usd_mesh(prototypes_, usd_mesh, result_.materials, result_.losses)) {
    prototype.subsets.emplace_back("mesh/" + subset, material);
    materials.insert(material);
  }
  put_looks(prototypes_, prototype.path, materials);
  prototypes_.end();
}

void UsdSceneWriter::put(const grf::DefinitionScope& scope, UsdParent& parent) {
  for (const grf::Definition& definition : scope.definitions) {
    if (const auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&definition.body))
      put_prototype(definition, **mesh);
    scope_.enter(definition);
  }
  put_blocks(scope.body, parent);
  scope_.leave(scope.definitions.size());
}

void UsdSceneWriter::put(const grf::Use& use, UsdParent& parent) {
  const auto found = prototype_of_.find(scope_.scope().find(use.mesh.name));
  if (found == prototype_of_.end()) return;
  const std::string original = grf::from_identifier(use.mesh.name);
  const std::string name = parent.names.take(to_prim_name(original, "instance"));
  const std::vector<std::string> metadata = {"instanceable = true",
                                             fmt::format("prepend references = <{}>", found->second.path)};
  world_.begin(fmt::format("def Xform \"{}\"", name), metadata);
  world_.end();
  assign(parent.path + "/" + name, found->second.subsets);
}

void UsdSceneWriter::put_looks(UsdText& text, const std::string& parent,
                               const std::set<std::size_t>& materials) {
  if (materials.empty()) return;
  text.begin("def Scope \"Looks\"");
  for (const std::size_t index : materials)
    put_usd_material(text, parent + "/Looks", result_.materials.all()[index]);
  text.end();
}

std::string UsdSceneWriter::header(const std::string& body) const {
  return "#usda 1.0\n(\n    defaultPrim = \"World\"\n"
         "    doc = \"Written by Granada's grfconvert. Radiances are in W/(sr m2).\"\n"
         "    metersPerUnit = 1\n    upAxis = \"Y\"\n)\n\n" +
         body;
}

grf::Box3d bounds_of(const grf::Scene& scene, std::deque<grf::Mesh>& parallelograms) {
  grf::Box3d bounds;
  const auto grow = [&](const grf::Mesh& mesh, const grf::Placement& placement) {
    for (const grf::Vec3f& position : mesh.geometry->positions)
      bounds.extendBy(Vec3d(position) * placement.to_world);
  };
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    grow(mesh, placement);
  };
  visitor.mesh_light = [&](const grf::MeshLight& light, const grf::Placement& placement, const grf::Block&) {
    grow(*light.mesh, placement);
  };
  visitor.light = [&](const grf::AreaLight& light, const grf::Placement& placement, const grf::Block&) {
    grow(parallelograms.emplace_back(parallelogram_of(light)), placement);
  };
  grf::visit(scene, visitor);
  return bounds;
}

bool UsdSceneWriter::write(const grf::Scene& scene, const std::string& path, const WriteOptions* options,
                           grf::Diagnostics& diagnostics) {
  UsdParent world;
  world.path = World;
  for (const char* taken : {"Looks", "Prototypes", "Camera", "Cameras", "Surroundings", "Render"})
    world.names.add(taken);
  world_.begin("def Xform \"World\"");
  prototypes_.begin("class \"Prototypes\"");
  put_blocks(scene.contents, world);
  put_looks(world_, World, used_materials_);
  prototypes_.end();
  if (!prototype_of_.empty()) world_.text += prototypes_.text;
  std::deque<grf::Mesh> parallelograms;
  const bool is_done =
      options == nullptr || put_usd_view(world_, World, path, *options, bounds_of(scene, parallelograms),
                                         result_.losses, diagnostics);
  world_.end();
  result_.text = header(world_.text);
  return is_done;
}

}  // namespace

UsdScene usd_scene_of(const grf::Scene& scene, const std::string& path) {
  grf::Diagnostics diagnostics;
  UsdScene result;
  UsdSceneWriter(result).write(scene, path, nullptr, diagnostics);
  return result;
}

std::optional<UsdScene> usd_scene_of(const grf::Scene& scene, const std::string& path,
                                     const WriteOptions& options, grf::Diagnostics& diagnostics) {
  std::optional<UsdScene> result(std::in_place);
  if (!UsdSceneWriter(*result).write(scene, path, &options, diagnostics)) return std::nullopt;
  return result;
}

}  // namespace convert
