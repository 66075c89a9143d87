// The surfaces of a scene against what formats make of them, by closed forms.
#include "converters/surface_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/relocate.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

using testing::HasSubstr;

class SurfaceComparisons : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;

  ComparedScene compare(const std::string& text, const std::string& format) {
    const auto scene = grf::read_text(text, "scene.grf", diagnostics_);
    EXPECT_TRUE(scene) << diagnostics_.to_text();
    auto compared = compare_surfaces(*scene, *find_format(format), folder_.path("."), diagnostics_);
    EXPECT_TRUE(compared) << diagnostics_.to_text();
    return compared.value_or(ComparedScene());
  }
  SurfaceComparison compare_brdf(const std::string& brdf, const std::string& format) {
    const ComparedScene compared = compare(mesh(brdf), format);
    EXPECT_EQ(compared.surfaces.size(), 1U);
    return compared.surfaces.empty() ? SurfaceComparison() : compared.surfaces[0];
  }
  static std::string mesh(const std::string& brdf) {
    return "begin mesh " + brdf +
           " begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end begin faces (0,1,2,3) end end\n";
  }
};

// STL has triangles alone, so that GRF's default comes back: Lambert's BRDF of albedo 0.5.
TEST_F(SurfaceComparisons, OfLambertsBrdfAreTheDifferenceOfItsAlbedos) {
  const SurfaceComparison one = compare_brdf("rgb (0.5, 1, 1) brdf diffuse kd=0.6", "stl");
  for (std::size_t i = 0; i < ComparedDegrees.size(); ++i) {
    EXPECT_NEAR(one.albedos[i], 0.5, 1e-3);
    EXPECT_NEAR(one.returned_albedos[i], 0.5, 1e-3);
  }
  // The channels differ by 0.2, 0.1 and 0.1, of 0.3, 0.6 and 0.6.
  EXPECT_NEAR(*one.lobe_error, 0.4 / 1.5, 1e-3);
  const SurfaceComparison darker = compare_brdf("brdf diffuse kd=0.8", "stl");
  EXPECT_NEAR(darker.albedo_change(), 0.3, 1e-3);
  EXPECT_NEAR(*darker.lobe_error, 0.3 / 0.8, 1e-3);
  EXPECT_EQ(darker.original, "diffuse kd=0.8");
}

// A mirror and a diffuse lobe have nothing in common.
TEST_F(SurfaceComparisons, OfMirrorsCountTheirWeight) {
  const SurfaceComparison one = compare_brdf("brdf specular ks=0.9", "stl");
  EXPECT_NEAR(one.albedo_change(), 0.4, 1e-3);
  EXPECT_NEAR(*one.lobe_error, (0.5 + 0.9) / 0.9, 2e-3);
}

TEST_F(SurfaceComparisons, AreEqualWhereTheFormatKeepsTheBrdf) {
  for (const char* brdf : {"brdf diffuse kd=0.8", "brdf ward sx=0.2 sy=0.3 ks=0.3 kd=0.2"}) {
    for (const char* format : {"grf", "glb", "gltf"}) {
      const SurfaceComparison one = compare_brdf(brdf, format);
      EXPECT_EQ(one.returned, one.original) << format;
      EXPECT_EQ(one.albedo_change(), 0) << format;
      EXPECT_NEAR(*one.lobe_error, 0, 1e-6) << format;
    }
  }
}

TEST_F(SurfaceComparisons, OfRenderersAreThoseOfTheirMaterials) {
  for (const char* format : {"pbrt", "mitsuba"}) {
    const SurfaceComparison diffuse = compare_brdf("rgb (0.5, 1, 1) brdf diffuse kd=0.6", format);
    EXPECT_LT(diffuse.albedo_change(), 1e-6) << format;
    EXPECT_NEAR(*diffuse.lobe_error, 0, 1e-6) << format;
    const SurfaceComparison table = compare_brdf("brdf oren s=0.5 r=0.8", format);
    EXPECT_THAT(table.returned, HasSubstr("rgl ")) << format;
    EXPECT_GT(*table.lobe_error, 0) << format;
    EXPECT_LT(*table.lobe_error, 0.03) << format;
  }
  // The mean by the cosine of Schlick's term (1 - c)^5 is 1/21.
  const SurfaceComparison coupled = compare_brdf("brdf coupled Rm=0 R0=0.05", "pbrt");
  const double mirror = 0.05 + 0.95 / 21;
  EXPECT_NEAR(coupled.albedos[0], 0.05, 2e-3);
  EXPECT_NEAR(coupled.returned_albedos[0], mirror, 2e-3);
}

// The mapped scene has the BRDFs that come back, and what else the original has.
TEST_F(SurfaceComparisons, OfFormatsThatAreNotReadMakeAScene) {
  const ComparedScene compared =
      compare("def shiny = brdf coupled Rm=0.5 R0=0.05 begin " + mesh("rgb (1, 0.5, 0.5) brdf shiny") +
                  mesh("light rgb (3, 2, 1)") + " end",
              "pbrt");
  ASSERT_TRUE(compared.mapped);
  const auto again = compare_surfaces(*compared.mapped, *find_format("grf"), folder_.path("."), diagnostics_);
  ASSERT_TRUE(again) << diagnostics_.to_text();
  ASSERT_EQ(again->surfaces.size(), compared.surfaces.size());
  EXPECT_THAT(again->surfaces[0].original, HasSubstr("combine"));
  for (std::size_t i = 0; i < ComparedDegrees.size(); ++i)
    EXPECT_NEAR(again->surfaces[0].albedos[i], compared.surfaces[0].returned_albedos[i], 1e-3);
  EXPECT_FALSE(compare(mesh("brdf diffuse"), "grf").mapped);
}

// The same file, included under two meanings of a name.
TEST_F(SurfaceComparisons, OfAMeshThatIsIncludedTwiceAreThoseOfEachScope) {
  folder_.add("part.grf", mesh("brdf material"));
  const std::string path =
      folder_.add("scene.grf",
                  "def material = brdf diffuse kd=0.25 begin include \"part.grf\" end\n"
                  "def material = brdf diffuse kd=0.75 begin include \"part.grf\" end\n");
  const auto scene = grf::read(path, diagnostics_);
  ASSERT_TRUE(scene) << diagnostics_.to_text();
  const auto compared = compare_surfaces(grf::with_absolute_names(*scene, path), *find_format("pbrt"),
                                         folder_.path("."), diagnostics_);
  ASSERT_TRUE(compared && compared->mapped) << diagnostics_.to_text();
  ASSERT_EQ(compared->surfaces.size(), 2U);
  EXPECT_NEAR(compared->surfaces[0].albedos[0], 0.25, 1e-3);
  EXPECT_NEAR(compared->surfaces[1].albedos[0], 0.75, 1e-3);
  const auto again =
      compare_surfaces(*compared->mapped, *find_format("grf"), folder_.path("."), diagnostics_);
  ASSERT_EQ(again->surfaces.size(), 2U);
  EXPECT_NEAR(again->surfaces[1].albedos[0], 0.75, 1e-3);
}

TEST_F(SurfaceComparisons, CountFacesOfAllInstances) {
  const ComparedScene compared = compare("def box = " + mesh("brdf diffuse kd=0.25") +
                                             " begin use box use box " + mesh("brdf diffuse kd=0.75") + "end",
                                         "stl");
  ASSERT_EQ(compared.surfaces.size(), 2U);
  EXPECT_EQ(compared.surfaces[0].faces, 2U);
  EXPECT_NEAR(compared.surfaces[0].albedos[0], 0.25, 1e-3);
  EXPECT_EQ(compared.surfaces[1].faces, 1U);
}

}  // namespace
}  // namespace convert
