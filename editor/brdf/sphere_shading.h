// Shades an image of a sphere with a BRDF, on the CPU or in GLSL from the same source, as linear values.
#pragma once

#include <QImage>
#include <memory>
#include <vector>

#include "editor/brdf/lobe_curves.h"
#include "editor/graphics/graphics_driver.h"
#include "editor/jobs/background_job.h"
#include "renderer/studies/brdf_viewer/lit_object.h"

class QOpenGLContext;

namespace editor {

struct SphereScene {
  SharedBrdf brdf;
  int side = 0;  ///< side of the image, pixels
  reflectance::Vec3f light = {0.32F, 0.5F,
                              0.8F};  ///< unit vector towards the light, x to the right, y up, z to the eye
  float light_strength = reflectance::Pi;  ///< irradiance: pi shows a white diffuse surface as 1
  studies::Environment environment = {studies::Environment::Kind::Studio};  ///< surrounds the sphere
};

/// Linear radiance, rows from the top; 0 outside of the sphere, whose radius is `radius_of(side)` pixels.
struct SphereImage {
  int side = 0;
  std::vector<reflectance::Rgb> radiance;
  bool is_by_glsl = false;
};

float radius_of(int side);

/// The sphere's normal at a position of the image (pixels from the upper left corner); z < 0 outside.
reflectance::Vec3f sphere_normal(int side, double x, double y);

/// Converts the image for the screen: sRGB, exposed by stops, antialiased at the rim, transparent around it.
QImage displayed(const SphereImage& image, double stops);

/// Shades on the CPU, on all cores. `samples` is the number of sky directions, a multiple of 4. Empty if the
/// flag was set.
SphereImage shade_on_cpu(const SphereScene& scene, int samples, const StopFlag& stop);

/// Shades with GLSL. It is created, used and destroyed while its context is current.
class SphereShader {
 public:
  /// Creates a shader for a context of OpenGL 3.3 or later. Null if it cannot draw.
  static std::unique_ptr<SphereShader> create(QOpenGLContext& context, const GraphicsDriver& driver = {});
  ~SphereShader();

  /// Returns nothing for BRDFs without a shader, and if the driver cannot compile it or hold the map.
  /// Incomplete if the flag was set.
  std::optional<SphereImage> shade(const SphereScene& scene, int samples, const StopFlag& stop);
  /// Why the driver rejected the shader of the last BRDF; empty if it did not.
  const QString& compile_error() const;

 private:
  struct Parts;
  explicit SphereShader(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace editor
