#include "editor/brdf/lobe_curves.h"

#include "editor/brdf/brdf_plots.h"
#include "editor/controls/text.h"

namespace editor {
namespace {

using reflectance::Reflector;
using reflectance::Rgb;

grf::ModelInfo info_of(const reflectance::Brdf& brdf) {
  return std::visit([]<class Model>(const Model&) { return reflectance::info_of<Model>(); }, brdf);
}

/// Builds the scheme with its tables, or reports why it cannot.
std::shared_ptr<const Reflector> reflector_of(const reflectance::Brdf& brdf, const grf::PdfModel& data,
                                              QString& mistake) {
  const auto scheme = reflectance::make_scheme(data);
  if (!scheme) {
    mistake = BrdfPlots::tr("unknown sampling scheme '%1'").arg(QString::fromStdString(data.keyword));
    return nullptr;
  }
  mistake = QString::fromStdString(reflectance::unsupported_reason(*scheme, brdf));
  return mistake.isEmpty() ? std::make_shared<const Reflector>(brdf, *scheme) : nullptr;
}

QString number(double value) { return QString::number(value, 'g', 9); }

QString numbers(const Rgb& rgb) { return number(rgb.x) + ',' + number(rgb.y) + ',' + number(rgb.z); }

}  // namespace

LobeCurves lobe_curves(const reflectance::Brdf& brdf, const std::vector<double>& views,
                       const std::optional<grf::PdfModel>& scheme, const StopFlag& stop) {
  LobeCurves result;
  const auto reflector = scheme ? reflector_of(brdf, *scheme, result.scheme_error) : nullptr;
  for (const double view : views) {
    if (stop.is_set()) break;
    result.curves.push_back(plot::lobe_curve(brdf, view, reflector.get()));
  }
  return result;
}

EnergyNote energy_note(const reflectance::Brdf& brdf, const grf::LargestAlbedo& largest) {
  constexpr float ClearlyOver = 1.005F;
  const grf::ModelInfo info = info_of(brdf);
  const QString why = text_of(info.not_conserving);
  EnergyNote words;
  words.is_warning = largest.albedo > ClearlyOver;
  if (words.is_warning) {
    words.text = BrdfPlots::tr("Reflects up to %1 times the light it receives (at %2 degrees).")
                     .arg(largest.albedo, 0, 'g', 3)
                     .arg(largest.degrees);
  } else {
    words.text =
        BrdfPlots::tr("Reflects at most %1 % of the light it receives.").arg(100 * largest.albedo, 0, 'f', 1);
  }
  if (!why.isEmpty()) words.text += ' ' + BrdfPlots::tr("The model: %1.").arg(why);
  return words;
}

QString curves_csv(const LobeCurves& curves) {
  QString text = "view_degrees,light_degrees,f_red,f_green,f_blue,density\n";
  for (const plot::LobeCurve& curve : curves.curves) {
    for (std::size_t i = 0; i < curve.degrees.size(); ++i) {
      text += number(curve.view) + ',' + number(curve.degrees[i]) + ',' + numbers(curve.values[i]) + ',' +
              (curve.pdfs.empty() ? "" : number(curve.pdfs[i])) + '\n';
    }
  }
  return text;
}

QString albedo_csv(const plot::AlbedoCurve& curve) {
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
