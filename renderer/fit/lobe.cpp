#include "renderer/fit/lobe.h"

#include <algorithm>
#include <cmath>

namespace fit {
namespace {

/// What is added to a value from the minimum on before the logarithm is taken.
double logarithm_offset(const ShapeParameter& shape) { return shape.minimum > 0 ? shape.minimum : 1; }

grf::Value value_of_colour(const Vec3d& colour) {
  const grf::Colour rgb(colour);
  if (rgb.x == rgb.y && rgb.x == rgb.z) return rgb.x;
  return rgb;
}

}  // namespace

double ShapeParameter::value(double t) const {
  double value = minimum + t * (maximum - minimum);
  if (is_logarithmic) {
    const double offset = logarithm_offset(*this);
    value = minimum + offset * std::expm1(t * std::log1p((maximum - minimum) / offset));
  }
  return static_cast<float>(std::clamp(value, minimum, maximum));
}

double ShapeParameter::coordinate(double value) const {
  if (!is_logarithmic) return (value - minimum) / (maximum - minimum);
  const double offset = logarithm_offset(*this);
  return std::log1p((value - minimum) / offset) / std::log1p((maximum - minimum) / offset);
}

double ShapeParameter::scanned(double uniform) const {
  if (uniform < 0.5) return 2 * uniform;
  const double decade = std::log(10) / std::log1p((maximum - minimum) / logarithm_offset(*this));
  const double reach = is_logarithmic ? std::min(1.0, decade) : 0.25;
  const double low = std::max(0.0, usual - reach);
  const double high = std::min(1.0, usual + reach);
  return low + (2 * uniform - 1) * (high - low);
}

grf::BrdfModel model_of(const Lobe& lobe, std::span<const double> shapes, std::span<const Vec3d> colours) {
  grf::BrdfModel model;
  model.keyword = lobe.info.keyword;
  const auto add = [&](const std::string& name, grf::Value value) {
    model.arguments.push_back({name, std::move(value), {}});
  };
  for (const grf::Argument& argument : lobe.fixed) model.arguments.push_back(argument);
  for (std::size_t i = 0; i < lobe.shapes.size(); ++i) {
    const ShapeParameter& shape = lobe.shapes[i];
    if (!shape.channel) {
      add(shape.name, static_cast<float>(shapes[i]));
    } else if (*shape.channel == 0) {  // the other channels follow
      add(shape.name, value_of_colour({shapes[i], shapes[i + 1], shapes[i + 2]}));
    }
  }
  for (std::size_t i = 0; i < lobe.colours.size(); ++i)
    add(lobe.colours[i].name, value_of_colour(colours[i]));
  return model;
}

std::optional<reflectance::Brdf> brdf_of(const Lobe& lobe, std::span<const double> shapes,
                                         std::span<const Vec3d> colours) {
  const grf::BrdfModel model = model_of(lobe, shapes, colours);
  if (lobe.info.validate != nullptr && !lobe.info.validate(model).empty()) return std::nullopt;
  return reflectance::make_brdf(model);
}

}  // namespace fit
