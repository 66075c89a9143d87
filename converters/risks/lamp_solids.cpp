#include "converters/risks/lamp_solids.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "converters/risks/mesh_risks.h"
#include "grf/topology.h"

namespace convert {
namespace {

using grf::Vec3d;

// A point on a solid's surface has the winding number 1/2.
constexpr double Inside = 0.75;
constexpr std::size_t MostPoints = 8;

Vec3d centre_of_face(const grf::Mesh& mesh, std::uint32_t face) {
  Vec3d sum(0);
  for (const std::uint32_t corner : mesh.face(face)) sum += Vec3d(mesh.geometry->positions[corner]);
  return sum / static_cast<double>(mesh.face(face).size());
}

}  // namespace

void Lamps::add(const grf::AreaLight& light, const grf::Placement& placement,
                const grf::SourceLocation& location) {
  Vec3d edge1;
  Vec3d edge2;
  placement.to_world.multDirMatrix(Vec3d(light.edge1), edge1);
  placement.to_world.multDirMatrix(Vec3d(light.edge2), edge2);
  const Vec3d corner = Vec3d(light.corner) * placement.to_world;
  Lamp lamp{
      {placement.path.begin(), placement.path.end()}, location, nullptr, {}, {}, edge1.cross(edge2).length()};
  lamp.points.push_back(corner + (edge1 + edge2) / 2);
  for (const double s : {0.05, 0.95}) {
    for (const double t : {0.05, 0.95}) lamp.points.push_back(corner + edge1 * s + edge2 * t);
  }
  lamps_.push_back(std::move(lamp));
}

void Lamps::add(const grf::MeshLight& light, const grf::Placement& placement,
                const grf::SourceLocation& location) {
  std::vector<std::uint32_t> faces(light.mesh->face_count());
  std::iota(faces.begin(), faces.end(), 0U);
  add_faces(*light.mesh, std::move(faces), placement, location);
}

void Lamps::add_emitting(const grf::Mesh& mesh, const grf::Placement& placement,
                         const grf::SourceLocation& location) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t face = 0; face < mesh.face_count(); ++face) {
    const std::optional<grf::Colour>& emission = mesh.surface(face).emission;
    if (emission && std::max({emission->x, emission->y, emission->z}) > 0) faces.push_back(face);
  }
  add_faces(mesh, std::move(faces), placement, location);
}

void Lamps::add_faces(const grf::Mesh& mesh, std::vector<std::uint32_t> faces,
                      const grf::Placement& placement, const grf::SourceLocation& location) {
  if (faces.empty()) return;
  Lamp lamp{{placement.path.begin(), placement.path.end()}, location, &mesh, {}, {}, 0};
  const std::size_t step = (faces.size() + MostPoints - 1) / MostPoints;
  for (std::size_t i = 0; i < faces.size(); i += step) {
    lamp.points.push_back(centre_of_face(mesh, faces[i]) * placement.to_world);
  }
  for (const std::uint32_t face : faces) {
    lamp.area += grf::doubled_area_vector(*mesh.geometry, face, placement.to_world).length() / 2;
  }
  lamp.faces = std::move(faces);
  lamps_.push_back(std::move(lamp));
}

std::vector<Vec3d> Lamps::points() const {
  std::vector<Vec3d> points;
  for (const Lamp& lamp : lamps_) points.push_back(lamp.points.front());
  return points;
}

std::vector<const Lamp*> Lamps::largest() const {
  std::vector<const Lamp*> lamps;
  for (const Lamp& lamp : lamps_) lamps.push_back(&lamp);
  const std::size_t count = std::min(lamps.size(), MostLamps);
  std::partial_sort(lamps.begin(), lamps.begin() + static_cast<std::ptrdiff_t>(count), lamps.end(),
                    [](const Lamp* a, const Lamp* b) { return a->area > b->area; });
  lamps.resize(count);
  return lamps;
}

void LampSolids::add(const grf::Mesh& mesh, const grf::Matrix44d& to_world, const grf::Box3d& bounds) {
  const grf::Topology& topology = mesh.geometry.topology();
  if (topology.boundary_edges > 0 || topology.nonmanifold_edges > 0) return;
  if (to_world.determinant() == 0) return;
  solids_.push_back({&mesh, to_world.inverse(), bounds});
}

const grf::Mesh* LampSolids::around(const Lamp& lamp) const {
  for (const Solid& solid : solids_) {
    if (solid.mesh == lamp.mesh) continue;
    const bool encloses = std::all_of(lamp.points.begin(), lamp.points.end(), [&](const Vec3d& point) {
      return solid.bounds.intersects(point) &&
             winding_number(solid.mesh->geometry, point * solid.to_object) > Inside;
    });
    if (encloses) return solid.mesh;
  }
  return nullptr;
}

}  // namespace convert
