// Formulas are one text for two languages: both run it here over the same directions and parameters.
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/reflectance/glsl_texts.h"
#include "renderer/reflectance/lit_surface.h"
#include "renderer/reflectance/shader.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/glsl_context.h"
#include "tests/reflectance/random_models.h"

namespace {

using reflectance::Rgb;
using reflectance::Vec3f;
using test::Pair;

/// An invisible difference in 1/sr: where the terms of a formula cancel, digits are lost in both.
constexpr float Unseen = 1e-7F;

/// Returns the shader that the 3D view uses for the model.
template <class Model>
reflectance::FormulaShader shader_of_model() {
  return reflectance::formula_shader(reflectance::FormulaBrdf(Model()).index(),
                                     [](std::size_t k) { return fmt::format("parameter({})", k); });
}

/// Returns the call of a model's delta part, unless it is constant: the model's arguments without v and the
/// diffuse part, which is the last parameter.
template <class Model>
std::string specular_call_of() {
  std::string call = shader_of_model<Model>().call;
  const std::string keyword(Model::table().keyword);
  call.resize(call.rfind(", parameter"));
  return keyword + "_specular(u" + call.substr(keyword.size() + 5) + ")";
}

/// The inputs of a model's shader, and the models, for messages.
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
    for (const Rgb& value : reflectance::shader_values(model)) parameters.values.push_back(value);
    for (const Pair& pair : pairs) {
      u.push_back(pair.u);
      v.push_back(pair.v);
    }
  }

  const Model& model_of(std::size_t i) const {
    return models[i / static_cast<std::size_t>(parameters.pairs_each)];
  }
};

/// Sums and integrals with many terms differ a little more.
float tolerance(std::string_view keyword) {
  return keyword == "he" || keyword == "westin" || keyword == "poulin" ? 1e-3F : 1e-4F;
}

/// Under a film, a channel is a sum over wavelengths, of which some count negatively: where it is far darker
/// than the others, most of the sum cancels. Returns what that may leave, as a part of the brightest channel.
float cancelled(std::string_view keyword) {
  return keyword == "thinfilm" || keyword == "gltf" || keyword == "openpbr" ? 1e-6F : 0;
}

template <class Model>
void expect_same(const Triples<Model>& triples) {
  const std::string_view keyword = Model::table().keyword;
  const reflectance::FormulaShader text = shader_of_model<Model>();
  EXPECT_EQ(text.keyword, keyword);
  const std::vector<Rgb> shader =
      test::GlslContext().run(text.functions, text.call, triples.u, triples.v, triples.parameters);
  test::Failures failures;
  for (std::size_t i = 0; i < shader.size(); ++i) {
    const Model& model = triples.model_of(i);
    const Pair pair = {triples.u[i], triples.v[i]};
    const Rgb expected = model.evaluate(pair.u, pair.v);
    const float brightest = std::max({expected.x, expected.y, expected.z});
    for (int k = 0; k < 3; ++k) {
      const float difference = std::abs(shader[i][k] - expected[k]);
      if (difference <= tolerance(keyword) * expected[k] + cancelled(keyword) * brightest + Unseen) continue;
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

/// C++ can evaluate what a shader would.
TYPED_TEST(Glsl, ValuesMakeTheModelAgain) {
  test::for_each_set<TypeParam>([](const TypeParam& model, std::span<const Pair> pairs) {
    const std::size_t formula = reflectance::FormulaBrdf(model).index();
    const reflectance::Brdf made =
        reflectance::brdf_of_values(formula, reflectance::shader_values(reflectance::Brdf(model)));
    ASSERT_EQ(made.index(), formula);
    for (const Pair& pair : pairs.first(4)) {
      EXPECT_EQ(reflectance::evaluate(made, pair.u, pair.v), model.evaluate(pair.u, pair.v));
    }
  });
}

template <class Model>
void expect_mirror_is_what_cpp_is() {
  Triples<Model> triples;
  test::for_each_set<Model>(
      [&](const Model& model, std::span<const Pair> pairs) { triples.add(model, pairs.first(4)); });
  const std::vector<Rgb> shader =
      test::GlslContext().run(shader_of_model<Model>().functions, specular_call_of<Model>(), triples.u,
                              triples.u, triples.parameters);
  test::Failures failures;
  for (std::size_t i = 0; i < shader.size(); ++i) {
    const Rgb expected = triples.model_of(i).specular_weight(triples.u[i]);
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

/// A shared file that is missing from the list would fail only in the window.
TEST(GlslTexts, AreAModelsOrShared) {
  // The shader of a lit surface has its own texts around those of the BRDF.
  const std::string shared = reflectance::shader_functions({}) + reflectance::lit_surface_shader("", "");
  for (const reflectance::GlslText& file : reflectance::glsl_texts()) {
    EXPECT_FALSE(file.text.empty()) << file.name;
    const bool is_a_models = std::ranges::any_of(
        reflectance::brdf_infos(), [&](const grf::ModelInfo& info) { return info.keyword == file.name; });
    EXPECT_NE(is_a_models, shared.find(file.text) != std::string::npos) << file.name;
  }
}

/// All formulas in one weighted text: names of functions must not clash.
TEST(GlslSum, IsWhatCppIs) {
  using reflectance::CombinedBrdfs;
  auto parts = std::make_shared<CombinedBrdfs>();
  for (const reflectance::Preset& preset : reflectance::thesis_models().presets) {
    parts->push_back({0.1F * static_cast<float>(parts->size()), test::brdf_of(std::string(preset.brdf))});
  }
  for (const char* more :
       {"specular", "diffuse", "neumann", "kajiya", "hanrahan", "westin", "granier tilt=0.2"}) {
    parts->push_back({0.5F, test::brdf_of(more)});
  }
  const reflectance::Brdf brdf = reflectance::Combine{parts};
  const auto shader = reflectance::shader_of(brdf);
  ASSERT_TRUE(shader);
  std::string text = shader->text;
  const std::string uniform = fmt::format("uniform vec3 brdf_parameters[{}];", shader->parameters.size());
  ASSERT_NE(text.find(uniform), std::string::npos);
  std::string constants = fmt::format("const vec3 brdf_parameters[{}] = vec3[](", shader->parameters.size());
  for (const Rgb& value : shader->parameters)
    constants += fmt::format("vec3({}, {}, {}),", value.x, value.y, value.z);
  constants.back() = ')';
  text.replace(text.find(uniform), uniform.size(), constants + ";");
  std::vector<Vec3f> u;
  std::vector<Vec3f> v;
  for (const Pair& pair : test::direction_pairs(256, 7)) {
    u.push_back(pair.u);
    v.push_back(pair.v);
  }
  const std::vector<Rgb> values =
      test::GlslContext().run(text, "brdf_value(u, v)", u, v, {1, static_cast<int>(u.size()), {Rgb(0)}});
  int far = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Rgb expected = reflectance::evaluate(brdf, u[i], v[i]);
    if (!values[i].equalWithRelError(expected, 2e-3F)) ++far;
  }
  // Steps, such as the edge of a disc lobe, may fall between the two.
  EXPECT_LE(far, static_cast<int>(u.size()) / 100);
}

TEST(Shader, IsNotThereForMeasurements) {
  auto parts = std::make_shared<reflectance::CombinedBrdfs>();
  parts->push_back({0.5F, reflectance::Diffuse()});
  EXPECT_TRUE(reflectance::shader_of(reflectance::Combine{parts}));
  parts->push_back({0.5F, reflectance::Measured()});
  EXPECT_FALSE(reflectance::shader_of(reflectance::Combine{parts}));
  EXPECT_FALSE(reflectance::shader_of(reflectance::Measured()));
  EXPECT_FALSE(reflectance::shader_of(reflectance::Rgl()));
}

}  // namespace
