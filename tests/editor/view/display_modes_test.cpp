// Tests of the display modes.
#include <QImage>
#include <QTemporaryDir>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "editor/appearance/theme.h"
#include "tests/editor/view/shown_view.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using grf::Vec3d;
using test::ShownView;

/// The mean difference of two images' channels, 0 to 255.
double difference(const QImage& a, const QImage& b) {
  EXPECT_EQ(a.size(), b.size());
  double sum = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
    }
  }
  return sum / (3.0 * a.width() * a.height());
}

QImage grab(ShownView& shown, DisplayMode mode) {
  shown.view.set_mode(mode);
  EXPECT_TRUE(shown.complete());
  return shown.view.grab().toImage();
}

/// A cube with a texture, irradiance at its vertices, and a glossy BRDF.
SceneObjects rich_cube(const QTemporaryDir& folder) {
  QImage image(2, 2, QImage::Format_RGB32);
  image.fill(Qt::white);
  image.setPixelColor(0, 0, Qt::blue);
  image.save(folder.filePath("squares.png"));
  std::string text = test::cube_text("texture \"squares.png\" brdf ward sx=0.2 ks=0.6 kd=0.3");
  for (std::size_t at = text.find("uv"); at != std::string::npos; at = text.find("uv", at + 20)) {
    text.insert(at, "irad (1,2,3) ");
  }
  grf::Diagnostics diagnostics;
  const std::string path = folder.filePath("scene.grf").toStdString();
  const auto scene = grf::read_text(text, path, diagnostics);
  EXPECT_TRUE(scene);
  return objects_of(*scene, path);
}

ViewCamera from_a_corner() {
  transport::View view;
  view.eye = Vec3d(2.5, 2, 4);
  view.field_of_view = 40;
  return ViewCamera(view);
}

TEST(DisplayModes, EachDrawsSomethingElse) {
  const QTemporaryDir folder;
  ShownView shown(rich_cube(folder), from_a_corner());
  ASSERT_TRUE(shown.is_shown);
  std::map<DisplayMode, QImage> images;
  for (const DisplayMode mode :
       {DisplayMode::Points, DisplayMode::Wireframe, DisplayMode::Solid, DisplayMode::SolidEdges,
        DisplayMode::Textured, DisplayMode::VertexColours, DisplayMode::Irradiance, DisplayMode::Brdf}) {
    const QImage image = grab(shown, mode);
    for (const auto& [other, other_image] : images) {
      EXPECT_GT(difference(image, other_image), 0.05) << int(mode) << " and " << int(other);
    }
    images[mode] = image;
  }
  EXPECT_LT(difference(grab(shown, DisplayMode::Solid), images[DisplayMode::Solid]), 0.01);
}

TEST(DisplayModes, ColoursAreThoseOfTheFaces) {
  const QTemporaryDir folder;
  ShownView shown(rich_cube(folder));
  const QImage image = grab(shown, DisplayMode::VertexColours);
  const QColor front = image.pixelColor(shown.pixel_of(Vec3d(0, 0, 1)));
  EXPECT_GT(front.red(), 1.5 * front.green());
  EXPECT_NEAR(front.green(), front.blue(), 2);
}

/// A square in the plane z = 0 whose texture is absent in its left half and red in its right one.
SceneObjects cut_square(const QTemporaryDir& folder, const std::string& opacity) {
  QImage image(2, 1, QImage::Format_RGBA8888);
  image.setPixelColor(0, 0, QColor(0, 0, 0, 0));
  image.setPixelColor(1, 0, QColor(255, 0, 0));
  image.save(folder.filePath("half.png"));
  const std::string text = "begin mesh brdf diffuse texture \"half.png\" " + opacity +
                           " begin vertexs uv (0,0) (-1,-1,0) uv (1,0) (1,-1,0) uv (1,1) (1,1,0) uv (0,1) "
                           "(-1,1,0) end vertexs begin faces (0,1,2,3) end faces end mesh";
  grf::Diagnostics diagnostics;
  const std::string path = folder.filePath("scene.grf").toStdString();
  const auto scene = grf::read_text(text, path, diagnostics);
  EXPECT_TRUE(scene) << diagnostics.to_text();
  return objects_of(*scene, path);
}

/// The largest difference of two colours' channels, 0 to 255.
int difference(const QColor& a, const QColor& b) {
  return std::max(
      {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
}

TEST(DisplayModes, FacesAreAbsentWhereTheirOpacitySaysSo) {
  const QTemporaryDir folder;
  transport::View from_the_front;
  from_the_front.eye = Vec3d(0, 0, 4);
  ShownView shown(cut_square(folder, ""), ViewCamera(from_the_front));
  shown.view.resize(200, 150);
  for (const DisplayMode mode : {DisplayMode::Solid, DisplayMode::Textured, DisplayMode::Brdf}) {
    SCOPED_TRACE(int(mode));
    const auto colours = [&](const std::string& opacity) {
      shown.view.show(std::make_shared<const SceneObjects>(cut_square(folder, opacity)));
      const QImage image = grab(shown, mode);
      return std::pair(image.pixelColor(shown.pixel_of(Vec3d(-0.5, 0, 0))),
                       image.pixelColor(shown.pixel_of(Vec3d(0.5, 0, 0))));
    };
    const auto opaque = colours("");
    const auto absent = colours("opacity 0");
    EXPECT_GT(difference(opaque.second, absent.second), 20);
    EXPECT_LE(difference(colours("opacity 1").second, opaque.second), 1);
    for (const char* opacity : {"opacity mask 0.5", "opacity blend 1"}) {
      const auto cut = colours(opacity);
      EXPECT_EQ(cut.first, absent.first) << opacity;
      EXPECT_LE(difference(cut.second, opaque.second), 1) << opacity;
    }
  }
}

TEST(DisplayModes, ATextureStandsUpright) {
  const QTemporaryDir folder;
  ShownView shown(rich_cube(folder));
  const QImage image = grab(shown, DisplayMode::Textured);
  // The texture's upper left quarter is blue, which removes the red of the front.
  const QColor blue = image.pixelColor(shown.pixel_of(Vec3d(-0.5, 0.5, 1)));
  const QColor red = image.pixelColor(shown.pixel_of(Vec3d(0.5, -0.5, 1)));
  EXPECT_LT(blue.red(), 60);
  EXPECT_GT(red.red(), 120);
}

TEST(DisplayModes, IrradianceIsInItsOwnColour) {
  const QTemporaryDir folder;
  ShownView shown(rich_cube(folder));
  const QColor colour = grab(shown, DisplayMode::Irradiance).pixelColor(shown.pixel_of(Vec3d(0.2, 0.2, 1)));
  EXPECT_GT(colour.blue(), colour.green());
  EXPECT_GT(colour.green(), colour.red());
  EXPECT_GE(colour.blue(), 254);
}

// The near plane is much nearer than the object then. A line that is moved toward the eye by a fixed depth in
// clip space would be drawn over faces before it.
TEST(DisplayModes, FacesHideTheGridAlsoWhereTheEyeIsBesideATallObject) {
  transport::View place;
  place.eye = Vec3d(1.3, 1.1, 1.9);
  place.target = Vec3d(0, 0.5, 0);
  place.field_of_view = 40;
  const std::string tower =
      "transform scale (0.5,1.5,0.5) translation (0,1.5,0) begin " + test::cube_text() + " end";
  ShownView shown(test::objects_of_text(tower), ViewCamera(place));
  ASSERT_TRUE(shown.is_shown);
  // Within the front: its lower edge falls to the right.
  const QPoint left = shown.pixel_of({-0.4, 0.04, 0.5});
  const QRect front(QPoint(left.x(), shown.pixel_of({-0.4, 0.8, 0.5}).y()),
                    QPoint(shown.pixel_of({0.4, 0.8, 0.5}).x(), left.y()));
  const QImage without = grab(shown, DisplayMode::Solid).copy(front);
  shown.view.set_grid(true);
  const QImage with = grab(shown, DisplayMode::Solid).copy(front);
  EXPECT_EQ(difference(with, without), 0);
}

TEST(DisplayModes, NormalsAreDrawnAsLines) {
  const QTemporaryDir folder;
  ShownView shown(rich_cube(folder), from_a_corner());
  const QImage without = grab(shown, DisplayMode::Solid);
  shown.view.set_face_normals(true);
  ASSERT_TRUE(shown.complete());
  const QImage with = shown.view.grab().toImage();
  EXPECT_GT(difference(with, without), 0.01);
  shown.view.set_face_normals(false);
  shown.view.set_vertex_normals(true);  // it has none
  ASSERT_TRUE(shown.complete());
  EXPECT_LT(difference(shown.view.grab().toImage(), without), 0.01);
}

/// A red square before a green one, with an opacity: that in front covers the middle of the view.
SceneObjects red_before_green(const std::string& folder, const std::string& opacity) {
  grf::Diagnostics diagnostics;
  const auto square = [](double z) {
    return fmt::format(
        "begin vertices uv (0,0) (-1,-1,{0}) uv (1,0) (1,-1,{0}) uv (1,1) (1,1,{0}) "
        "uv (0,1) (-1,1,{0}) end vertices begin faces 4 (0,1,2,3) end faces end mesh ",
        z);
  };
  const std::string path = folder + "/scene.grf";
  const auto scene =
      grf::read_text(fmt::format("begin mesh \"behind\" rgb (0, 0.6, 0) {}begin mesh \"front\" "
                                 "rgb (0.6, 0, 0) {} {}",
                                 square(0), opacity, square(1)),
                     path, diagnostics);
  EXPECT_TRUE(scene) << diagnostics.to_text();
  return scene ? objects_of(*scene, path) : SceneObjects();
}

/// The mean of the displayed red channel over a square of pixels, in which the red square is in front.
double displayed_red(ShownView& shown, const Vec3d& at) {
  const QImage image = grab(shown, DisplayMode::VertexColours);
  const QPoint middle = shown.pixel_of(at);
  constexpr int Reach = 6;
  double sum = 0;
  for (int y = -Reach; y < Reach; ++y) {
    for (int x = -Reach; x < Reach; ++x) sum += image.pixelColor(middle + QPoint(x, y)).redF();
  }
  return sum / (4 * Reach * Reach);
}

// Antialiasing passes are averaged as they are displayed, and a face is drawn in a part of them.
TEST(DisplayModes, OpacityIsThePartOfThePassesThatDrawAFace) {
  const QTemporaryDir folder;
  QImage image(8, 8, QImage::Format_ARGB32);
  image.fill(Qt::white);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 4; ++x) image.setPixelColor(x, y, QColor(255, 255, 255, 100));
  }
  ASSERT_TRUE(image.save(folder.filePath("left.png")));
  ShownView shown(red_before_green(folder.path().toStdString(), ""));
  shown.view.resize(200, 150);
  const auto red = [&](const std::string& opacity, double x) {
    shown.view.show(
        std::make_shared<const SceneObjects>(red_before_green(folder.path().toStdString(), opacity)));
    return displayed_red(shown, Vec3d(x, 0, 1));
  };
  const double full = red("", 0);
  EXPECT_GT(full, 0.3);
  const double none = red("opacity 0", 0);
  EXPECT_LT(none, 0.1 * full);
  const auto share = [&](const std::string& opacity, double x) {
    return (red(opacity, x) - none) / (full - none);
  };
  EXPECT_NEAR(share("opacity 0.75", 0), 0.75, 0.05);
  EXPECT_NEAR(share("opacity 0.25", 0), 0.25, 0.05);
  const std::string texture = "texture \"left.png\" opacity ";
  EXPECT_NEAR(share(texture + "blend 0.5", -0.5), 0.5 * 100 / 255, 0.05);
  EXPECT_NEAR(share(texture + "blend 0.5", 0.5), 0.5, 0.05);
  EXPECT_NEAR(share(texture + "mask 0.3", -0.5), 1, 0.01) << "the alpha is above the cutoff";
}

TEST(DisplayModes, EveryModelCompiles) {
  const auto objects = test::objects_of_file(GRANADA_SOURCE_DIR "/samples/models/models.grf");
  ASSERT_FALSE(objects.meshes.empty());
  ShownView shown(objects);
  shown.view.resize(200, 120);
  shown.view.frame_all();
  EXPECT_FALSE(grab(shown, DisplayMode::Brdf).isNull());
}

TEST(DisplayModes, TheThemeIsFollowedAtOnce) {
  const QTemporaryDir folder;
  ShownView shown(rich_cube(folder));
  const QColor dark = shown.view.grab().toImage().pixelColor(3, 3);
  apply(Theme::Light, *qApp);
  ASSERT_TRUE(shown.complete());
  const QColor light = shown.view.grab().toImage().pixelColor(3, 3);
  apply(Theme::Dark, *qApp);
  EXPECT_LT(dark.lightness(), 80);
  EXPECT_GT(light.lightness(), 180);
}

TEST(DisplayModes, AnEditOfSurfacesAloneIsShown) {
  const QTemporaryDir folder;
  ShownView shown(rich_cube(folder));
  const QImage before = grab(shown, DisplayMode::VertexColours);
  SceneObjects objects = shown.view.objects();
  objects.meshes[0].flat_surfaces[objects.meshes[0].mesh->surface_of_face->front()].colour =
      grf::Colour(0, 0, 1);
  shown.view.show(std::make_shared<const SceneObjects>(objects));
  ASSERT_TRUE(shown.complete());
  const QColor front = shown.view.grab().toImage().pixelColor(shown.pixel_of(Vec3d(0, 0, 1)));
  EXPECT_GT(front.blue(), 100);
  EXPECT_LT(front.red(), 40);
  EXPECT_GT(difference(shown.view.grab().toImage(), before), 1);
}

}  // namespace
}  // namespace editor
