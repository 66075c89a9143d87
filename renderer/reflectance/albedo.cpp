#include "renderer/reflectance/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/reflectance/halton.h"

namespace reflectance {
Rgb albedo(const Reflector& reflector, const Vec3f& u, int count) {
  Imath::V3d sum(0);
  for (int i = 0; i < count; ++i) {
    const auto drawn = reflector.sample(u, halton_point(static_cast<std::uint32_t>(i)));
    if (drawn) sum += Imath::V3d(drawn->weight);
  }
  return Rgb(sum / count);
}

grf::LargestAlbedo largest_albedo(const Brdf& brdf) {
  constexpr int Rough = 512;
  constexpr int Fine = 8192;
  const Reflector reflector(brdf, OwnScheme());
  const std::array<float, 3> azimuths = {0, Pi / 2, Pi};
  const std::size_t azimuth_count = is_anisotropic(brdf) ? azimuths.size() : 1;
  grf::LargestAlbedo most;
  for (const float degrees : {0.0F, 30.0F, 60.0F, 80.0F, 85.0F}) {
    const float theta = degrees * Pi / 180;
    for (std::size_t i = 0; i < azimuth_count; ++i) {
      const Vec3f u = from_angles(std::cos(theta), std::sin(theta), azimuths[i]);
      float value = largest(albedo(reflector, u, Rough));
      if (value > 1) value = largest(albedo(reflector, u, Fine));
      if (value > most.albedo) most = {value, degrees};
    }
  }
  return most;
}

}  // namespace reflectance
