#include <gtest/gtest.h>

#include "renderer/reflectance/scheme.h"
#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::Rgb;

TEST(Catalogue, DefaultsAreInTheirRanges) {
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    EXPECT_FALSE(model.title.empty());
    for (const grf::ParameterInfo& parameter : model.parameters) {
      EXPECT_GE(parameter.default_value, parameter.minimum) << model.keyword << parameter.name;
      EXPECT_LE(parameter.default_value, parameter.maximum) << model.keyword << parameter.name;
      EXPECT_FALSE(parameter.help.empty()) << model.keyword << parameter.name;
    }
  }
}

TEST(Catalogue, KeywordsAreDistinct) {
  const grf::Catalogue catalogue = reflectance::catalogue();
  for (const auto& models : {catalogue.brdfs, catalogue.pdfs}) {
    for (const grf::ModelInfo& model : models) {
      EXPECT_EQ(std::count_if(models.begin(), models.end(),
                              [&](const grf::ModelInfo& other) { return other.keyword == model.keyword; }),
                1);
    }
  }
}

TEST(Brdf, TakesItsParametersFromTheScene) {
  const auto ward = std::get<reflectance::Ward>(test::brdf_of("Ward SX=0.1 sy=0.3 ks=(0.1, 0.2, 0.3)"));
  EXPECT_EQ(ward.sx, 0.1F);
  EXPECT_EQ(ward.sy, 0.3F);
  EXPECT_EQ(ward.ks, Rgb(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(ward.kd, Rgb(0.5F));
}

TEST(Brdf, SaysWhatPartsItHas) {
  using test::brdf_of;
  EXPECT_TRUE(is_anisotropic(brdf_of("ward sx=0.1 sy=0.2")) && is_anisotropic(brdf_of("kajiya")));
  EXPECT_TRUE(is_anisotropic(brdf_of("poulin")) && is_anisotropic(brdf_of("granier tilt=0.1")));
  EXPECT_FALSE(is_anisotropic(brdf_of("poulin d=0")) || is_anisotropic(brdf_of("granier")));
  EXPECT_TRUE(has_specular_part(brdf_of("he")) && has_specular_part(brdf_of("westin")));
  EXPECT_TRUE(has_glossy_part(brdf_of("beardmaxwell Rd=0")));
  EXPECT_FALSE(has_diffuse_part(brdf_of("beardmaxwell Rd=0")));
  EXPECT_FALSE(has_glossy_part(brdf_of("beardmaxwell Rs=0 Rv=0")) || has_glossy_part(brdf_of("he sigma=0")));
}

TEST(Brdf, IsUnknownByAnyOtherName) {
  grf::BrdfModel model;
  model.keyword = "wrd";
  EXPECT_FALSE(reflectance::make_brdf(model));
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(grf::check(model, reflectance::brdf_infos(), "BRDF", diagnostics));
  EXPECT_NE(diagnostics.to_text().find("did you mean 'ward'?"), std::string::npos) << diagnostics.to_text();
}

}  // namespace
