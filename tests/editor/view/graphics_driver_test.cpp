// Tests of the view with graphics drivers that fail or have low limits.
#include <QImage>
#include <QSignalSpy>
#include <cmath>

#include <gmock/gmock.h>

#include "tests/editor/pointer.h"
#include "tests/editor/view/shown_view.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using test::ShownView;

/// Fails to compile programs whose fragment shader contains this text.
GraphicsDriver driver_without(const QByteArray& text) {
  GraphicsDriver driver;
  driver.compile = [text](const ShaderTexts& texts) -> CompiledProgram {
    if (texts.fragment.contains(text)) return {nullptr, "0:1(1): error: no such thing\nmore of it"};
    return compile_program(texts);
  };
  return driver;
}

QStringList texts(const QSignalSpy& spy) {
  QStringList all;
  for (const auto& arguments : spy) all += arguments[0].toString();
  return all;
}

ViewCamera seen_from_above() {
  transport::View view;
  view.eye = grf::Vec3d(2.5, 2, 4);
  view.field_of_view = 40;
  return ViewCamera(view);
}

QImage drawn(ShownView& shown) {
  shown.view.set_mode(DisplayMode::Brdf);
  EXPECT_TRUE(shown.complete());
  return shown.view.grab().toImage();
}

/// The fraction of clearly different pixels, of those that are covered in either image.
double fraction_of_far_pixels(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int far = std::max(
          {std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
      if (far > 2) ++count;
    }
  }
  return double(count) / (a.width() * a.height());
}

class RefusedShader : public testing::TestWithParam<std::string> {};

/// The CPU image equals that of the shader, including terms of sums and colours of faces.
TEST_P(RefusedShader, IsDoneByCpp) {
  const SceneObjects objects = test::objects_of_text(GetParam());
  ShownView by_glsl(objects, seen_from_above());
  const QImage expected = drawn(by_glsl);
  ShownView by_cpp(objects, seen_from_above(), driver_without("vec3 ward("));
  QSignalSpy warned(&by_cpp.view, &SceneView::warned);
  const QImage image = drawn(by_cpp);
  EXPECT_THAT(texts(warned),
              testing::Contains(testing::ResultOf(
                  [](const QString& text) { return text.toStdString(); },
                  testing::AllOf(testing::HasSubstr("BRDF ward"), testing::HasSubstr("on the CPU"),
                                 testing::EndsWith("error: no such thing")))));
  EXPECT_LT(fraction_of_far_pixels(image, expected), 0.002);
  ShownView without(test::objects_of_text(test::cube_text("brdf diffuse kd=0")), seen_from_above());
  EXPECT_GT(fraction_of_far_pixels(drawn(without), expected), 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Brdfs, RefusedShader,
    testing::Values(
        test::cube_text("brdf ward sx=0.2 sy=0.1 ks=0.6 kd=(0.3,0.1,0.2)"),
        "def wide = brdf ward sx=0.3 ks=0.5 kd=0\ndef narrow = brdf phong n=20\nbegin\n" +
            test::cube_text("brdf combine 0.5 wide, 0.8 narrow") + "end\n",
        "def wide = brdf ward sx=0.3 ks=0.9 kd=0.4\ndef coated = brdf coat base=wide alpha=0.3 ior=2\n"
        "begin\n" +
            test::cube_text("brdf coated") + "end\n"));

TEST(RefusedShaders, OfOtherModelsAreNotMissed) {
  ShownView shown(test::objects_of_text(test::cube_text("brdf phong n=20")), seen_from_above(),
                  driver_without("vec3 ward("));
  QSignalSpy warned(&shown.view, &SceneView::warned);
  drawn(shown);
  EXPECT_TRUE(warned.isEmpty());
}

/// Without an indispensable shader nothing is drawn, and the window continues to work.
TEST(RefusedShaders, OfTheViewItselfLeaveAMessage) {
  SceneView view(nullptr, driver_without("background_top"));
  QSignalSpy warned(&view, &SceneView::warned);
  view.resize(300, 200);
  view.set_camera(test::front_camera());
  view.show(std::make_shared<const SceneObjects>(test::objects_of_text(test::cube_text())));
  view.show();
  ASSERT_TRUE(test::wait_for([&] { return !warned.isEmpty(); }));
  EXPECT_THAT(texts(warned)[0].toStdString(),
              testing::AllOf(testing::HasSubstr("compose.frag"), testing::HasSubstr("no such thing")));
  QTest::mousePress(&view, Qt::LeftButton, Qt::ShiftModifier, {100, 50});
  for (const QPoint& place : {QPoint(150, 100), QPoint(200, 150)}) {
    test::move_pointer(view, place, Qt::LeftButton, Qt::ShiftModifier);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, Qt::ShiftModifier, {200, 150});
  EXPECT_TRUE(test::wait_for([&] { return !view.is_selecting(); }, 5));
}

GraphicsDriver driver_with(const GraphicsLimits& limits) {
  GraphicsDriver driver;
  driver.limits = [limits] { return limits; };
  return driver;
}

constexpr std::size_t ManyTexels = 1'000'000;

/// A red image of so many pixels per row, and two rows.
std::string red_image(const test::TemporaryFolder& folder, int width) {
  std::string bytes = "PF\n" + std::to_string(width) + " 2\n-1.0\n";
  for (int i = 0; i < 2 * width; ++i) bytes += std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0", 12);
  return folder.add("red.pfm", bytes);
}

TEST(DriverLimits, MakeImagesSmallerThatAreTooLarge) {
  const test::TemporaryFolder folder;
  const SceneObjects objects = test::objects_of_text("begin mesh texture \"" + red_image(folder, 1300) +
                                                     "\" begin vertices uv (0,0) (-1,-1,1) uv (1,0) (1,-1,1) "
                                                     "uv (1,1) (1,1,1) uv (0,1) (-1,1,1) end vertices "
                                                     "begin faces (0,1,2,3) end faces end mesh");
  for (const int side : {1300, 1024}) {
    ShownView shown(objects, test::front_camera(), driver_with({side, ManyTexels}));
    QSignalSpy warned(&shown.view, &SceneView::warned);
    shown.view.set_mode(DisplayMode::Textured);
    ASSERT_TRUE(shown.complete());
    const QColor middle = shown.view.grab().toImage().pixelColor(400, 300);
    EXPECT_GT(middle.red(), 100) << side;
    EXPECT_LT(middle.green(), 30) << side;
    shown.view.set_mode(DisplayMode::Solid);
    ASSERT_TRUE(shown.complete());
    const QStringList said = texts(warned).filter("lower resolution");
    EXPECT_EQ(said.isEmpty(), side == 1300);
    for (const QString& text : said) EXPECT_TRUE(text.contains("red.pfm") && text.contains("1024"));
  }
}

/// A window larger than the driver's limit has a downscaled image, in which boxes select as usual.
TEST(DriverLimits, HoldForTheWindowToo) {
  const SceneObjects objects = test::objects_of_text(test::cube_text());
  const auto selected = [&](const GraphicsDriver& driver, QImage& image) {
    ShownView shown(objects, seen_from_above(), driver);
    EXPECT_TRUE(shown.is_shown);
    image = shown.view.grab().toImage();
    shown.drag(Qt::LeftButton, Qt::ShiftModifier, {{300, 200}, {350, 240}, {450, 330}});
    return shown.view.selection();
  };
  QImage image;
  QImage small;
  const FaceSelection expected = selected({}, image);
  ASSERT_GT(expected.count(), 1U);
  EXPECT_EQ(selected(driver_with({320, ManyTexels}), small), expected);
  ASSERT_EQ(small.size(), image.size());
  EXPECT_GT(fraction_of_far_pixels(small, image), 0.01) << "it has fewer pixels";
  for (const QPoint& place : {QPoint(350, 240), QPoint(450, 330), QPoint(400, 300)}) {
    const QColor expected_colour = image.pixelColor(place);
    const QColor colour = small.pixelColor(place);
    EXPECT_NEAR(colour.red(), expected_colour.red(), 8);
    EXPECT_NEAR(colour.green(), expected_colour.green(), 8);
    EXPECT_NEAR(colour.blue(), expected_colour.blue(), 8);
  }
}

/// Texel fetches beyond the end of a table are undefined.
TEST(DriverLimits, LeaveMeshesOutForWhichTablesAreTooShort) {
  const SceneObjects objects = test::objects_of_text(
      test::cube_text() + "transform translation (3,0,0) begin " + test::cube_text() + " end");
  for (const std::size_t texels : {ManyTexels, std::size_t(35)}) {
    ShownView shown(objects, test::front_camera(), driver_with({2000, texels}));
    QSignalSpy warned(&shown.view, &SceneView::warned);
    shown.view.set_mode(DisplayMode::SolidEdges);
    ASSERT_TRUE(shown.complete());
    const QImage image = shown.view.grab().toImage();
    EXPECT_GT(image.pixelColor(400, 300).red(), 90) << "the first cube's front";
    EXPECT_EQ(image.pixelColor(shown.pixel_of(grf::Vec3d(3, 0, 1))).red() > 90, texels == ManyTexels);
    ASSERT_EQ(warned.count(), texels == ManyTexels ? 0 : 1);
    for (const QString& text : texts(warned)) EXPECT_TRUE(text.contains("1 of 2 meshes"));
  }
}

}  // namespace
}  // namespace editor
