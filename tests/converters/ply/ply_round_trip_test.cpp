// Generated meshes that go through PLY files and come back.
#include <algorithm>
#include <bit>
#include <memory>
#include <string>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "converters/material_mapping.h"
#include "converters/scene_building.h"
#include "grf/keywords.h"
#include "tests/converters/ply/ply_bytes.h"
#include "tests/converters/reading.h"
#include "tests/grf/scene_generator.h"

namespace convert {
namespace {

using grf::Colour;
using grf::SceneGenerator;
using grf::Vec2f;
using grf::Vec3f;

bool coin() { return *rc::gen::arbitrary<bool>(); }
int up_to(int last) { return *rc::gen::inRange(0, last + 1); }

Vec3f any_vector() { return {SceneGenerator::number(), SceneGenerator::number(), SceneGenerator::number()}; }

/// Of bytes, as most are, or of any numbers that are not negative.
Colour any_colour(bool of_bytes) {
  const auto component = [&] {
    return of_bytes ? static_cast<float>(up_to(255)) / 255.0F : std::abs(SceneGenerator::number());
  };
  return {component(), component(), component()};
}

/// Which values the vertices and faces of a mesh may have.
struct Attributes {
  bool normals = coin();
  bool uvs = coin();
  bool colours = coin();
  bool face_colours = coin();
  bool byte_colours = coin();
  bool all_have_all = coin();

  bool has(bool kind) const { return kind && (all_have_all || coin()); }
};

std::vector<grf::Surface> any_surfaces(const Attributes& attributes,
                                       const std::vector<std::string>& materials) {
  std::vector<grf::Surface> surfaces(static_cast<std::size_t>(1 + up_to(3)));
  for (grf::Surface& surface : surfaces) {
    if (attributes.has(attributes.face_colours)) surface.colour = any_colour(attributes.byte_colours);
    const int material = up_to(static_cast<int>(materials.size()));
    if (material > 0) surface.brdf = grf::Reference{materials[static_cast<std::size_t>(material - 1)], {}};
  }
  return surfaces;
}

grf::Mesh any_mesh(const Attributes& attributes, const std::vector<std::string>& materials) {
  grf::MeshDraft mesh;
  const int vertices = 3 + up_to(9);
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices); ++i) {
    mesh.positions.push_back(any_vector());
    const Vec3f normal = any_vector();
    if (attributes.has(attributes.normals) && normal != Vec3f(0)) mesh.normals.set(i, normal);
    if (attributes.has(attributes.uvs)) mesh.uvs.set(i, {SceneGenerator::number(), SceneGenerator::number()});
    if (attributes.has(attributes.colours)) mesh.colours.set(i, any_colour(attributes.byte_colours));
  }
  mesh.surfaces = any_surfaces(attributes, materials);
  for (int faces = 1 + up_to(5); faces > 0; --faces) {
    std::vector<std::uint32_t> corners(static_cast<std::size_t>(3 + up_to(3)));
    for (std::uint32_t& corner : corners) corner = static_cast<std::uint32_t>(up_to(vertices - 1));
    mesh.add_face(corners, static_cast<std::uint32_t>(up_to(static_cast<int>(mesh.surfaces.size()) - 1)));
  }
  return mesh;
}

std::vector<std::string> any_materials() {
  DefinitionNames names;
  std::vector<std::string> materials;
  for (int i = up_to(3); i > 0; --i) materials.push_back(names.take(*rc::gen::arbitrary<std::string>()));
  return materials;
}

grf::Scene scene_of_mesh(const grf::Mesh& mesh, const std::vector<std::string>& materials) {
  std::vector<grf::Definition> definitions;
  for (const std::string& name : materials) definitions.push_back({name, default_brdf(), {}, {}});
  std::vector<grf::Block> blocks(1);
  blocks.front().content = grf::Shared<grf::Mesh>(mesh);
  return scene_of(std::move(definitions), std::move(blocks), {});
}

bool same_bits(const auto& a, const auto& b) {
  for (unsigned i = 0; i < a.dimensions(); ++i) {
    const int k = static_cast<int>(i);
    if (std::bit_cast<std::uint32_t>(a[k]) != std::bit_cast<std::uint32_t>(b[k])) return false;
  }
  return true;
}

Colour colour_of(const grf::Surface& surface) {
  return surface.colour ? std::get<Colour>(*surface.colour) : Colour(1);
}

/// The same faces, and the same values bit for bit. What is absent where others have it may be there as what
/// it stands for.
void assert_same(const grf::Mesh& mesh, const grf::Mesh& expected) {
  RC_ASSERT(mesh.geometry->corners == expected.geometry->corners);
  RC_ASSERT(mesh.geometry->face_offsets == expected.geometry->face_offsets);
  RC_ASSERT(mesh.geometry->positions.size() == expected.geometry->positions.size());
  RC_ASSERT(mesh.geometry->normals == expected.geometry->normals);
  RC_ASSERT(mesh.geometry->uvs.empty() == expected.geometry->uvs.empty());
  RC_ASSERT(mesh.geometry->colours.empty() == expected.geometry->colours.empty());
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    RC_ASSERT(same_bits(mesh.geometry->positions[i], expected.geometry->positions[i]));
    if (mesh.geometry->uvs.has(i))
      RC_ASSERT(same_bits(mesh.geometry->uvs[i],
                          expected.geometry->uvs.has(i) ? expected.geometry->uvs[i] : Vec2f(0)));
    if (mesh.geometry->colours.has(i))
      RC_ASSERT(mesh.geometry->colours[i] ==
                (expected.geometry->colours.has(i) ? expected.geometry->colours[i] : Colour(1)));
  }
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    RC_ASSERT(colour_of(mesh.surface(i)) == colour_of(expected.surface(i)));
    RC_ASSERT(material_of(mesh, i) == material_of(expected, i));
  }
}

Reading written_and_read(const grf::Scene& scene, const std::string& format) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  if (!find_format(format)->write(scene, folder.path("a.ply"), diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
  return read_path(folder.path("a.ply"));
}

RC_GTEST_PROP(PlyRoundTrip, AMeshComesBackFromPly, ()) {
  const std::vector<std::string> materials = any_materials();
  const grf::Mesh mesh = any_mesh({}, materials);
  const Reading reading = written_and_read(scene_of_mesh(mesh, materials), coin() ? "ply" : "ply-ascii");
  RC_ASSERT(reading.scene.has_value());
  assert_same(meshes_of(*reading.scene).front(), mesh);
}

template <class T>
std::vector<T> shuffled(std::vector<T> values) {
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[static_cast<std::size_t>(up_to(static_cast<int>(i) - 1))]);
  }
  return values;
}

/// A property of a generated file: its name, whether it is a double, and a value for each element.
struct Column {
  std::string name;
  std::vector<float> values;
  bool is_double = false;
};

void add_columns(std::vector<Column>& columns, const std::vector<std::string>& names, bool is_double,
                 const std::vector<Vec3f>& values) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    Column& column = columns.emplace_back(Column{names[k], {}, is_double});
    for (const Vec3f& value : values) column.values.push_back(value[static_cast<int>(k)]);
  }
}

std::vector<Column> vertex_columns(const grf::Mesh& mesh) {
  std::vector<Vec3f> normals;
  std::vector<Vec3f> uvs;
  std::vector<Vec3f> colours;
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    normals.push_back(mesh.geometry->normals.has(i) ? mesh.geometry->normals[i] : Vec3f(0));
    const Vec2f uv = mesh.geometry->uvs.has(i) ? mesh.geometry->uvs[i] : Vec2f(0);
    uvs.emplace_back(uv.x, uv.y, 0.0F);
    colours.push_back(mesh.geometry->colours.has(i) ? mesh.geometry->colours[i] : Colour(1));
  }
  std::vector<Column> columns;
  add_columns(columns, {"x", "y", "z"}, coin(), mesh.geometry->positions);
  if (!mesh.geometry->normals.empty()) add_columns(columns, {"nx", "ny", "nz"}, coin(), normals);
  if (!mesh.geometry->uvs.empty())
    add_columns(
        columns,
        coin() ? std::vector<std::string>{"u", "v"} : std::vector<std::string>{"texture_u", "texture_v"},
        coin(), uvs);
  if (!mesh.geometry->colours.empty()) add_columns(columns, {"red", "green", "blue"}, coin(), colours);
  return coin() ? shuffled(columns) : columns;
}

void put_integer(PlyBytes& file, std::string_view type, std::uint32_t value) {
  if (type == "char") file.put(static_cast<std::int8_t>(value));
  if (type == "uchar") file.put(static_cast<std::uint8_t>(value));
  if (type == "short") file.put(static_cast<std::int16_t>(value));
  if (type == "ushort") file.put(static_cast<std::uint16_t>(value));
  if (type == "int") file.put(static_cast<std::int32_t>(value));
  if (type == "uint") file.put(value);
}

/// A PLY file of a mesh, in any of the ways in which it can be written.
std::string any_file_of(const grf::Mesh& mesh, bool has_face_colours) {
  const auto integer = [] {
    return *rc::gen::element<std::string>("char", "uchar", "short", "ushort", "int", "uint");
  };
  PlyBytes file(*rc::gen::element<std::string>("ascii", "binary_little_endian", "binary_big_endian"));
  const std::vector<Column> columns = vertex_columns(mesh);
  const std::string count = coin() ? "uchar" : integer();
  const std::string index = coin() ? "int" : integer();
  file.line(fmt::format("element vertex {}", mesh.geometry->positions.size()));
  for (const Column& column : columns) {
    file.line(fmt::format("property {} {}", column.is_double ? "double" : "float", column.name));
  }
  file.line(fmt::format("element face {}", mesh.face_count()));
  file.line(fmt::format("property list {} {} vertex_indices", count, index));
  if (has_face_colours)
    file.line("property float red").line("property float green").line("property float blue");
  file.line("end_header");
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    for (const Column& column : columns) {
      if (column.is_double) {
        file.put(static_cast<double>(column.values[i]));
      } else {
        file.put(column.values[i]);
      }
    }
    file.end();
  }
  for (std::size_t i = 0; i < mesh.face_count(); ++i) {
    put_integer(file, count, static_cast<std::uint32_t>(mesh.face(i).size()));
    for (const std::uint32_t corner : mesh.face(i)) put_integer(file, index, corner);
    const Colour colour = colour_of(mesh.surface(i));
    if (has_face_colours) file.put(colour.x).put(colour.y).put(colour.z);
    file.end();
  }
  return file.bytes();
}

RC_GTEST_PROP(PlyRoundTrip, AFileOfAnyLayoutIsReadAndComesBack, ()) {
  const Attributes attributes;
  const grf::Mesh mesh = any_mesh(attributes, {});
  const std::string bytes = any_file_of(mesh, attributes.face_colours);
  const test::TemporaryFolder folder;
  const Reading first = read_path(folder.add("first.ply", bytes));
  RC_ASSERT(first.scene.has_value());
  RC_ASSERT(first.text() == "");
  assert_same(meshes_of(*first.scene).front(), mesh);
  const Reading second = written_and_read(*first.scene, coin() ? "ply" : "ply-ascii");
  RC_ASSERT(second.scene.has_value());
  RC_ASSERT(*second.scene == *first.scene);
}

RC_GTEST_PROP(PlyRoundTrip, AssimpReadsWhatIsWritten, ()) {
  const grf::Mesh mesh = any_mesh({}, {"gold"});
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  const std::string path = folder.path("a.ply");
  RC_ASSERT(
      find_format(coin() ? "ply" : "ply-ascii")->write(scene_of_mesh(mesh, {"gold"}), path, diagnostics));
  // Assimp takes a first byte of binary data that is a line feed for the second end of the header's line.
  RC_PRE(test::bytes_of(path).find("end_header\n\n") == std::string::npos);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, 0);
  RC_ASSERT(scene != nullptr);
  RC_ASSERT(scene->mNumMeshes == 1U);
  const aiMesh& read = *scene->mMeshes[0];
  RC_ASSERT(read.mNumFaces == mesh.face_count());
  RC_ASSERT(read.mNumVertices == mesh.geometry->positions.size());
  for (unsigned i = 0; i < read.mNumFaces; ++i) {
    const auto face = mesh.face(i);
    RC_ASSERT(std::equal(face.begin(), face.end(), read.mFaces[i].mIndices,
                         read.mFaces[i].mIndices + read.mFaces[i].mNumIndices));
  }
}

}  // namespace
}  // namespace convert
