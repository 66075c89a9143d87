#include "converters/usd/usd_mesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "converters/text_encoding.h"

namespace convert {
namespace {

using grf::Vec3d;
using grf::Vec3f;

/// Puts one mesh.
class UsdMeshWriter {
 public:
  UsdMeshWriter(UsdText& text, const UsdMesh& usd_mesh, const ExchangeMaterials& materials, Losses& losses)
      : text_(text),
        usd_mesh_(usd_mesh),
        mesh_(*usd_mesh.mesh),
        geometry_(*mesh_.geometry),
        materials_(materials),
        losses_(losses) {}

  std::vector<std::pair<std::string, std::size_t>> put();

 private:
  const ExchangeMaterial& material_of(std::size_t face) const {
    return materials_.all()[usd_mesh_.materials[(*mesh_.surface_of_face)[face]]];
  }
  std::size_t face_of_corner(std::size_t corner) const {
    const auto& offsets = geometry_.face_offsets;
    return static_cast<std::size_t>(std::upper_bound(offsets.begin(), offsets.end(), corner) -
                                    offsets.begin() - 1);
  }
  void put_sides();
  void put_positions();
  void put_normals();
  void put_coordinates();
  void put_colours();

  UsdText& text_;
  const UsdMesh& usd_mesh_;
  const grf::Mesh& mesh_;
  const grf::Geometry& geometry_;
  const ExchangeMaterials& materials_;
  Losses& losses_;
};

// Faces of GRF reflect on both sides, and emit from their front.
void UsdMeshWriter::put_sides() {
  std::size_t emitting = 0;
  for (std::size_t i = 0; i < mesh_.face_count(); ++i) {
    if (material_of(i).shaded.surface.emission) ++emitting;
  }
  const bool only_emits = emitting > 0 && emitting == mesh_.face_count();
  if (!only_emits) losses_.add(Loss::EmissionOfOneSide, emitting);
  text_.line(fmt::format("uniform bool doubleSided = {}", only_emits ? 0 : 1));
}

void UsdMeshWriter::put_positions() {
  grf::Box3f box;
  for (const Vec3f& position : geometry_.positions) box.extendBy(position);
  text_.line(fmt::format("float3[] extent = [{}, {}]", usd_tuple(box.min), usd_tuple(box.max)));
  text_.array("int[] faceVertexCounts", mesh_.face_count(),
              [&](std::size_t i) { return fmt::format("{}", mesh_.face(i).size()); });
  text_.array("int[] faceVertexIndices", geometry_.corners.size(),
              [&](std::size_t i) { return fmt::format("{}", geometry_.corners[i]); });
  text_.array("point3f[] points", geometry_.positions.size(),
              [&](std::size_t i) { return usd_tuple(geometry_.positions[i]); });
}

// Faces with a corner that lacks a normal are flat, so that their corners get the face's own.
void UsdMeshWriter::put_normals() {
  const auto& normals = geometry_.normals;
  if (normals.empty()) return;
  const std::size_t vertices = geometry_.positions.size();
  bool all = true;
  for (std::size_t i = 0; i < vertices; ++i) all = all && normals.has(i) && normals[i].length() > 0;
  if (all) {
    return text_.array(
        "normal3f[] normals", vertices,
        [&](std::size_t i) { return usd_tuple(Vec3f(Vec3d(normals[i]).normalized())); },
        " ( interpolation = \"vertex\" )");
  }
  const auto has = [&](std::uint32_t vertex) { return normals.has(vertex) && normals[vertex].length() > 0; };
  text_.array(
      "normal3f[] normals", geometry_.corners.size(),
      [&](std::size_t corner) {
        const std::size_t face = face_of_corner(corner);
        const auto corners = mesh_.face(face);
        const Vec3d normal = std::all_of(corners.begin(), corners.end(), has)
                                 ? Vec3d(normals[geometry_.corners[corner]])
                                 : grf::doubled_area_vector(geometry_, face, grf::Matrix44d());
        return usd_tuple(Vec3f(normal.normalized()));
      },
      " ( interpolation = \"faceVarying\" )");
}

void UsdMeshWriter::put_coordinates() {
  const auto& uvs = geometry_.uvs;
  if (uvs.empty()) return;
  text_.array(
      "texCoord2f[] primvars:st", geometry_.positions.size(),
      [&](std::size_t i) { return usd_tuple(uvs.has(i) ? uvs[i] : grf::Vec2f(0)); },
      " ( interpolation = \"vertex\" )");
}

// The preview surface has one colour, which is the product of base and vertices; MaterialX multiplies itself.
void UsdMeshWriter::put_colours() {
  const auto& colours = geometry_.colours;
  const auto base_of = [&](std::size_t face) { return material_of(face).preview.base; };
  if (colours.empty()) {
    return text_.array(
        "color3f[] primvars:displayColor", mesh_.face_count(),
        [&](std::size_t i) { return usd_tuple(base_of(i)); }, " ( interpolation = \"uniform\" )");
  }
  const auto colour_of = [&](std::size_t i) { return colours.has(i) ? colours[i] : grf::Colour(1); };
  text_.array(
      "color3f[] primvars:displayColor", geometry_.corners.size(),
      [&](std::size_t i) {
        return usd_tuple(base_of(face_of_corner(i)) * Vec3d(colour_of(geometry_.corners[i])));
      },
      " ( interpolation = \"faceVarying\" )");
  text_.array(
      fmt::format("color3f[] primvars:{}", VertexColours), geometry_.positions.size(),
      [&](std::size_t i) { return usd_tuple(colour_of(i)); }, " ( interpolation = \"vertex\" )");
}

std::vector<std::pair<std::string, std::size_t>> UsdMeshWriter::put() {
  std::vector<std::string> metadata;
  if (!usd_mesh_.original.empty()) {
    metadata = usd_custom_data(std::array{"string name = " + usd_string(usd_mesh_.original)});
  }
  text_.begin(fmt::format("def Mesh \"{}\"", usd_mesh_.name), metadata);
  put_sides();
  text_.line("uniform token orientation = \"rightHanded\"");
  text_.line("uniform token subdivisionScheme = \"none\"");
  put_positions();
  put_normals();
  put_coordinates();
  put_colours();
  text_.line("uniform token subsetFamily:materialBind:familyType = \"partition\"");
  std::map<std::size_t, std::vector<std::size_t>> faces_of_material;
  for (std::size_t i = 0; i < mesh_.face_count(); ++i)
    faces_of_material[usd_mesh_.materials[(*mesh_.surface_of_face)[i]]].push_back(i);
  std::vector<std::pair<std::string, std::size_t>> subsets;
  for (const auto& [material, faces] : faces_of_material) {
    const std::string& name = materials_.all()[material].name;
    const std::vector<std::string> apis = {"prepend apiSchemas = [\"MaterialBindingAPI\"]"};
    text_.begin(fmt::format("def GeomSubset \"{}\"", name), apis);
    text_.line("uniform token elementType = \"face\"");
    text_.line("uniform token familyName = \"materialBind\"");
    text_.array("int[] indices", faces.size(),
                [&faces = faces](std::size_t i) { return fmt::format("{}", faces[i]); });
    text_.line(fmt::format("rel material:binding = <{}/{}>", usd_mesh_.looks, name));
    text_.end();
    subsets.emplace_back(name, material);
  }
  text_.end();
  return subsets;
}

}  // namespace

std::vector<std::pair<std::string, std::size_t>> put_usd_mesh(UsdText& text, const UsdMesh& usd_mesh,
                                                              const ExchangeMaterials& materials,
                                                              Losses& losses) {
  return UsdMeshWriter(text, usd_mesh, materials, losses).put();
}

}  // namespace convert
