// What a fit does with data of all kinds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/fit/problem.h"
#include "tests/fit/fit_cases.h"
#include "tests/support/temporary_folder.h"

namespace {

using fit::Metric;
using test::fit_of;
using test::observations_of;
using test::parameter;
using testing::Contains;
using testing::HasSubstr;

TEST(FitTargets, AreModelsAndSums) {
  const auto targets = fit::targets_of("ward, ggx,combine ggx eon", 2);
  ASSERT_TRUE(targets);
  ASSERT_EQ(targets->size(), 3U);
  EXPECT_EQ((*targets)[0].name(), "combine ward ward");
  EXPECT_EQ((*targets)[1].name(), "combine ggx ggx");
  EXPECT_EQ((*targets)[2].name(), "combine ggx eon");
  EXPECT_FALSE(fit::targets_of("ward,,ggx", 1));
  EXPECT_FALSE(fit::targets_of("ward ggx", 1));
  EXPECT_FALSE(fit::targets_of("combine", 1));
}

TEST(FitLobes, KnowWhatEntersLinearly) {
  grf::Diagnostics diagnostics;
  const fit::Observations data = observations_of("ward sx=0.3 ks=0.5 kd=(0.5, 0.3, 0.1)", 300);
  const auto names = [&](const std::string& keyword) {
    std::string text;
    const auto lobes = fit::lobes_of({keyword}, {}, data, diagnostics);
    for (const fit::ShapeParameter& shape : lobes->at(0).shapes) text += shape.name + " ";
    text += "|";
    for (const fit::ColourParameter& colour : lobes->at(0).colours) text += " " + colour.name;
    return text;
  };
  EXPECT_EQ(names("ward"), "sx | ks kd");  // isotropic data: sy follows sx
  EXPECT_EQ(names("diffuse"), "| kd");
  EXPECT_EQ(names("minnaert"), "k | kd");
  EXPECT_EQ(names("torrance"), "rough nreal nimag | ks kd");
  EXPECT_EQ(names("ggx"), "alpha nreal nimag | ks");
  EXPECT_EQ(names("ashikhmin"), "ex Rd Rd Rd | Rs");  // the diffuse part is Rd (1 - Rs)
}

TEST(FitLobes, OfASumHaveOneDiffusePart) {
  grf::Diagnostics diagnostics;
  const fit::Observations data = observations_of("ward sx=0.3 ks=0.5 kd=0.3", 300);
  const auto lobes = fit::lobes_of({"ward", "phong"}, {}, data, diagnostics);
  ASSERT_TRUE(lobes);
  ASSERT_EQ((*lobes)[1].colours.size(), 1U);
  EXPECT_EQ((*lobes)[1].colours[0].name, "ks");
  EXPECT_THAT((*lobes)[1].held, Contains(HasSubstr("kd: 0, since another lobe has the same part")));
}

TEST(FitLobes, CannotBeAnythingElse) {
  const fit::Observations data = observations_of("diffuse", 100);
  const auto message = [&](const std::string& keyword) {
    grf::Diagnostics diagnostics;
    EXPECT_FALSE(fit::lobes_of({keyword}, {}, data, diagnostics));
    return diagnostics.to_text();
  };
  EXPECT_THAT(message("wardd"), HasSubstr("did you mean 'ward'?"));
  EXPECT_THAT(message("measured"), HasSubstr("'measured' cannot be fitted: it is no model with parameters"));
  EXPECT_THAT(message("coat"), HasSubstr("'coat' cannot be fitted"));
  EXPECT_THAT(message("specular"),
              HasSubstr("'specular' cannot be fitted: ks: it changes none of the values"));
}

TEST(Fit, KeepsFixedParameters) {
  const fit::Observations data = observations_of("ward sx=0.3 ks=0.5 kd=0.3", 500);
  fit::FitSettings settings;
  settings.fixed = {{"kd", 0.1F, {}}};
  const fit::Fit fit = fit_of("ward", data, settings);
  EXPECT_THAT(text_of(fit), HasSubstr("kd=0.1"));
  EXPECT_GT(fit.error(Metric::CubeRoot).relative, 0.01);
  EXPECT_THROW(parameter(fit, "kd"), std::runtime_error);
}

TEST(Fit, MinimisesTheMetricAskedFor) {
  const fit::Observations data = observations_of("ggx alpha=0.15 nreal=1.8 ks=0.8", 1000);
  std::vector<fit::Fit> fits;
  for (const Metric metric : fit::Metrics) fits.push_back(fit_of("ward", data, {metric, {}, 0}));
  for (const Metric metric : fit::Metrics)
    EXPECT_EQ(ranking(fits, metric).front(), static_cast<std::size_t>(metric)) << name_of(metric);
}

TEST(Fit, SaysWhatTheDataDoNotDetermine) {
  // A lobe that is not there has no width.
  const fit::Fit fit = fit_of("phong", observations_of("diffuse kd=0.4", 500));
  EXPECT_FALSE(parameter(fit, "n").is_determined);
  EXPECT_NEAR(parameter(fit, "kd").value, 0.4, 1e-4);
  EXPECT_TRUE(parameter(fit, "kd").is_determined);
  EXPECT_THAT(fit.warnings, Contains(HasSubstr("the data do not determine n")));
}

TEST(Fit, SaysThatNoiseAloneIsNoise) {
  fit::Observations data = observations_of("diffuse kd=0.4", 400);
  std::mt19937 random(5);
  for (fit::Observation& one : data.list) one.value = fit::Vec3d(static_cast<double>(random()) / 0x1p32);
  const fit::Fit fit = fit_of("ward", data);
  EXPECT_THAT(fit.warnings,
              Contains(HasSubstr("no better than those of a diffuse BRDF: the data are noise")));
}

TEST(Fit, NeedsMoreValuesThanParameters) {
  const fit::Observations data = observations_of("ward sx=0.3 ks=0.5 kd=0.3", 3);
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(fit_brdf({{"ward"}}, data, {}, diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("'ward' has 3 free parameters, and there are only 3 values"));
}

TEST(Fit, DoesNotDependOnThreads) {
  fit::Observations data = observations_of("ward sx=0.3 ks=0.5 kd=0.3", 500);
  test::add_noise(data, 0.02, 1);
  EXPECT_EQ(text_of(fit_of("torrance", data, {Metric::Log, {}, 1})),
            text_of(fit_of("torrance", data, {Metric::Log, {}, 2})));
}

TEST(Fit, OfASumIsAScene) {
  const fit::Fit fit = fit_of("combine diffuse phong", observations_of("phong n=20 ks=0.2 kd=0.3", 500));
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text_of(fit), "fit.grf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const auto& scope = std::get<grf::DefinitionScope>(scene->contents.blocks.at(0).content);
  ASSERT_EQ(scope.definitions.size(), 3U);
  EXPECT_EQ(scope.definitions[2].name, "fit");
  EXPECT_EQ(std::get<grf::BrdfModel>(scope.definitions[2].body).terms.size(), 2U);
}

TEST(FitData, OfAMerlTableAreItsCellsUpTo80Degrees) {
  const fit::Observations data = observations_of("table of blinn n=40 ks=0.3 kd=0.3", 5000);
  EXPECT_EQ(data.list.size(), 5000U);
  const double lowest = std::cos(80 * M_PI / 180);
  for (const fit::Observation& one : data.list) {
    EXPECT_GE(one.u.z, lowest);
    EXPECT_GE(one.v.z, lowest);
  }
  const fit::Fit fit = fit_of("blinn", data);
  // The table has floats of 32 bits and cell centres.
  EXPECT_NEAR(parameter(fit, "n").value, 40, 0.01);
  EXPECT_NEAR(parameter(fit, "kd").value, 0.3, 1e-4);
}

TEST(FitData, OfAnisotropicBrdfsAreTurned) {
  EXPECT_TRUE(observations_of("ward sx=0.3", 10).is_isotropic);
  const fit::Observations data = observations_of("ward sx=0.3 sy=0.1", 200);
  EXPECT_FALSE(data.is_isotropic);
  double north = 0;
  for (const fit::Observation& one : data.list) north += one.u.y + one.v.y > 0 ? 1 : 0;
  EXPECT_NEAR(north / 200, 0.5, 0.1);
}

}  // namespace
