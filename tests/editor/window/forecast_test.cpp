// The forecast of the Render dock through the whole window, by pointer and keyboard.
#include <QLabel>
#include <QToolButton>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/rendering/forecast_row.h"
#include "editor/rendering/render_panel.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

/// A floor under a lamp out of view, and the Render dock in view.
class RenderForecasts : public Authoring {
 protected:
  RenderForecasts() {
    std::ofstream(folder_.path("scene.grf"))
        << "begin mesh \"floor\" brdf diffuse kd=0.6 begin vertexs (-4,0,4) (4,0,4) (4,0,-4) (-4,0,-4) end "
           "vertexs begin faces (0,1,2,3) end faces end mesh\n"
           "light begin rgb (9,9,9) (-1,4,-1) (2,0,0) (0,0,2) end\n";
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 2 6\nBPT_VLook 0 0 0\nBPT_Image_Resolution 64 48\n"
           "BPT_Samples 20\n";
    open(path("scene.grf"));
    QTest::keyClick(&window_, Qt::Key_5, Qt::ControlModifier);
  }

  ForecastRow& row() { return *window_.findChild<ForecastRow*>(); }
  QToolButton& button(const char* target) {
    return test::named<QToolButton>(row(), QString("Render until an error of %1").arg(target));
  }
  QString label() { return test::named<QLabel>(row(), "Forecast of the render time").text(); }
  bool has_forecast() {
    return QTest::qWaitFor([this] { return label().startsWith("Time until"); }, 3 * test::Minute);
  }
  const options::RenderOptions& options() { return document().options().valid_options(); }
  const ForecastTime& forecast_of(double target) {
    for (const ForecastTime& time : row().forecasts()) {
      if (std::abs(time.target_error - target) < 1e-6) return time;
    }
    throw std::runtime_error("no such target");
  }
};

TEST_F(RenderForecasts, TellTheTimeAndTakeATarget) {
  ASSERT_TRUE(row().isVisible());
  ASSERT_TRUE(has_forecast()) << label().toStdString();
  EXPECT_THAT(button("2 %").text().toStdString(), testing::MatchesRegex("2 %: .* s\n.* s.*"));
  EXPECT_THAT(button("2 %").toolTip().toStdString(), testing::HasSubstr("with 90 % probability"));
  EXPECT_LE(*forecast_of(0.05).seconds, *forecast_of(0.01).seconds);
  EXPECT_FALSE(button("2 %").isChecked());
  const int steps = document().options().undo_stack().index();
  QTest::mouseClick(&button("2 %"), Qt::LeftButton);
  EXPECT_EQ(options().target_error, 0.02F);
  EXPECT_FALSE(options().samples) << "which would end the render before";
  EXPECT_TRUE(button("2 %").isChecked());
  EXPECT_NEAR(test::named<NumberBox>(window_, "Target error").value(), 2, 1e-5);
  EXPECT_EQ(document().options().undo_stack().index(), steps + 1);
  document().options().undo_stack().undo();
  EXPECT_FALSE(options().target_error);
  EXPECT_EQ(options().samples, 20);
  EXPECT_FALSE(button("2 %").isChecked());
  button("1 %").setFocus();
  QTest::keyClick(&button("1 %"), Qt::Key_Space);
  EXPECT_EQ(options().target_error, 0.01F);
  QTest::keyClick(&button("1 %"), Qt::Key_Space);
  EXPECT_TRUE(button("1 %").isChecked()) << "it is still the target";
}

TEST_F(RenderForecasts, AreOfTheFinalSize) {
  ASSERT_TRUE(has_forecast());
  const double small = *forecast_of(0.01).seconds;
  options::RenderOptions larger = options();
  larger.size = {256, 192};
  document().options().set_options("Enlarge", larger);
  EXPECT_THAT(label().toStdString(), testing::HasSubstr("measuring"));
  ASSERT_TRUE(has_forecast());
  // 16 times as many pixels, of which fewer are at an edge.
  EXPECT_GT(*forecast_of(0.01).seconds, 4 * small);
  EXPECT_LT(*forecast_of(0.01).seconds, 40 * small);
}

TEST_F(RenderForecasts, AreKeptTrueByTheRender) {
  options::RenderOptions until = options();
  until.samples.reset();
  until.target_error = 0.0002F;
  document().options().set_options("Aim high", until);
  ASSERT_TRUE(has_forecast());
  ASSERT_EQ(row().forecasts().size(), 4U) << "with the own target";
  const ForecastTime before = forecast_of(0.0002);
  QTest::keyClick(&window_, Qt::Key_F6);
  ASSERT_TRUE(QTest::qWaitFor([&] { return forecast_of(0.0002).seconds != before.seconds; }, test::Minute));
  EXPECT_GT(*forecast_of(0.0002).seconds, 0);
  QTest::keyClick(&window_, Qt::Key_F5, Qt::ShiftModifier);
  ASSERT_TRUE(are_jobs_done());
}

TEST_F(RenderForecasts, AreMadeAfterARenderThatCameFirst) {
  QTest::qWait(1500);  // the forecast is being made
  QTest::keyClick(&window_, Qt::Key_F6);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_TRUE(has_forecast());
}

TEST_F(RenderForecasts, SayWhyThereIsNone) {
  document().replace("Empty it", {});
  ASSERT_TRUE(QTest::qWaitFor([this] { return label().startsWith("No forecast"); }, test::Minute));
  EXPECT_EQ(button("2 %").text().toStdString(), "2 %: …");
}

TEST(RoughDuration, HasTwoDigits) {
  EXPECT_EQ(rough_duration_text(0.3).toStdString(), "under 1 s");
  EXPECT_EQ(rough_duration_text(18.2).toStdString(), "18 s");
  EXPECT_EQ(rough_duration_text(33).toStdString(), "35 s");
  EXPECT_EQ(rough_duration_text(84).toStdString(), "80 s");
  EXPECT_EQ(rough_duration_text(540).toStdString(), "9 min");
  EXPECT_EQ(rough_duration_text(2 * 3600).toStdString(), "2 h");
  EXPECT_EQ(rough_duration_text(3 * 86400).toStdString(), "3 days");
}

}  // namespace
}  // namespace editor
