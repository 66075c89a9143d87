// The reflectance of thin films against closed forms, and against a fine sum over wavelengths.
#include "renderer/reflectance/thinfilm.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

namespace {

using Imath::V3d;
using Complex = std::complex<double>;
using FilmFormula = reflectance::glsl::ThinFilmFormula<double>;

TEST(ThinFilm, IsTheBareBaseWithoutThickness) {
  for (const double c : {1.0, 0.7, 0.2, 0.01}) {
    for (const auto& [n, k] : {std::pair(1.5, 0.0), std::pair(0.2, 3.9), std::pair(0.7, 0.0)}) {
      const V3d value = FilmFormula().film_reflectance(c, 1 - c * c, 0, 1.7, V3d(n), V3d(k));
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(value[i], FilmFormula().fresnel(c, n, k), 1e-6) << c << " " << n;
    }
  }
}

TEST(ThinFilm, OfTheIndexOfAirOrOfTheBaseIsNotSeen) {
  for (const double c : {1.0, 0.4, 0.05}) {
    EXPECT_NEAR(FilmFormula().film_reflectance(c, 1 - c * c, 730, 1, V3d(1.5), V3d(0)).y,
                FilmFormula().fresnel(c, 1.5, 0), 1e-6);
    EXPECT_NEAR(FilmFormula().film_reflectance(c, 1 - c * c, 730, 1.5, V3d(1.5), V3d(0)).y,
                FilmFormula().fresnel(c, 1.5, 0), 1e-6);
  }
}

// A quarter of a wave between the indices 1, n and n^2 reflects nothing, and half a wave is not there.
TEST(ThinFilm, OfAQuarterWaveReflectsNothing) {
  FilmFormula film;
  const auto of_phase = [&](double phase) {
    const auto s = film.film_sides(1.0, 0.0, 1.4, 1.4, V3d(1.96), V3d(0), false);
    const auto p = film.film_sides(1.0, 0.0, 1.4, 1.4, V3d(1.96), V3d(0), true);
    return film.film_wave(phase, s, p).x;
  };
  EXPECT_NEAR(of_phase(std::numbers::pi), 0, 1e-15);
  EXPECT_NEAR(of_phase(2 * std::numbers::pi), film.fresnel(1.0, 1.96, 0.0), 1e-15);
}

double observer_lobe(double wavelength, double factor, double centre, double below, double above) {
  const double x = (wavelength - centre) / (wavelength < centre ? below : above);
  return factor * std::exp(-x * x / 2);
}

/// Linear sRGB of a wavelength, by the fit to the CIE 1931 observer of Wyman, Sloan and Shirley (2013).
V3d rgb_of_wavelength(double l) {
  const double x = observer_lobe(l, 1.056, 599.8, 37.9, 31) + observer_lobe(l, 0.362, 442, 16, 26.7) +
                   observer_lobe(l, -0.065, 501.1, 20.4, 26.2);
  const double y = observer_lobe(l, 0.821, 568.8, 46.9, 40.5) + observer_lobe(l, 0.286, 530.9, 16.3, 31.1);
  const double z = observer_lobe(l, 1.217, 437, 11.8, 36) + observer_lobe(l, 0.681, 459, 26, 13.8);
  return {3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
          0.0557 * x - 0.204 * y + 1.057 * z};
}

/// The reflectance at one wavelength, by Airy's sum of complex amplitudes.
double film_reflectance_at(double wavelength, double c, double thickness, double index, const Complex& base) {
  const double s2 = 1 - c * c;
  const double inside = std::sqrt(index * index - s2);
  const Complex under = std::sqrt(base * base - s2);
  const Complex delay = std::polar(1.0, 4 * std::numbers::pi * thickness * inside / wavelength);
  const auto airy = [&](double front, const Complex& back) {
    return std::norm((front + back * delay) / (1.0 + front * back * delay));
  };
  const double film2 = index * index;
  return (airy((c - inside) / (c + inside), (inside - under) / (inside + under)) +
          airy((film2 * c - inside) / (film2 * c + inside),
               (base * base * inside - film2 * under) / (base * base * inside + film2 * under))) /
         2;
}

TEST(ThinFilm, IsNearAFineSumOverWavelengths) {
  for (const double thickness : {60.0, 200.0, 350.0, 500.0, 800.0, 1000.0}) {
    for (const auto& [index, base] : {std::pair(1.33, Complex(1)), std::pair(1.5, Complex(0.2, 3.9)),
                                      std::pair(2.2, Complex(1.5)), std::pair(2.4, Complex(2.5, 2.9))}) {
      for (const double c : {1.0, 0.5, 0.1}) {
        V3d sum(0);
        V3d weights(0);
        for (double wavelength = 340; wavelength < 860; wavelength += 0.25) {
          sum += rgb_of_wavelength(wavelength) * film_reflectance_at(wavelength, c, thickness, index, base);
          weights += rgb_of_wavelength(wavelength);
        }
        const V3d value = FilmFormula().film_reflectance(c, 1 - c * c, thickness, index, V3d(base.real()),
                                                         V3d(base.imag()));
        for (int i = 0; i < 3; ++i) {
          EXPECT_NEAR(value[i], std::clamp(sum[i] / weights[i], 0.0, 1.0), thickness <= 500 ? 0.003 : 0.007)
              << thickness << " " << index << " " << c;
        }
      }
    }
  }
}

}  // namespace
