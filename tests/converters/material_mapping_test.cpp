#include "converters/material_mapping.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/converters/reading.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PhongMaterial plastic() {
  PhongMaterial material;
  material.name = "plastic";
  material.source = "MTL";
  material.diffuse = grf::Vec3d(0.2, 0.3, 0.4);
  material.specular = grf::Vec3d(0.5);
  material.exponent = 40;
  return material;
}

std::string brdf_of(const PhongMaterial& material) { return brdf_text(map_material(material).definition); }

TEST(MaterialMapping, AMaterialWithoutHighlightIsDiffuse) {
  PhongMaterial material = plastic();
  material.reflection = Reflection::None;
  EXPECT_EQ(brdf_of(material), "diffuse kd=(0.2, 0.3, 0.4)");
  material = plastic();
  material.specular = grf::Vec3d(0);
  EXPECT_EQ(brdf_of(material), "diffuse kd=(0.2, 0.3, 0.4)");
  EXPECT_EQ(brdf_of(PhongMaterial()), "diffuse kd=0.5");
}

TEST(MaterialMapping, AHighlightIsANormalisedPhongLobe) {
  EXPECT_EQ(brdf_of(plastic()), "lewis n=40 ks=0.5 kd=(0.2, 0.3, 0.4)");
  PhongMaterial material = plastic();
  material.exponent.reset();
  EXPECT_EQ(brdf_of(material), "lewis ks=0.5 kd=(0.2, 0.3, 0.4)");
}

TEST(MaterialMapping, ReflectsNoMoreThanComesInInAnyComponent) {
  PhongMaterial material = plastic();
  material.specular = grf::Vec3d(0.9, 0.7, 0.1);
  const MappedMaterial mapped = map_material(material);
  EXPECT_EQ(brdf_text(mapped.definition), "lewis n=40 ks=(0.9, 0.7, 0.1) kd=(0.1, 0.3, 0.4)");
  EXPECT_FALSE(mapped.clamped);
  EXPECT_THAT(mapped.definition.comments.before.back(), HasSubstr("kd is smaller than the original"));
}

TEST(MaterialMapping, AMirrorIsSpecularIfNothingIsLeftForADiffusePart) {
  PhongMaterial material = plastic();
  material.reflection = Reflection::Mirror;
  EXPECT_EQ(brdf_of(material), "lewis n=40 ks=0.5 kd=(0.2, 0.3, 0.4)")
      << "its exponent says that it is rough";
  material.exponent = 1000;
  EXPECT_EQ(brdf_of(material), "lewis n=1000000 ks=0.5 kd=(0.2, 0.3, 0.4)");
  material.diffuse = grf::Vec3d(0);
  EXPECT_EQ(brdf_of(material), "specular ks=0.5");
  material.exponent.reset();
  EXPECT_EQ(brdf_of(material), "specular ks=0.5");
  material.diffuse = grf::Vec3d(0.5);
  material.specular = grf::Vec3d(1);
  EXPECT_EQ(brdf_of(material), "specular ks=1");
}

TEST(MaterialMapping, AHighExponentAloneMakesNoMirror) {
  PhongMaterial material = plastic();
  material.exponent = 5000;
  material.diffuse = grf::Vec3d(0);
  EXPECT_EQ(brdf_of(material), "lewis n=5000 ks=0.5 kd=0");
}

TEST(MaterialMapping, ClampsWhatIsOutOfRange) {
  PhongMaterial material = plastic();
  material.diffuse = grf::Vec3d(-1, 0.5, 0.25);
  material.specular = grf::Vec3d(0.5, 1.5, 0.5);
  material.exponent = 2e6;
  material.emission = grf::Vec3d(-1, 0, 2);
  const MappedMaterial mapped = map_material(material);
  EXPECT_EQ(brdf_text(mapped.definition), "lewis n=1000000 ks=(0.5, 1, 0.5) kd=(0, 0, 0.25)");
  EXPECT_EQ(mapped.emission, grf::Colour(0, 0, 2));
  EXPECT_TRUE(mapped.clamped);
}

TEST(MaterialMapping, KeepsTheOriginalInAComment) {
  PhongMaterial material = plastic();
  material.name = "my plastic";
  material.source_values = {"Kd 0.2 0.3 0.4", "Ns 40", std::string(90, 'x'), "illum 2"};
  const MappedMaterial mapped = map_material(material);
  EXPECT_EQ(mapped.definition.name, "my$20$plastic");
  EXPECT_THAT(mapped.definition.comments.before,
              ElementsAre(" \"my plastic\"", " MTL: Kd 0.2 0.3 0.4; Ns 40;",
                          "   " + std::string(90, 'x') + ";", "   illum 2"));
}

TEST(MaterialMapping, AnUnknownMaterialKeepsItsName) {
  const MappedMaterial mapped = unknown_material("2nd", default_brdf());
  EXPECT_EQ(mapped.definition.name, "$32$nd");
  EXPECT_EQ(brdf_text(mapped.definition), "diffuse kd=0.5");
}

}  // namespace
}  // namespace convert
