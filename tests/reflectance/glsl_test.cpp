// The formulas are one text for two languages: here both run it over the same directions.
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/glsl_context.h"

namespace {

using reflectance::Rgb;
using reflectance::Vec3f;

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
std::string argument(const Model& model, float Model::*field) {
  return fmt::format("float({})", model.*field);
}
template <class Model>
std::string argument(const Model& model, Rgb Model::*field) {
  const Rgb& rgb = model.*field;
  return fmt::format("vec3({}, {}, {})", rgb.x, rgb.y, rgb.z);
}
template <class Model>
std::string argument(const Model& model, bool Model::*field) {
  return model.*field ? "true" : "false";
}

/// The call of a model's GLSL function: its arguments are its parameters in the order of its table.
template <class Model>
std::string call_of(const Model& model) {
  const auto table = Model::table();
  std::string call = fmt::format("{}(u, v", table.keyword);
  for (const auto& parameter : table.parameters) {
    call += ", " + std::visit([&](auto field) { return argument(model, field); }, parameter.field);
  }
  return call + ")";
}

/// The call of the function for a model's Dirac part, for those whose formula is no constant: as `call_of`,
/// without v and without the diffuse part, which is the last parameter.
template <class Model>
std::string mirror_call_of(const Model& model) {
  std::string call = call_of(model);
  const std::string keyword(Model::table().keyword);
  call.resize(call.rfind(", vec3"));
  return keyword + "_mirror(u" + call.substr(keyword.size() + 5) + ")";
}

/// Long sums and integrals differ a little more.
float tolerance(const std::string& keyword) {
  return keyword == "he" || keyword == "westin" || keyword == "poulin" ? 1e-3F : 1e-4F;
}

TEST(Glsl, IsWhatCppIs) {
  test::GlslContext context;
  std::vector<Vec3f> u;
  std::vector<Vec3f> v;
  for (const test::Pair& pair : test::direction_pairs(65536, 5)) {
    u.push_back(pair.u);
    v.push_back(pair.v);
  }
  std::vector<std::string> cases = test::extreme_cases();
  cases.insert(cases.end(), test::plain_cases().begin(), test::plain_cases().end());
  cases.insert(cases.end(), test::stepped_cases().begin(), test::stepped_cases().end());
  cases.insert(cases.end(), test::hard_cases().begin(), test::hard_cases().end());
  for (const std::string& text : cases) {
    const reflectance::Brdf brdf = test::brdf_of(text);
    const auto [keyword, call] = std::visit(
        [](const auto& model) { return std::pair(std::string(model.table().keyword), call_of(model)); },
        brdf);
    if (test::info_of(brdf).takes != grf::ModelInfo::Takes::Parameters)
      continue;  // no formula, but data or others'
    const std::vector<Rgb> shader = context.run(functions_of(keyword), call, u, v);
    for (std::size_t i = 0; i < u.size(); ++i) {
      const Rgb expected = evaluate(brdf, u[i], v[i]);
      for (int k = 0; k < 3; ++k) {
        ASSERT_NEAR(shader[i][k], expected[k], tolerance(keyword) * expected[k] + Unseen)
            << text << " on " << context.renderer() << " u " << u[i] << " v " << v[i];
      }
    }
  }
}

template <class Model>
void expect_mirror_is_what_cpp_is(const std::string& text) {
  test::GlslContext context;
  const auto model = std::get<Model>(test::brdf_of(text));
  std::vector<Vec3f> u;
  for (const test::Pair& pair : test::direction_pairs(4096, 6)) u.push_back(pair.u);
  const std::vector<Rgb> shader =
      context.run(functions_of(Model::table().keyword), mirror_call_of(model), u, u);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Rgb expected = model.mirror(u[i]);
    for (int k = 0; k < 3; ++k)
      ASSERT_NEAR(shader[i][k], expected[k], 1e-3F * expected[k] + 1e-12F) << text << u[i];
  }
}

TEST(Glsl, MirrorPartsAreWhatCppsAre) {
  expect_mirror_is_what_cpp_is<reflectance::He>("he sigma=0.1 nreal=1.5");
  expect_mirror_is_what_cpp_is<reflectance::He>("he sigma=2 tau=1");
  expect_mirror_is_what_cpp_is<reflectance::Westin>("westin sigma=0.1 nreal=0.2 nimag=3");
}

}  // namespace
