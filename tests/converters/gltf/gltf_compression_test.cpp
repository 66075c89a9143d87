// Compressed glTF files: made by the encoders of meshoptimizer and Draco, and a real one beside the same
// model without compression.
#include <algorithm>
#include <array>
#include <cstring>
#include <random>

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "tests/converters/gltf/assimp_count.h"
#include "tests/converters/gltf/gltf_maker.h"
#include "tests/converters/model_files.h"

namespace convert {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* Meshopt = "EXT_meshopt_compression";
constexpr const char* Draco = "KHR_draco_mesh_compression";

/// A grid of 5 x 5 vertices, whose heights tell them apart.
constexpr std::uint32_t Side = 5;

std::vector<float> grid_positions() {
  std::vector<float> values;
  for (std::uint32_t i = 0; i < Side * Side; ++i) {
    values.insert(values.end(), {float(i % Side), float(i / Side), 0.125F * float(i)});
  }
  return values;
}

std::vector<std::uint32_t> grid_corners() {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t y = 0; y + 1 < Side; ++y) {
    for (std::uint32_t x = 0; x + 1 < Side; ++x) {
      const std::uint32_t first = y * Side + x;
      for (const std::uint32_t i :
           {first, first + 1, first + Side, first + Side, first + 1, first + Side + 1}) {
        corners.push_back(i);
      }
    }
  }
  return corners;
}

/// The positions of each triangle's corners, first the triangles and then the corners in an order of their
/// own.
std::vector<std::array<float, 9>> triangles_of(const grf::Mesh& mesh) {
  std::vector<std::array<float, 9>> triangles;
  for (std::size_t face = 0; face < mesh.geometry->face_count(); ++face) {
    std::vector<std::array<float, 3>> corners;
    for (std::uint32_t i = mesh.geometry->face_offsets[face]; i < mesh.geometry->face_offsets[face + 1];
         ++i) {
      const grf::Vec3f& place = mesh.geometry->positions[mesh.geometry->corners[i]];
      corners.push_back({place.x, place.y, place.z});
    }
    // The first corner is the least one, so that the winding stays.
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::array<float, 9>& triangle = triangles.emplace_back();
    for (std::size_t i = 0; i < 9; ++i) triangle[i] = corners.at(i / 3)[i % 3];
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

GltfMaker plain_grid() {
  GltfMaker maker;
  std::vector<std::uint16_t> corners;
  for (const std::uint32_t corner : grid_corners()) corners.push_back(static_cast<std::uint16_t>(corner));
  const int positions = maker.floats(grid_positions(), "VEC3");
  maker.add_mesh({{"attributes", {{"POSITION", positions}}}, {"indices", maker.indices(corners)}});
  return maker;
}

/// Replaces a view by one of compressed bytes, whose plain buffer is not there.
void compress_view(GltfMaker& maker, std::size_t view, const std::vector<unsigned char>& bytes,
                   std::size_t count, std::size_t stride, const char* mode, const char* filter) {
  while (maker.buffer.size() % 4 != 0) maker.buffer += '\0';
  json extension = {{"buffer", 0},
                    {"byteOffset", maker.buffer.size()},
                    {"byteLength", bytes.size()},
                    {"count", count},
                    {"byteStride", stride},
                    {"mode", mode},
                    {"filter", filter}};
  maker.buffer.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  maker.json["bufferViews"][view] = {{"buffer", 1},
                                     {"byteOffset", 0},
                                     {"byteLength", count * stride},
                                     {"extensions", {{Meshopt, extension}}}};
}

std::vector<unsigned char> encoded_vertices(const void* values, std::size_t count, std::size_t stride) {
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, stride));
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values, count, stride));
  return bytes;
}

std::vector<unsigned char> encoded_triangles(const std::vector<std::uint32_t>& corners) {
  std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(corners.size(), Side * Side));
  bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), corners.data(), corners.size()));
  return bytes;
}

/// The grid with compressed views, and the fallback buffer that they stand for.
GltfMaker meshopt_grid() {
  GltfMaker maker = plain_grid();
  maker.buffer.clear();
  const std::vector<float> positions = grid_positions();
  const std::vector<std::uint32_t> corners = grid_corners();
  compress_view(maker, 0, encoded_vertices(positions.data(), Side * Side, 12), Side * Side, 12, "ATTRIBUTES",
                "NONE");
  compress_view(maker, 1, encoded_triangles(corners), corners.size(), 2, "TRIANGLES", "NONE");
  maker.json["extensionsUsed"] = {Meshopt};
  maker.json["extensionsRequired"] = {Meshopt};
  return maker;
}

json fallback_buffer() { return {{"byteLength", 4096}, {"extensions", {{Meshopt, {{"fallback", true}}}}}}; }

Reading read_meshopt(GltfMaker maker) {
  maker.json["buffers"] = {{{"byteLength", maker.buffer.size()},
                            {"uri", "data:application/octet-stream;base64," + maker.base64()}},
                           fallback_buffer()};
  return maker.read();
}

TEST(MeshoptCompression, GivesTheMeshThatWasCompressed) {
  const grf::Mesh expected = only_mesh(plain_grid().read());
  const Reading reading = read_meshopt(meshopt_grid());
  EXPECT_FALSE(reading.diagnostics.has_errors()) << reading.text();
  EXPECT_EQ(triangles_of(only_mesh(reading)), triangles_of(expected));
}

// The JSON of a GLB file is changed before tinygltf reads it, and its buffer has to stay.
TEST(MeshoptCompression, IsReadFromBinaryFiles) {
  GltfMaker maker = meshopt_grid();
  const std::string plain = maker.glb();
  maker.json["buffers"] = {{{"byteLength", maker.buffer.size()}}, fallback_buffer()};
  std::string text = maker.json.dump();
  while (text.size() % 4 != 0) text += ' ';
  const std::size_t old_length = static_cast<unsigned char>(plain[12]) | static_cast<unsigned char>(plain[13])
                                                                             << 8U;
  std::string glb = plain.substr(0, 20) + text + plain.substr(20 + old_length);
  const auto put = [&](std::size_t place, std::size_t word) {
    for (unsigned i = 0; i < 4; ++i) glb[place + i] = static_cast<char>(word >> (8 * i) & 0xFFU);
  };
  put(8, glb.size());
  put(12, text.size());
  EXPECT_EQ(triangles_of(only_mesh(GltfMaker::read_bytes("a.glb", glb))),
            triangles_of(only_mesh(plain_grid().read())));
}

TEST(MeshoptCompression, ReadsSequencesOfIndices) {
  GltfMaker maker = meshopt_grid();
  const std::vector<std::uint32_t> corners = grid_corners();
  std::vector<unsigned char> bytes(meshopt_encodeIndexSequenceBound(corners.size(), Side * Side));
  bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), corners.data(), corners.size()));
  compress_view(maker, 1, bytes, corners.size(), 2, "INDICES", "NONE");
  EXPECT_EQ(triangles_of(only_mesh(read_meshopt(maker))), triangles_of(only_mesh(plain_grid().read())));
}

// Normals as octahedra in 8 bits (with KHR_mesh_quantization): x, y, and 1 in units of 127.
TEST(MeshoptCompression, HasFilters) {
  GltfMaker maker = meshopt_grid();
  std::vector<float> normals;
  for (std::uint32_t i = 0; i < Side * Side; ++i) {
    const float angle = 0.2F * float(i);
    normals.insert(normals.end(), {0.6F * std::cos(angle), 0.6F * std::sin(angle), 0.8F, 0});
  }
  std::vector<unsigned char> octahedra(4 * Side * Side);
  meshopt_encodeFilterOct(octahedra.data(), Side * Side, 4, 8, normals.data());
  const int accessor = maker.add(std::vector<std::int8_t>(4 * Side * Side), "VEC3", 5120,
                                 {{"normalized", true}, {"count", Side * Side}});
  compress_view(maker, 2, encoded_vertices(octahedra.data(), Side * Side, 4), Side * Side, 4, "ATTRIBUTES",
                "OCTAHEDRAL");
  maker.json["bufferViews"][2]["byteStride"] = 4;
  maker.attributes()["NORMAL"] = accessor;
  const grf::Mesh mesh = only_mesh(read_meshopt(maker));
  ASSERT_EQ(mesh.geometry->positions.size(), Side * Side);
  for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
    const auto row = static_cast<std::size_t>(mesh.geometry->positions[i].z / 0.125F);
    ASSERT_TRUE(mesh.geometry->normals.has(i));
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(mesh.geometry->normals[i][k], normals[4 * row + static_cast<std::size_t>(k)], 0.02) << i;
  }
}

TEST(MeshoptCompression, ReportsWhatIsWrong) {
  const auto changed = [](const char* name, const json& value) {
    GltfMaker maker = meshopt_grid();
    maker.json["bufferViews"][0]["extensions"][Meshopt][name] = value;
    return read_meshopt(maker);
  };
  expect_error(changed("byteLength", 20), "buffer view 0: its compressed data are damaged");
  expect_error(changed("byteLength", 1'000'000), "buffer view 0: 1000000 compressed bytes from byte 0");
  expect_error(changed("byteOffset", 1'000'000), "compressed bytes from byte 1000000");
  expect_error(changed("buffer", 7), "does not say where its data are");
  expect_error(changed("buffer", -1), "does not say where its data are");
  expect_error(changed("byteStride", 7), "for 25 elements of 7 bytes cannot be read");
  expect_error(changed("mode", "CUBES"), "mode 'CUBES'");
  expect_error(changed("filter", "SEPIA"), "filter 'SEPIA'");
  expect_error(changed("count", 9e15), "its compressed meshes expand to more than 256 MB");
  expect_error(changed("count", 3), "buffer view 0");
}

/// The grid as Draco compresses it, with texture coordinates and colours in bytes.
struct DracoGrid {
  GltfMaker maker;
  std::size_t points = 0;
};

DracoGrid draco_grid(int method) {
  const std::vector<float> positions = grid_positions();
  const std::vector<std::uint32_t> corners = grid_corners();
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(corners.size() / 3));
  const int place = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int colour = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8, true);
  for (std::uint32_t face = 0; face < corners.size() / 3; ++face) {
    const auto value = [&](std::uint32_t k) { return positions.data() + 3 * corners[3 * face + k]; };
    const auto shade = [&](std::uint32_t k) {
      const auto grey = static_cast<std::uint8_t>(10 * corners[3 * face + k]);
      return std::array<std::uint8_t, 4>{grey, grey, 0, 255};
    };
    builder.SetAttributeValuesForFace(place, draco::FaceIndex(face), value(0), value(1), value(2));
    builder.SetAttributeValuesForFace(colour, draco::FaceIndex(face), shade(0).data(), shade(1).data(),
                                      shade(2).data());
  }
  const std::unique_ptr<draco::Mesh> mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetTrackEncodedProperties(true);
  draco::EncoderBuffer encoded;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &encoded).ok());
  DracoGrid grid;
  grid.points = encoder.num_encoded_points();
  GltfMaker& maker = grid.maker;
  maker.buffer.assign(encoded.data(), encoded.size());
  maker.json["bufferViews"] = {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", encoded.size()}}};
  maker.json["accessors"] = {
      {{"componentType", 5126}, {"count", grid.points}, {"type", "VEC3"}},
      {{"componentType", 5123}, {"count", corners.size()}, {"type", "SCALAR"}},
      {{"componentType", 5121}, {"count", grid.points}, {"type", "VEC4"}, {"normalized", true}}};
  maker.add_mesh({{"attributes", {{"POSITION", 0}, {"COLOR_0", 2}}},
                  {"indices", 1},
                  {"extensions",
                   {{Draco,
                     {{"bufferView", 0},
                      {"attributes",
                       {{"POSITION", mesh->attribute(place)->unique_id()},
                        {"COLOR_0", mesh->attribute(colour)->unique_id()}}}}}}}});
  maker.json["extensionsUsed"] = {Draco};
  maker.json["extensionsRequired"] = {Draco};
  return grid;
}

TEST(DracoCompression, GivesTheMeshThatWasCompressed) {
  const auto expected = triangles_of(only_mesh(plain_grid().read()));
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const Reading reading = draco_grid(method).maker.read();
    EXPECT_FALSE(reading.diagnostics.has_errors()) << reading.text();
    const grf::Mesh mesh = only_mesh(reading);
    EXPECT_EQ(triangles_of(mesh), expected) << method;
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
      const float row = mesh.geometry->positions[i].z / 0.125F;
      ASSERT_TRUE(mesh.geometry->colours.has(i));
      EXPECT_NEAR(mesh.geometry->colours[i].x, 10 * row / 255, 1e-6) << method << " " << i;
      EXPECT_EQ(mesh.geometry->colours[i].z, 0) << method << " " << i;
    }
  }
}

TEST(DracoCompression, ReportsWhatIsWrong) {
  const auto changed = [](const auto& change) {
    GltfMaker maker = draco_grid(draco::MESH_EDGEBREAKER_ENCODING).maker;
    change(maker);
    return maker.read();
  };
  const auto extension = [](GltfMaker& m) -> json& { return m.primitive()["extensions"][Draco]; };
  expect_error(changed([](auto& m) { m.json["bufferViews"][0]["byteLength"] = 30; }),
               "buffer view 0: its compressed mesh is damaged");
  expect_error(changed([&](auto& m) { extension(m)["bufferView"] = 4; }), "invalid bufferView");
  expect_error(changed([&](auto& m) { extension(m).erase("attributes"); }),
               "no buffer view or no attributes");
  expect_error(changed([&](auto& m) { extension(m)["attributes"]["POSITION"] = 17; }),
               "the compressed mesh has no attribute 17");
  expect_error(changed([](auto& m) { m.json["accessors"][0]["count"] = 3; }),
               "accessor 0: it has 3 elements");
  expect_error(changed([](auto& m) { m.json["accessors"][1]["count"] = 3; }),
               "accessor 1: it has 3 elements");
  expect_error(changed([](auto& m) { m.json["accessors"][0]["type"] = "VEC2"; }),
               "accessor 0: its compressed values have another type");
  expect_error(changed([](auto& m) { m.json["accessors"][0]["componentType"] = 5130; }), "accessor 0");
  expect_error(changed([](auto& m) { m.primitive().erase("indices"); }), "it has 0 elements");
}

// The same model without compression, of which Draco left out faces without area and rounded coordinates.
TEST(DracoCompression, GivesARealModel) {
  const Reading reading = read_path(AssimpModels + "glTF2/draco/2CylinderEngine.gltf");
  ASSERT_TRUE(reading.scene.has_value()) << reading.text();
  const Reading plain = read_path(AssimpModels + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
  ASSERT_TRUE(plain.scene.has_value()) << plain.text();
  const ModelCount found = count_of(*reading.scene);
  const ModelCount expected = count_of(*plain.scene);
  EXPECT_NEAR(found.area, expected.area, 2e-3 * expected.area);
  const double size = expected.bounds.size().length();
  EXPECT_LE((found.bounds.min - expected.bounds.min).length(), 2e-3 * size);
  EXPECT_LE((found.bounds.max - expected.bounds.max).length(), 2e-3 * size);
}

// Bytes that are not what was compressed: an error or another mesh, and no harm.
TEST(CompressedFiles, ThatAreGarbledDoNoHarm) {
  std::mt19937 random(5);
  for (int i = 0; i < 400; ++i) {
    GltfMaker maker = i % 2 == 0 ? meshopt_grid() : draco_grid(i % 4 == 1 ? 0 : 1).maker;
    for (std::uint32_t k = 0; k <= random() % 4; ++k) {
      maker.buffer[random() % maker.buffer.size()] = static_cast<char>(random());
    }
    const Reading reading = i % 2 == 0 ? read_meshopt(maker) : maker.read();
    EXPECT_EQ(reading.diagnostics.has_errors(), !reading.scene.has_value());
  }
}

}  // namespace
}  // namespace convert
