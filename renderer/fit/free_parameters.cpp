// Finds what of a model a fit may change.
#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grf/keywords.h"
#include "renderer/fit/lobe.h"

namespace fit {
namespace {

using grf::Argument;
using grf::ParameterInfo;
using grf::ParameterKind;
using Values = std::vector<Vec3d>;

constexpr std::size_t ProbeCount = 64;
constexpr int SettingCount = 6;

double largest_of(const Values& values) {
  double largest = 0;
  for (const Vec3d& value : values) largest = std::max({largest, value.x, value.y, value.z});
  return largest;
}

double largest_difference(const Values& a, const Values& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3d d = a[i] - b[i];
    largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return largest;
}

/// Returns the values scaled so that the largest is 1; empty if all are 0.
Values normalised(Values values) {
  const double largest = largest_of(values);
  if (!(largest > 0)) return {};
  for (Vec3d& value : values) value /= largest;
  return values;
}

ShapeParameter shape_of(const ParameterInfo& info) {
  constexpr float WideRange = 50;
  ShapeParameter shape;
  shape.name = info.name;
  shape.minimum = info.minimum;
  shape.maximum = info.maximum;
  shape.is_logarithmic =
      info.scale == grf::ParameterScale::Logarithmic || (info.minimum >= 0 && info.maximum >= WideRange);
  return shape;
}

/// Evaluates a model with some parameters for some of the observations.
class Probe {
 public:
  Probe(const grf::ModelInfo& info, std::vector<Argument> fixed, const Observations& observations)
      : lobe_{info, std::move(fixed), {}, {}, false, {}} {
    const std::size_t count = std::min(ProbeCount, observations.list.size());
    for (std::size_t i = 0; i < count; ++i)
      probes_.push_back(observations.list[i * observations.list.size() / count]);
  }

  const grf::ModelInfo& info() const { return lobe_.info; }

  std::optional<reflectance::Brdf> brdf(const std::vector<Argument>& arguments) const {
    Lobe lobe = lobe_;
    lobe.fixed.insert(lobe.fixed.end(), arguments.begin(), arguments.end());
    return brdf_of(lobe, {}, {});
  }
  /// Returns the values; empty if the model does not take these parameters together.
  Values values(const std::vector<Argument>& arguments) const {
    Values values;
    const auto brdf = this->brdf(arguments);
    if (brdf) evaluate(*brdf, probes_, values);
    return values;
  }

 private:
  Lobe lobe_;
  std::vector<Observation> probes_;
};

Argument argument_of(std::string_view name, double value) {
  return {std::string(name), static_cast<float>(value), {}};
}

/// Finds the free parameters of one lobe.
class LobeAnalysis {
 public:
  LobeAnalysis(const grf::ModelInfo& info, const std::vector<Argument>& fixed,
               const Observations& observations)
      : observations_(observations), probe_(info, fixed, observations), lobe_{info, fixed, {},
                                                                              {},   false, {}} {
    for (const ParameterInfo& parameter : lobe_.info.parameters) {
      const bool is_fixed = std::any_of(fixed.begin(), fixed.end(),
                                        [&](const Argument& one) { return parameter.is_called(one.name); });
      const bool is_number = parameter.kind == ParameterKind::Number && !parameter.is_whole;
      if (is_fixed || (!is_number && parameter.kind != ParameterKind::Reflectance)) continue;
      if (observations.is_isotropic && makes_anisotropic(parameter)) {
        lobe_.held.push_back(fmt::format("{}: the data are isotropic", parameter.name));
      } else if (selects_formula(parameter)) {
        lobe_.held.push_back(fmt::format("{}: any other value selects another formula", parameter.name));
      } else {
        candidates_.push_back(&parameter);
      }
    }
  }

  /// `diffuse_parts` are those of the lobes before, normalised; the first one is added to them.
  Lobe find(bool is_in_sum, std::vector<Values>& diffuse_parts) {
    make_settings();
    find_linear_colours();
    hold_repeated_diffuse_part(diffuse_parts);
    find_weight(is_in_sum);
    for (const ParameterInfo* parameter : candidates_) {
      if (is_linear(*parameter)) continue;
      if (!changes_values(*parameter)) {
        lobe_.held.push_back(fmt::format("{}: it changes none of the values", parameter->name));
      } else {
        add_shape(*parameter);
      }
    }
    for (const ParameterInfo* parameter : linear_)
      lobe_.colours.push_back({std::string(parameter->name), parameter->maximum});
    return std::move(lobe_);
  }

 private:
  bool makes_anisotropic(const ParameterInfo& parameter) const {
    if (!parameter.default_from.empty()) return true;
    const bool is_at_end =
        parameter.default_value == parameter.minimum || parameter.default_value == parameter.maximum;
    if (lobe_.info.not_isotropic.empty() || !is_at_end) return false;
    const auto usual = probe_.brdf({});
    const auto changed =
        probe_.brdf({argument_of(parameter.name, (parameter.minimum + parameter.maximum) / 2)});
    return usual && changed && !reflectance::is_anisotropic(*usual) && reflectance::is_anisotropic(*changed);
  }

  /// Returns whether the model has a jump at a default at an end of the range.
  bool selects_formula(const ParameterInfo& parameter) const {
    const bool is_at_minimum = parameter.default_value == parameter.minimum;
    if (!is_at_minimum && parameter.default_value != parameter.maximum) return false;
    const ShapeParameter shape = shape_of(parameter);
    const auto values_at = [&](double distance) {
      const double t = is_at_minimum ? distance : 1 - distance;
      return probe_.values({argument_of(parameter.name, shape.value(t))});
    };
    const Values usual = values_at(0);
    const Values near = values_at(1e-4);
    const Values further = values_at(2e-4);
    if (usual.empty() || near.empty() || further.empty()) return false;
    const double jump = largest_difference(usual, near);
    return jump > 0.02 * largest_of(usual) && largest_difference(near, further) < 0.1 * jump;
  }

  // The defaults, and random values of all shapes away from the ends, at which what is asked of the model is
  // tested.
  void make_settings() {
    std::mt19937 random(3);
    settings_.resize(1 + SettingCount);
    for (std::size_t i = 1; i < settings_.size(); ++i) {
      std::vector<Argument>& setting = settings_[i];
      for (const ParameterInfo* parameter : candidates_) {
        if (parameter->kind != ParameterKind::Number) continue;
        const double t = 0.1 + 0.6 * static_cast<double>(random()) / 0x1p32;
        setting.push_back(argument_of(parameter->name, shape_of(*parameter).value(t)));
      }
    }
  }

  /// Returns the values at a setting, with colours in the order of `linear_`.
  Values values_with(const std::vector<Argument>& setting, const std::vector<Vec3d>& colours) const {
    std::vector<Argument> arguments = setting;
    for (std::size_t i = 0; i < linear_.size(); ++i)
      arguments.push_back({std::string(linear_[i]->name), grf::Colour(colours[i]), {}});
    return probe_.values(arguments);
  }

  /// Returns the values of each linear colour, white alone, above those of none; and those of none at the
  /// end. Empty if the model does not take this setting.
  std::vector<Values> parts_of(const std::vector<Argument>& setting) const {
    std::vector<Values> parts;
    std::vector<Vec3d> colours(linear_.size(), Vec3d(0));
    const Values none = values_with(setting, colours);
    for (std::size_t i = 0; i < linear_.size(); ++i) {
      colours[i] = Vec3d(1);
      Values part = values_with(setting, colours);
      if (part.empty() || none.empty()) return {};
      for (std::size_t k = 0; k < part.size(); ++k) part[k] -= none[k];
      parts.push_back(std::move(part));
      colours[i] = Vec3d(0);
    }
    parts.push_back(none);
    return parts;
  }

  /// Returns whether the colours of `linear_` superpose, with different values per channel, and the last one
  /// has an effect.
  bool superpose() const {
    std::mt19937 random(7);
    bool has_effect = false;
    for (const std::vector<Argument>& setting : settings_) {
      std::vector<Vec3d> colours;
      for (std::size_t i = 0; i < linear_.size(); ++i) {
        colours.emplace_back();
        for (int c = 0; c < 3; ++c) colours.back()[c] = static_cast<double>(1 + random() % 62) / 64;
      }
      const std::vector<Values> parts = parts_of(setting);
      const Values all = values_with(setting, colours);
      if (parts.empty() || all.empty() || parts.back().empty()) continue;
      for (std::size_t k = 0; k < all.size(); ++k) {
        Vec3d sum = parts.back()[k];
        for (std::size_t i = 0; i < linear_.size(); ++i) sum += parts[i][k] * colours[i];
        for (int c = 0; c < 3; ++c) {
          if (std::abs(sum[c] - all[k][c]) > 1e-7 * (std::abs(sum[c]) + std::abs(all[k][c]))) return false;
        }
      }
      has_effect = has_effect || largest_of(parts[linear_.size() - 1]) > 0;
    }
    return has_effect;
  }

  void find_linear_colours() {
    for (const ParameterInfo* parameter : candidates_) {
      if (parameter->kind != ParameterKind::Reflectance || parameter->minimum != 0) continue;
      linear_.push_back(parameter);
      if (!superpose()) linear_.pop_back();
    }
  }

  bool is_linear(const ParameterInfo& parameter) const {
    return std::find(linear_.begin(), linear_.end(), &parameter) != linear_.end();
  }

  /// Returns the part of a linear colour if it is the same at all settings, so that no shape tells it apart.
  Values constant_part(std::size_t colour) const {
    Values constant;
    for (const std::vector<Argument>& setting : settings_) {
      const std::vector<Values> parts = parts_of(setting);
      if (parts.empty() || parts.back().empty()) continue;
      Values part = normalised(parts[colour]);
      if (part.empty()) return {};
      if (constant.empty()) constant = part;
      if (largest_difference(part, constant) > 1e-6) return {};
    }
    return constant;
  }

  void hold_repeated_diffuse_part(std::vector<Values>& diffuse_parts) {
    for (std::size_t i = 0; i < linear_.size(); ++i) {
      const Values part = constant_part(i);
      if (part.empty()) continue;
      const bool is_repeated =
          std::any_of(diffuse_parts.begin(), diffuse_parts.end(),
                      [&](const Values& other) { return largest_difference(part, other) <= 1e-6; });
      if (!is_repeated) {
        diffuse_parts.push_back(part);
        continue;
      }
      const ParameterInfo* parameter = linear_[i];
      lobe_.held.push_back(fmt::format("{}: 0, since another lobe has the same part", parameter->name));
      lobe_.fixed.push_back(argument_of(parameter->name, 0));
      probe_ = Probe(lobe_.info, lobe_.fixed, observations_);
      std::erase(candidates_, parameter);
      linear_.erase(linear_.begin() + static_cast<std::ptrdiff_t>(i--));
    }
  }

  /// In a sum, a lobe that is not black without its linear colours has a weight; its colours are shapes then,
  /// since the product of two unknowns is not linear.
  void find_weight(bool is_in_sum) {
    if (!is_in_sum) return;
    for (const std::vector<Argument>& setting : settings_) {
      const Values none = values_with(setting, std::vector<Vec3d>(linear_.size(), Vec3d(0)));
      if (largest_of(none) > 0) lobe_.has_weight = true;
    }
    if (lobe_.has_weight) linear_.clear();
  }

  bool changes_values(const ParameterInfo& parameter) const {
    const ShapeParameter shape = shape_of(parameter);
    for (const std::vector<Argument>& setting : settings_) {
      std::vector<Argument> others = setting;
      std::erase_if(others, [&](const Argument& one) { return parameter.is_called(one.name); });
      // What shapes the part of a colour that is black by default changes nothing without it.
      for (const ParameterInfo* other : candidates_) {
        if (other->kind == ParameterKind::Reflectance && other != &parameter && other->default_value == 0)
          others.push_back(argument_of(other->name, other->maximum / 2));
      }
      Values first;
      for (const double t : {0.05, 0.1, 0.2, 0.35, 0.5, 0.8}) {
        std::vector<Argument> arguments = others;
        arguments.push_back(argument_of(parameter.name, shape.value(t)));
        const Values values = probe_.values(arguments);
        if (values.empty()) continue;
        if (first.empty()) first = values;
        if (largest_difference(first, values) > 1e-9 * largest_of(first)) return true;
      }
    }
    return false;
  }

  void add_shape(const ParameterInfo& parameter) {
    ShapeParameter shape = shape_of(parameter);
    // A reflectance has a colour; of other numbers that may differ per channel, colours share one.
    const bool is_coloured = parameter.kind == ParameterKind::Reflectance && parameter.maximum <= 1 &&
                             parameter.minimum == 0 && !observations_.is_grey;
    if (!is_coloured) {
      lobe_.shapes.push_back(shape);
      return;
    }
    for (int channel = 0; channel < 3; ++channel) {
      shape.channel = channel;
      lobe_.shapes.push_back(shape);
    }
  }

  const Observations& observations_;
  Probe probe_;
  Lobe lobe_;
  std::vector<const ParameterInfo*> candidates_;  ///< of the model's table in `lobe_`
  std::vector<const ParameterInfo*> linear_;      ///< those among them that enter linearly
  std::vector<std::vector<Argument>> settings_;
};

/// Returns the fixed arguments that a model has a parameter for; nothing after an error.
std::optional<std::vector<Argument>> arguments_for(const grf::ModelInfo& info,
                                                   const std::vector<grf::ModelInfo>& models,
                                                   const std::vector<Argument>& fixed,
                                                   grf::Diagnostics& diagnostics) {
  grf::Model model;
  model.keyword = info.keyword;
  for (const Argument& argument : fixed) {
    if (info.find(argument.name) != nullptr) model.arguments.push_back(argument);
  }
  if (!grf::check(model, models, "BRDF", diagnostics)) return std::nullopt;
  return model.arguments;
}

}  // namespace

std::optional<std::vector<Lobe>> lobes_of(const std::vector<std::string>& keywords,
                                          const std::vector<Argument>& fixed,
                                          const Observations& observations, grf::Diagnostics& diagnostics) {
  const std::vector<grf::ModelInfo> models = reflectance::brdf_infos();
  std::vector<Lobe> lobes;
  std::vector<Values> diffuse_parts;
  for (const std::string& keyword : keywords) {
    grf::Model model;
    model.keyword = keyword;
    const grf::ModelInfo* info = grf::find_model(models, keyword);
    if (info == nullptr) {
      grf::report_unknown(model, models, "BRDF", {}, diagnostics);
      return std::nullopt;
    }
    if (info->argument_kind != grf::ModelInfo::ArgumentKind::Parameters) {
      diagnostics.error({}, fmt::format("'{}' cannot be fitted: it is no model with parameters", keyword));
      return std::nullopt;
    }
    const auto arguments = arguments_for(*info, models, fixed, diagnostics);
    if (!arguments) return std::nullopt;
    Lobe lobe = LobeAnalysis(*info, *arguments, observations).find(keywords.size() > 1, diffuse_parts);
    if (lobe.shapes.empty() && lobe.colours.empty() && !lobe.has_weight) {
      diagnostics.error({}, fmt::format("'{}' cannot be fitted: {}", keyword,
                                        lobe.held.empty() ? "no free parameter of it changes the values"
                                                          : fmt::format("{}", fmt::join(lobe.held, "; "))));
      return std::nullopt;
    }
    lobes.push_back(std::move(lobe));
  }
  return lobes;
}

}  // namespace fit
