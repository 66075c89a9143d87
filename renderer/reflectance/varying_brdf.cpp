#include "renderer/reflectance/varying_brdf.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <variant>

namespace reflectance {
namespace {

Rgb factor_of(const grf::Value& value) {
  if (const auto* colour = std::get_if<grf::Colour>(&value)) return *colour;
  const auto* number = std::get_if<float>(&value);
  return Rgb(number != nullptr ? *number : 1);
}

}  // namespace

VaryingBrdf::VaryingBrdf(const grf::Model& model) : brdf_(*make_brdf(model)) {
  std::visit([&]<class Model>(const Model&) { find_varied<Model>(model); }, static_cast<AnyBrdf&>(brdf_));
  // All at their factors, none, and all different, so that parameters that are equal else are not.
  std::vector<Rgb> texels(maps_.size(), Rgb(0));
  std::vector<Brdf> probes = {brdf_, at(texels)};
  for (std::size_t i = 0; i < texels.size(); ++i) {
    texels[i] = Rgb(static_cast<float>(i + 1) / static_cast<float>(texels.size() + 1));
  }
  probes.push_back(at(texels));
  may_be_specular_ = std::ranges::any_of(probes, has_specular_part);
  may_be_anisotropic_ = std::ranges::any_of(probes, is_anisotropic);
}

template <class Model>
void VaryingBrdf::find_varied(const grf::Model& data) {
  const ModelTable<Model> table = Model::table();
  std::vector<const grf::Argument*> arguments;  // of the maps
  for (const Parameter<Model>& parameter : table.parameters) {
    const grf::Argument* argument = argument_for(parameter, table, data);
    if (argument == nullptr || !argument->map) continue;
    const auto known = std::ranges::find(arguments, argument);
    Varied varied{static_cast<std::size_t>(known - arguments.begin()),
                  factor_of(argument->value),
                  parameter.info.minimum,
                  parameter.info.maximum,
                  {}};
    if (known == arguments.end()) {
      arguments.push_back(argument);
      maps_.push_back({map_path(*argument), argument->map->channel, argument->location});
    }
    visit_field(parameter, [&]<class Field>(Field Model::*field) {
      if constexpr (std::is_same_v<Field, float>) {
        varied.set = [field](Brdf& brdf, const Rgb& value) { *std::get_if<Model>(&brdf).*field = value.x; };
      } else if constexpr (std::is_same_v<Field, Rgb>) {
        varied.set = [field](Brdf& brdf, const Rgb& value) { *std::get_if<Model>(&brdf).*field = value; };
      }
    });
    if (varied.set) varied_.push_back(std::move(varied));
  }
}

Brdf VaryingBrdf::at(std::span<const Rgb> texels) const {
  Brdf brdf = brdf_;
  for (const Varied& varied : varied_) {
    Rgb value = varied.factor * texels[varied.map];
    for (int k = 0; k < 3; ++k) value[k] = std::clamp(value[k], varied.minimum, varied.maximum);
    varied.set(brdf, value);
  }
  std::visit([](auto& model) { prepare(model); }, static_cast<AnyBrdf&>(brdf));
  return brdf;
}

}  // namespace reflectance
