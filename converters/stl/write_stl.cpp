#include "converters/stl/write_stl.h"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "converters/losses.h"
#include "converters/world_meshes.h"
#include "grf/text_file.h"
#include "grf/triangulation.h"

namespace convert {
namespace {

/// The size of the header, free text before the triangle count. It must not begin with `solid`, as text files
/// do.
constexpr std::size_t HeaderSize = 80;
constexpr std::string_view HeaderText = "binary STL";

void append(std::string& bytes, std::uint32_t bits) {
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xFFU);
}
void append(std::string& bytes, const grf::Vec3f& v) {
  for (int i = 0; i < 3; ++i) append(bytes, std::bit_cast<std::uint32_t>(v[i]));
}

/// Appends a record of 50 bytes: normal, three corners, and two unused bytes.
void append_triangle(std::string& bytes, const grf::Vec3f& a, const grf::Vec3f& b, const grf::Vec3f& c) {
  const grf::Vec3d origin(a);
  const grf::Vec3d area = (grf::Vec3d(b) - origin).cross(grf::Vec3d(c) - origin);
  append(bytes, grf::Vec3f(area.normalized()));  // 0 if degenerate
  for (const grf::Vec3f& corner : {a, b, c}) append(bytes, corner);
  bytes.append(2, '\0');
}

std::uint64_t count_triangles(const WorldMeshes& world) {
  std::uint64_t count = 0;
  for (const WorldMesh& placed : world.meshes()) {
    if (!placed.is_light()) count += placed.mesh().geometry->triangle_count();
  }
  return count;
}

bool write_mesh(const WorldMesh& placed, const grf::FileWriter& write) {
  std::string bytes;
  std::vector<grf::Vec3f> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i < placed.mesh().face_count(); ++i) {
    corners.clear();
    triangles.clear();
    for (const std::uint32_t vertex : placed.face(i)) corners.push_back(placed.position(vertex));
    grf::triangulate(corners, triangles);
    for (const auto& [a, b, c] : triangles) append_triangle(bytes, corners[a], corners[b], corners[c]);
    constexpr std::size_t LargestBuffer = 1U << 18U;
    if (bytes.size() < LargestBuffer) continue;
    if (!write(bytes)) return false;
    bytes.clear();
  }
  return write(bytes);
}

bool write_all(const WorldMeshes& world, std::uint64_t triangles, const grf::FileWriter& write) {
  std::string header(HeaderText);
  header.resize(HeaderSize, '\0');
  append(header, static_cast<std::uint32_t>(triangles));
  if (!write(header)) return false;
  for (const WorldMesh& placed : world.meshes()) {
    if (!placed.is_light() && !write_mesh(placed, write)) return false;
  }
  return true;
}

}  // namespace

bool write_stl(const grf::Scene& scene, const std::string& path, grf::Diagnostics& diagnostics) {
  const WorldMeshes world(scene);
  const std::uint64_t triangles = count_triangles(world);
  const auto fail = [&](std::string_view why) {
    diagnostics.error(grf::whole_file(path), fmt::format("cannot write the file: {}", why));
    return false;
  };
  if (triangles == 0) return fail("the scene has no faces other than lights");
  if (!world.is_finite()) return fail("a transform moves a vertex out of the range of a float");
  if (triangles > std::numeric_limits<std::uint32_t>::max())
    return fail("there are too many triangles for STL");
  const auto fill = [&](const grf::FileWriter& write) { return write_all(world, triangles, write); };
  if (!grf::replace_file(path, fill, diagnostics)) return false;
  Losses losses;
  world.count({Loss::Brdf, Loss::SamplingScheme, Loss::Texture, Loss::TextureCoordinates, Loss::FaceColour,
               Loss::VertexColour, Loss::Normal, Loss::Polygon, Loss::LooseVertex, Loss::Emission,
               Loss::Opacity, Loss::Irradiance, Loss::AreaLight, Loss::MeshName},
              losses);
  losses.report_written(grf::whole_file(path), "STL", diagnostics);
  return true;
}

}  // namespace convert
