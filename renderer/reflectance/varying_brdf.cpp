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
  const Brdf without = at(std::vector<Rgb>(maps_.size(), Rgb(0)));
  may_be_specular_ = has_specular_part(brdf_) || has_specular_part(without);
}

template <class Model>
void VaryingBrdf::find_varied(const grf::Model& data) {
  const ModelTable<Model> table = Model::table();
  may_be_anisotropic_ = !table.not_isotropic.empty();
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
