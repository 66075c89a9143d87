#include "grf/surface.h"

#include <functional>

#include "grf/keywords.h"

namespace grf {
namespace {

void mix(std::size_t& hash, std::size_t value) {
  hash ^= value + 0x9e3779b97f4a7c15ULL + (hash << 6U) + (hash >> 2U);
}

// The two zeros are equal, so they need one hash.
std::size_t hash_of(float value) { return std::hash<float>()(value == 0.0F ? 0.0F : value); }

std::size_t hash_of(const Colour& colour) {
  std::size_t hash = hash_of(colour.x);
  mix(hash, hash_of(colour.y));
  mix(hash, hash_of(colour.z));
  return hash;
}

std::size_t hash_of(const Reference& reference) { return std::hash<std::string>()(reference.name); }

std::size_t hash_of(const Model& model) {
  std::size_t hash = std::hash<std::string>()(lower_case(model.keyword));
  for (const Argument& argument : model.arguments) {
    mix(hash, std::hash<std::string>()(lower_case(argument.name)));
    if (const auto* number = std::get_if<float>(&argument.value)) mix(hash, hash_of(*number));
    if (const auto* colour = std::get_if<Colour>(&argument.value)) mix(hash, hash_of(*colour));
  }
  return hash;
}

template <class Attribute>
std::size_t hash_of_attribute(const Attribute& attribute) {
  return attribute ? std::visit([](const auto& value) { return hash_of(value); }, *attribute) : 0;
}

}  // namespace

std::size_t hash_value(const Surface& surface) {
  std::size_t hash = hash_of_attribute(surface.colour);
  mix(hash, hash_of_attribute(surface.brdf));
  mix(hash, hash_of_attribute(surface.pdf));
  mix(hash, surface.emission ? hash_of(*surface.emission) : 0);
  return hash;
}

}  // namespace grf
