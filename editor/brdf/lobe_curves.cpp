#include "editor/brdf/lobe_curves.h"

#include <QtConcurrent>
#include <cmath>
#include <numbers>
#include <numeric>

#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/light_angles.h"

namespace editor {
namespace {

using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Vec3f;

constexpr double Radian = std::numbers::pi / 180;

grf::ModelInfo info_of(const reflectance::Brdf& brdf) {
  return std::visit([]<class Model>(const Model&) { return reflectance::info_of<Model>(); }, brdf);
}

/// The scheme with its tables, or why there is none.
std::shared_ptr<const Reflector> reflector_of(const reflectance::Brdf& brdf, const grf::PdfModel& data,
                                              QString& mistake) {
  const auto scheme = reflectance::make_scheme(data);
  if (!scheme) {
    mistake = QString("there is no scheme '%1'").arg(QString::fromStdString(data.keyword));
    return nullptr;
  }
  mistake = QString::fromStdString(reflectance::refusal(*scheme, brdf));
  return mistake.isEmpty() ? std::make_shared<const Reflector>(brdf, *scheme) : nullptr;
}

QString number(double value) { return QString::number(value, 'g', 9); }

QString numbers(const Rgb& rgb) { return number(rgb.x) + ',' + number(rgb.y) + ',' + number(rgb.z); }

}  // namespace

double channel_of(const Rgb& rgb, Channel channel) {
  switch (channel) {
    case Channel::Red:
      return rgb.x;
    case Channel::Green:
      return rgb.y;
    case Channel::Blue:
      return rgb.z;
    case Channel::Luminance:
      break;
  }
  return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
}

Vec3f direction_at(double degrees) {
  return {static_cast<float>(std::sin(degrees * Radian)), 0, static_cast<float>(std::cos(degrees * Radian))};
}

LobeCurves lobe_curves(const reflectance::Brdf& brdf, const std::vector<double>& views,
                       const std::optional<grf::PdfModel>& scheme, const StopFlag& stop) {
  LobeCurves result;
  const auto reflector = scheme ? reflector_of(brdf, *scheme, result.scheme_mistake) : nullptr;
  for (const double view : views) {
    LobeCurve curve;
    curve.view = view;
    const Vec3f u = direction_at(-view);
    curve.mirror = reflectance::mirror(brdf, u);
    for (const double degrees : reflectance::light_angles(view)) {
      if (stop.is_set()) return result;
      if (std::abs(degrees) >= 90) continue;
      const Vec3f v = direction_at(degrees);
      curve.degrees.push_back(degrees);
      curve.values.push_back(reflectance::evaluate(brdf, u, v));
      if (reflector) curve.densities.push_back(reflector->density(u, v));
    }
    result.curves.push_back(std::move(curve));
  }
  return result;
}

AlbedoCurve albedo_curve(const reflectance::Brdf& brdf, int samples, const StopFlag& stop) {
  AlbedoCurve curve;
  // Closer to each other towards the horizon, where it bends most.
  for (int step = 0; step < 28; ++step) curve.degrees.push_back(2.5 * step);
  for (int degrees = 70; degrees < 90; ++degrees) curve.degrees.push_back(degrees);
  const Reflector reflector(brdf, reflectance::OwnScheme());
  const bool has_y = reflectance::is_anisotropic(brdf);
  curve.along_x.resize(curve.degrees.size());
  if (has_y) curve.along_y.resize(curve.degrees.size());
  std::vector<std::size_t> places(curve.degrees.size());
  std::iota(places.begin(), places.end(), 0U);
  QtConcurrent::blockingMap(places, [&](std::size_t i) {
    if (stop.is_set()) return;
    const Vec3f u = direction_at(curve.degrees[i]);
    curve.along_x[i] = reflectance::albedo(reflector, u, samples);
    if (has_y) curve.along_y[i] = reflectance::albedo(reflector, Vec3f(0, u.x, u.z), samples);
  });
  for (const std::vector<Rgb>* values : {&curve.along_x, &curve.along_y}) {
    for (std::size_t i = 0; i < values->size(); ++i) {
      const float most = reflectance::largest((*values)[i]);
      if (most > curve.largest.albedo) curve.largest = {most, static_cast<float>(curve.degrees[i])};
    }
  }
  return curve;
}

EnergyWords energy_words(const reflectance::Brdf& brdf, const grf::LargestAlbedo& largest) {
  constexpr float ClearlyOver = 1.005F;
  const grf::ModelInfo info = info_of(brdf);
  const auto why =
      QString::fromUtf8(info.not_conserving.data(), static_cast<qsizetype>(info.not_conserving.size()));
  EnergyWords words;
  words.is_warning = largest.albedo > ClearlyOver;
  if (words.is_warning) {
    words.text = QString("Reflects up to %1 times the light it receives (at %2 degrees).")
                     .arg(largest.albedo, 0, 'g', 3)
                     .arg(largest.degrees);
  } else {
    words.text =
        QString("Reflects at most %1 % of the light it receives.").arg(100 * largest.albedo, 0, 'f', 1);
  }
  if (!why.isEmpty()) words.text += " The model: " + why + ".";
  return words;
}

QString curves_csv(const LobeCurves& curves) {
  QString text = "view_degrees,light_degrees,f_red,f_green,f_blue,density\n";
  for (const LobeCurve& curve : curves.curves) {
    for (std::size_t i = 0; i < curve.degrees.size(); ++i) {
      text += number(curve.view) + ',' + number(curve.degrees[i]) + ',' + numbers(curve.values[i]) + ',' +
              (curve.densities.empty() ? "" : number(curve.densities[i])) + '\n';
    }
  }
  return text;
}

QString albedo_csv(const AlbedoCurve& curve) {
  QString text = "view_degrees,red,green,blue";
  if (!curve.along_y.empty()) text += ",red_along_y,green_along_y,blue_along_y";
  text += '\n';
  for (std::size_t i = 0; i < curve.degrees.size(); ++i) {
    text += number(curve.degrees[i]) + ',' + numbers(curve.along_x[i]);
    if (!curve.along_y.empty()) text += ',' + numbers(curve.along_y[i]);
    text += '\n';
  }
  return text;
}

}  // namespace editor
