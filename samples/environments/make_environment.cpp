// Writes an environment map of the samples as OpenEXR (half float), made by formula and the same on every
// machine: y is up, the image's centre looks down -z, and right of it is +x.
//   overcast  the CIE overcast sky, three times as bright at the zenith as at the horizon (Moon and Spencer
//             1942, "Illumination from a non-uniform sky"), over grey ground
//   sky       a clear sky with a low sun, larger than the real one, over dull ground
//   studio    a dark room with a large soft light above, and strips of light left, right and behind
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <ImathVec.h>
#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <fmt/format.h>

namespace {

using Imath::V3d;

constexpr int Width = 512;
constexpr int Height = 256;
constexpr double Pi = std::numbers::pi;
constexpr double Degree = Pi / 180;

/// From 0 to 1 without a corner while x goes from `from` to `to`.
double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// A direction in degrees: azimuth from -z (0) over +x (90), and height over the horizon.
struct Direction {
  double azimuth = 0;
  double height = 0;

  V3d unit() const {
    const double a = azimuth * Degree;
    const double h = height * Degree;
    return {std::cos(h) * std::sin(a), std::sin(h), -std::cos(h) * std::cos(a)};
  }
};

V3d sky(const Direction& direction) {
  constexpr Direction Sun = {-128, 36};
  const double away = std::acos(std::clamp(direction.unit().dot(Sun.unit()), -1.0, 1.0)) / Degree;
  if (direction.height < 0) {
    return V3d(0.2, 0.18, 0.15) + V3d(0.5, 0.47, 0.44) * std::exp(direction.height / 2.5);
  }
  const double haze = std::exp(-direction.height / 16);
  const V3d blue = V3d(0.13, 0.28, 0.66) + V3d(0.5, 0.42, 0.16) * haze;
  const V3d glow = V3d(1.5, 1.2, 0.8) * std::exp(-away / 9);
  return blue + glow + V3d(200, 164, 118) * (1 - smooth_step(2, 7.5, away));
}

V3d overcast(const Direction& direction) {
  constexpr V3d Zenith = {1.0, 1.03, 1.1};
  if (direction.height < 0) return Zenith * 0.12;
  return Zenith * ((1 + 2 * std::sin(direction.height * Degree)) / 3);
}

/// A rectangle of light with soft edges.
struct Lamp {
  Direction centre;
  double width = 0;   ///< degrees
  double height = 0;  ///< degrees
  V3d radiance;

  V3d towards(const Direction& direction) const {
    constexpr double Softness = 5;
    const double across = std::abs(std::remainder(direction.azimuth - centre.azimuth, 360.0));
    const double up = std::abs(direction.height - centre.height);
    const double inside = (1 - smooth_step(width / 2 - Softness, width / 2, across)) *
                          (1 - smooth_step(height / 2 - Softness, height / 2, up));
    return radiance * inside;
  }
};

V3d studio(const Direction& direction) {
  const std::array lamps = {Lamp{{-118, 22}, 16, 64, {2.6, 2.7, 2.9}},
                            Lamp{{104, 24}, 34, 56, {1.3, 1.2, 1.05}},
                            Lamp{{10, 20}, 110, 14, {1.1, 1.15, 1.3}}};
  const double up = direction.height;
  V3d sum = V3d(0.08, 0.085, 0.1) + V3d(0.16, 0.17, 0.2) * smooth_step(-30, 60, up);
  sum += V3d(0.3, 0.3, 0.31) * smooth_step(45, 80, up);
  for (const Lamp& lamp : lamps) sum += lamp.towards(direction);
  return sum;
}

void write(V3d (*radiance_from)(const Direction&), const std::string& path) {
  Imf::Array2D<Imf::Rgba> pixels(Height, Width);
  for (int y = 0; y < Height; ++y) {
    for (int x = 0; x < Width; ++x) {
      const V3d radiance = radiance_from({(x + 0.5) / Width * 360 - 180, 90 - (y + 0.5) / Height * 180});
      const auto half_of = [](double value) { return Imath::half(static_cast<float>(value)); };
      pixels[y][x] = {half_of(radiance.x), half_of(radiance.y), half_of(radiance.z), half_of(1)};
    }
  }
  Imf::Header header(Width, Height);
  header.compression() = Imf::PIZ_COMPRESSION;
  Imf::RgbaOutputFile file(path.c_str(), header, Imf::WRITE_RGB);
  file.setFrameBuffer(&pixels[0][0], 1, Width);
  file.writePixels(Height);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  const std::map<std::string, V3d (*)(const Direction&)> environments = {
      {"overcast", overcast}, {"sky", sky}, {"studio", studio}};
  const auto environment = environments.find(name);
  if (argc != 3 || environment == environments.end()) {
    fmt::print(stderr, "usage: make_environment overcast|sky|studio FILE.exr\n");
    return 2;
  }
  try {
    write(environment->second, argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
