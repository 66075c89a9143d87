#include "grf/surface.h"

#include <array>
#include <cstring>
#include <functional>
#include <string_view>

#include "grf/keywords.h"

namespace grf {
namespace {

/// Builds the key of a surface: the bytes of everything that takes part in comparison.
class Key {
 public:
  /// `is_exact`: the sign of zeros and the case of keywords count.
  explicit Key(bool is_exact) : is_exact_(is_exact) {}

  void add(const Surface& surface) {
    add(surface.colour);
    add(surface.brdf);
    add(surface.pdf);
    add(surface.texture);
    add(surface.emission);
    add(surface.opacity);
  }

  std::string bytes;

 private:
  template <class Number>
  void add_number(Number number) {
    std::array<char, sizeof(Number)> digits;
    std::memcpy(digits.data(), &number, sizeof(Number));
    bytes.append(digits.data(), digits.size());
  }
  void add_name(std::string_view name) { bytes.append(name) += '\0'; }
  void add_keyword(std::string_view word) { add_name(is_exact_ ? std::string(word) : lower_case(word)); }

  void add(float value) { add_number(is_exact_ || value != 0 ? value : 0.0F); }
  void add(bool value) { add_number(value); }
  void add(const Word& word) { add_keyword(word.text); }
  void add(const Reference& reference) { add_name(reference.name); }
  void add(const Texture& texture) { add_name(texture.file); }
  void add(const Colour& colour) {
    for (const float component : {colour.x, colour.y, colour.z}) add(component);
  }
  void add(const Opacity& opacity) {
    add_number(opacity.kind);
    add(opacity.value);
  }
  void add(const Model& model) {
    add_keyword(model.keyword);
    add_number(model.arguments.size());
    for (const Argument& argument : model.arguments) {
      add_keyword(argument.name);
      add(argument.value);
    }
  }
  void add(const BrdfModel& brdf) {
    add(static_cast<const Model&>(brdf));
    add_number(brdf.terms.size());
    for (const CombineTerm& term : brdf.terms) {
      add(term.weight);
      add(term.brdf);
    }
    add_name(brdf.data_file);
    add_name(brdf.instance_file);
  }
  template <class... Alternatives>
  void add(const std::variant<Alternatives...>& value) {
    add_number(value.index());
    std::visit([this](const auto& alternative) { this->add(alternative); }, value);
  }
  template <class Attribute>
  void add(const std::optional<Attribute>& attribute) {
    add_number(attribute.has_value());
    if (attribute) add(*attribute);
  }

  bool is_exact_;
};

std::string key_of(const Surface& surface, bool is_exact) {
  Key key(is_exact);
  key.add(surface);
  return std::move(key.bytes);
}

}  // namespace

std::size_t hash_value(const Surface& surface) { return std::hash<std::string>()(key_of(surface, false)); }

std::string written_key(const Surface& surface) { return key_of(surface, true); }

}  // namespace grf
