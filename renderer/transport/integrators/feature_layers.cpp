#include "renderer/transport/integrators/feature_layers.h"

#include <limits>

#include "renderer/parallel/loops.h"
#include "renderer/transport/sobol.h"

namespace transport {
namespace {

/// Sums over the camera rays of one pixel.
struct PixelFeatures {
  Rgb albedo = Rgb(0);
  Vec3f normal = Vec3f(0);
  float depth = 0;
  int hits = 0;
};

/// An unbiased Monte Carlo estimate of the albedo, by the sampling scheme.
Rgb albedo_estimate(const reflectance::Reflector& reflector, const Vec3f& u, PathSampler& sampler) {
  constexpr int Directions = 4;
  const SampleSet points = sampler.next_set(Directions);
  Rgb sum(0);
  for (int i = 0; i < Directions; ++i) {
    const Uniform4 xi = points[i];
    if (const auto drawn = reflector.sample(u, {xi.xy(), xi.z})) sum += drawn->weight;
  }
  return sum / Directions;
}

/// The shading normal as paths use it: replaced by the geometric one if it points away from the eye.
Vec3f normal_towards(const Vec3f& back, const SurfacePoint& point) {
  const float side = back.dot(point.geometric_normal) < 0 ? -1.0F : 1.0F;
  const Vec3f shading = side * point.shading_normal;
  return shading.dot(back) > 0 ? shading : side * point.geometric_normal;
}

class FeatureRays {
 public:
  FeatureRays(const CompiledScene& scene, const View& view, int width, int height)
      : scene_(scene),
        camera_(camera_of(scene, view, width, height)),
        eye_(scene.to_local(view.eye)),
        forward_((view.target - view.eye).normalized()) {}

  void add(int column, int row, PathSampler& sampler, PixelFeatures& features) const {
    const Uniform4 place = sampler.next();
    const Ray ray = camera_.ray(static_cast<float>(column) + place.x, static_cast<float>(row) + place.y,
                                {place.z, place.w});
    const auto point = scene_.intersect(ray, sampler.word());
    if (!point) return;
    const Vec3f back = -ray.direction;
    const Vec3f normal = normal_towards(back, *point);
    ++features.hits;
    features.normal += normal;
    features.depth += (point->position - eye_).dot(forward_);
    std::optional<reflectance::Reflector> varied;
    const reflectance::Reflector* reflector = scene_.reflector_at(*point, varied);
    if (reflector == nullptr) return;
    const Vec3f u = reflectance::Frame(normal, point->tangent).to_local(back);
    if (u.z > 0) features.albedo += point->colour * albedo_estimate(*reflector, u, sampler);
  }

 private:
  const CompiledScene& scene_;
  Camera camera_;
  Vec3f eye_;
  Vec3f forward_;
};

}  // namespace

FeatureLayers feature_layers(const CompiledScene& scene, const View& view, int width, int height, int samples,
                             std::uint32_t seed, int threads, const std::optional<CropWindow>& crop) {
  const CropWindow window = crop.value_or(CropWindow{0, 0, width, height});
  const std::size_t count = static_cast<std::size_t>(window.width) * static_cast<std::size_t>(window.height);
  FeatureLayers layers;
  layers.albedo = {window.width, window.height, std::vector<Rgb>(count)};
  layers.normal = {window.width, window.height, std::vector<Rgb>(count)};
  layers.depth.resize(count);
  const FeatureRays rays(scene, view, width, height);
  const auto fill = [&](int column, int row) {
    const int x = window.x + column;
    const int y = window.y + row;
    const std::uint32_t pixel_seed =
        hash(hash(seed, static_cast<std::uint32_t>(x)), static_cast<std::uint32_t>(y));
    PixelFeatures sum;
    for (int sample = 0; sample < samples; ++sample) {
      PathSampler sampler(pixel_seed, static_cast<std::uint32_t>(sample));
      rays.add(x, y, sampler, sum);
    }
    const std::size_t index = static_cast<std::size_t>(row) * static_cast<std::size_t>(window.width) +
                              static_cast<std::size_t>(column);
    layers.albedo.pixels[index] = sum.albedo / static_cast<float>(samples);
    layers.normal.pixels[index] = sum.normal / static_cast<float>(samples);
    layers.depth[index] =
        sum.hits > 0 ? sum.depth / static_cast<float>(sum.hits) : std::numeric_limits<float>::infinity();
  };
  parallel::run_with_threads(threads, [&] {
    parallel::for_each_index(window.height, [&](int row) {
      for (int column = 0; column < window.width; ++column) fill(column, row);
    });
  });
  return layers;
}

}  // namespace transport
