#pragma once

#include <array>
#include <cmath>
#include <memory>

#include "grf/relocate.h"
#include "renderer/bake/bake.h"
#include "renderer/bake/baked_scene.h"
#include "tests/transport/scene_helpers.h"

namespace test {

/// A scene from GRF text, compiled for baking.
struct BakeScene {
  explicit BakeScene(const std::string& text)
      : scene(grf::flatten(parsed(text), "test.grf")),
        compiled(compiled_of(scene)),
        points(scene, compiled) {}

  grf::Scene scene;
  transport::CompiledScene compiled;
  bake::BakePoints points;

 private:
  static grf::Scene parsed(const std::string& text) {
    grf::Diagnostics diagnostics;
    auto scene = grf::read_text(text, "test.grf", diagnostics);
    if (!scene || !grf::check(*scene, reflectance::catalogue(), diagnostics)) {
      throw std::runtime_error(diagnostics.to_text());
    }
    return std::move(*scene);
  }
  static transport::CompiledScene compiled_of(const grf::Scene& scene) {
    grf::Diagnostics diagnostics;
    auto compiled = transport::compile(scene, diagnostics, bake::without_instances({}));
    if (!compiled) throw std::runtime_error(diagnostics.to_text());
    return std::move(*compiled);
  }
};

inline bake::BakeSettings bake_settings(int samples, int depth = 5) {
  bake::BakeSettings settings;
  settings.samples = samples;
  settings.integrator.depth = depth;
  return settings;
}

/// Returns all values of a bake, in order.
inline std::vector<transport::Rgb> values_of(const bake::Bake& bake) {
  std::vector<transport::Rgb> values;
  for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
    for (int k = 0; k < std::max(1, bake.settings().directions); ++k) {
      values.push_back(bake.irradiance(i, k));
    }
  }
  return values;
}

/// The irradiance of a polygon (Lambert 1760): half the sum over its edges of the angle that each subtends,
/// times the cosine between the normal and the edge's plane.
inline double irradiance_of_polygon(const Imath::V3d& place, const Imath::V3d& normal,
                                    const std::array<Imath::V3d, 4>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Imath::V3d a = (corners[i] - place).normalized();
    const Imath::V3d b = (corners[(i + 1) % 4] - place).normalized();
    const Imath::V3d across = a.cross(b);
    sum += std::atan2(across.length(), a.dot(b)) * normal.dot(across.normalized());
  }
  return std::abs(sum) / 2;
}

/// A box from (0,0,0) to (size,size,size) with inward fronts; each wall has cells x cells squares with
/// vertices of its own.
inline std::string room(const std::string& attributes, int cells, float size = 1) {
  std::string vertices;
  std::string faces;
  int first = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      for (int i = 0; i <= cells; ++i) {
        for (int k = 0; k <= cells; ++k) {
          transport::Vec3f p;
          p[axis] = side == 0 ? 0 : size;
          p[(axis + 1) % 3] = size * static_cast<float>(i) / static_cast<float>(cells);
          p[(axis + 2) % 3] = size * static_cast<float>(k) / static_cast<float>(cells);
          vertices += fmt::format("({},{},{})\n", p.x, p.y, p.z);
        }
      }
      for (int i = 0; i < cells; ++i) {
        for (int k = 0; k < cells; ++k) {
          const int a = first + i * (cells + 1) + k;
          const int b = a + cells + 1;
          faces += side == 0 ? fmt::format("({},{},{},{})\n", a, b, b + 1, a + 1)
                             : fmt::format("({},{},{},{})\n", a, a + 1, b + 1, b);
        }
      }
      first += (cells + 1) * (cells + 1);
    }
  }
  return "begin mesh " + attributes + "\nbegin vertexs\n" + vertices + "end vertexs begin faces\n" + faces +
         "end faces end mesh\n";
}

}  // namespace test
