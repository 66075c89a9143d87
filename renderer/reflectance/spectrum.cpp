#include "renderer/reflectance/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace reflectance {
namespace {

using Imath::V3d;

/// The range of `thinfilm`'s sum, in nanometres; its wavelengths are equally spaced in their reciprocals.
constexpr double FilmShortest = 385;
constexpr double FilmLongest = 720;
constexpr int FilmCount = 28;

std::vector<float> film_wavelengths() {
  std::vector<float> wavelengths;
  for (int i = FilmCount - 1; i >= 0; --i) {
    const double step = (1 / FilmShortest - 1 / FilmLongest) / (FilmCount - 1);
    wavelengths.push_back(static_cast<float>(1 / (1 / FilmLongest + i * step)));
  }
  return wavelengths;
}

/// Interpolates linearly between values at ascending places; constant beyond them.
template <class Places, class Values>
double interpolate(const Places& places, const Values& values, double place) {
  const auto above = std::upper_bound(places.begin(), places.end(), static_cast<float>(place));
  if (above == places.begin()) return values.front();
  if (above == places.end()) return values.back();
  const auto right = static_cast<std::size_t>(above - places.begin());
  const double left_place = places[right - 1];
  const double fraction = (place - left_place) / (double(places[right]) - left_place);
  return values[right - 1] + fraction * (values[right] - values[right - 1]);
}

/// Colours as functions of the wavelength, given the wavelengths of R, G and B. The mean, if those are equal.
class ChannelSpectrum {
 public:
  explicit ChannelSpectrum(const Rgb& wavelengths) : order_{0, 1, 2} {
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return wavelengths[a] < wavelengths[b]; });
    for (std::size_t i = 0; i < 3; ++i) places_[i] = wavelengths[order_[i]];
  }

  double at(const Rgb& colour, double wavelength) const {
    if (places_.front() == places_.back()) return mean(colour);
    std::array<double, 3> values;
    for (std::size_t i = 0; i < 3; ++i) values[i] = colour[order_[i]];
    return interpolate(places_, values, wavelength);
  }

 private:
  std::array<int, 3> order_;
  std::array<float, 3> places_{};
};

template <class Model>
std::vector<float> kirchhoff_wavelengths(const Model& model) {
  std::vector<float> wavelengths = {model.lambda.x, model.lambda.y, model.lambda.z};
  std::sort(wavelengths.begin(), wavelengths.end());
  wavelengths.erase(std::unique(wavelengths.begin(), wavelengths.end()), wavelengths.end());
  return wavelengths;
}

template <class Model>
double kirchhoff_value(const Model& model, const V3d& u, const V3d& v, float wavelength) {
  const ChannelSpectrum channels(model.lambda);
  Model single = model;
  single.lambda = Rgb(wavelength);
  single.ks = Rgb(static_cast<float>(channels.at(model.ks, double(wavelength))));
  single.kd = Rgb(static_cast<float>(channels.at(model.kd, double(wavelength))));
  return single.template evaluate<double>(u, v).x;
}

/// Evaluates a film as film_fresnel.glsl does, at one wavelength instead of the sum of all.
double film_value(const ThinFilm& model, const V3d& u, const V3d& v, double wavelength) {
  glsl::ThinFilmFormula<double> formula;
  if (formula.below_horizon(u, v)) return 0;
  const ChannelSpectrum channels(He().lambda);
  const V3d n(channels.at(model.nreal, wavelength));
  const V3d k(channels.at(model.nimag, wavelength));
  const double film = double(model.film);
  const auto reflectance = [&](double cosine, double squared_sine) {
    const double normal = std::sqrt((film - 1) * (film + 1) + cosine * cosine);
    const auto s = formula.film_sides(cosine, squared_sine, normal, film, n, k, false);
    const auto p = formula.film_sides(cosine, squared_sine, normal, film, n, k, true);
    return formula.film_wave(4 * std::numbers::pi * double(model.thickness) * normal / wavelength, s, p).x;
  };
  const double flat = std::sqrt((1 - 1 / std::sqrt(3.0)) / 2);
  const double steep = std::sqrt((1 + 1 / std::sqrt(3.0)) / 2);
  const double film_mean = (reflectance(flat, steep * steep) + reflectance(steep, flat * flat)) / 2;
  const V3d rough(double(model.alpha), double(model.ay), 0);
  const double alpha = std::sqrt((rough.x * rough.x + rough.y * rough.y) / 2);
  const double of_facet = reflectance(formula.cosine_at_half(u, v), formula.squared_sine_at_half(u, v));
  const double lobe = of_facet * formula.ggx_facets(u, v, rough, 0) +
                      formula.ggx_further(V3d(film_mean), alpha).x * formula.ggx_further_lobe(u, v, alpha);
  return channels.at(model.ks, wavelength) * lobe;
}

}  // namespace

std::vector<float> wavelengths_of(const Brdf& brdf) {
  if (const auto* measured = std::get_if<Rgl>(&brdf)) {
    return measured->data ? measured->data->wavelengths() : std::vector<float>();
  }
  if (const auto* he = std::get_if<He>(&brdf)) return kirchhoff_wavelengths(*he);
  if (const auto* westin = std::get_if<Westin>(&brdf)) return kirchhoff_wavelengths(*westin);
  if (std::holds_alternative<ThinFilm>(brdf)) return film_wavelengths();
  return {};
}

std::vector<double> spectrum_of(const Brdf& brdf, const V3d& u, const V3d& v,
                                const std::vector<float>& wavelengths) {
  std::vector<double> values;
  const auto add_each = [&](const auto& value_at) {
    for (const float wavelength : wavelengths) values.push_back(value_at(wavelength));
  };
  if (const auto* measured = std::get_if<Rgl>(&brdf)) {
    const std::vector<double> own = measured->data->spectrum(u, v);
    add_each([&](float place) { return interpolate(measured->data->wavelengths(), own, double(place)); });
  } else if (const auto* he = std::get_if<He>(&brdf)) {
    add_each([&](float wavelength) { return kirchhoff_value(*he, u, v, wavelength); });
  } else if (const auto* westin = std::get_if<Westin>(&brdf)) {
    add_each([&](float wavelength) { return kirchhoff_value(*westin, u, v, wavelength); });
  } else if (const auto* film = std::get_if<ThinFilm>(&brdf)) {
    add_each([&](float wavelength) { return film_value(*film, u, v, double(wavelength)); });
  }
  return values;
}

}  // namespace reflectance
