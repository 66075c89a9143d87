#include "editor/rendering/cost_study.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

#include "editor/rendering/json_number.h"
#include "renderer/options/op_line.h"

namespace editor {
namespace {

constexpr double MostSamples = 1e6;

CostCurve curve_of(const QJsonObject& fit) {
  CostCurve curve;
  curve.name = fit["line"].toString();
  curve.seconds_for_1_percent = number_in(fit, "seconds_for_1_percent");
  curve.factor = number_in(fit, "factor_over_samples");
  curve.exponent = number_in(fit, "exponent_over_samples");
  curve.grf = fit["grf"].toString();
  for (const auto& line : fit["op"].toArray()) curve.op << line.toString();
  const QJsonObject efficiency = fit["efficiency"].toObject();
  if (!efficiency.isEmpty()) {
    curve.efficiency = EfficiencyInterval{efficiency["value"].toDouble(), efficiency["low"].toDouble(),
                                          efficiency["high"].toDouble()};
  }
  return curve;
}

std::optional<SamplePair> pair_of(int a, double b) {
  if (!(b <= MostSamples)) return std::nullopt;
  return SamplePair{a, std::max(1, static_cast<int>(std::lround(b)))};
}

}  // namespace

std::optional<CostStudy> cost_study_of(const QByteArray& json) {
  const QJsonObject object = QJsonDocument::fromJson(json).object();
  if (!object["rows"].isArray() || !object["fits"].isArray()) return std::nullopt;
  CostStudy study;
  for (const auto& fit : object["fits"].toArray()) study.curves.push_back(curve_of(fit.toObject()));
  for (const auto& value : object["rows"].toArray()) {
    const QJsonObject row = value.toObject();
    for (CostCurve& curve : study.curves) {
      if (curve.name != row["line"].toString()) continue;
      curve.rows.push_back(
          {row["samples"].toInt(), row["render_seconds"].toDouble(), std::sqrt(row["relmse"].toDouble())});
    }
  }
  for (std::size_t i = 0; i < study.curves.size(); ++i) {
    if (study.curves[i].name == object["winner"].toString()) study.winner = i;
  }
  return study;
}

std::optional<SamplePair> samples_at_equal_time(const CostCurve& a, const CostCurve& b) {
  if (a.rows.empty() || b.rows.empty()) return std::nullopt;
  const CostMeasurement& of_a = a.rows.back();
  const CostMeasurement& of_b = b.rows.back();
  return pair_of(of_a.samples, of_a.seconds / of_b.seconds * of_b.samples);
}

std::optional<SamplePair> samples_at_equal_error(const CostCurve& a, const CostCurve& b) {
  if (a.rows.empty() || !a.factor || !b.factor || !(a.exponent > 0) || !(b.exponent > 0)) return std::nullopt;
  const int samples = a.rows.back().samples;
  const double error = *a.factor * std::pow(samples, -*a.exponent);
  return pair_of(samples, std::pow(*b.factor / error, 1 / *b.exponent));
}

options::RenderOptions with_settings(options::RenderOptions render_options, const QStringList& op) {
  for (const QString& line : op) {
    const std::string text = line.toStdString();
    std::vector<std::string> words;
    for (const options::OpWord& word : options::op_words(text)) words.emplace_back(word.text);
    if (words.empty()) continue;
    const options::OptionInfo* option = options::find_option(words.front());
    words.erase(words.begin());
    if (option != nullptr) options::set_option(render_options, *option, words);
  }
  return render_options;
}

int set_samples(options::RenderOptions& render_options, int samples) {
  render_options.target_error.reset();
  render_options.max_seconds.reset();
  if (render_options.integrator != "naive") {
    render_options.samples = samples;
    return samples;
  }
  render_options.samples.reset();
  render_options.pixel_samples = {1, 1};
  const int root = std::max(1, static_cast<int>(std::lround(std::sqrt(samples))));
  render_options.secondary_rays_root = root;
  return root * root;
}

}  // namespace editor
