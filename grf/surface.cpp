#include "grf/surface.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>

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

std::size_t hash_of(const Texture& texture) { return std::hash<std::string>()(texture.file); }

std::size_t hash_of(const Model& model) {
  std::size_t hash = std::hash<std::string>()(lower_case(model.keyword));
  for (const Argument& argument : model.arguments) {
    mix(hash, std::hash<std::string>()(lower_case(argument.name)));
    if (const auto* number = std::get_if<float>(&argument.value)) mix(hash, hash_of(*number));
    if (const auto* colour = std::get_if<Colour>(&argument.value)) mix(hash, hash_of(*colour));
    if (const auto* word = std::get_if<Word>(&argument.value)) {
      mix(hash, std::hash<std::string>()(lower_case(word->text)));
    }
  }
  return hash;
}

std::size_t hash_of(const BrdfModel& brdf) {
  std::size_t hash = hash_of(static_cast<const Model&>(brdf));
  for (const CombineTerm& term : brdf.terms) {
    mix(hash, hash_of(term.weight));
    mix(hash, hash_of(term.brdf));
  }
  mix(hash, std::hash<std::string>()(brdf.data_file));
  mix(hash, std::hash<std::string>()(brdf.instance_file));
  return hash;
}

template <class Attribute>
std::size_t hash_of_attribute(const Attribute& attribute) {
  return attribute ? std::visit([](const auto& value) { return hash_of(value); }, *attribute) : 0;
}

bool written_alike(float a, float b) { return a == b && std::signbit(a) == std::signbit(b); }
bool written_alike(bool a, bool b) { return a == b; }
bool written_alike(const Word& a, const Word& b) { return a.text == b.text; }
bool written_alike(const Colour& a, const Colour& b) {
  return written_alike(a.x, b.x) && written_alike(a.y, b.y) && written_alike(a.z, b.z);
}
bool written_alike(const Reference& a, const Reference& b) { return a.name == b.name; }
bool written_alike(const Texture& a, const Texture& b) { return a == b; }
bool written_alike(const Model& a, const Model& b);
bool written_alike(const BrdfModel& a, const BrdfModel& b);

template <class... Alternatives>
bool written_alike(const std::variant<Alternatives...>& a, const std::variant<Alternatives...>& b) {
  const auto same_as_b = [&b](const auto& value) {
    return written_alike(value, std::get<std::decay_t<decltype(value)>>(b));
  };
  return a.index() == b.index() && std::visit(same_as_b, a);
}

bool written_alike(const Model& a, const Model& b) {
  return a.keyword == b.keyword && std::equal(a.arguments.begin(), a.arguments.end(), b.arguments.begin(),
                                              b.arguments.end(), [](const Argument& x, const Argument& y) {
                                                return x.name == y.name && written_alike(x.value, y.value);
                                              });
}

bool written_alike(const CombineTerm& a, const CombineTerm& b) {
  return written_alike(a.weight, b.weight) && written_alike(a.brdf, b.brdf);
}

bool written_alike(const BrdfModel& a, const BrdfModel& b) {
  return written_alike(static_cast<const Model&>(a), static_cast<const Model&>(b)) &&
         std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(),
                    [](const CombineTerm& x, const CombineTerm& y) { return written_alike(x, y); }) &&
         a.data_file == b.data_file && a.instance_file == b.instance_file;
}

template <class Attribute>
bool written_alike(const std::optional<Attribute>& a, const std::optional<Attribute>& b) {
  return a.has_value() == b.has_value() && (!a || written_alike(*a, *b));
}

}  // namespace

std::size_t hash_value(const Surface& surface) {
  std::size_t hash = hash_of_attribute(surface.colour);
  mix(hash, hash_of_attribute(surface.brdf));
  mix(hash, hash_of_attribute(surface.pdf));
  mix(hash, hash_of_attribute(surface.texture));
  mix(hash, surface.emission ? hash_of(*surface.emission) : 0);
  return hash;
}

bool is_written_alike(const Surface& a, const Surface& b) {
  return written_alike(a.colour, b.colour) && written_alike(a.brdf, b.brdf) && written_alike(a.pdf, b.pdf) &&
         written_alike(a.texture, b.texture) && written_alike(a.emission, b.emission);
}

}  // namespace grf
