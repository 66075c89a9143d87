#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"

namespace test {

/// The arguments of gtest's typed tests, one per type of a variant.
template <class Variant>
struct TypesOf;
template <class... Models>
struct TypesOf<std::variant<Models...>> {
  using Types = testing::Types<Models...>;
};
struct KeywordOf {
  template <class Model>
  static std::string GetName(int /*index*/) {  // NOLINT(readability-identifier-naming): gtest's name
    return std::string(Model::table().keyword);
  }
};

/// Generates models with random parameters over their full ranges: of nine values one is the minimum and one
/// the maximum, two are near those, two are within ten times the default, one has any order of magnitude.
class ModelGenerator {
 public:
  explicit ModelGenerator(std::uint32_t seed) : random_(seed) {}

  template <class Model>
  Model next() {
    Model model;
    do {
      model = Model();
      for (const auto& parameter : Model::table().parameters) {
        reflectance::visit_field(parameter, [&](auto field) { draw(parameter.info, model.*field); });
      }
    } while (is_wrong(model));
    reflectance::prepare(model);
    return model;
  }

 private:
  template <class Model>
  static bool is_wrong(const Model& model) {
    if constexpr (requires { model.validate(); }) return !model.validate().empty();
    return false;
  }

  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }

  void draw(const grf::ParameterInfo& info, int& field) {
    field = std::uniform_int_distribution<int>(0, static_cast<int>(info.choices.size()) - 1)(random_);
  }
  void draw(const grf::ParameterInfo& info, float& field) { field = number(info, field); }
  void draw(const grf::ParameterInfo&, bool& field) { field = random_() % 2 == 0; }
  void draw(const grf::ParameterInfo& info, Imath::V3f& field) {
    const Imath::V3f usual = field;
    field = Imath::V3f(number(info, usual.x));
    if (random_() % 2 == 0) return;
    field.y = number(info, usual.y);
    field.z = number(info, usual.z);
  }

  float number(const grf::ParameterInfo& info, float usual) {
    const float range = info.maximum - info.minimum;
    const float from_end = range * std::pow(10.0F, uniform(-8, -1));
    switch (random_() % 9) {
      case 0:
        return info.minimum;
      case 1:
        return info.maximum;
      case 2:
        return info.minimum + from_end;
      case 3:
        return info.maximum - from_end;
      case 4:
        return of_any_magnitude(info);
      case 5:
      case 6:
        return std::clamp(usual * std::pow(10.0F, uniform(-1, 1)), info.minimum, info.maximum);
      default:
        return info.scale == grf::ParameterScale::Logarithmic ? of_any_magnitude(info)
                                                              : uniform(info.minimum, info.maximum);
    }
  }

  float of_any_magnitude(const grf::ParameterInfo& info) {
    if (info.minimum < 0) return uniform(info.minimum, info.maximum);
    const float least = std::max(info.minimum, info.maximum * 1e-9F);
    return std::min(info.maximum, std::exp(uniform(std::log(least), std::log(info.maximum))));
  }

  std::mt19937 random_;
};

/// Returns a model's instance as GRF text, as in `ward sx=0.1 sy=0.2`.
template <class Model>
std::string instance_of(const Model& model) {
  const auto value = [](auto field) {
    if constexpr (std::is_same_v<decltype(field), Imath::V3f>) {
      return fmt::format("({}, {}, {})", field.x, field.y, field.z);
    } else {
      return fmt::format("{}", field);
    }
  };
  std::string text(Model::table().keyword);
  for (const auto& parameter : Model::table().parameters) {
    text += fmt::format(" {}=", parameter.info.name) +
            std::visit([&](auto field) { return value(model.*field); }, parameter.field);
  }
  return text;
}

constexpr int SetCount = 15625;
constexpr int PairsPerSet = 64;

inline const std::vector<Pair>& million_pairs() {
  static const std::vector<Pair> pairs = direction_pairs(SetCount * PairsPerSet, 1);
  return pairs;
}

/// Calls a function with each random model and the pairs to test.
template <class Model, class Function>
void for_each_set(Function function) {
  ModelGenerator generator(2);
  for (std::size_t set = 0; set < SetCount; ++set) {
    const Model model = generator.next<Model>();
    function(model, std::span(million_pairs()).subspan(set * PairsPerSet, PairsPerSet));
  }
}

/// Counts failing triples, and keeps the worst one.
class Failures {
 public:
  template <class Model>
  void add(double error, const Model& model, const Pair& pair, double got, double expected) {
    ++count_;
    if (!(error > worst_)) return;
    worst_ = error;
    text_ = fmt::format("{} u ({}, {}, {}) v ({}, {}, {}): {} and not {}", instance_of(model), pair.u.x,
                        pair.u.y, pair.u.z, pair.v.x, pair.v.y, pair.v.z, got, expected);
  }
  bool are_none() const { return count_ == 0; }
  void expect_none() const { EXPECT_EQ(count_, 0) << "the worst by " << worst_ << ": " << text_; }

 private:
  int count_ = 0;
  double worst_ = -1;
  std::string text_;
};

/// Returns true if the formula has a declared step or steep slope here, and the value is one that it takes
/// within 1e-6 of v, and of its cosine.
template <class Model>
bool is_taken_nearby(const Model& model, const Pair& pair, int channel, double value) {
  if (Model::table().not_continuous.empty()) return false;
  double least = INFINITY;
  double greatest = 0;
  for (int i = 0; i < 27; ++i) {
    const Imath::V3d v(pair.v);
    const Imath::V3d near = v + 1e-6 * Imath::V3d(i % 3 - 1, i / 3 % 3 - 1, (i / 9 - 1) * v.z);
    const double f = model.evaluate(Imath::V3d(pair.u), near)[channel];
    least = std::min(least, f);
    greatest = std::max(greatest, f);
  }
  if (greatest - least < 0.1 * greatest) return false;
  return value >= least * (1 - 1e-3) && value <= greatest * (1 + 1e-3);
}

}  // namespace test
