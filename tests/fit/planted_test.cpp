// Parameters that were planted in data are found again, from the scan's starts alone.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/fit/fit_cases.h"

namespace {

using test::fit_of;
using test::observations_of;
using test::parameter;

/// A BRDF with values of all parameters that the data determine.
struct Planted {
  std::string brdf;
  std::vector<std::string> determined;  ///< those that have to be found
};

class PlantedParameters : public testing::TestWithParam<Planted> {};

TEST_P(PlantedParameters, AreFoundAgain) {
  const std::string& text = GetParam().brdf;
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf(text, "planted", diagnostics);
  ASSERT_TRUE(model) << diagnostics.to_text();
  const fit::Fit fit = fit_of(model->keyword, observations_of(text, 1000));
  SCOPED_TRACE(text_of(fit));
  EXPECT_LT(fit.error(fit::Metric::CubeRoot).relative, 1e-5);
  for (const std::string& name : GetParam().determined) {
    double expected[3] = {};
    for (const grf::Argument& argument : model->arguments) {
      if (argument.name != name) continue;
      const auto* rgb = std::get_if<grf::Colour>(&argument.value);
      for (int c = 0; c < 3; ++c) expected[c] = rgb ? (*rgb)[c] : std::get<float>(argument.value);
    }
    for (int c = 0; c < 3; ++c) {
      const fit::FittedParameter& found = parameter(fit, name, c);
      EXPECT_NEAR(found.value, expected[c], 1e-4 * std::abs(expected[c])) << name << " " << c;
      EXPECT_TRUE(found.is_determined) << name;
    }
  }
}

std::string name_of_planted(const testing::TestParamInfo<Planted>& instance) {
  return instance.param.brdf.substr(0, instance.param.brdf.find(' ')) + std::to_string(instance.index);
}

INSTANTIATE_TEST_SUITE_P(
    Models, PlantedParameters,
    testing::Values(
        Planted{"diffuse kd=(0.2, 0.5, 0.7)", {"kd"}},
        Planted{"phong n=40 ks=(0.5, 0.4, 0.1) kd=0.3", {"n", "ks", "kd"}},
        Planted{"blinn n=85 ks=0.7 kd=(0.1, 0.5, 0.2)", {"n", "ks", "kd"}},
        Planted{"lewis n=25 ks=0.6 kd=0.2", {"n", "ks", "kd"}},
        Planted{"ward sx=0.13 ks=0.35 kd=(0.3, 0.2, 0.1)", {"sx", "ks", "kd"}},
        Planted{"ward sx=0.1 sy=0.4 ks=0.35 kd=0.2", {"sx", "sy", "ks", "kd"}},
        Planted{"minnaert k=1.7 kd=0.4", {"k", "kd"}},
        Planted{"lafortune n=12 kp=0.3 Cx=-0.9 Cy=-0.9 Cz=0.8", {"n", "kp", "Cx", "Cy", "Cz"}},
        Planted{"oren s=0.35 r=(0.8, 0.4, 0.2)", {"s", "r"}},
        Planted{"torrance rough=0.25 nreal=1.6 nimag=0 ks=0.9 kd=0.2", {"rough", "nreal", "ks", "kd"}},
        Planted{"coupled Rm=(0.7, 0.4, 0.3) R0=0.06", {}},  // R0 is a factor of all values, too
        Planted{"ashikhmin ex=45 Rs=(0.4, 0.2, 0.1) Rd=0.5", {"ex", "Rs", "Rd"}},
        Planted{"schlick SC=(0.5, 0.4, 0.2) Sr=0.3", {"Sr", "SC"}},
        Planted{"strauss s=0.7 m=0.3 ks=0.6 kd=0.5", {"s", "ks"}},  // kd and m are a product
        Planted{"beardmaxwell tau=0.4 omega=0.6 nreal=1.7 nimag=0.4 Rs=0.5 Rd=0.3 Rv=0.4 sigma=0.3",
                {"tau", "omega", "sigma", "Rd", "Rv"}},
        Planted{"kajiya sigma=2 taux=12 tauy=12 nreal=1.7 ks=0.6 kd=0.2", {"nreal", "ks", "kd"}},
        Planted{"hanrahan nreal=1.4 g=0.3 albedo=0.8 depth=0.7 rough=0.2 ks=0.6 kd=0.3",
                {"nreal", "g", "albedo", "depth", "rough", "ks", "kd"}},
        Planted{"poulin d=2 h=0.2 n=40 ks=0.5 kd=0.3", {"d", "h", "n", "ks", "kd"}},
        Planted{"granier nreal=1.4 d=700 n=40 m=15 ks=0.6 kt=0.5 kd=0.1", {"n", "m", "ks", "kt", "kd"}},
        Planted{"eon rough=0.6 kd=(0.8, 0.5, 0.3)", {"rough", "kd"}},
        Planted{"ggx alpha=0.22 nreal=1.7 ks=(0.9, 0.7, 0.4)", {"alpha", "nreal", "ks"}},
        Planted{"sheen rough=0.35 ks=(0.8, 0.5, 0.2)", {"rough", "ks"}},
        Planted{"gltf baseColor=(0.8, 0.3, 0.1) roughness=0.5 ior=1.6 specular=1",
                {"baseColor", "roughness"}}),
    name_of_planted);

// With its other shapes fixed: the wavelength scales these, and all of them take a minute.
TEST(PlantedKirchhoff, IsFoundAgain) {
  fit::FitSettings settings;
  settings.fixed = {{"lambda", 500.0F, {}}, {"nreal", 1.5F, {}}, {"nimag", 0.0F, {}}};
  const fit::Fit fit = fit_of(
      "he", observations_of("he sigma=0.1 tau=3 lambda=500 nreal=1.5 nimag=0 ks=0.8 kd=0.3", 1000), settings);
  EXPECT_NEAR(parameter(fit, "sigma").value, 0.1, 1e-5);
  EXPECT_NEAR(parameter(fit, "tau").value, 3, 3e-4);
  EXPECT_NEAR(parameter(fit, "ks").value, 0.8, 8e-5);
  EXPECT_NEAR(parameter(fit, "kd").value, 0.3, 3e-5);
}

TEST(PlantedLobes, OfASumAreFoundAgain) {
  const fit::Observations observations =
      observations_of("1 ward sx=0.08 ks=0.3 kd=0.25 + 1 ward sx=0.45 ks=0.5 kd=0", 3000);
  const fit::Fit fit = fit_of("combine ward ward", observations);
  ASSERT_EQ(fit.terms.size(), 2U);
  EXPECT_LT(fit.error(fit::Metric::CubeRoot).relative, 1e-5) << text_of(fit);
  std::vector<double> slopes;
  for (const fit::FittedParameter& one : fit.parameters) {
    if (one.name == "sx") slopes.push_back(one.value);
  }
  std::sort(slopes.begin(), slopes.end());
  ASSERT_EQ(slopes.size(), 2U);
  EXPECT_NEAR(slopes[0], 0.08, 8e-6);
  EXPECT_NEAR(slopes[1], 0.45, 4.5e-5);
}

}  // namespace
