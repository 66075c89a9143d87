// Values of BRDFs at single wavelengths against their RGB, against closed forms, and against the files' own.
#include "renderer/reflectance/spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "renderer/reflectance/brdf.h"
#include "renderer/reflectance/observer.h"
#include "tests/reflectance/rgl_cases.h"

namespace {

using Imath::V3d;
using reflectance::Brdf;
using reflectance::Rgb;
using reflectance::spectrum_of;
using reflectance::wavelengths_of;
using Wavelengths = std::vector<float>;

V3d at_angles(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

reflectance::He rough_surface(const Rgb& lambda) {
  reflectance::He he;
  he.sigma = 0.1F;
  he.tau = 1.5F;
  he.lambda = lambda;
  return he;
}

reflectance::ThinFilm film_of(float thickness, float film, float base) {
  reflectance::ThinFilm model;
  model.alpha = model.ay = 0.001F;
  model.thickness = thickness;
  model.film = film;
  model.nreal = Rgb(base);
  model.prepare();
  return model;
}

TEST(Spectrum, IsThatOfModelsWithWavelengthsAlone) {
  EXPECT_TRUE(wavelengths_of(reflectance::Diffuse()).empty());
  EXPECT_TRUE(wavelengths_of(reflectance::Ggx()).empty());
  EXPECT_TRUE(wavelengths_of(reflectance::Rgl()).empty());
  EXPECT_EQ(wavelengths_of(rough_surface(Rgb(800, 500, 640))), (Wavelengths{500, 640, 800}));
  EXPECT_EQ(wavelengths_of(rough_surface(Rgb(555))), Wavelengths{555});
  const Wavelengths film = wavelengths_of(reflectance::ThinFilm());
  ASSERT_EQ(film.size(), 28U);
  EXPECT_NEAR(film.front(), 385, 1e-3);
  EXPECT_NEAR(film.back(), 720, 1e-3);
  EXPECT_NEAR(1 / film[3] - 1 / film[4], 1 / film[20] - 1 / film[21], 1e-8);
}

TEST(Spectrum, OfWaveOpticsHasTheChannelsAtTheirWavelengths) {
  reflectance::He he = rough_surface(Rgb(610, 540, 450));
  he.ks = Rgb(0.9F, 0.5F, 0.2F);
  he.kd = Rgb(0.1F, 0.2F, 0.05F);
  const V3d u = at_angles(0.5, 0);
  const V3d v = at_angles(0.8, 2.9);
  const V3d rgb = he.evaluate<double>(u, v);
  const std::vector<double> values = spectrum_of(he, u, v, {450, 540, 610});
  ASSERT_EQ(values.size(), 3U);
  EXPECT_NEAR(values[0], rgb.z, 1e-6 * rgb.z);
  EXPECT_NEAR(values[1], rgb.y, 1e-6 * rgb.y);
  EXPECT_NEAR(values[2], rgb.x, 1e-6 * rgb.x);
}

// The diffuse part does not depend on the wavelength but by its colour.
TEST(Spectrum, HasColoursThatAreLinearBetweenTheChannels) {
  reflectance::Westin westin;
  westin.ks = Rgb(0);
  westin.kd = Rgb(0.8F, 0.4F, 0.2F);
  westin.lambda = Rgb(650, 550, 450);
  const std::vector<double> values =
      spectrum_of(westin, at_angles(0.3, 0), at_angles(0.4, 1), {300, 450, 500, 575, 650, 900});
  const std::vector<double> albedos = {0.2, 0.2, 0.3, 0.5, 0.8, 0.8};
  for (std::size_t i = 0; i < albedos.size(); ++i)
    EXPECT_NEAR(values[i] * std::numbers::pi, albedos[i], 1e-6) << i;
  westin.lambda = Rgb(500);
  EXPECT_NEAR(spectrum_of(westin, at_angles(0.3, 0), at_angles(0.4, 1), {400})[0] * std::numbers::pi, 1.4 / 3,
              1e-6);
}

// A film of the index n on a base of n^2 reflects nothing of light whose quarter wave it is thick; for light
// whose half wave it is, it is not there.
TEST(Spectrum, OfAFilmIsDarkAtFourTimesItsOpticalThickness) {
  const reflectance::ThinFilm film = film_of(100, 1.4F, 1.96F);
  const V3d normal(0, 0, 1);
  const std::vector<double> values = spectrum_of(film, normal, normal, {560, 280});
  const double bare = std::pow((1.96 - 1) / (1.96 + 1), 2) / (4 * std::numbers::pi * 0.001 * 0.001);
  EXPECT_LT(values[0], 1e-4 * bare);
  EXPECT_NEAR(values[1], bare, 1e-4 * bare);
}

// RGB is what the observer sees of the spectrum.
TEST(Spectrum, OfAFilmHasItsRgb) {
  Wavelengths fine;
  for (int i = 380; i <= 780; ++i) fine.push_back(static_cast<float>(i));
  const auto weights = reflectance::rgb_weights(fine);
  for (const float thickness : {150.0F, 300.0F, 450.0F}) {
    reflectance::ThinFilm film = film_of(thickness, 1.5F, 2.5F);
    film.alpha = film.ay = 0.4F;
    film.prepare();
    const V3d u = at_angles(0.6, 0);
    const V3d v = at_angles(0.7, 3);
    const V3d rgb = film.evaluate<double>(u, v);
    const std::vector<double> spectrum = spectrum_of(film, u, v, fine);
    for (std::size_t k = 0; k < 3; ++k) {
      double sum = 0;
      for (std::size_t i = 0; i < fine.size(); ++i) sum += weights[k][i] * spectrum[i];
      EXPECT_NEAR(sum, rgb[static_cast<int>(k)], 0.05 * std::max({rgb.x, rgb.y, rgb.z}))
          << thickness << " channel " << k;
    }
  }
}

TEST(Spectrum, IsZeroBelowTheHorizon) {
  const V3d below(0.6, 0, -0.8);
  EXPECT_EQ(spectrum_of(film_of(300, 1.5F, 2), at_angles(0.2, 0), below, {500})[0], 0);
  EXPECT_EQ(spectrum_of(rough_surface(Rgb(500)), at_angles(0.2, 0), below, {500})[0], 0);
}

TEST(Spectrum, OfDataIsLinearBetweenTheirWavelengths) {
  grf::Diagnostics diagnostics;
  reflectance::Rgl copper;
  copper.data = reflectance::RglData::load(test::rgl_path("copper"), diagnostics);
  ASSERT_TRUE(copper.data) << diagnostics.to_text();
  const V3d u = at_angles(0.3, 0);
  const V3d v = at_angles(0.4, 3);
  const std::vector<double> own = copper.data->spectrum(u, v);
  ASSERT_EQ(wavelengths_of(copper), copper.data->wavelengths());
  ASSERT_EQ(own.size(), 10U);  // 380, 420, 460, 500, 530 ...
  const std::vector<double> values = spectrum_of(copper, u, v, {300, 380, 430, 500, 720, 900});
  EXPECT_DOUBLE_EQ(values[0], own[0]);
  EXPECT_DOUBLE_EQ(values[1], own[0]);
  EXPECT_NEAR(values[2], 0.75 * own[1] + 0.25 * own[2], 1e-12);
  EXPECT_DOUBLE_EQ(values[3], own[3]);
  EXPECT_DOUBLE_EQ(values[4], own[9]);
  EXPECT_DOUBLE_EQ(values[5], own[9]);
}

}  // namespace
