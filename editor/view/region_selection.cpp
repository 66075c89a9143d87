#include "editor/view/region_selection.h"

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

namespace editor {
namespace {

using grf::Vec3d;

/// A mask of the pixels inside a region.
class Mask {
 public:
  Mask(const QPainterPath& region, const QSize& size)
      : rectangle_(region.boundingRect().toAlignedRect().intersected(QRect(QPoint(), size))) {
    if (rectangle_.isEmpty()) return;
    image_ = QImage(rectangle_.size(), QImage::Format_Grayscale8);
    image_.fill(0);
    QPainter painter(&image_);
    painter.translate(-rectangle_.topLeft());
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::white);
    painter.drawPath(region);
  }

  const QRect& rectangle() const { return rectangle_; }
  bool empty() const { return rectangle_.isEmpty(); }
  /// The position is relative to the rectangle's corner (0,0).
  bool has(int x, int y) const { return image_.constScanLine(y)[x] != 0; }

 private:
  QRect rectangle_;
  QImage image_;
};

/// An instance with precomputed values for all of its faces.
struct PlacedMesh {
  std::uint32_t mesh = 0;
  const MeshGeometry* geometry = nullptr;
  grf::Matrix44d to_world;
  grf::Matrix44d normal_to_world;
  double scale = 1;

  Vec3d centre(std::uint32_t face) const { return Vec3d(geometry->centres()[face]) * to_world; }
  Vec3d normal(std::uint32_t face) const {
    Vec3d result;
    normal_to_world.multDirMatrix(Vec3d(geometry->normals()[face]), result);
    return result.normalized();
  }
  /// The largest distance of a corner from the centre.
  double radius(std::uint32_t face) const {
    const TriangleArrays& arrays = geometry->arrays();
    const grf::Vec3f& middle = geometry->centres()[face];
    float farthest = 0;
    const std::size_t end = geometry->first_triangle(face + 1);
    for (std::size_t i = geometry->first_triangle(face); i < end; ++i) {
      for (const std::uint32_t corner : arrays.triangles[i]) {
        farthest = std::max(farthest, (arrays.positions[corner] - middle).length2());
      }
    }
    return std::sqrt(farthest) * scale;
  }
};

std::vector<PlacedMesh> placed_meshes(const ProjectedScene& scene) {
  std::vector<PlacedMesh> placed;
  for (const MeshInstance& instance : *scene.objects.instances) {
    PlacedMesh mesh{instance.mesh, scene.shapes[instance.mesh].geometry.get(), instance.to_world,
                    instance.to_world.inverse().transposed(), 1};
    mesh.scale = std::cbrt(std::abs(instance.to_world.determinant()));
    placed.push_back(mesh);
  }
  return placed;
}

/// Calls visit(face, x, y, centre) for each face of a mesh whose centre is in the region: the pixel in the
/// mask's rectangle, and the centre in world space.
template <class Visit>
void for_each_centre(const ProjectedScene& scene, const Mask& mask, const PlacedMesh& mesh,
                     const Visit& visit) {
  if (mesh.geometry == nullptr) return;
  const double aspect = static_cast<double>(scene.size.width()) / scene.size.height();
  const grf::Matrix44d to_clip =
      mesh.to_world * scene.camera.world_to_camera() * scene.camera.camera_to_clip(aspect, {});
  for (std::uint32_t face = 0; face < mesh.geometry->face_count(); ++face) {
    const Vec3d p(mesh.geometry->centres()[face]);
    const double w = p.x * to_clip[0][3] + p.y * to_clip[1][3] + p.z * to_clip[2][3] + to_clip[3][3];
    if (!(w > 0)) continue;
    const double clip_x = p.x * to_clip[0][0] + p.y * to_clip[1][0] + p.z * to_clip[2][0] + to_clip[3][0];
    const double clip_y = p.x * to_clip[0][1] + p.y * to_clip[1][1] + p.z * to_clip[2][1] + to_clip[3][1];
    const double x = (0.5 + 0.5 * clip_x / w) * scene.size.width() - mask.rectangle().x();
    const double y = (0.5 - 0.5 * clip_y / w) * scene.size.height() - mask.rectangle().y();
    if (!(x >= 0 && y >= 0 && x < mask.rectangle().width() && y < mask.rectangle().height())) continue;
    if (mask.has(static_cast<int>(x), static_cast<int>(y)))
      visit(face, static_cast<int>(x), static_cast<int>(y));
  }
}

/// Tells whether a face smaller than a pixel lies on the face that its pixel shows.
bool is_seen_small(const ProjectedScene& scene, const PlacedMesh& mesh, std::uint32_t face,
                   const PlacedMesh& shown, std::uint32_t shown_face) {
  const Vec3d centre = mesh.centre(face);
  const ViewCamera& camera = scene.camera;
  const double pixel = 2 * camera.half_height_at(centre) / scene.size.height();
  if (mesh.radius(face) > 1.5 * pixel) return false;  // it would have a pixel
  const Vec3d along = camera.is_orthographic() ? camera.forward() : (centre - camera.eye()).normalized();
  const double cosine = along.dot(mesh.normal(face));
  const double shown_cosine = along.dot(shown.normal(shown_face));
  if (cosine * shown_cosine <= 0) return false;  // from the other side
  const double behind = (centre - shown.centre(shown_face)).dot(shown.normal(shown_face)) / shown_cosine;
  const double slope = std::max(0.15, std::min(std::abs(cosine), std::abs(shown_cosine)));
  return std::abs(behind) <= 2 * pixel / slope;
}

}  // namespace

std::optional<SceneHit> intersect(const SceneObjects& objects, const std::vector<MeshShape>& shapes,
                                  const FaceSelection& hidden, const ViewRay& ray) {
  std::optional<SceneHit> nearest;
  const FaceSelection::Faces none;
  for (std::uint32_t i = 0; i < objects.instances->size(); ++i) {
    const MeshInstance& instance = (*objects.instances)[i];
    const auto& geometry = shapes[instance.mesh].geometry;
    if (geometry == nullptr) continue;
    const auto hit =
        geometry->intersect(transformed(ray, instance.to_world.inverse()),
                            hidden.count(instance.mesh) > 0 ? hidden.of_mesh(instance.mesh) : none);
    if (!hit || (nearest && hit->distance >= nearest->distance)) continue;
    nearest = {
        {instance.mesh, geometry->arrays().face_of_triangle[hit->triangle]}, i, hit->distance, hit->triangle};
  }
  return nearest;
}

grf::Vec3d normal_at(const SceneObjects& objects, const std::vector<MeshShape>& shapes, const ViewRay& ray,
                     const SceneHit& hit) {
  const MeshInstance& instance = (*objects.instances)[hit.instance];
  const TriangleArrays& arrays = shapes[instance.mesh].geometry->arrays();
  const TriangleArrays::Triangle& triangle = arrays.triangles[hit.triangle];
  const grf::Matrix44d to_local = instance.to_world.inverse();
  const grf::Vec3d a(arrays.positions[triangle[0]]), b(arrays.positions[triangle[1]]),
      c(arrays.positions[triangle[2]]);
  const grf::Vec3d across = (b - a).cross(c - a);
  grf::Vec3d local = across;
  const auto has_normal = [&](std::uint32_t corner) {
    return corner < arrays.normals.size() && arrays.normals[corner].w > 0;
  };
  if (std::ranges::all_of(triangle, has_normal) && across.length2() > 0) {
    // Barycentric coordinates as ratios of areas.
    const grf::Vec3d point = transformed(ray, to_local).at(hit.distance);
    const std::array<double, 3> weights = {(b - point).cross(c - point).dot(across),
                                           (c - point).cross(a - point).dot(across),
                                           (a - point).cross(b - point).dot(across)};
    grf::Vec3d sum(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const Imath::V4f& normal = arrays.normals[triangle[i]];
      sum += grf::Vec3d(grf::Vec3f(normal.x, normal.y, normal.z)).normalized() * weights[i];
    }
    if (sum.length2() > 0) local = sum;
  }
  grf::Vec3d normal;
  to_local.transposed().multDirMatrix(local, normal);
  normal.normalize();
  return normal.dot(ray.direction) > 0 ? -normal : normal;
}

QPainterPath path_of(const QPolygonF& polygon) {
  QPainterPath path;
  path.addPolygon(polygon);
  path.closeSubpath();
  return path;
}

FaceSelection visible_in_region(const ProjectedScene& scene, const QPainterPath& region,
                                const std::function<std::vector<FacePixel>(const QRect&)>& faces_in) {
  FaceSelection selection(scene.objects);
  const Mask mask(region, scene.size);
  if (mask.empty()) return selection;
  const std::vector<PlacedMesh> placed = placed_meshes(scene);
  std::vector<std::uint32_t> first_face;
  std::uint32_t faces = 0;
  for (const MeshObject& mesh : scene.objects.meshes) {
    first_face.push_back(faces);
    faces += static_cast<std::uint32_t>(mesh.mesh->face_count());
  }
  const QRect& area = mask.rectangle();
  const QRect upwards(area.x(), scene.size.height() - area.y() - area.height(), area.width(), area.height());
  const std::vector<FacePixel> pixels = faces_in(upwards);
  const auto pixel_at = [&](int x, int y) {
    return pixels[static_cast<std::size_t>(area.height() - 1 - y) * static_cast<std::size_t>(area.width()) +
                  static_cast<std::size_t>(x)];
  };
  for (int y = 0; y < area.height(); ++y) {
    for (int x = 0; x < area.width(); ++x) {
      const FacePixel pixel = pixel_at(x, y);
      if (pixel.instance == 0 || !mask.has(x, y)) continue;
      const std::uint32_t mesh = placed[pixel.instance - 1].mesh;
      selection.set({mesh, pixel.face - first_face[mesh]});
    }
  }
  for (const PlacedMesh& mesh : placed) {
    for_each_centre(scene, mask, mesh, [&](std::uint32_t face, int x, int y) {
      const FacePixel pixel = pixel_at(x, y);
      if (pixel.instance == 0 || selection.has({mesh.mesh, face})) return;
      const PlacedMesh& shown = placed[pixel.instance - 1];
      if (is_seen_small(scene, mesh, face, shown, pixel.face - first_face[shown.mesh]))
        selection.set({mesh.mesh, face});
    });
  }
  return selection;
}

FaceSelection all_in_region(const ProjectedScene& scene, const QPainterPath& region) {
  FaceSelection selection(scene.objects);
  const Mask mask(region, scene.size);
  if (mask.empty()) return selection;
  for (const PlacedMesh& mesh : placed_meshes(scene)) {
    for_each_centre(scene, mask, mesh, [&](std::uint32_t face, int, int) {
      selection.set({mesh.mesh, face});
    });
  }
  return selection;
}

}  // namespace editor
