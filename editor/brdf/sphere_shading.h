// A picture of a sphere with a BRDF, by C++ or by GLSL from one text, as linear values.
#pragma once

#include <QImage>
#include <array>
#include <memory>
#include <vector>

#include "editor/brdf/lobe_curves.h"
#include "editor/graphics/graphics_driver.h"
#include "editor/jobs/background_job.h"

class QOpenGLContext;

namespace editor {

/// Mirror weights by angle of view from 0 to 90 degrees: they depend on nothing else.
using MirrorTable = std::array<reflectance::Rgb, 64>;
MirrorTable mirror_table(const reflectance::Brdf& brdf);

struct SphereScene {
  SharedBrdf brdf;
  int side = 0;                                    ///< of the picture, in pixels
  reflectance::Vec3f light = {0.32F, 0.5F, 0.8F};  ///< towards the light, in the frame of sphere.glsl; unit
  float light_strength = reflectance::Pi;          ///< irradiance: pi shows a white matte surface as 1
};

/// Linear radiance, rows from the top; 0 outside of the sphere, whose radius is `radius_of(side)` pixels.
struct SphereImage {
  int side = 0;
  std::vector<reflectance::Rgb> radiance;
  bool is_by_glsl = false;
};

float radius_of(int side);

/// The normal that is seen at a place of the picture (pixels from its upper left corner); z < 0 outside.
reflectance::Vec3f sphere_normal(int side, double x, double y);

/// As it is on a screen: sRGB, exposed by powers of two, smooth at the rim, and transparent around it.
QImage displayed(const SphereImage& image, double stops);

/// Shades by C++, on all cores. `samples` are directions to the sky, a multiple of 4. Empty after the flag is
/// set.
SphereImage shade_by_cpp(const SphereScene& scene, int samples, const StopFlag& stop);

/// Shades by GLSL. It is made, used and destroyed while its context is current.
class SphereShader {
 public:
  /// The context is of OpenGL 3.3 or later. Null if it cannot draw.
  static std::unique_ptr<SphereShader> create(QOpenGLContext& context, const GraphicsDriver& driver = {});
  ~SphereShader();

  /// Nothing for BRDFs that have no shader, and if the driver refuses it. Not all of it after the flag is
  /// set.
  std::optional<SphereImage> shade(const SphereScene& scene, int samples, const StopFlag& stop);
  /// Why the driver refused the BRDF that was to be shaded last; empty: it did not.
  const QString& refusal() const;

 private:
  struct Parts;
  explicit SphereShader(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace editor
