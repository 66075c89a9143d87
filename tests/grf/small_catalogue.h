// A small catalogue of models for tests.
#pragma once

#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "grf/catalogue.h"

namespace grf {

inline ParameterInfo parameter(std::string_view name, ParameterKind kind, float maximum,
                               std::vector<std::string_view> aliases = {}) {
  ParameterInfo info;
  info.name = name;
  info.aliases = std::move(aliases);
  info.kind = kind;
  info.maximum = maximum;
  return info;
}

inline const Catalogue& catalogue() {
  static const Catalogue known = [] {
    ModelInfo glossy;
    glossy.keyword = "glossy";
    glossy.parameters = {
        parameter("Rough", ParameterKind::Number, std::numeric_limits<float>::max(), {"m", "sigma"}),
        parameter("kd", ParameterKind::Reflectance, 1), parameter("fast", ParameterKind::Boolean, 1)};
    glossy.takes_maps = true;
    ModelInfo flat;
    flat.keyword = "flat";
    ModelInfo cosine;
    cosine.keyword = "cosine";
    ParameterInfo mode = parameter("mode", ParameterKind::Word, 1);
    mode.choices = {"reject", "warp"};
    cosine.parameters = {parameter("n", ParameterKind::Number, 100), mode};
    ModelInfo combine;
    combine.keyword = "combine";
    combine.argument_kind = ModelInfo::ArgumentKind::Terms;
    return Catalogue{{glossy, flat, combine}, {cosine}};
  }();
  return known;
}

}  // namespace grf
