#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/reflectance/geometry.h"

namespace test {

/// Shader inputs besides directions: numbers and colours in rows of `width`, one per `pairs_each` pairs of
/// directions. In a shader, `parameter(k)` is the k-th of a pair's row.
struct ShaderParameters {
  int width = 1;
  int pairs_each = 1;
  std::vector<reflectance::Rgb> values;
};

/// An OpenGL 3.3 context without a window (surfaceless EGL), to run a BRDF's shader over lists of directions.
class GlslContext {
 public:
  GlslContext();
  ~GlslContext();
  GlslContext(const GlslContext&) = delete;
  GlslContext& operator=(const GlslContext&) = delete;

  std::string renderer() const;

  /// Evaluates `expression` of `u` and `v` for each pair of directions. `functions` is the GLSL before it.
  /// Throws the compiler's log on errors.
  std::vector<reflectance::Rgb> run(const std::string& functions, const std::string& expression,
                                    const std::vector<reflectance::Vec3f>& u,
                                    const std::vector<reflectance::Vec3f>& v,
                                    const ShaderParameters& parameters);

 private:
  struct Display;
  std::unique_ptr<Display> display_;
};

}  // namespace test
