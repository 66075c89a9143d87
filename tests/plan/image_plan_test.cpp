// Tests of the images that a plan loads: textures, their alpha, and what varies BRDFs.
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/plan/plan_scenes.h"

namespace {

using test::depth;
using test::Effect;
using test::Floor;
using test::Lamp;
using test::OutOfView;
using test::PlannedRender;
using test::PlannedScene;
using test::wall;

TEST(Plan, LoadsImagesThatVaryBrdfsOfFacesThatPathsMeet) {
  const std::string brdf = "brdf ward sx=texture \"missing.png\" r ";
  const std::string text = wall(brdf) + Lamp;
  const PlannedScene scene(text, depth(1));
  ASSERT_EQ(scene.plan().textures.size(), 1U);
  EXPECT_TRUE(scene.plan().textures[0].is_needed);
  EXPECT_TRUE(scene.plan()[Effect::Textures].is_needed);
  EXPECT_THROW(PlannedScene(text, depth(1)).compiled(), std::runtime_error);
  const PlannedRender uniform = test::without(depth(1), Effect::Textures);
  EXPECT_FALSE(PlannedScene(text, uniform).plan().textures.at(0).is_needed);
  EXPECT_EQ(PlannedScene(text, uniform).compiled().texture_count(), 0U);
  const std::string hidden = wall("brdf diffuse") + test::quad(brdf, OutOfView) + Lamp;
  EXPECT_FALSE(PlannedScene(hidden, depth(1)).plan().textures.at(0).is_needed);
  EXPECT_EQ(PlannedScene(hidden, depth(1)).compiled().texture_count(), 0U);
}

// The factor alone would be all metal, isotropic, or not a mirror.
TEST(Plan, TakesBrdfsThatImagesVaryForWhatTheyCanBe) {
  const auto needs = [](const std::string& brdf, Effect effect) {
    return PlannedScene(wall(brdf) + test::quad(brdf, Floor) + Lamp, depth(3)).plan()[effect].is_needed;
  };
  const std::string image = "texture \"a.png\" r";
  EXPECT_TRUE(needs("brdf ward sx=" + image + " sy=1", Effect::Anisotropy));
  EXPECT_FALSE(needs("brdf ward sx=1 sy=1", Effect::Anisotropy));
  EXPECT_TRUE(needs("brdf specular ks=" + image, Effect::MirrorReflection));
  EXPECT_TRUE(needs("brdf gltf metallic=" + image, Effect::GlossyInterreflection));
  EXPECT_TRUE(needs("brdf diffuse kd=" + image, Effect::DiffuseInterreflection));
  EXPECT_FALSE(needs("brdf diffuse kd=" + image, Effect::GlossyInterreflection));
}

// Its alpha decides what is seen behind a black face.
TEST(Plan, LoadsTexturesWhoseAlphaLightPasses) {
  const std::string text = wall("rgb (0,0,0) texture \"missing.png\" opacity mask 0.5") + Lamp;
  const PlannedScene scene(text, depth(1));
  ASSERT_EQ(scene.plan().textures.size(), 1U);
  EXPECT_TRUE(scene.plan().textures[0].is_needed);
  EXPECT_THROW(PlannedScene(text, depth(1)).compiled(), std::runtime_error);
  const PlannedRender opaque = test::without(depth(1), Effect::Opacity);
  EXPECT_FALSE(PlannedScene(text, opaque).plan().textures[0].is_needed);
  EXPECT_EQ(PlannedScene(text, opaque).compiled().texture_count(), 0U);
  const std::string lamp = wall("light rgb (1,1,1) texture \"missing.png\" opacity blend 1");
  EXPECT_TRUE(PlannedScene(lamp, depth(1)).plan().textures.at(0).is_needed);
}

}  // namespace
