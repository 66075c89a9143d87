// Final renders on a farm of this machine, chosen in the Render dock.
#include <QComboBox>
#include <QLabel>
#include <QSettings>
#include <QTabWidget>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/preferences.h"
#include "editor/rendering/render_panel.h"
#include "editor/window/file_actions.h"
#include "editor/window/preferences_dialog.h"
#include "tests/editor/window/window_driver.h"
#include "tests/farm/farm_processes.h"

namespace editor {
namespace {

using testing::HasSubstr;

class RendersOnAFarm : public test::FarmTest {
 protected:
  RendersOnAFarm() : window_(QString::fromStdString(path("sessions"))) {
    QSettings().clear();
    window_.resize(1600, 1000);
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
  }

  void open(const std::string& options = "") {
    scene(32, options);
    window_.files().open(QString::fromStdString(path("scene.grf")));
    ASSERT_TRUE(QTest::qWaitFor([this] { return window_.view().is_complete(); }, test::Minute));
    QTest::keyClick(&window_, Qt::Key_5, Qt::ControlModifier);
  }
  /// Types the farm's address into the preferences.
  void choose_farm() {
    QTest::keyClick(&window_, Qt::Key_Comma, Qt::ControlModifier);
    auto& dialog = *window_.findChild<PreferencesDialog*>();
    dialog.findChild<QTabWidget*>()->setCurrentIndex(3);
    auto& server = test::named<QLineEdit>(dialog, "Server of the farm");
    QTest::keyClicks(&server, QString::fromStdString(url_));
    QTest::keyClick(&server, Qt::Key_Return);
    dialog.close();
    window_.activateWindow();
    auto& machines = test::named<QComboBox>(window_, "Machines of final renders");
    machines.setFocus();
    QTest::keyClick(&machines, Qt::Key_Down);
    EXPECT_EQ(machines.currentText(), "On the farm 127.0.0.1");
  }
  /// Renders, and returns the last state that the Render dock showed.
  std::string render() {
    is_started_ = false;
    QTest::keyClick(&window_, Qt::Key_F6);
    const bool is_done =
        QTest::qWaitFor([this] { return has_started() && window_.jobs().jobs().empty(); }, 2 * test::Minute);
    EXPECT_TRUE(is_done);
    return state();
  }
  std::string state() {
    return test::named<QLabel>(window_.render_panel(), "State of the render").text().toStdString();
  }
  bool has_started() {
    is_started_ = is_started_ || !window_.jobs().jobs().empty();
    return is_started_;
  }

  MainWindow window_;
  bool is_started_ = false;
};

TEST_F(RendersOnAFarm, IsOfferedOnceTheFarmIsNamed) {
  open();
  auto* machines = window_.render_panel().findChild<QComboBox*>("machines");
  ASSERT_NE(machines, nullptr);
  EXPECT_FALSE(machines->isVisible());
  choose_farm();
  EXPECT_TRUE(machines->isVisible());
  EXPECT_EQ(window_.render_panel().final_request().farm->server.toStdString(), url_);
  EXPECT_EQ(Preferences::load().farm.server.toStdString(), url_) << "it is remembered";
}

TEST_F(RendersOnAFarm, MakesTheImageOfThisMachine) {
  const test::Process server = serve();
  const test::Process worker = work();
  open("BPT_Output_Image image.pfm\n");
  EXPECT_THAT(render(), testing::Not(HasSubstr("failed")));
  const std::string expected = test::digest_of_file(path("image.pfm"));
  std::filesystem::remove(path("image.pfm"));
  choose_farm();
  std::set<std::string> states;
  QObject::connect(&window_.render_panel().final_render(), &FinalRender::progressed, &window_,
                   [&](const RenderReport&) { states.insert(state()); });
  EXPECT_THAT(render(), testing::Not(HasSubstr("failed")));
  EXPECT_EQ(test::digest_of_file(path("image.pfm")), expected);
  EXPECT_THAT(states, testing::Contains(testing::AllOf(HasSubstr(" parts"), HasSubstr("worker"))));
}

TEST_F(RendersOnAFarm, MakesAJobOfEachFrame) {
  const test::Process server = serve();
  const test::Process worker = work();
  open("BPT_Output_Image turn.pfm\nBPT_Frames 3\n");
  EXPECT_THAT(render(), testing::Not(HasSubstr("failed")));
  const auto frames = [this] {
    std::vector<std::string> digests;
    for (const std::string number : {"1", "2", "3"}) {
      const std::string file = path("turn_000" + number + ".pfm");
      digests.push_back(std::filesystem::exists(file) ? test::digest_of_file(file) : "");
      std::filesystem::remove(file);
    }
    return digests;
  };
  const std::vector<std::string> expected = frames();
  EXPECT_EQ(std::set(expected.begin(), expected.end()).size(), 3U) << "the camera turns";
  choose_farm();
  EXPECT_THAT(render(), testing::Not(HasSubstr("failed")));
  EXPECT_EQ(frames(), expected);
}

TEST_F(RendersOnAFarm, SaysThatNoServerAnswers) {
  open("BPT_Output_Image farm.pfm\n");
  choose_farm();
  EXPECT_THAT(render(), HasSubstr("Render failed"));
  EXPECT_FALSE(std::filesystem::exists(path("farm.pfm")));
}

}  // namespace
}  // namespace editor
