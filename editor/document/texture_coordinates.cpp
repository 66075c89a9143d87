#include "editor/document/texture_coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "converters/mesh_operations/rebuild.h"

namespace editor {
namespace {

using grf::Box3d;
using grf::Matrix44d;
using grf::Vec2d;
using grf::Vec2f;
using grf::Vec3d;

constexpr double DegreesToRadians = std::numbers::pi / 180;

/// The axes of the image plane, as seen against a direction.
struct ImageAxes {
  Vec3d right;
  Vec3d up;

  explicit ImageAxes(const Vec3d& toward_eye) {
    // Seen from above or below, +y is no upward direction of the image.
    constexpr double NearlyVertical = 0.999;
    const Vec3d n = toward_eye.normalized();
    up = std::abs(n.y) < NearlyVertical ? Vec3d(0, 1, 0) : Vec3d(0, 0, n.y > 0 ? -1 : 1);
    up = (up - n * (up ^ n)).normalized();
    right = up % n;
  }
  Vec2d operator()(const Vec3d& point) const { return {point ^ right, point ^ up}; }
};

Vec3d axis(int number, double sign = 1) {
  Vec3d direction(0);
  direction[number] = sign;
  return direction;
}

int longest_axis(const Vec3d& direction) {
  const Vec3d size(std::abs(direction.x), std::abs(direction.y), std::abs(direction.z));
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Where each mesh with selected faces is in world space. Places of the same file have the same matrix, since
/// they are the same text.
class WorldPlaces {
 public:
  explicit WorldPlaces(const SelectedFaces& faces)
      : objects_(faces.objects), meshes_(faces.selection.meshes()) {
    matrices_.resize(objects_.meshes.size());
    std::vector<bool> is_known(objects_.meshes.size());
    for (const MeshInstance& instance : *objects_.instances) {
      if (!is_known[instance.mesh]) matrices_[instance.mesh] = instance.to_world;
      is_known[instance.mesh] = true;
    }
  }
  const Matrix44d& operator[](std::uint32_t mesh) const {
    const auto same = std::ranges::find_if(meshes_, [&](std::uint32_t other) {
      return objects_.meshes[other].mesh->geometry.shares(objects_.meshes[mesh].mesh->geometry);
    });
    return matrices_[same == meshes_.end() ? mesh : *same];
  }

 private:
  const SceneObjects& objects_;
  std::vector<std::uint32_t> meshes_;
  std::vector<Matrix44d> matrices_;
};

/// Calls an action with each selected face and its matrix to world space.
template <class Action>
void for_each_placed_face(const SelectedFaces& faces, const WorldPlaces& places, const Action& action) {
  for (const std::uint32_t i : faces.selection.meshes()) {
    const grf::Mesh& mesh = *faces.objects.meshes[i].mesh;
    const Matrix44d& to_world = places[i];
    faces.selection.for_each_face(i, [&](std::size_t face) { action(mesh, face, to_world); });
  }
}

/// The sum of the faces' normals, each as long as twice the face's area, and of their lengths.
struct NormalSum {
  Vec3d normal = Vec3d(0);
  double length = 0;

  /// The mean cosine of the angles to the mean normal; 0 if there is none.
  double mean_cosine() const { return length > 0 ? normal.length() / length : 0; }
};

NormalSum sum_of_normals(const SelectedFaces& faces, const WorldPlaces& places) {
  NormalSum sum;
  for_each_placed_face(faces, places,
                       [&](const grf::Mesh& mesh, std::size_t face, const Matrix44d& to_world) {
                         const Vec3d normal = grf::doubled_area_vector(*mesh.geometry, face, to_world);
                         sum.normal += normal;
                         sum.length += normal.length();
                       });
  return sum;
}

/// The projection of single faces, about the bounds of all.
class FaceProjector {
 public:
  FaceProjector(const SelectedFaces& faces, const WorldPlaces& places, UvProjection projection)
      : projection_(projection) {
    for_each_placed_face(faces, places,
                         [&](const grf::Mesh& mesh, std::size_t face, const Matrix44d& to_world) {
                           for (const std::uint32_t corner : mesh.face(face))
                             bounds_.extendBy(Vec3d(mesh.geometry->positions[corner]) * to_world);
                         });
    const NormalSum normals = sum_of_normals(faces, places);
    // The remainder of normals that cancel out is rounding, and no direction.
    constexpr double Cancelled = 1e-6;
    const bool has_normal = normals.mean_cosine() > Cancelled;
    plane_ = ImageAxes(projection == UvProjection::AlongX                      ? axis(0)
                       : projection == UvProjection::AlongY                    ? axis(1)
                       : projection == UvProjection::AlongNormal && has_normal ? normals.normal
                                                                               : axis(2));
    for_each_placed_face(
        faces, places, [&](const grf::Mesh& mesh, std::size_t face, const Matrix44d& to_world) {
          for (const std::uint32_t corner : mesh.face(face))
            plane_bounds_.extendBy(plane_(Vec3d(mesh.geometry->positions[corner]) * to_world));
        });
  }

  /// Computes the coordinates of the corners of a face with this normal of any length, in world space.
  void project(const std::vector<Vec3d>& corners, const Vec3d& normal, std::vector<Vec2d>& uvs) const {
    uvs.clear();
    switch (projection_) {
      case UvProjection::Box:
        return project_along(longest_axis(normal), corners, normal, uvs);
      case UvProjection::Cylinder:
        if (std::abs(normal.y) > std::hypot(normal.x, normal.z))
          return project_along(1, corners, normal, uvs);
        return project_around(corners, uvs);
      case UvProjection::Sphere:
        return project_around(corners, uvs);
      default:
        return project_on(plane_, plane_bounds_, corners, uvs);
    }
  }

 private:
  static void project_on(const ImageAxes& axes, const UvBounds& bounds, const std::vector<Vec3d>& corners,
                         std::vector<Vec2d>& uvs) {
    const Vec2d size = bounds.size();
    const double longest = std::max(size.x, size.y);
    for (const Vec3d& corner : corners)
      uvs.push_back(longest > 0 ? (axes(corner) - bounds.min) / longest : Vec2d(0));
  }

  /// Projects along a coordinate axis, seen from the side of the normal.
  void project_along(int number, const std::vector<Vec3d>& corners, const Vec3d& normal,
                     std::vector<Vec2d>& uvs) const {
    const ImageAxes axes(axis(number, normal[number] < 0 ? -1 : 1));
    UvBounds bounds;
    bounds.extendBy(axes(bounds_.min));
    bounds.extendBy(axes(bounds_.max));
    if (projection_ == UvProjection::Box) {
      // All sides have one scale.
      const Vec3d size = bounds_.size();
      bounds.max = bounds.min + Vec2d(std::max({size.x, size.y, size.z}));
    }
    project_on(axes, bounds, corners, uvs);
  }

  void project_around(const std::vector<Vec3d>& corners, std::vector<Vec2d>& uvs) const {
    constexpr double AtAxis = 1e-6;
    const Vec3d centre = bounds_.center();
    const double least_radius = AtAxis * bounds_.size().length();
    Vec2d mean(0);
    for (const Vec3d& corner : corners) {
      const Vec2d away(corner.x - centre.x, corner.z - centre.z);
      if (away.length() > least_radius) mean += away.normalized();
    }
    const double middle = longitude(mean);
    for (const Vec3d& corner : corners) {
      const Vec3d from_centre = corner - centre;
      const Vec2d away(from_centre.x, from_centre.z);
      const double turn = away.length() > least_radius ? longitude(away) - middle : 0;
      uvs.emplace_back(middle + turn - std::round(turn), height(from_centre));
    }
  }

  /// From 0 to 1; 0.5 is toward +z, 0.75 toward +x.
  static double longitude(const Vec2d& away) {
    return 0.5 + std::atan2(away.x, away.y) / (2 * std::numbers::pi);
  }
  double height(const Vec3d& from_centre) const {
    if (projection_ == UvProjection::Sphere) {
      return 0.5 + std::atan2(from_centre.y, std::hypot(from_centre.x, from_centre.z)) / std::numbers::pi;
    }
    const double size = bounds_.size().y;
    return size > 0 ? 0.5 + from_centre.y / size : 0;
  }

  UvProjection projection_;
  Box3d bounds_;
  ImageAxes plane_{Vec3d(0, 0, 1)};
  UvBounds plane_bounds_;
};

/// Sets texture coordinates at corners of faces: corners of a vertex with different ones get a vertex each.
class CornerUvs {
 public:
  explicit CornerUvs(const grf::Mesh& mesh) : bare_(without_uvs(mesh)), made_(bare_) {
    first_ = convert::first_equal_vertex(bare_);
    next_.resize(made_.positions.size(), None);
    made_.uvs.reserve(made_.positions.size());
  }

  void set(std::size_t corner, const Vec2f& uv) {
    const std::uint32_t source = first_[made_.corners[corner]];
    std::uint32_t vertex = source;
    while (made_.uvs.has(vertex) && made_.uvs[vertex] != uv) {
      if (next_[vertex] == None) {
        next_[vertex] = made_.copy_vertex(bare_, source);
        next_.push_back(None);
      }
      vertex = next_[vertex];
    }
    made_.uvs.set(vertex, uv);
    made_.corners[corner] = vertex;
  }

  grf::Mesh take() {
    const grf::Mesh made(std::move(made_));
    convert::Rebuild used(made);
    for (std::size_t face = 0; face < made.face_count(); ++face)
      used.add_face(made.face(face), (*made.surface_of_face)[face]);
    return used.take();
  }

 private:
  static constexpr std::uint32_t None = std::numeric_limits<std::uint32_t>::max();

  static grf::Mesh without_uvs(const grf::Mesh& mesh) {
    grf::MeshDraft bare(mesh);
    bare.uvs = {};
    return bare;
  }

  grf::Mesh bare_;
  grf::MeshDraft made_;
  std::vector<std::uint32_t> first_;  ///< the vertex that is equal but for texture coordinates
  std::vector<std::uint32_t> next_;   ///< another vertex with other texture coordinates
};

grf::Mesh projected(const grf::Mesh& mesh, const Matrix44d& to_world, const FaceProjector& projector) {
  CornerUvs result(mesh);
  std::vector<Vec3d> corners;
  std::vector<Vec2d> uvs;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    corners.clear();
    for (const std::uint32_t corner : mesh.face(face))
      corners.push_back(Vec3d(mesh.geometry->positions[corner]) * to_world);
    projector.project(corners, grf::doubled_area_vector(*mesh.geometry, face, to_world), uvs);
    for (std::size_t i = 0; i < uvs.size(); ++i)
      result.set(mesh.geometry->face_offsets[face] + i, Vec2f(uvs[i]));
  }
  return result.take();
}

}  // namespace

grf::Scene with_projected_uvs(const SelectedFaces& faces, UvProjection projection) {
  const WorldPlaces places(faces);
  const FaceProjector projector(faces, places, projection);
  return with_edited_faces(faces, [&](const grf::Mesh& mesh, std::uint32_t object) {
    return projected(mesh, places[object], projector);
  });
}

UvProjection suitable_projection(const SelectedFaces& faces) {
  constexpr double NearlyFlat = 0.9;
  return sum_of_normals(faces, WorldPlaces(faces)).mean_cosine() > NearlyFlat ? UvProjection::AlongNormal
                                                                              : UvProjection::Box;
}

Vec2d UvTransform::operator()(const Vec2d& uv) const {
  const Vec2d scaled = (uv - pivot) * scale;
  // Quarter turns are exact.
  const double quarters = rotation / 90;
  const bool is_exact = quarters == std::round(quarters);
  const double cosine = std::cos(rotation * DegreesToRadians);
  const double sine = std::sin(rotation * DegreesToRadians);
  const Vec2d x_axis = is_exact ? Vec2d(std::round(cosine), std::round(sine)) : Vec2d(cosine, sine);
  return pivot + offset +
         Vec2d(scaled.x * x_axis.x - scaled.y * x_axis.y, scaled.x * x_axis.y + scaled.y * x_axis.x);
}

grf::Scene with_transformed_uvs(const SelectedFaces& faces, const UvTransform& transform) {
  return with_edited_faces(faces, [&transform](const grf::Mesh& mesh, std::uint32_t) {
    grf::MeshDraft edited(mesh);
    for (std::size_t i = 0; i < edited.positions.size(); ++i) {
      if (edited.uvs.has(i)) edited.uvs.set(i, Vec2f(transform(Vec2d(edited.uvs[i]))));
    }
    return grf::Mesh(std::move(edited));
  });
}

UvBounds uv_bounds(const SceneObjects& objects, const FaceSelection& selection) {
  UvBounds bounds;
  for (const std::uint32_t i : selection.meshes()) {
    const grf::Mesh& mesh = *objects.meshes[i].mesh;
    const auto& uvs = mesh.geometry->uvs;
    if (uvs.empty()) continue;
    selection.for_each_face(i, [&](std::size_t face) {
      for (const std::uint32_t corner : mesh.face(face)) {
        if (uvs.has(corner)) bounds.extendBy(Vec2d(uvs[corner]));
      }
    });
  }
  return bounds;
}

UvTransform fitted(const UvBounds& bounds, const UvBounds& target) {
  UvTransform fit;
  fit.pivot = bounds.center();
  for (int i = 0; i < 2; ++i) {
    if (bounds.size()[i] > 0) fit.scale[i] = target.size()[i] / bounds.size()[i];
  }
  fit.offset = target.center() - bounds.center();
  return fit;
}

}  // namespace editor
