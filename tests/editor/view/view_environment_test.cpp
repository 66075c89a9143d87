// The environment of a scene in the 3D view, compared with the renderer's map and with closed forms.
#include <QImage>
#include <QSignalSpy>
#include <array>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "editor/view/environment_store.h"
#include "grf/srgb.h"
#include "renderer/image/encoders.h"
#include "renderer/studies/environment/file.h"
#include "tests/editor/view/shown_view.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using grf::Colour;
using grf::Vec3d;
using image::Image;
using std::numbers::pi;
using test::ShownView;

/// The value of the screen for a radiance: sRGB of 1 - exp(-1.25 L).
int shown_value(double radiance) {
  return static_cast<int>(std::lround(255 * grf::srgb_encoded(1 - std::exp(-1.25 * radiance))));
}

/// Texels of 15 degrees in different colours, without much contrast.
Image patches() {
  Image image = {24, 12, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      image.pixels.emplace_back(0.1F * static_cast<float>((3 * x + y) % 9), 0.2F * static_cast<float>(y % 4),
                                x % 2 == 0 ? 0.3F : 0.7F);
    }
  }
  return image;
}

/// A black sky with a sun of 2 x 2 degrees on the horizon towards +x.
Image low_sun(float radiance) {
  Image image = {360, 180, std::vector<Colour>(std::size_t(360) * 180, Colour(0))};
  for (const int y : {89, 90}) {
    for (const int x : {269, 270}) image.pixels[static_cast<std::size_t>(y * 360 + x)] = Colour(radiance);
  }
  return image;
}

/// Turns a direction about the y axis, counter-clockwise seen from above.
Vec3d turned(const Vec3d& d, double degrees) {
  const double a = degrees * pi / 180;
  return {d.x * std::cos(a) + d.z * std::sin(a), d.y, -d.x * std::sin(a) + d.z * std::cos(a)};
}

class ViewEnvironment : public testing::Test {
 protected:
  /// Shows an image as the environment.
  void show(ShownView& shown, const Image& image, float rotation = 0, float scale = 1,
            const std::string& projection = "latlong") {
    options_.environment = folder_.add("map" + std::to_string(++files_) + ".pfm", image::encode_pfm({image}));
    options_.projection = projection;
    options_.environment_rotation = rotation;
    options_.environment_scale = scale;
    show(shown);
  }

  void show(ShownView& shown) {
    store_.set_options(options_);
    ASSERT_TRUE(test::wait_for([this] { return store_.is_complete(); }));
    shown.view.set_environment(store_.environment());
    shown.view.set_mode(DisplayMode::Brdf);
    ASSERT_TRUE(shown.complete());
    image_ = shown.view.grab().toImage();
  }

  const test::TemporaryFolder folder_;
  options::RenderOptions options_;
  EnvironmentStore store_;
  QImage image_;  ///< of the view
  int files_ = 0;
};

TEST_F(ViewEnvironment, IsBehindTheSceneWhereTheRendererHasIt) {
  const Image image = patches();
  ShownView shown(
      test::objects_of_text("transform scale (0.01,0.01,0.01) begin " + test::cube_text() + " end"));
  for (const float rotation : {0.0F, 40.0F, -125.0F}) {
    show(shown, image, rotation, 0.8F);
    const transport::EnvironmentMap by_renderer(image, rotation);
    int compared = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const Vec3d centre(studies::map_direction((x + 0.5) / image.width, (y + 0.5) / image.height));
        const Vec3d there = turned(centre, double(rotation));
        if (there.dot(shown.view.camera().forward()) < 0.1) continue;
        const QPoint pixel = shown.pixel_of(shown.view.camera().eye() + there * 1000);
        if (!image_.rect().contains(pixel)) continue;
        const Colour radiance = 0.8F * image.at(x, y);
        EXPECT_LT((radiance - 0.8F * by_renderer.radiance(grf::Vec3f(there))).length(), 1e-6F);
        const QColor colour = image_.pixelColor(pixel);
        const std::array shown_channels = {colour.red(), colour.green(), colour.blue()};
        for (int k = 0; k < 3; ++k) {
          // The steepest part of sRGB is that of the darkest values.
          const int expected = shown_value(double(radiance[k]));
          EXPECT_NEAR(shown_channels[static_cast<std::size_t>(k)], expected, expected < 20 ? 8 : 3)
              << x << ' ' << y << ' ' << k << ' ' << rotation;
        }
        ++compared;
      }
    }
    EXPECT_GE(compared, 6);
  }
  shown.view.set_mode(DisplayMode::Solid);
  ASSERT_TRUE(shown.complete());
  const QColor plain = shown.view.grab().toImage().pixelColor(60, 300);
  EXPECT_NEAR(plain.red(), plain.blue(), 24) << "the other modes have a plain background";
}

/// A white surface under the sun reflects E cos / pi with E = L times its solid angle.
TEST_F(ViewEnvironment, LightsBrdfsFromWhereItIs) {
  // The sides of the cube face +z, -z, +x, -x, +y and -y.
  std::string text = test::cube_text("brdf diffuse kd=1");
  for (std::size_t at = text.find("rgb ("); at != std::string::npos; at = text.find("rgb (", at + 1)) {
    text.replace(at, text.find(')', at) - at + 1, "rgb (1,1,1)");
  }
  transport::View view;
  view.eye = Vec3d(5, 0.5, 5);
  view.target = Vec3d(0);
  view.field_of_view = 40;
  ShownView shown(test::objects_of_text(text), ViewCamera(view));
  const double solid_angle = 2 * pi * 2 / 360 * 2 * std::sin(pi / 180);
  const Image sun = low_sun(static_cast<float>(1.5 / solid_angle));
  const auto value_at = [&](const Vec3d& point) { return image_.pixelColor(shown.pixel_of(point)).green(); };
  // Towards +x, then 30 degrees from it towards -z, then towards +z.
  for (const double degrees : {0.0, 30.0, -90.0}) {
    show(shown, sun, static_cast<float>(degrees));
    const Vec3d to_sun = turned({1, 0, 0}, degrees);
    const auto expected = [&](const Vec3d& normal) {
      return shown_value(1.5 * std::max(0.0, to_sun.dot(normal)) / pi);
    };
    EXPECT_NEAR(value_at({1, 0.1, 0.1}), expected({1, 0, 0}), 4) << degrees;
    EXPECT_NEAR(value_at({0.1, 0.1, 1}), expected({0, 0, 1}), 4) << degrees;
  }
  show(shown, sun, 0, 0.5F);
  EXPECT_NEAR(value_at({1, 0.1, 0.1}), shown_value(0.75 / pi), 4);
}

/// In a uniform environment a white surface is as bright as the background: a furnace.
TEST_F(ViewEnvironment, IsAFurnaceIfItIsUniform) {
  Image image = {8, 4, std::vector<Colour>(32, Colour(0.3F))};
  const std::string white = "rgb (1,1,1) ";
  ShownView shown(test::objects_of_text(
      "begin mesh brdf diffuse kd=1 begin vertices (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) end vertices "
      "begin faces " +
      white + "(0,1,2,3) end faces end mesh"));
  show(shown, image);
  EXPECT_NEAR(image_.pixelColor(400, 300).red(), shown_value(0.3), 2);
  EXPECT_NEAR(image_.pixelColor(40, 300).red(), shown_value(0.3), 1);
}

TEST_F(ViewEnvironment, IsSeenInMirrors) {
  // The image of what is behind the eye, at +z: two colours beside its border.
  Image image = {72, 36, std::vector<Colour>(std::size_t(72) * 36, Colour(0.05F))};
  for (int y = 0; y < 36; ++y) {
    for (int x = 0; x < 6; ++x) {
      image.pixels[static_cast<std::size_t>(y * 72 + x)] = Colour(0.6F, 0, 0);
      image.pixels[static_cast<std::size_t>(y * 72 + 71 - x)] = Colour(0, 0.6F, 0);
    }
  }
  ShownView shown(test::objects_of_text(
      "begin mesh brdf specular ks=1 begin vertices (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) end vertices "
      "begin faces rgb (1,1,1) (0,1,2,3) end faces end mesh"));
  show(shown, image);
  // The map's left border is behind the eye on its left: -x.
  EXPECT_NEAR(image_.pixelColor(shown.pixel_of({-0.9, 0, 0})).red(), shown_value(0.6), 12);
  EXPECT_LT(image_.pixelColor(shown.pixel_of({-0.9, 0, 0})).green(), 12);
  EXPECT_NEAR(image_.pixelColor(shown.pixel_of({0.9, 0, 0})).green(), shown_value(0.6), 12);
}

/// A backplate is stretched over the image of the render camera, which is as high as the view.
TEST_F(ViewEnvironment, IsABackplateThatLightsNothing) {
  Image image = {2, 2, {Colour(0.5F, 0, 0), Colour(0, 0.5F, 0), Colour(0, 0, 0.5F), Colour(0.5F)}};
  ShownView shown(test::objects_of_text(test::cube_text("brdf diffuse kd=1")));
  shown.view.set_render_camera(shown.view.camera().view(), 1);  // 600 pixels wide, from 100 on
  shown.view.set_mode(DisplayMode::Brdf);
  ASSERT_TRUE(shown.complete());
  const QImage without = shown.view.grab().toImage();
  show(shown, image, 0, 0.5F, "backplate");
  EXPECT_NEAR(image_.pixelColor(110, 10).red(), shown_value(0.25), 2);
  EXPECT_EQ(image_.pixelColor(110, 10).green(), 0);
  EXPECT_NEAR(image_.pixelColor(690, 10).green(), shown_value(0.25), 2);
  EXPECT_NEAR(image_.pixelColor(110, 590).blue(), shown_value(0.25), 2);
  EXPECT_EQ(image_.pixelColor(50, 300), without.pixelColor(50, 300)) << "outside of the image";
  EXPECT_EQ(image_.pixelColor(400, 300), without.pixelColor(400, 300)) << "on the cube";
}

/// The CPU, which shades what the driver refuses, gives the same image.
TEST_F(ViewEnvironment, LightsWhatTheCpuShades) {
  GraphicsDriver driver;
  driver.compile = [](const ShaderTexts& texts) -> CompiledProgram {
    if (texts.fragment.contains("vec3 ward(")) return {nullptr, "no such thing"};
    return compile_program(texts);
  };
  const SceneObjects objects =
      test::objects_of_text(test::cube_text("brdf ward sx=0.2 sy=0.3 ks=0.6 kd=0.3"));
  Image image = patches();
  image.pixels[4 * 24 + 3] = Colour(90);  // behind the eye: a light shines on the front
  ShownView by_glsl(objects);
  show(by_glsl, image, 25);
  const QImage expected = image_;
  ShownView by_cpp(objects, test::front_camera(), driver);
  QSignalSpy warned(&by_cpp.view, &SceneView::warned);
  show(by_cpp);
  EXPECT_EQ(warned.count(), 1);
  int far = 0;
  for (int y = 0; y < 600; y += 3) {
    for (int x = 0; x < 800; x += 3) {
      const QColor a = image_.pixelColor(x, y);
      const QColor b = expected.pixelColor(x, y);
      if (std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) > 4) ++far;
    }
  }
  EXPECT_LT(far, 200 * 267 / 500);
  EXPECT_GT(expected.pixelColor(400, 300).red(), 40);
}

TEST_F(ViewEnvironment, IsReadOnceWhateverItsRotation) {
  options_.environment = folder_.add("map.pfm", image::encode_pfm({low_sun(100)}));
  QSignalSpy changed(&store_, &EnvironmentStore::changed);
  QSignalSpy failed(&store_, &EnvironmentStore::failed);
  store_.set_options(options_);
  ASSERT_TRUE(test::wait_for([this] { return store_.is_complete(); }));
  const auto map = store_.environment()->sky.map;
  ASSERT_NE(map, nullptr);
  options_.environment_rotation = 90;
  options_.environment_scale = 2;
  store_.set_options(options_);
  EXPECT_TRUE(store_.is_complete());
  EXPECT_EQ(store_.readings(), 1);
  EXPECT_EQ(store_.environment()->sky.map, map);
  EXPECT_EQ(changed.count(), 2);
  ASSERT_EQ(store_.environment()->world_lights().size(), 1U);
  // A quarter of a turn, counter-clockwise seen from above: from +x to -z.
  const auto light = store_.environment()->world_lights()[0];
  EXPECT_LT((light.direction - grf::Vec3f(0, 0, -1)).length(), 1e-3F);
  store_.set_options(options_);
  EXPECT_EQ(changed.count(), 2) << "nothing has changed";
  // Another content of the same file.
  folder_.add("map.pfm", image::encode_pfm({patches()}));
  ASSERT_TRUE(test::wait_for([this] { return store_.readings() == 2 && store_.is_complete(); }));
  EXPECT_EQ(store_.environment()->sky.map->image().width, 24);
  EXPECT_TRUE(failed.isEmpty());
  options_.environment = folder_.path("missing.exr");
  store_.set_options(options_);
  ASSERT_TRUE(test::wait_for([this] { return store_.is_complete(); }));
  EXPECT_EQ(store_.environment(), nullptr);
  ASSERT_EQ(failed.count(), 1);
  EXPECT_THAT(failed[0][0].toString().toStdString(), testing::HasSubstr("missing.exr"));
  options_.environment.clear();
  store_.set_options(options_);
  EXPECT_EQ(store_.environment(), nullptr);
}

}  // namespace
}  // namespace editor
