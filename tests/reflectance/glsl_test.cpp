// The formulas are one text for two languages: here both run it over the same directions and parameters.
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/glsl_context.h"
#include "tests/reflectance/random_models.h"

namespace {

using reflectance::Rgb;
using reflectance::Vec3f;
using test::Pair;

std::string text_of(const std::string& name) {
  std::ifstream file(std::string(GRANADA_SOURCE_DIR "/renderer/reflectance/") + name + ".glsl");
  EXPECT_TRUE(file) << name;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string functions_of(std::string_view keyword) {
  std::string text;
  for (const char* shared :
       {"glsl_functions", "float_functions", "common", "fresnel", "beckmann", "refraction", "kirchhoff"})
    text += text_of(shared);
  return text + text_of(std::string(keyword));
}

/// A difference in 1/sr that no image shows: where the terms of a formula cancel, digits are lost in both.
constexpr float Unseen = 1e-7F;

template <class Model>
std::string argument(std::size_t k, float Model::*) {
  return fmt::format("parameter({}).x", k);
}
template <class Model>
std::string argument(std::size_t k, Rgb Model::*) {
  return fmt::format("parameter({})", k);
}
template <class Model>
std::string argument(std::size_t k, int Model::*) {
  return fmt::format("int(parameter({}).x)", k);
}
template <class Model>
std::string argument(std::size_t k, bool Model::*) {
  return fmt::format("(parameter({}).x != 0)", k);
}

/// The call of a model's GLSL function: its arguments are its parameters in the order of its table.
template <class Model>
std::string call_of() {
  const auto table = Model::table();
  std::string call = fmt::format("{}(u, v", table.keyword);
  for (std::size_t k = 0; k < table.parameters.size(); ++k) {
    call += ", " + std::visit([&](auto field) { return argument(k, field); }, table.parameters[k].field);
  }
  return call + ")";
}

/// The call of the function for a model's Dirac part, for those whose formula is no constant: as `call_of`,
/// without v and without the diffuse part, which is the last parameter.
template <class Model>
std::string mirror_call_of() {
  std::string call = call_of<Model>();
  const std::string keyword(Model::table().keyword);
  call.resize(call.rfind(", parameter"));
  return keyword + "_mirror(u" + call.substr(keyword.size() + 5) + ")";
}

Rgb shader_value(float value) { return Rgb(value); }
Rgb shader_value(int value) { return Rgb(static_cast<float>(value)); }
Rgb shader_value(bool value) { return Rgb(value ? 1.0F : 0.0F); }
Rgb shader_value(const Rgb& value) { return value; }

/// What a model's shader is run over, and the models, for messages.
template <class Model>
struct Triples {
  std::vector<Vec3f> u;
  std::vector<Vec3f> v;
  std::vector<Model> models;
  test::ShaderParameters parameters;

  void add(const Model& model, std::span<const Pair> pairs) {
    const auto table = Model::table();
    models.push_back(model);
    parameters.width = static_cast<int>(table.parameters.size());
    parameters.pairs_each = static_cast<int>(pairs.size());
    for (const auto& parameter : table.parameters) {
      parameters.values.push_back(
          std::visit([&](auto field) { return shader_value(model.*field); }, parameter.field));
    }
    for (const Pair& pair : pairs) {
      u.push_back(pair.u);
      v.push_back(pair.v);
    }
  }

  const Model& model_of(std::size_t i) const {
    return models[i / static_cast<std::size_t>(parameters.pairs_each)];
  }
};

/// Long sums and integrals differ a little more.
float tolerance(std::string_view keyword) {
  return keyword == "he" || keyword == "westin" || keyword == "poulin" ? 1e-3F : 1e-4F;
}

template <class Model>
void expect_same(const Triples<Model>& triples) {
  const std::string_view keyword = Model::table().keyword;
  const std::vector<Rgb> shader = test::GlslContext().run(functions_of(keyword), call_of<Model>(), triples.u,
                                                          triples.v, triples.parameters);
  test::Failures failures;
  for (std::size_t i = 0; i < shader.size(); ++i) {
    const Model& model = triples.model_of(i);
    const Pair pair = {triples.u[i], triples.v[i]};
    const Rgb expected = model.evaluate(pair.u, pair.v);
    for (int k = 0; k < 3; ++k) {
      const float difference = std::abs(shader[i][k] - expected[k]);
      if (difference <= tolerance(keyword) * expected[k] + Unseen) continue;
      if (test::is_taken_nearby(model, pair, k, shader[i][k])) continue;
      failures.add(difference / expected[k], model, pair, shader[i][k], expected[k]);
    }
  }
  failures.expect_none();
}

template <class Model>
class Glsl : public testing::Test {};

TYPED_TEST_SUITE(Glsl, test::TypesOf<reflectance::FormulaBrdf>::Types, test::KeywordOf);

TYPED_TEST(Glsl, IsWhatCppIsInKnownCases) {
  const std::vector<Pair> pairs = test::direction_pairs(8192, 5);
  Triples<TypeParam> triples;
  for (const auto& cases :
       {test::extreme_cases(), test::plain_cases(), test::stepped_cases(), test::hard_cases()}) {
    for (const std::string& text : cases) {
      const reflectance::Brdf brdf = test::brdf_of(text);
      if (const auto* model = std::get_if<TypeParam>(&brdf)) triples.add(*model, pairs);
    }
  }
  expect_same(triples);
}

TYPED_TEST(Glsl, IsWhatCppIsForRandomParameters) {
  Triples<TypeParam> triples;
  test::for_each_set<TypeParam>(
      [&](const TypeParam& model, std::span<const Pair> pairs) { triples.add(model, pairs); });
  expect_same(triples);
}

template <class Model>
void expect_mirror_is_what_cpp_is() {
  Triples<Model> triples;
  test::for_each_set<Model>(
      [&](const Model& model, std::span<const Pair> pairs) { triples.add(model, pairs.first(4)); });
  const std::vector<Rgb> shader =
      test::GlslContext().run(functions_of(Model::table().keyword), mirror_call_of<Model>(), triples.u,
                              triples.u, triples.parameters);
  test::Failures failures;
  for (std::size_t i = 0; i < shader.size(); ++i) {
    const Rgb expected = triples.model_of(i).mirror(triples.u[i]);
    for (int k = 0; k < 3; ++k) {
      const float difference = std::abs(shader[i][k] - expected[k]);
      if (difference <= 1e-3F * expected[k] + 1e-12F) continue;
      failures.add(difference / expected[k], triples.model_of(i), {triples.u[i], triples.u[i]}, shader[i][k],
                   expected[k]);
    }
  }
  failures.expect_none();
}

TEST(GlslMirror, IsWhatCppsIs) {
  expect_mirror_is_what_cpp_is<reflectance::He>();
  expect_mirror_is_what_cpp_is<reflectance::Westin>();
}

}  // namespace
