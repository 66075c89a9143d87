// BRDFs that are tabulated in the format of the RGL data base, evaluated from the published description
// alone.
#include "renderer/reflectance/rgl_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/observer.h"
#include "renderer/reflectance/spectrum.h"

namespace {

using Imath::V2d;
using Imath::V3d;
using reflectance::Brdf;
using reflectance::Rgb;
using reflectance::RglColours;
using reflectance::Vec3f;

constexpr double HalfPi = std::numbers::pi / 2;

/// A reader of the format that shares no code with the library: the arrays of a file by name, as numbers.
struct Arrays {
  std::map<std::string, std::vector<double>> values;
  std::map<std::string, std::vector<std::size_t>> shapes;

  explicit Arrays(const std::string& file) {
    EXPECT_EQ(file.substr(0, 12), std::string("tensor_file\0", 12));
    std::size_t at = 14;
    const auto take = [&](std::size_t size) {
      std::uint64_t number = 0;
      std::memcpy(&number, file.data() + at, size);
      at += size;
      return number;
    };
    for (std::uint64_t left = take(4); left > 0; --left) {
      const std::size_t length = take(2);
      const std::string name = file.substr(at, length);
      at += length;
      const std::size_t rank = take(2);
      const std::uint64_t type = take(1);
      const std::size_t offset = take(8);
      std::size_t count = 1;
      for (std::size_t i = 0; i < rank; ++i) {
        shapes[name].push_back(take(8));
        count *= shapes[name].back();
      }
      for (std::size_t i = 0; i < count; ++i) {
        float number = 0;
        if (type == 10) std::memcpy(&number, file.data() + offset + 4 * i, 4);
        values[name].push_back(type == 10 ? double(number)
                                          : double(static_cast<unsigned char>(file[offset + i])));
      }
    }
  }
};

/// The slice of a table at a node of views, bilinear between its nodes.
struct Slice {
  const double* values = nullptr;
  std::size_t width = 0;
  std::size_t height = 0;

  double at(const V2d& point) const {
    const auto split = [](double x, std::size_t count, std::size_t& cell) {
      const double place = std::clamp(x, 0.0, 1.0) * static_cast<double>(count - 1);
      cell = std::min(static_cast<std::size_t>(place), count - 2);
      return place - static_cast<double>(cell);
    };
    std::size_t x = 0;
    std::size_t y = 0;
    const double fx = split(point.x, width, x);
    const double fy = split(point.y, height, y);
    const auto node = [&](std::size_t i, std::size_t k) { return values[(y + k) * width + x + i]; };
    return (1 - fy) * ((1 - fx) * node(0, 0) + fx * node(1, 0)) +
           fy * ((1 - fx) * node(0, 1) + fx * node(1, 1));
  }
};

/// Integrates a density that is bilinear between nodes, by its rows and columns, up to a point: the uniform
/// point that is warped to it (Dupuy and Jakob 2018, section 4).
V2d uniform_point(const Slice& density, const V2d& point) {
  constexpr int Steps = 4096;
  const auto row_integral = [&](double y, double to) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < density.width; ++i) {
      const double left = static_cast<double>(i) / static_cast<double>(density.width - 1);
      const double right = std::min(to, static_cast<double>(i + 1) / static_cast<double>(density.width - 1));
      if (right <= left) break;
      sum += (right - left) * (density.at({left, y}) + density.at({right, y})) / 2;
    }
    return sum;
  };
  double below = 0;
  double all = 0;
  for (int i = 0; i < Steps; ++i) {
    const double y = (i + 0.5) / Steps;
    const double row = row_integral(y, 1) / Steps;
    all += row;
    below += row * std::clamp(point.y * Steps - i, 0.0, 1.0);
  }
  return {row_integral(point.y, point.x) / row_integral(point.y, 1), below / all};
}

/// Evaluates a file for a view at a node of its tables.
std::vector<double> value_of(const Arrays& file, std::size_t azimuth, std::size_t angle, const V3d& v) {
  const double phi = file.values.at("phi_i")[azimuth];
  const double theta = file.values.at("theta_i")[angle];
  const bool is_isotropic = file.values.at("phi_i").size() <= 2;
  const V3d u(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
  const V3d half = (u + v).normalized();
  const double turn = is_isotropic ? phi : 0;
  const auto point = [&](const V3d& direction) {
    const double turns =
        (std::atan2(direction.y, direction.x) - turn + std::numbers::pi) / (2 * std::numbers::pi);
    return V2d(std::sqrt(std::acos(std::clamp(direction.z, -1.0, 1.0)) / HalfPi), turns - std::floor(turns));
  };
  const std::size_t view = azimuth * file.values.at("theta_i").size() + angle;
  const auto slice = [&](const std::string& name, std::size_t number) {
    const auto& shape = file.shapes.at(name);
    const std::size_t width = shape.back();
    const std::size_t height = shape[shape.size() - 2];
    return Slice{file.values.at(name).data() + number * width * height, width, height};
  };
  const V2d uniform = uniform_point(slice("vndf", view), point(half));
  const double factor = slice("ndf", 0).at(point(half)) / (4 * slice("sigma", 0).at(point(u)) * v.z);
  const std::string name = file.values.contains("spectra") ? "spectra" : "rgb";
  const std::size_t channels = file.shapes.at(name)[2];
  std::vector<double> values;
  for (std::size_t k = 0; k < channels; ++k)
    values.push_back(slice(name, view * channels + k).at(uniform) * factor);
  return values;
}

V3d view_at(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// The mean difference of a file from the BRDF at its nodes of views, as a fraction of the mean value.
double error_of(const Brdf& brdf, const Arrays& file) {
  double difference = 0;
  double sum = 0;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  const std::size_t azimuths = file.values.at("phi_i").size();
  for (int i = 0; i < 120; ++i) {
    const std::size_t azimuth = random() % azimuths;
    const std::size_t angle = random() % (file.values.at("theta_i").size() - 2);
    const double phi = file.values.at("phi_i")[azimuth];
    const V3d u = view_at(file.values.at("theta_i")[angle], phi);
    const V3d v = view_at(1.3 * uniform(random), 2 * std::numbers::pi * uniform(random));
    const Rgb expected = reflectance::evaluate(brdf, Vec3f(u), Vec3f(v));
    const std::vector<double> values = value_of(file, azimuth, angle, v);
    for (std::size_t k = 0; k < 3; ++k) {
      difference += std::abs(values[k] - double(expected[static_cast<int>(k)]));
      sum += double(expected[static_cast<int>(k)]);
    }
  }
  return difference / sum;
}

reflectance::RglResolution small() { return {8, 8, 48, 32}; }

TEST(RglWriter, HasTheValuesOfIsotropicBrdfs) {
  reflectance::Ggx ggx;
  ggx.alpha = ggx.ay = 0.4F;
  ggx.prepare();
  reflectance::Diffuse diffuse;
  diffuse.kd = Rgb(0.8F, 0.4F, 0.1F);
  reflectance::Eon eon;
  const std::map<std::string, Brdf> brdfs = {{"ggx", ggx}, {"diffuse", diffuse}, {"eon", eon}};
  for (const auto& [name, brdf] : brdfs) {
    const Arrays file(reflectance::rgl_file_of(brdf, small(), RglColours::LinearSrgb, name));
    EXPECT_EQ(file.shapes.at("phi_i"), std::vector<std::size_t>{1}) << name;
    EXPECT_EQ(file.values.at("jacobian"), std::vector<double>{1}) << name;
    EXPECT_LT(error_of(brdf, file), 0.03) << name;
  }
}

TEST(RglWriter, HasTheValuesOfAnisotropicBrdfsOverTheFullTurn) {
  reflectance::Ward ward;
  ward.sx = 0.25F;
  ward.sy = 0.6F;
  ward.kd = Rgb(0.2F);
  const Arrays file(reflectance::rgl_file_of(ward, small(), RglColours::LinearSrgb, "ward"));
  const auto& azimuths = file.values.at("phi_i");
  EXPECT_NEAR(azimuths.front(), -std::numbers::pi, 1e-6);
  EXPECT_NEAR(azimuths.back(), std::numbers::pi, 1e-6);
  EXPECT_LT(error_of(ward, file), 0.05);
}

TEST(RglWriter, HasTheWavelengthsOfAModel) {
  reflectance::ThinFilm film;
  film.alpha = film.ay = 0.4F;
  film.nreal = Rgb(2.5F);
  film.prepare();
  const Arrays file(reflectance::rgl_file_of(film, small(), RglColours::Spectra, "film"));
  std::vector<float> wavelengths;
  for (const double wavelength : file.values.at("wavelengths"))
    wavelengths.push_back(static_cast<float>(wavelength));
  const V3d u = view_at(file.values.at("theta_i")[2], 0);
  for (const V3d& v : {view_at(0.3, 3), view_at(0.9, 2.5), view_at(0.1, 1)}) {
    const std::vector<double> values = value_of(file, 0, 2, v);
    const std::vector<double> expected = reflectance::spectrum_of(film, u, v, wavelengths);
    for (std::size_t i = 0; i < values.size(); ++i)
      EXPECT_NEAR(values[i], expected[i], 0.05 * expected[i]) << v;
  }
}

// Spectra of a BRDF in RGB have that RGB to the observer; a grey one is flat.
TEST(RglWriter, MakesSpectraOfRgb) {
  reflectance::Diffuse diffuse;
  for (const Rgb& colour : {Rgb(0.8F, 0.5F, 0.3F), Rgb(0.2F, 0.6F, 0.4F), Rgb(0.5F)}) {
    diffuse.kd = colour;
    const Arrays file(reflectance::rgl_file_of(diffuse, small(), RglColours::Spectra, "diffuse"));
    std::vector<float> wavelengths;
    for (const double wavelength : file.values.at("wavelengths"))
      wavelengths.push_back(static_cast<float>(wavelength));
    const auto weights = reflectance::rgb_weights(wavelengths);
    const std::vector<double> values = value_of(file, 0, 1, view_at(0.4, 2));
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < values.size(); ++i) sum += weights[k][i] * values[i];
      EXPECT_NEAR(sum * std::numbers::pi, colour[static_cast<int>(k)], 0.02) << colour;
    }
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    if (colour == Rgb(0.5F)) {
      EXPECT_NEAR(*least, *most, 1e-6);
    }
  }
}

// More nodes, less error.
TEST(RglWriter, ConvergesWithItsResolution) {
  reflectance::Ggx ggx;
  ggx.alpha = ggx.ay = 0.2F;
  ggx.prepare();
  const double coarse = error_of(
      ggx, Arrays(reflectance::rgl_file_of(ggx, small().times(0.5), RglColours::LinearSrgb, "coarse")));
  const double fine =
      error_of(ggx, Arrays(reflectance::rgl_file_of(ggx, small().times(2), RglColours::LinearSrgb, "fine")));
  EXPECT_LT(fine, 0.6 * coarse);
}

}  // namespace
