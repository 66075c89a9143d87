#include "editor/view/cpu_shading.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "renderer/reflectance/shader.h"

namespace editor {
namespace {

using reflectance::Rgb;

/// The C++ side of sky.glsl, view_environment.glsl and reflected_light.glsl, in double, the type of
/// unsuffixed literals in C++.
struct LightFormula {
  // NOLINTBEGIN(readability-identifier-naming): GLSL's names
  using real = double;
  using uint = std::uint32_t;
  using vec2 = Imath::V2d;
  using vec3 = Imath::V3d;
  static constexpr double PI = std::numbers::pi;

  /// Three columns.
  struct mat3 {
    vec3 x, y, z;

    mat3(const vec3& a, const vec3& b, const vec3& c) : x(a), y(b), z(c) {}
    vec3 operator*(const vec3& v) const { return x * v.x + y * v.y + z * v.z; }
    mat3 operator*(const mat3& m) const { return {*this * m.x, *this * m.y, *this * m.z}; }
    friend vec3 operator*(const vec3& v, const mat3& m) { return {v.dot(m.x), v.dot(m.y), v.dot(m.z)}; }
  };
  // NOLINTEND(readability-identifier-naming)

  const reflectance::CombinedBrdf* term = nullptr;
  const SceneEnvironment* environment = nullptr;
  real headlight = static_cast<real>(StudioHeadlight);
  int light_count = 0;
  std::vector<vec3> light_directions;
  std::vector<vec3> light_irradiance;

  void set_environment(const SceneEnvironment* of_scene) {
    environment = of_scene;
    if (environment == nullptr) return;
    headlight = 0;
    for (const reflectance::DistantLight& light : environment->world_lights()) {
      light_directions.emplace_back(light.direction);
      light_irradiance.emplace_back(light.irradiance);
      ++light_count;
    }
  }

  vec3 sampled_sky(const vec3& d) {
    if (environment == nullptr) return studio_sky(d);
    return vec3(studies::below_limit(environment->sky(reflectance::Vec3f(d)), environment->limit()));
  }

  vec3 model(const vec3& u, const vec3& v) const {
    const reflectance::Vec3f from(u);
    const reflectance::Vec3f to(v);
    return vec3(term->contribution(reflectance::evaluate(term->brdf, from, to), from, to));
  }

  static real exp(real x) { return std::exp(x); }
  static real expm1(real x) { return std::expm1(x); }
  static real log1p(real x) { return std::log1p(x); }
  static real sqrt(real x) { return std::sqrt(x); }
  static real sin(real x) { return std::sin(x); }
  static real cos(real x) { return std::cos(x); }
  static real max(real a, real b) { return std::max(a, b); }
  static real dot(const vec3& a, const vec3& b) { return a.dot(b); }
  static vec3 cross(const vec3& a, const vec3& b) { return a.cross(b); }
  static vec3 normalize(const vec3& v) { return v.normalized(); }
  static vec3 mix(const vec3& a, const vec3& b, real t) { return a * (1 - t) + b * t; }
  static vec2 fract(const vec2& v) { return {v.x - std::floor(v.x), v.y - std::floor(v.y)}; }
  static real smoothstep(real from, real to, real x) {
    const real t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }
  static real tan2_of_half(const vec3& h) { return (h.x * h.x + h.y * h.y) / (h.z * h.z); }

#include "editor/view/shaders/reflected_light.glsl"
#include "editor/view/shaders/sky.glsl"
};

using Vec3 = LightFormula::vec3;

/// Decodes as normal_at of g_buffer.glsl does.
Vec3 decoded_normal(const Imath::V4f& encoded) {
  const double x = 2.0 * encoded.x - 1;
  const double y = 2.0 * encoded.y - 1;
  const double z = 1 - std::abs(x) - std::abs(y);
  if (z >= 0) return Vec3(x, y, z).normalized();
  return Vec3(std::copysign(1 - std::abs(y), x), std::copysign(1 - std::abs(x), y), z).normalized();
}

LightFormula::mat3 world_frame(const ViewCamera& camera) {
  const grf::Matrix44d matrix = camera.world_to_camera().inverse();
  const auto axis = [&matrix](const Vec3& camera_axis) {
    Vec3 world_axis;
    matrix.multDirMatrix(camera_axis, world_axis);
    return world_axis;
  };
  return {axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
}

class Shading {
 public:
  Shading(const CpuShading& light, const SurfaceTables& tables, const QSize& size)
      : light_(light),
        tables_(tables),
        size_(size.width(), size.height()),
        to_world_(world_frame(light.camera)) {
    formula_.set_environment(light.environment);
    const double tangent = std::tan(light.camera.field_of_view() * std::numbers::pi / 360);
    tangents_ = {tangent * light.aspect, tangent};
  }

  /// The radiance of a pixel, before multiplication by its colour.
  Vec3 reflected(std::uint32_t surface, const Imath::V4f& normal, int column, int row) {
    const Imath::V4f& terms = tables_.surfaces[SurfaceTables::Rows * surface + 2];
    const auto frame = formula_.frame_about(decoded_normal(normal), normal.z);
    const Vec3 eye =
        formula_.eye_direction({column + 0.5, row + 0.5}, size_, tangents_, light_.camera.is_orthographic());
    const Vec3 u = formula_.local_eye(eye, frame);
    const auto start =
        formula_.pixel_start(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row));
    Vec3 sum(0);
    auto term = static_cast<std::size_t>(terms.x);
    for (int i = 0; i < static_cast<int>(terms.y); ++i) {
      const Imath::V4f& head = tables_.terms[term];
      if (static_cast<std::size_t>(head.y) == light_.model) {
        formula_.term = term_of(term);
        sum += static_cast<double>(head.x) * formula_.reflected_light(u, to_world_ * frame, terms.w, start,
                                                                      light_.samples, light_.first_sample);
      }
      term += 1 + static_cast<std::size_t>(head.z) + static_cast<std::size_t>(head.w);
    }
    return sum;
  }

 private:
  /// Makes the BRDF of a term, once: its parameters and what layers above it transmit are in the table.
  const reflectance::CombinedBrdf* term_of(std::size_t term) {
    const auto [entry, is_new] = terms_.try_emplace(term);
    if (is_new) {
      const Imath::V4f& head = tables_.terms[term];
      const auto parameters = static_cast<std::size_t>(head.z);
      entry->second = {1, reflectance::brdf_of_values(light_.model, values_of(term + 1, parameters))};
      const auto rows = values_of(term + 1 + parameters, static_cast<std::size_t>(head.w));
      if (!rows.empty()) {
        reflectance::Transmission::Table table;
        std::copy_n(rows.begin(), table.size(), table.begin());
        entry->second.transmission = std::make_shared<const reflectance::Transmission>(table);
      }
    }
    return &entry->second;
  }

  std::vector<Rgb> values_of(std::size_t first, std::size_t count) const {
    std::vector<Rgb> values;
    for (std::size_t i = first; i < first + count; ++i) {
      const Imath::V4f& value = tables_.terms[i];
      values.emplace_back(value.x, value.y, value.z);
    }
    return values;
  }

  const CpuShading& light_;
  const SurfaceTables& tables_;
  LightFormula::vec2 size_;
  LightFormula::vec2 tangents_;
  LightFormula::mat3 to_world_;
  LightFormula formula_;
  std::map<std::size_t, reflectance::CombinedBrdf> terms_;  ///< by their place in the table
};

}  // namespace

void add_cpu_shading(const CpuShading& light, const FaceTables& faces, const SurfaceTables& surfaces,
                     GBuffer& g_buffer, int first_row, int rows) {
  GBuffer::Rows read = g_buffer.read_rows(first_row, rows);
  Shading shading(light, surfaces, g_buffer.size());
  const int width = g_buffer.size().width();
  for (int i = 0; i < width * rows; ++i) {
    const auto pixel = static_cast<std::size_t>(i);
    const auto [instance, face] = read.faces[pixel];
    if ((instance & 0x7fffffffU) == 0) continue;
    const std::uint32_t surface = faces.surface_of_face[face];
    const Vec3 reflected = shading.reflected(surface, read.normals[pixel], i % width, first_row + i / width);
    const Imath::V4f& colour = surfaces.surfaces[SurfaceTables::Rows * surface];
    const Imath::V4f& value = read.values[pixel];
    read.light[pixel] +=
        Imath::V3f(colour.x * value.x, colour.y * value.y, colour.z * value.z) * Imath::V3f(reflected);
  }
  g_buffer.set_light(first_row, read.light);
}

}  // namespace editor
