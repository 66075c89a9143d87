#include "editor/brdf/live_sphere.h"

#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>
#include <array>
#include <atomic>
#include <cmath>
#include <tuple>

#include <gmock/gmock.h>

#include "editor/brdf/compiled_brdf.h"
#include "grf/read.h"
#include "renderer/reflectance/presets.h"
#include "tests/editor/brdf/brdf_of.h"

namespace editor {
namespace {

// Each task of the pool shades in parallel; none may wait for threads that the others hold.
TEST(SphereShading, IsDoneByAllThreadsOfThePool) {
  SphereScene scene;
  scene.brdf = compiled_brdf_of("ward sx=0.2");
  scene.side = 32;
  QThreadPool& pool = *QThreadPool::globalInstance();
  std::atomic<int> done = 0;
  const int tasks = 8 * pool.maxThreadCount();
  for (int i = 0; i < tasks; ++i) {
    pool.start([&] {
      if (!shade_on_cpu(scene, 16, {}).radiance.empty()) ++done;
    });
  }
  ASSERT_TRUE(pool.waitForDone(60'000)) << done << " of " << tasks;
  EXPECT_EQ(done, tasks);
}

using reflectance::Vec3f;

/// The number of pixels that differ by more than 1 % between GPU and CPU.
int differing(SphereShader& shader, const std::string& text) {
  SphereScene scene;
  scene.brdf = compiled_brdf_of(text);
  scene.side = 48;
  scene.light.normalize();
  const auto by_glsl = shader.shade(scene, 16, StopFlag());
  EXPECT_TRUE(by_glsl) << text;
  if (!by_glsl) return 0;
  EXPECT_TRUE(by_glsl->is_by_glsl);
  const SphereImage by_cpp = shade_on_cpu(scene, 16, {});
  int count = 0;
  double sum = 0;
  for (std::size_t i = 0; i < by_cpp.radiance.size(); ++i) {
    const reflectance::Rgb& expected = by_cpp.radiance[i];
    for (int k = 0; k < 3; ++k) sum += expected[k];
    const reflectance::Rgb difference = by_glsl->radiance[i] - expected;
    if (difference.length() > 0.01F * expected.length() + 1e-4F) ++count;
  }
  EXPECT_GT(sum, 0) << text;
  return count;
}

TEST(SphereShader, IsWhatCppIs) {
  OffscreenContext context;
  QOpenGLContext* const current = context.make_current();
  ASSERT_NE(current, nullptr);
  const auto shader = SphereShader::create(*current);
  ASSERT_TRUE(shader);
  for (const reflectance::Preset& preset : reflectance::thesis_models().presets) {
    // The rim of a narrow lobe may differ.
    EXPECT_LE(differing(*shader, std::string(preset.brdf)), 20) << preset.brdf;
  }
  for (const char* text :
       {"specular ks=0.8", "ward sx=0.05 sy=0.4 kd=(0.1, 0.2, 0.9)", "neumann", "granier"}) {
    EXPECT_LE(differing(*shader, text), 20) << text;
  }
}

TEST(SphereShader, LeavesMeasurementsToCpp) {
  OffscreenContext context;
  QOpenGLContext* const current = context.make_current();
  ASSERT_NE(current, nullptr);
  const auto shader = SphereShader::create(*current);
  SphereScene scene;
  scene.brdf = std::make_shared<const reflectance::Brdf>(reflectance::Measured());
  scene.side = 32;
  ASSERT_TRUE(shader);
  EXPECT_FALSE(shader->shade(scene, 16, StopFlag()));
  EXPECT_EQ(shade_on_cpu(scene, 16, {}).radiance.size(), 32U * 32U);
}

TEST(LiveSphere, IsShadedByCppWhereTheDriverRefuses) {
  GraphicsDriver driver;
  driver.compile = [](const ShaderTexts& texts) -> CompiledProgram {
    if (texts.fragment.contains("vec3 ward(")) return {nullptr, "0:1(1): error: no such thing\nmore"};
    return compile_program(texts);
  };
  LiveSphere sphere(nullptr, driver);
  QSignalSpy warned(&sphere, &LiveSphere::warned);
  const auto shows = [&](const char* text, bool is_by_glsl) {
    sphere.set_brdf(compiled_brdf_of(text));
    return QTest::qWaitFor(
        [&] {
          return !sphere.is_busy() && sphere.image().side > 0 && sphere.image().is_by_glsl == is_by_glsl;
        },
        20000);
  };
  sphere.resize(120, 120);
  sphere.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&sphere));
  EXPECT_TRUE(shows("phong", true));
  EXPECT_TRUE(warned.isEmpty());
  EXPECT_TRUE(shows("ward", false));
  ASSERT_FALSE(warned.isEmpty());
  EXPECT_THAT(warned[0][0].toString().toStdString(),
              testing::EndsWith("on the CPU: 0:1(1): error: no such thing"));
}

TEST(Displayed, IsEncodedAsSrgbWithExposure) {
  SphereImage image;
  image.side = 9;
  image.radiance.assign(81, reflectance::Rgb(0.18F, 0.5F, 2));
  const QColor middle = displayed(image, 0).pixelColor(4, 4);
  EXPECT_EQ(middle.red(), 118);
  EXPECT_EQ(middle.green(), 188);
  EXPECT_EQ(middle.blue(), 255);
  EXPECT_EQ(displayed(image, 1).pixelColor(4, 4).green(), 255);
  EXPECT_EQ(displayed(image, 0).pixelColor(0, 0).alpha(), 0);
}

TEST(ShadeByCpp, ShowsAMatteSurfaceUnderTheLight) {
  SphereScene scene;
  scene.brdf = compiled_brdf_of("diffuse kd=1");
  scene.side = 65;
  scene.light = Vec3f(0, 0, 1);
  const SphereImage with_light = shade_on_cpu(scene, 64, {});
  scene.light_strength = 0;
  const SphereImage without = shade_on_cpu(scene, 64, {});
  const std::size_t middle = 32 * 65 + 32;
  EXPECT_NEAR(with_light.radiance[middle].x - without.radiance[middle].x, 1, 1e-4);
}

/// A map with a bright patch towards -x, 20 degrees over the horizon.
studies::Environment map_with_a_window() {
  image::Image image = {64, 32, std::vector<reflectance::Rgb>(2048, reflectance::Rgb(0.1F, 0.2F, 0.3F))};
  for (int y = 10; y < 14; ++y) {
    for (int x = 14; x < 18; ++x) image.pixels[static_cast<std::size_t>(y * 64 + x)] = reflectance::Rgb(20);
  }
  studies::Environment environment;
  environment.kind = studies::Environment::Kind::Map;
  environment.set_map(std::make_shared<const transport::EnvironmentMap>(std::move(image)));
  return environment;
}

TEST(SphereShader, IsWhatCppIsInAnEnvironment) {
  OffscreenContext context;
  QOpenGLContext* const current = context.make_current();
  ASSERT_NE(current, nullptr);
  const auto shader = SphereShader::create(*current);
  ASSERT_TRUE(shader);
  for (const char* text : {"ward sx=0.2 ks=0.5 kd=0.3", "diffuse kd=0.7", "specular ks=0.8"}) {
    SphereScene scene;
    scene.brdf = compiled_brdf_of(text);
    scene.side = 48;
    scene.light_strength = 0;
    scene.environment = map_with_a_window();
    scene.environment.turned = 0.7F;
    const auto by_glsl = shader->shade(scene, 64, StopFlag());
    ASSERT_TRUE(by_glsl) << text;
    const SphereImage by_cpp = shade_on_cpu(scene, 64, {});
    int differing = 0;
    for (std::size_t i = 0; i < by_cpp.radiance.size(); ++i) {
      const reflectance::Rgb& expected = by_cpp.radiance[i];
      if ((by_glsl->radiance[i] - expected).length() > 0.01F * expected.length() + 1e-4F) ++differing;
    }
    // Samples at the border of a texel may fall on either side.
    EXPECT_LE(differing, 48 * 48 / 20) << text;
  }
}

/// The mean radiance of the left and the right half of an image.
std::array<float, 2> halves(const SphereImage& image) {
  std::array<float, 2> sums = {};
  for (int row = 0; row < image.side; ++row) {
    for (int column = 0; column < image.side; ++column) {
      sums[column < image.side / 2 ? 0 : 1] +=
          image.radiance[static_cast<std::size_t>(row * image.side + column)].y;
    }
  }
  return sums;
}

TEST(LiveSphere, IsLitByAnEnvironmentThatTurns) {
  LiveSphere sphere;
  sphere.resize(120, 120);
  sphere.set_brdf(compiled_brdf_of("diffuse kd=1"));
  sphere.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&sphere));
  const auto shown = [&] {
    EXPECT_TRUE(QTest::qWaitFor([&] { return sphere.image().side > 0 && !sphere.is_busy(); }, 20000));
    return sphere.image();
  };
  const SphereImage studio = shown();
  studies::Environment environment = map_with_a_window();
  sphere.set_environment(environment);
  auto [left, right] = halves(shown());
  EXPECT_GT(left, 1.3F * right) << "the window is towards -x";
  environment.turned = reflectance::Pi;
  sphere.set_environment(environment);
  std::tie(left, right) = std::tuple_cat(halves(shown()));
  EXPECT_GT(right, 1.3F * left);
  // A white sphere in a uniform environment is as bright as it.
  environment.set_map(std::make_shared<const transport::EnvironmentMap>(
      image::Image{4, 2, std::vector<reflectance::Rgb>(8, reflectance::Rgb(0.4F))}));
  sphere.set_environment(environment);
  const SphereImage furnace = shown();
  EXPECT_NEAR(furnace.radiance[static_cast<std::size_t>(furnace.side / 2 * (furnace.side + 1))].x, 0.4F,
              0.02F);
  sphere.set_environment(std::nullopt);
  EXPECT_EQ(shown().radiance, studio.radiance);
}

TEST(LiveSphere, FollowsThePointerAndTheKeys) {
  LiveSphere sphere;
  sphere.resize(200, 200);
  sphere.set_brdf(compiled_brdf_of("ward sx=0.1"));
  sphere.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&sphere));
  ASSERT_TRUE(QTest::qWaitFor([&] { return sphere.image().side > 0 && !sphere.is_busy(); }, 20000));
  EXPECT_TRUE(sphere.image().is_by_glsl);
  QSignalSpy shaded(&sphere, &LiveSphere::shaded);
  QTest::mousePress(&sphere, Qt::LeftButton, {}, {140, 70});
  QTest::mouseMove(&sphere, {60, 100});
  QTest::mouseRelease(&sphere, Qt::LeftButton, {}, {60, 100});
  ASSERT_TRUE(QTest::qWaitFor([&] { return shaded.count() > 0 && !sphere.is_busy(); }, 20000));
  // The brightest pixel is under the pointer.
  const auto& radiance = sphere.image().radiance;
  const auto brightest = std::max_element(radiance.begin(), radiance.end(), [](const auto& a, const auto& b) {
    return a.length2() < b.length2();
  });
  const auto place = static_cast<int>(brightest - radiance.begin());
  EXPECT_NEAR(place % sphere.image().side, 60, 6);
  EXPECT_NEAR(place / sphere.image().side, 100, 6);
  const Vec3f before = sphere.light();
  QTest::keyClick(&sphere, Qt::Key_Right);
  EXPECT_GT(sphere.light().x, before.x);
}

}  // namespace
}  // namespace editor
