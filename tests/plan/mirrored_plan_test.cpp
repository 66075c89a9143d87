// Lights of all kinds under reflections, by plan and image: they emit from their fronts.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/plan/plan_helpers.h"

namespace {

using test::PlannedRender;
using test::PlannedScene;
using transport::Vec3f;

constexpr double Radiance = 7;
constexpr double Reflectance = 0.6;

/// A square of side 1 at y = -1, its front up or down, in five strips.
std::string strips(const std::string& of_face, bool shines_up) {
  std::string text = "begin vertexs\n";
  for (int i = 0; i < 12; ++i) {
    text += fmt::format("({},-1,{})\n", static_cast<float>(i / 2) / 5 - 0.5F, i % 2 == 0 ? -0.5F : 0.5F);
  }
  text += "end vertexs begin faces\n";
  for (int i = 0; i < 10; i += 2) {
    text += of_face + (shines_up ? fmt::format(" ({},{},{},{})\n", i, i + 1, i + 3, i + 2)
                                 : fmt::format(" ({},{},{},{})\n", i, i + 2, i + 3, i + 1));
  }
  return text + "end faces ";
}

/// The same square as each kind of light.
std::vector<std::pair<std::string, std::string>> lights_that_shine(bool up) {
  const std::string edges = up ? "(0,0,1) (1,0,0)" : "(1,0,0) (0,0,1)";
  const std::string emitting = "begin mesh " + strips("light rgb (7,7,7)", up) + "end mesh ";
  return {{"area light", "light begin rgb (7,7,7) (-0.5,-1,-0.5) " + edges + " end "},
          {"faces", emitting},
          {"mesh light", "mesh light begin " + strips("rgb (7,7,7)", up) + "end "},
          // The second one is too far away to matter.
          {"instance", "def lamp = " + emitting +
                           "begin use lamp transform translation (0,0,-5000) begin use lamp end end "}};
}

/// A floor at y = 0, whose centre is visible.
PlannedScene planned(const std::string& light, const Vec3f& scale) {
  PlannedRender setup;
  setup.eye = Vec3f(3, 0.5F, 0);
  setup.width = setup.height = 4;
  setup.samples = 64;
  setup.field_of_view = 0.01F;
  setup.most_copied_triangles = 0;
  return PlannedScene(test::quad("brdf diffuse kd=0.6", "(-1,0,1) (1,0,1) (1,0,-1) (-1,0,-1)") +
                          test::placed(light, scale, Vec3f(0), Vec3f(0)),
                      setup);
}

// The cosine-weighted fraction of the hemisphere over the floor's centre that a parallel square of half side
// a at height 1 covers is 4/pi s atan(s), s = a/sqrt(1 + a^2).
TEST(MirroredLight, ShinesFromItsFront) {
  const double s = 0.5 / std::sqrt(1.25);
  const double expected = Reflectance * Radiance * 4 / std::numbers::pi * s * std::atan(s);
  for (const Vec3f& scale : {Vec3f(1, -1, 1), Vec3f(-1, -1, -1)}) {
    for (const auto& [kind, light] : lights_that_shine(true)) {
      PlannedScene scene = planned(light, scale);
      ASSERT_FALSE(scene.needed().empty()) << kind;
      EXPECT_EQ(scene.needed()[0], "area_lights") << kind;
      const test::Estimate estimate = test::mean_radiance(scene.film());
      EXPECT_NEAR(estimate.mean, expected, 4 * estimate.deviation + 2e-3 * expected) << kind;
      EXPECT_LT(estimate.deviation, 0.02 * expected) << kind << ": it is sampled";
    }
  }
}

TEST(MirroredLight, IsDarkFromItsBack) {
  for (const Vec3f& scale : {Vec3f(1, -1, 1), Vec3f(-1, -1, -1)}) {
    for (const auto& [kind, light] : lights_that_shine(false)) {
      PlannedScene scene = planned(light, scale);
      EXPECT_FALSE(scene.plan()[transport::Effect::AreaLights].is_needed && kind != "instance") << kind;
      EXPECT_EQ(test::mean_radiance(scene.film()).mean, 0) << kind;
    }
  }
}

}  // namespace
