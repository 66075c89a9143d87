// A BRDF scene holds all that the BRDF viewer draws, as values that its thread can use.
#pragma once

#include <QColor>
#include <QImage>
#include <QPoint>
#include <QStringList>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "editor/document/scene_objects.h"
#include "editor/view/mesh_geometry.h"
#include "renderer/studies/brdf_viewer/lit_object.h"

namespace editor {

/// An object of one or several meshes.
struct ViewedObject {
  struct Part {
    std::shared_ptr<const MeshGeometry> geometry;
    std::vector<grf::Matrix44d> to_world;  ///< of its instances
  };
  std::vector<Part> parts;
  grf::Box3d bounds;
  std::size_t triangles = 0;  ///< of all instances
};
/// Triangulates the meshes of a scene, which takes long for large ones.
std::shared_ptr<const ViewedObject> viewed_object(const SceneObjects& objects);

struct BrdfScene {
  std::shared_ptr<const ViewedObject> object;  ///< null: nothing is drawn
  std::array<std::shared_ptr<const studies::LitBrdf>, 2> brdfs;
  double split = 1;  ///< fraction of the width that shows the first one
  studies::Lighting lighting;
  transport::View view;
  QSize size;          ///< device pixels
  float exposure = 0;  ///< stops
  bool has_backdrop = false;
  QColor background_top, background_bottom;

  /// The first column of the second BRDF in an image of this width.
  int split_column(int width) const;
  const studies::LitBrdf& brdf_at(int column) const {
    return *brdfs[column < split_column(size.width()) ? 0 : 1];
  }
  /// The number of directions of the environment per pixel; 0 without an environment.
  int samples() const;
  double aspect() const { return static_cast<double>(size.width()) / size.height(); }
  /// The direction towards the eye from what is at a place of the image, -1..1 from the left to the right and
  /// from the bottom to the top.
  reflectance::Vec3f to_eye(double x, double y) const;
};

/// The normals of an image's pixels, rows from the top; 0 for the background.
struct NormalImage {
  QSize size;
  std::vector<reflectance::Vec3f> normals;
};

/// The light of the pixel under the pointer, by the GPU and by the CPU with the same directions of the
/// environment.
struct PixelProbe {
  QPoint pixel;
  bool is_object = false;  ///< else the background
  bool is_first = true;    ///< whether it shows the first BRDF
  reflectance::Vec3f normal = reflectance::Vec3f(0);
  double view_angle = 0;  ///< degrees from the normal
  reflectance::Rgb by_gpu = reflectance::Rgb(0);
  reflectance::Rgb by_cpu = reflectance::Rgb(0);
};

/// The GLSL of a BRDF's fragment shader; empty if it has none.
struct ShaderSource {
  QString text;
  QString log;  ///< why the driver cannot compile it; empty if it can

  bool operator==(const ShaderSource&) const = default;
};

/// An image of the viewer, as it is refined.
struct BrdfImage {
  QImage image;
  int number = 0;  ///< of the request
  int passes = 0;  ///< that it is the mean of; 0: a draft
  int all_passes = 1;
  double seconds = 0;  ///< that a draft took
  int scale = 1;       ///< device pixels per pixel of a draft
  bool is_by_glsl = true;
  std::array<ShaderSource, 2> sources;
  QStringList limitations;                     ///< messages about what is not drawn as it should be
  std::shared_ptr<const NormalImage> normals;  ///< null if they are not known
  std::optional<PixelProbe> probe;

  bool is_done() const { return passes >= all_passes; }
};

}  // namespace editor
