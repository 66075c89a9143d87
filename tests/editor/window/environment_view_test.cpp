// The environment of a scene, seen and turned through the whole window, by pointer and keyboard.
#include <QComboBox>
#include <QDateEdit>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QTimeEdit>
#include <cmath>
#include <fstream>
#include <numbers>

#include <gtest/gtest.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/controls/number_box.h"
#include "editor/panels/sky_dialog.h"
#include "editor/view/environment_store.h"
#include "renderer/image/encoders.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

const char* const GlossySquare =
    "begin mesh \"square\" brdf ward sx=0.2 ks=0.5 kd=0.3 begin vertexs (-1,-1,0) (1,-1,0) (1,1,0) (-1,1,0) "
    "end vertexs begin faces (0,1,2,3) end faces end mesh\n";

/// A map that is red on the left, towards -x, and green on the right.
std::string red_and_green() {
  image::Image image = {64, 32, {}};
  for (int i = 0; i < 64 * 32; ++i)
    image.pixels.emplace_back(i % 64 < 32 ? grf::Colour(0.5F, 0, 0) : grf::Colour(0, 0.5F, 0));
  return image::encode_pfm({image});
}

class EnvironmentInWindow : public Authoring {
 protected:
  EnvironmentInWindow() {
    folder_.add("halves.pfm", red_and_green());
    std::ofstream(folder_.path("scene.grf")) << GlossySquare;
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 0 5\nBPT_VLook 0 0 0\nBPT_FieldOfView 40\n"
           "BPT_Image_Resolution 300 200\nBPT_EM_Background halves.pfm\n";
    open(path("scene.grf"));
    window_.findChild<QDockWidget*>("lights")->show();
    window_.findChild<QDockWidget*>("lights")->raise();
  }

  bool is_drawn() {
    return QTest::qWaitFor(
        [this] { return window_.environment().is_complete() && window_.view().is_complete(); }, test::Minute);
  }
  /// The colour beside the left border of the view.
  QColor on_the_left() {
    EXPECT_TRUE(is_drawn());
    QTest::qWait(50);
    EXPECT_TRUE(is_drawn());
    return window_.view().grab().toImage().pixelColor(12, window_.view().height() / 4);
  }
  void type(const QString& field, const QString& text) {
    auto& box = test::named<NumberBox>(window_, field);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Return);
  }
};

TEST_F(EnvironmentInWindow, IsSeenAndTurnedInTheView) {
  QTest::keyClick(&window_, Qt::Key_8, Qt::AltModifier);
  ASSERT_EQ(window_.view().mode(), DisplayMode::Brdf);
  QColor colour = on_the_left();
  EXPECT_GT(colour.red(), 150);
  EXPECT_LT(colour.green(), 20);
  // Half a turn: what was on the right is on the left.
  type("Rotation of the environment", "180");
  colour = on_the_left();
  EXPECT_LT(colour.red(), 20);
  EXPECT_GT(colour.green(), 150);
  EXPECT_EQ(window_.environment().readings(), 1);
  const int bright = colour.green();
  type("Brightness of the environment", "0.3");
  EXPECT_LT(on_the_left().green(), bright - 40);
  document().undo_stack().undo();
  document().undo_stack().undo();
  EXPECT_GT(on_the_left().red(), 150);
  QTest::keyClick(&window_, Qt::Key_3, Qt::AltModifier);
  colour = on_the_left();
  EXPECT_LT(std::abs(colour.red() - colour.green()), 30) << "solid faces have a plain background";
}

TEST_F(EnvironmentInWindow, LightsTheSphereOfTheBrdfDock) {
  ASSERT_TRUE(is_drawn());
  QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, window_.view().rect().center() + QPoint(60, 60));
  ASSERT_EQ(document().selection().count(), 1U);
  LiveSphere& sphere = window_.brdf_editor().sphere();
  const auto shown = [&] {
    EXPECT_TRUE(QTest::qWaitFor([&] { return sphere.image().side > 0 && !sphere.is_busy(); }, test::Minute));
    return sphere.image();
  };
  /// The channels of a point at the sphere's left rim.
  const auto at_the_left = [&] {
    const SphereImage image = shown();
    return image.radiance[static_cast<std::size_t>(image.side / 2) * static_cast<std::size_t>(image.side) +
                          static_cast<std::size_t>(image.side / 10)];
  };
  const grf::Colour in_studio = at_the_left();
  EXPECT_GT(in_studio.z, 0.05F);
  auto& light = test::named<QComboBox>(window_.brdf_editor(), "Light of the sphere");
  ASSERT_TRUE(light.isEnabled());
  light.setFocus();
  QTest::keyClick(&light, Qt::Key_Down);
  ASSERT_EQ(light.currentText(), "Environment");
  grf::Colour in_map = at_the_left();
  EXPECT_GT(in_map.x, 2 * in_map.y) << "red is on the left";
  EXPECT_EQ(in_map.z, 0);
  type("Rotation of the environment", "180");
  QTest::qWait(50);
  in_map = at_the_left();
  EXPECT_GT(in_map.y, 2 * in_map.x);
  // Without a map there is nothing to choose, and the studio lights the sphere.
  auto& maps = test::named<QComboBox>(window_, "Environment map");
  maps.setFocus();
  QTest::keyClick(&maps, Qt::Key_Home);
  QTest::keyClick(&maps, Qt::Key_Return);
  ASSERT_EQ(document().options().valid_options().environment, "");
  EXPECT_FALSE(light.isEnabled());
  EXPECT_EQ(at_the_left(), in_studio);
}

/// Opens the dialog of the sky, in which the morning sun of the example of Reda and Andreas 2004 is set.
SkyDialog& open_sky(MainWindow& window) {
  QTest::mouseClick(&test::named<QPushButton>(window, "Sky by place and time"), Qt::LeftButton);
  auto& dialog = *window.findChild<SkyDialog*>();
  EXPECT_TRUE(QTest::qWaitForWindowActive(&dialog));
  const auto type = [&dialog](const char* field, const char* text) {
    auto& box = test::named<QAbstractSpinBox>(dialog, field);
    // Without a window manager a dialog may lose the keyboard again, and what is typed is committed only as
    // the focus goes on.
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          if (!dialog.isActiveWindow()) dialog.activateWindow();
          box.setFocus();
          return box.hasFocus();
        },
        test::Minute));
    box.selectAll();
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, Qt::Key_Tab);
  };
  type("Latitude", "39.742476");
  type("Longitude", "-105.1786");
  type("Offset from UTC", "-7");
  test::named<QDateEdit>(dialog, "Date").setDate({2003, 10, 17});
  test::named<QTimeEdit>(dialog, "Local time").setTime({12, 30, 30});
  return dialog;
}

QString summary_of(const SkyDialog& dialog) {
  return test::named<QLabel>(dialog, "The sun and its light").text();
}

bool shows(const SkyDialog& dialog, const QString& text) {
  return QTest::qWaitFor([&] { return summary_of(dialog).contains(text); }, test::Minute);
}

TEST_F(EnvironmentInWindow, IsASkyByPlaceAndTime) {
  SkyDialog& dialog = open_sky(window_);
  ASSERT_TRUE(shows(dialog, "azimuth 194.3° from north over east, elevation 39.9°"))
      << summary_of(dialog).toStdString();
  // North is -z, in the middle of the picture: the sun is 14 degrees right of its left border, and 50 under
  // its top.
  const QImage picture = test::named<QLabel>(dialog, "Picture of the sky").pixmap().toImage();
  const auto brightness = [&](int x, int y) { return qGray(picture.pixel(x, y)); };
  EXPECT_GT(brightness(picture.width() * 14 / 360, picture.height() * 50 / 180), 250);
  EXPECT_GT(qBlue(picture.pixel(picture.width() / 2, 10)), qRed(picture.pixel(picture.width() / 2, 10)) + 20);
  const int steps = document().undo_stack().count();
  QPushButton* button = nullptr;
  for (QPushButton* each : dialog.findChildren<QPushButton*>()) {
    if (each->text() == "Set environment") button = each;
  }
  ASSERT_NE(button, nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  const auto& options = document().options().valid_options();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return options.environment == folder_.path("scene-sky.exr"); }, test::Minute))
      << options.environment;
  EXPECT_EQ(document().undo_stack().count(), steps + 1);
  grf::Diagnostics diagnostics;
  const auto image = image::read_image(options.environment, diagnostics);
  ASSERT_TRUE(image) << diagnostics.to_text();
  EXPECT_EQ(image->width, 1024);
  // The brightness makes a white horizontal surface 1.
  double irradiance = 0;
  for (int y = 0; y < image->height / 2; ++y) {
    const double theta = std::numbers::pi * (y + 0.5) / image->height;
    for (int x = 0; x < image->width; ++x) {
      irradiance += double(image->at(x, y).y) * std::cos(theta) * std::sin(theta) *
                    std::pow(std::numbers::pi / image->height, 2);
    }
  }
  EXPECT_NEAR(irradiance / std::numbers::pi * double(options.environment_scale), 1, 0.1);
  document().undo_stack().undo();
  EXPECT_EQ(options.environment, folder_.path("halves.pfm"));
  EXPECT_EQ(options.environment_scale, 1);
  // Another sky is another file, so that undo keeps the first one.
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.findChild<SkyDialog*>() == nullptr; }, test::Minute));
  SkyDialog& again = open_sky(window_);
  ASSERT_TRUE(shows(again, "azimuth 194.3"));
  QTest::keyClick(&again, Qt::Key_Return);
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return options.environment == folder_.path("scene-sky-2.exr"); }, test::Minute))
      << options.environment;
}

TEST_F(EnvironmentInWindow, HasNoSkyAtNight) {
  SkyDialog& dialog = open_sky(window_);
  ASSERT_TRUE(shows(dialog, "azimuth 194.3")) << summary_of(dialog).toStdString();
  auto& time = test::named<QTimeEdit>(dialog, "Local time");
  time.setTime({23, 0});
  ASSERT_TRUE(shows(dialog, "below the horizon"));
  for (QPushButton* each : dialog.findChildren<QPushButton*>()) {
    EXPECT_EQ(each->isEnabled(), each->text() != "Set environment") << each->text().toStdString();
  }
  QTest::keyClick(&dialog, Qt::Key_Escape);
  EXPECT_EQ(document().options().valid_options().environment, folder_.path("halves.pfm"));
}

}  // namespace
}  // namespace editor
