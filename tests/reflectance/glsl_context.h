#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/reflectance/geometry.h"

namespace test {

/// Numbers and colours that a BRDF's shader takes besides directions: a row of `width` of them for each
/// `pairs_each` pairs of directions. In a shader `parameter(k)` is the k-th of a pair's row.
struct ShaderParameters {
  int width = 1;
  int pairs_each = 1;
  std::vector<reflectance::Rgb> values;
};

/// OpenGL 3.3 without a window (surfaceless EGL), to run a BRDF's shader over lists of directions.
class GlslContext {
 public:
  GlslContext();
  ~GlslContext();
  GlslContext(const GlslContext&) = delete;
  GlslContext& operator=(const GlslContext&) = delete;

  std::string renderer() const;

  /// For each pair of directions, `expression`, in which `u` and `v` are the two. The functions are GLSL
  /// that comes before. Throws the compiler's log if it is not accepted.
  std::vector<reflectance::Rgb> run(const std::string& functions, const std::string& expression,
                                    const std::vector<reflectance::Vec3f>& u,
                                    const std::vector<reflectance::Vec3f>& v,
                                    const ShaderParameters& parameters);

 private:
  struct Display;
  std::unique_ptr<Display> display_;
};

}  // namespace test
