// The exceptions that models' tables declare: each has an instance that shows it, so that no model is exempt
// from common tests for nothing.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using reflectance::Brdf;
using reflectance::Vec3f;

/// Instances of models with an exception, and the view angle at which it shows, if that matters.
struct Exception {
  std::string brdf;
  double theta = 0;
};

struct Promise {
  std::string name;
  std::string_view grf::ModelInfo::*excuse;
  std::vector<Exception> exceptions;
  bool (*is_broken)(const Exception&);
};

bool is_turned_to_another_value(const Exception& exception) {
  const Brdf brdf = test::brdf_of(exception.brdf);
  EXPECT_TRUE(is_anisotropic(brdf)) << exception.brdf;
  const float one = evaluate(brdf, test::direction(40, 20), test::direction(15, 110)).x;
  const float turned = evaluate(brdf, test::direction(40, 75), test::direction(15, 165)).x;
  return std::abs(one - turned) > 0.05F * std::max(one, turned);
}

bool is_another_value_swapped(const Exception& exception) {
  const Brdf brdf = test::brdf_of(exception.brdf);
  const float forth = evaluate(brdf, test::direction(70, 0), test::direction(62, 180)).x;
  const float back = evaluate(brdf, test::direction(62, 180), test::direction(70, 0)).x;
  return std::abs(forth - back) > 0.05F * std::max(forth, back);
}

bool reflects_more_than_it_receives(const Exception& exception) {
  const Brdf brdf = test::brdf_of(exception.brdf);
  const Vec3f u = test::direction(exception.theta, 25);
  return test::albedo(brdf, u, 1e-6) + specular_weight(brdf, u).x > 1.001;
}

/// Returns true if float differs from double by more than 1e-3.
bool differs_in_float(const Brdf& brdf, const Vec3f& u, const Vec3f& v) {
  const Imath::V3d a(u);
  const Imath::V3d b(v);
  const double exact = std::visit([&](const auto& model) { return model.evaluate(a, b).x; }, brdf);
  return exact > double(std::numeric_limits<float>::min()) &&
         std::abs(evaluate(brdf, u, v).x - exact) > 1e-3 * exact;
}

/// Returns true if they differ on both sides of the direction at which the value falls to a fraction of the
/// larger one.
bool differs_where_it_falls(const Brdf& brdf, const Vec3f& u, Vec3f above, Vec3f below, float share) {
  const auto value = [&](const Vec3f& v) { return evaluate(brdf, u, v).x; };
  if (value(above) < value(below)) std::swap(above, below);
  const float limit = share * value(above);
  if (value(below) > limit) return false;
  for (int step = 0; step < 40; ++step) {
    const Vec3f middle = (above + below).normalized();
    (value(middle) > limit ? above : below) = middle;
  }
  return differs_in_float(brdf, u, above) || differs_in_float(brdf, u, below);
}

/// Returns true if they differ at a minimum, which is found from some direction by random steps.
bool differs_where_it_is_least(const Brdf& brdf, const Vec3f& u, Vec3f v, std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (float step = 0.1F; step > 1e-6F;) {
    const Vec3f offset{uniform(random), uniform(random), uniform(random)};  // the order of the calls is fixed
    const Vec3f next = (v + step * offset).normalized();
    const bool is_less = next.z > 0.1F && evaluate(brdf, u, next).x < evaluate(brdf, u, v).x;
    if (is_less) v = next;
    step *= is_less ? 1.1F : 0.95F;
    if (differs_in_float(brdf, u, v)) return true;
  }
  return false;
}

bool has_values_that_differ_in_float(const Exception& exception) {
  const Brdf brdf = test::brdf_of(exception.brdf);
  std::mt19937 random(32);
  for (const auto& [u, v] : test::direction_pairs(1000, 31)) {
    if (differs_in_float(brdf, u, v)) return true;
    for (const float share : {0.5F, 1e-3F, 1e-6F, 0.0F}) {
      if (differs_where_it_falls(brdf, u, reflectance::mirrored(u), v, share)) return true;
    }
    if (differs_where_it_is_least(brdf, u, test::direction(40, 10), random)) return true;
  }
  return false;
}

const std::vector<Promise>& promises() {
  static const std::vector<Promise> list = {
      {"Isotropic",
       &grf::ModelInfo::not_isotropic,
       {{"ward sx=0.2 sy=0.4"},
        {"lafortune n=5 kp=0 Cx=1 Cy=-1 Cz=1"},
        {"ashikhmin ex=10 ey=50"},
        {"schlick Sp=0.4"},
        {"neumann r=0.3 ry=0.9"},
        {"kajiya"},
        {"granier tilt=0.3"},
        {"poulin"},
        {"ggx alpha=0.1 ay=0.4"},
        {"thinfilm alpha=0.1 ay=0.4 nimag=3"},
        {"gltf metallic=1 anisotropy=0.5"},
        {"openpbr metalness=1 anisotropy=0.7"},
        {"rgl brushed_half"},
        {"utia of ward sx=0.4 sy=0.7"},
        {"0.5 diffuse + 0.5 ward sx=0.2 sy=0.4"},
        {"coat alpha=0.3 over ward sx=0.2 sy=0.4"},
        {"ward sx=0.2 sy=0.4 over diffuse"}},
       is_turned_to_another_value},
      {"Reciprocal",
       &grf::ModelInfo::not_reciprocal,
       {{"strauss s=0.6 m=0 ks=1 kd=0"},
        {"ggx alpha=0.6 F0=1 scattering=scaled"},
        {"sheen"},
        {"gltf baseColor=0 specular=0 sheenColor=1"},
        {"openpbr baseColor=0 specularWeight=0 fuzzWeight=1 fuzzRoughness=0.3"},
        {"rgl matte"},
        {"measured zemax.bsdf"},
        {"0.1 diffuse + 0.5 strauss s=0.6 m=0 ks=1 kd=0"},
        {"coat alpha=0.0001 over strauss s=0.6 m=0 ks=1 kd=0"},
        {"sheen over diffuse kd=0"}},
       is_another_value_swapped},
      {"Conserving",
       &grf::ModelInfo::not_conserving,
       {{"phong n=5 ks=1 kd=0.2", 0},
        {"blinn n=5 ks=1 kd=0", 0},
        {"ward sx=0.2 ks=1 kd=0", 89.99},
        {"minnaert k=0.5 kd=1", 60},
        {"lafortune n=5 kp=0.5 Cx=-1 Cy=-1 Cz=1", 0},
        {"oren s=0.3 r=1", 85},
        {"schlick SC=1 Sr=1", 75},
        {"strauss s=0.8 m=0 ks=1 kd=1", 0},
        {"beardmaxwell nreal=0 Rs=1 Rd=0 Rv=0", 85},
        {"granier d=0 n=20 ks=1 kt=1", 0},
        {"ggx alpha=0.4 anisotropy=0.8 F0=1", 80},
        {"gltf roughness=0.2 clearcoat=1 clearcoatRoughness=0.1", 89},
        {"openpbr baseColor=1 coatWeight=1 coatRoughness=0.3", 88},
        {"thinfilm alpha=0.555 ay=0.111 nreal=0.001 nimag=100", 80},
        {"table of blinn n=5 ks=1 kd=0", 20},
        {"rgl matte", 89},
        {"0.7 diffuse kd=0.8 + 0.7 diffuse kd=0.8", 30},
        {"coat alpha=0.3 over blinn n=5 ks=1 kd=0", 0},
        {"blinn n=5 ks=1 kd=0 over diffuse", 0}},
       reflects_more_than_it_receives},
      {"TheSameInFloat",
       &grf::ModelInfo::not_continuous,
       {{"phong n=0 ks=1 kd=0"},
        {"lewis n=0 ks=1 kd=0"},
        {"lafortune n=0 kp=0"},
        {"oren s=0.7 r=0.01"},
        {"neumann r=0.3"},
        {"sheen rough=0.132355"},
        {"gltf baseColor=0 specular=0 sheenColor=1 sheenRoughness=0.132355"},
        {"openpbr baseColor=0 specularWeight=0 fuzzWeight=1 fuzzRoughness=0.132355"},
        {"he sigma=1e-6 tau=100000 lambda=500"},
        {"westin sigma=1e-6 tau=100000 lambda=500"},
        {"granier nreal=1.5 d=115 n=5 m=5 ks=1 kt=0.11"},
        {"poulin d=100 h=0.99 n=1"}},
       has_values_that_differ_in_float},
  };
  return list;
}

class Promises : public testing::TestWithParam<Promise> {};

std::string keyword_of(const std::string& brdf) {
  if (brdf.starts_with("table") || brdf.starts_with("utia")) return "measured";
  if (brdf.find(" over ") != std::string::npos && !brdf.starts_with("coat")) return "layer";
  return brdf.find(" + ") != std::string::npos ? "combine" : brdf.substr(0, brdf.find(' '));
}

TEST_P(Promises, AreBrokenByWhateverModelSaysSoAndByNoOther) {
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    const auto& exceptions = GetParam().exceptions;
    const auto found = std::find_if(exceptions.begin(), exceptions.end(), [&](const Exception& exception) {
      return keyword_of(exception.brdf) == model.keyword;
    });
    EXPECT_EQ(found == exceptions.end(), (model.*GetParam().excuse).empty()) << model.keyword;
    if (found != exceptions.end()) {
      EXPECT_TRUE(GetParam().is_broken(*found)) << "by " << found->brdf << "; " << model.*GetParam().excuse;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, Promises, testing::ValuesIn(promises()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
