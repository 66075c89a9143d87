// The glTF material: its energy, and the fit of what facets with Schlick's second part reflect.
#include "renderer/reflectance/gltf.h"

#include <string>

#include <gtest/gtest.h>

#include "tests/reflectance/albedo.h"

namespace {

using reflectance::Brdf;

using GltfInDouble = reflectance::glsl::GltfFormula<double>;

double albedo_of(const std::string& text, double degrees) { return test::albedo(text, degrees, 25, 1e-6); }

// A metal of white facets with F0 = 0 reflects Schlick's second part alone.
TEST(Gltf, KnowsWhatFacetsReflectAtGrazing) {
  for (const double roughness : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    for (const double degrees : {5.0, 45.0, 65.0, 80.0, 86.0}) {
      const double alpha = roughness * roughness;
      const std::string text = "ggx alpha=" + std::to_string(alpha) + " scattering=single F0=";
      const double white = albedo_of(text + "1", degrees);
      const double half = albedo_of(text + "0.5", degrees);
      const double c = test::direction(degrees, 0).z;
      // F0 = 1/2 reflects (white + grazing)/2.
      EXPECT_NEAR(GltfInDouble().ggx_grazing(c, alpha), 2 * half - white, 0.017) << alpha << " " << degrees;
    }
  }
}

TEST(Gltf, KnowsTheMeanOfWhatFacetsReflectAtGrazing) {
  for (const double alpha : {0.04, 0.16, 0.36, 0.64, 1.0}) {
    double mean = 0;
    constexpr int Count = 400;
    for (int i = 0; i < Count; ++i) {
      const double c = (i + 0.5) / Count;
      mean += 2 * c * GltfInDouble().ggx_grazing(c, alpha) / Count;
    }
    EXPECT_NEAR(GltfInDouble().ggx_mean_grazing(alpha), mean, 0.003) << alpha;
  }
}

TEST(Gltf, OfWhiteReflectsAllLight) {
  for (const char* material : {"metallic=0", "metallic=1", "metallic=0.5"}) {
    for (const char* roughness : {"0.3", "0.5", "0.8", "1"}) {
      for (const double degrees : {0.0, 40.0, 70.0, 85.0}) {
        const std::string text = std::string("gltf roughness=") + roughness + " " + material;
        EXPECT_NEAR(albedo_of(text, degrees), 1, 0.012) << text << " at " << degrees;
      }
    }
  }
}

// What is below a coat or fibres loses what these do not let through twice, up to 6 %.
TEST(Gltf, OfWhiteUnderLayersReflectsNearlyAllLight) {
  for (const char* layers : {"clearcoat=1 clearcoatRoughness=0.3", "sheenColor=1 sheenRoughness=0.5",
                             "clearcoat=0.5 clearcoatRoughness=0.6 sheenColor=0.4"}) {
    for (const double degrees : {0.0, 40.0, 70.0, 85.0}) {
      const double albedo = albedo_of(std::string("gltf roughness=0.5 ") + layers, degrees);
      EXPECT_GT(albedo, 0.94 - (std::string(layers).starts_with("sheen") ? 0.2 : 0)) << layers << degrees;
      EXPECT_LT(albedo, 1.015) << layers << " at " << degrees;
    }
  }
}

TEST(Gltf, WithoutSpecularReflectionIsLambert) {
  const Brdf brdf = test::brdf_of("gltf baseColor=0.6 specular=0");
  for (const double degrees : {0.0, 40.0, 80.0}) {
    EXPECT_NEAR(evaluate(brdf, test::direction(degrees, 10), test::direction(50, 200)).x,
                0.6 / reflectance::Pi, 1e-6);
  }
}

}  // namespace
