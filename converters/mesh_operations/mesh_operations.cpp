#include "converters/mesh_operations/mesh_operations.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "converters/mesh_operations/decimate.h"
#include "converters/mesh_operations/normals.h"
#include "converters/mesh_operations/smooth.h"
#include "converters/mesh_operations/subdivide.h"
#include "converters/mesh_operations/triangulate.h"
#include "converters/mesh_operations/weld.h"
#include "converters/scene_building.h"
#include "converters/wording.h"
#include "grf/topology.h"

namespace convert {
namespace {

std::size_t count_unused_vertices(const grf::Mesh& mesh) {
  std::vector<bool> is_used(mesh.geometry->positions.size());
  for (const std::uint32_t corner : mesh.geometry->corners) is_used[corner] = true;
  return static_cast<std::size_t>(std::count(is_used.begin(), is_used.end(), false));
}

class Operator {
 public:
  explicit Operator(const MeshOperations& operations) : operations_(operations) {}

  void run(grf::Shared<grf::Mesh>& shared) {
    unused_vertices_ += count_unused_vertices(*shared);
    grf::Mesh& mesh = shared.edit();
    if (operations_.weld) weld_mesh(mesh, *operations_.weld);
    if (operations_.smooth > 0 || operations_.subdivide) {
      nonmanifold_edges_ += mesh.geometry.topology().nonmanifold_edges;
    }
    if (operations_.smooth > 0) mesh = smoothed(mesh, operations_.smooth);
    if (operations_.decimate) decimate_mesh(mesh, *operations_.decimate);
    if (operations_.subdivide) subdivide_mesh(mesh, *operations_.subdivide);
    if (operations_.triangulate) mesh = triangulated(mesh);
    if (operations_.normals == Normals::Flat) mesh = with_flat_faces(mesh);
    if (operations_.normals == Normals::Smooth) mesh = with_smooth_normals(mesh, operations_.crease);
  }

  void report(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const {
    const auto lose = [&](std::size_t count, std::string_view one, std::string_view many,
                          std::string_view why) {
      if (count > 0) diagnostics.loss(location, fmt::format("{}: {}", counted(count, one, many), why));
    };
    lose(unused_vertices_, "vertex was left out", "vertices were left out", "no face uses it");
    lose(collapsed_faces_, "face was left out", "faces were left out",
         "fewer than three distinct corners remain after welding");
    if (operations_.weld) {
      diagnostics.note(location,
                       fmt::format("{} welded", counted(merged_vertices_, "vertex was", "vertices were")));
    }
    if (operations_.decimate) report_decimation(location, diagnostics);
    if (operations_.subdivide) {
      diagnostics.note(location, fmt::format("{} {}",
                                             counted(faces_before_, "face was subdivided into",
                                                     "faces were subdivided into"),
                                             faces_after_));
    }
    lose(lost_irradiance_, "vertex lost its irradiance", "vertices lost their irradiance",
         "the mesh was subdivided");
    if (nonmanifold_edges_ > 0) {
      diagnostics.warning(location, fmt::format("{} kept sharp: more than two faces share each",
                                                counted(nonmanifold_edges_, "edge was", "edges were")));
    }
  }

 private:
  void weld_mesh(grf::Mesh& mesh, double distance) {
    Welded welded = weld(mesh, distance);
    merged_vertices_ += welded.merged_vertices;
    collapsed_faces_ += welded.collapsed_faces;
    mesh = std::move(welded.mesh);
  }

  void decimate_mesh(grf::Mesh& mesh, double ratio) {
    Decimated decimated = decimate(mesh, ratio);
    const std::size_t left = decimated.mesh.face_count();
    // The last collapse can remove two triangles or one.
    if (left > decimated.triangles_wanted + 1) {
      ++meshes_held_;
      triangles_held_ += left - decimated.triangles_wanted;
    }
    triangles_before_ += decimated.triangles_before;
    triangles_after_ += left;
    triangles_left_alone_ += decimated.triangles_left_alone;
    mesh = std::move(decimated.mesh);
  }

  void subdivide_mesh(grf::Mesh& mesh, const Subdivision& subdivision) {
    for (std::size_t i = 0; i < mesh.geometry->positions.size(); ++i) {
      if (mesh.irradiance->has(i)) ++lost_irradiance_;
    }
    faces_before_ += mesh.face_count();
    mesh = subdivided(mesh, subdivision);
    faces_after_ += mesh.face_count();
  }

  void report_decimation(const grf::SourceLocation& location, grf::Diagnostics& diagnostics) const {
    diagnostics.note(location, fmt::format("{} of {} {} left; their vertices are unchanged", triangles_after_,
                                           counted(triangles_before_, "triangle", "triangles"),
                                           triangles_after_ == 1 ? "is" : "are"));
    if (triangles_left_alone_ > 0) {
      diagnostics.warning(location, fmt::format("{}: not part of a manifold",
                                                counted(triangles_left_alone_, "triangle was not decimated",
                                                        "triangles were not decimated")));
    }
    if (meshes_held_ > 0) {
      diagnostics.warning(location, fmt::format("{} by {}: holes, borders, seams and shape are preserved",
                                                counted(meshes_held_, "mesh has more triangles than asked",
                                                        "meshes have more triangles than asked"),
                                                triangles_held_));
    }
  }

  const MeshOperations& operations_;
  std::size_t unused_vertices_ = 0;
  std::size_t merged_vertices_ = 0;
  std::size_t collapsed_faces_ = 0;
  std::size_t triangles_before_ = 0;
  std::size_t triangles_after_ = 0;
  std::size_t triangles_left_alone_ = 0;
  std::size_t meshes_held_ = 0;
  std::size_t triangles_held_ = 0;
  std::size_t faces_before_ = 0;
  std::size_t faces_after_ = 0;
  std::size_t nonmanifold_edges_ = 0;
  std::size_t lost_irradiance_ = 0;
};

bool has_room_for_faces(const MeshOperations& operations, grf::Scene& scene,
                        const grf::SourceLocation& location, grf::Diagnostics& diagnostics) {
  double most = 0;
  for_each_mesh(scene.contents, [&](grf::Shared<grf::Mesh>& mesh) {
    if (operations.subdivide) most = std::max(most, faces_after(*mesh, *operations.subdivide));
  });
  if (most <= MostSubdividedFaces) return true;
  diagnostics.error(location,
                    fmt::format("a mesh would have {:.3g} faces after subdivision, over the limit of "
                                "{:.3g}: use fewer levels",
                                most, MostSubdividedFaces));
  return false;
}

}  // namespace

void apply(const MeshOperations& operations, grf::Scene& scene, const grf::SourceLocation& location,
           grf::Diagnostics& diagnostics) {
  if (!operations.any()) return;
  if (!has_room_for_faces(operations, scene, location, diagnostics)) return;
  Operator each(operations);
  for_each_mesh(scene.contents, [&each](grf::Shared<grf::Mesh>& mesh) { each.run(mesh); });
  each.report(location, diagnostics);
}

}  // namespace convert
