// Tests of the windows of study tools, which a user works with the pointer and the keyboard.
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QListWidget>
#include <QMimeData>
#include <QStatusBar>
#include <QToolButton>

#include <gmock/gmock.h>

#include "editor/appearance/theme.h"
#include "tests/editor/pointer.h"
#include "tests/editor/tools/study_tool_test.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"

namespace editor {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* Fit =
    "diffuse kd=0.5\nviewer (0.5, 0)\nbegin\n(0, 0, 1) 0.159155\n(0.6, 0, 0.8) 0.2\nend\n";

/// Counts how often it is to show a state.
class CountingWindow : public ToolWindow {
 public:
  CountingWindow() : ToolWindow(studies::study_tool("fitplot").value(), nullptr) { begin(new QWidget); }
  bool has_picture() const override { return true; }
  bool is_busy() const override { return false; }

  int requests = 0;
  std::size_t files = 0;

 protected:
  void request() override {
    ++requests;
    files = state().files.size();
  }
  std::vector<studies::DataFile> data_files() const override { return {}; }
};

TEST(ToolWindow, ShowsTheFilesThatItIsOpenedWithAtOnce) {
  CountingWindow window;
  window.open({"a.fit"});
  QApplication::processEvents();
  EXPECT_EQ(window.requests, 1);
  EXPECT_EQ(window.files, 1U);
  CountingWindow empty;
  QApplication::processEvents();
  EXPECT_EQ(empty.requests, 1);
}

class StudyWindowTest : public StudyToolTest {
 protected:
  StudyWindowTest() : StudyToolTest("fitplot") {}
  void SetUp() override {
    StudyToolTest::SetUp();
    ASSERT_TRUE(is_done());
  }
  QString fit(const std::string& name = "a.fit", const std::string& text = Fit) {
    return QString::fromStdString(folder_.add(name, text));
  }
};

// Files on the command line are shown as those that a window is opened with.
TEST(Program, MakesTheFigureOfAFile) {
  const test::TemporaryFolder folder;
  const std::string model = folder.add("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const std::string figure = folder.path("a.svg");
  const test::Outcome outcome =
      test::run({GRANADA_BIN_DIR "/wannabe", "--tool", "brdfviewer", model, "-o", figure});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "ward on 1 triangle, 1 light\n");
  EXPECT_THAT(test::bytes_of(figure), StartsWith("<svg "));
}

TEST_F(StudyWindowTest, SaysWhatToDoWithoutAFile) {
  EXPECT_FALSE(window_.study());
  EXPECT_EQ(notice(), "") << "no file is no mistake";
  EXPECT_TRUE(window_.figure().image().isNull());
}

TEST_F(StudyWindowTest, ShowsAFileAndDescribesWhatIsUnderThePointer) {
  open({fit()});
  ASSERT_TRUE(window_.study());
  FigureView& figure = window_.figure();
  EXPECT_FALSE(figure.image().isNull());
  EXPECT_THAT(figure.accessibleDescription().toStdString(), HasSubstr("1 value differs"));
  // The normal is at the centre of the disc, at (750, 206) of the figure.
  test::move_pointer(figure, figure.in_widget({750, 206}));
  EXPECT_TRUE(QTest::qWaitFor([this] { return pointed().startsWith("\u03B8 = 0\u00B0"); }))
      << pointed().toStdString();
  EXPECT_THAT(pointed().toStdString(), HasSubstr("value 0.15915, the BRDF's own 0.15915"));
  test::move_pointer(figure, figure.in_widget({600, 20}));
  EXPECT_TRUE(QTest::qWaitFor([this] { return pointed().isEmpty(); }));
}

TEST_F(StudyWindowTest, TurnsByThePointerAndTheKeyboard) {
  open({fit()});
  const QImage before = window_.figure().image();
  test::drag(window_.figure(), {200, 300}, {150, 320});
  ASSERT_TRUE(is_done());
  EXPECT_NEAR(number("azimuth"), 60 + 0.6 * 50, 0.01);
  EXPECT_NEAR(number("elevation"), 25 + 0.6 * 20, 0.01);
  EXPECT_NE(window_.figure().image(), before);
  window_.figure().setFocus();
  QTest::keyClick(&window_.figure(), Qt::Key_Right);
  EXPECT_NEAR(number("azimuth"), 90 - 0.6 * 8, 0.01);
  // A drag is one step.
  test::action(window_, "Undo").trigger();
  EXPECT_NEAR(number("azimuth"), 90, 0.01);
  test::action(window_, "Undo").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_NEAR(number("azimuth"), 60, 0.01);
  EXPECT_EQ(window_.figure().image(), before);
  test::action(window_, "Redo").trigger();
  EXPECT_NEAR(number("azimuth"), 90, 0.01);
}

TEST_F(StudyWindowTest, FollowsItsForm) {
  open({fit()});
  const QImage before = window_.figure().image();
  type("azimuth", "10");
  ASSERT_TRUE(is_done());
  EXPECT_NE(window_.figure().image(), before);
  EXPECT_THAT(studies::to_text(window_.state()), StartsWith("tool fitplot azimuth=10\n"));
}

TEST_F(StudyWindowTest, SaysWhatToDoInAnEmptyListOfFiles) {
  auto& files = test::named<QListWidget>(window_, "Files");
  const auto has_words = [&] {
    const QImage image = files.viewport()->grab().toImage();
    QImage plain = image;
    plain.fill(image.pixelColor(0, image.height() - 1));
    return image != plain;
  };
  EXPECT_TRUE(has_words());
  files.addItem("");
  files.setCurrentRow(-1);
  EXPECT_FALSE(has_words());
}

TEST_F(StudyWindowTest, AddsAndRemovesFiles) {
  const QString first = fit("a.fit");
  open({first, fit("b.fit")});
  auto& files = test::named<QListWidget>(window_, "Files");
  EXPECT_EQ(files.count(), 2);
  QMimeData dropped;
  dropped.setUrls({QUrl::fromLocalFile(fit("c.fit"))});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &dropped, Qt::LeftButton, {});
  QApplication::sendEvent(&window_, &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({10, 10}, Qt::CopyAction, &dropped, Qt::LeftButton, {});
  QApplication::sendEvent(&window_, &drop);
  ASSERT_TRUE(is_done());
  EXPECT_EQ(files.count(), 3);
  files.setCurrentRow(1);
  test::named<QToolButton>(window_, "Remove the file").click();
  ASSERT_TRUE(is_done());
  EXPECT_EQ(files.count(), 2);
  EXPECT_THAT(window_.figure().accessibleDescription().toStdString(), HasSubstr("c.fit"));
  EXPECT_THAT(window_.figure().accessibleDescription().toStdString(), testing::Not(HasSubstr("b.fit")));
}

TEST_F(StudyWindowTest, SaysWhatIsWrongAndGoesOn) {
  open({fit("cut.fit", "diffuse\nviewer (0.5, 0)\nbegin\n(0, 0")});
  EXPECT_THAT(notice(), HasSubstr("cut.fit:4:6: error: found the end of the file"));
  EXPECT_FALSE(window_.study());
  test::action(window_, "Undo").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_EQ(notice(), "");
  open({fit("degrees.fit", "diffuse\nviewer (0.5, 45)\nbegin\nend\n")});
  EXPECT_THAT(notice(), HasSubstr("warning: the view's phi, 45"));
  EXPECT_TRUE(window_.study());
  open({QString::fromStdString(folder_.path("gone.fit"))});
  EXPECT_THAT(notice(), HasSubstr("gone.fit"));
}

TEST_F(StudyWindowTest, KeepsItsSettingsAsText) {
  open({fit()});
  QTest::keyClick(&window_.figure(), Qt::Key_Left);
  ASSERT_TRUE(is_done());
  const studies::ToolState state = window_.state();
  const QImage picture = window_.figure().image();
  const QString saved = path("s.study");
  EXPECT_EQ(message_of([&] { window_.save_state(saved); }), "");
  EXPECT_EQ(test::bytes_of(saved.toStdString()), "tool fitplot azimuth=64.8 elevation=25\nfile a.fit\n");
  test::action(window_, "Copy settings").trigger();
  const QString copied = QApplication::clipboard()->text();
  EXPECT_THAT(copied.toStdString(), HasSubstr("file /")) << "for other places";
  test::action(window_, "Reset all settings").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_FALSE(window_.study());
  test::action(window_, "Paste settings").trigger();
  ASSERT_TRUE(is_done());
  EXPECT_EQ(window_.figure().image(), picture);
  test::action(window_, "Reset all settings").trigger();
  open({saved});
  EXPECT_EQ(window_.state().settings, state.settings);
  EXPECT_EQ(window_.figure().image(), picture);
  // What is no state changes nothing.
  for (const char* wrong :
       {"", "tool fitplot azimuth=x\n", "tool fitplot\nbrdf ward\n", "tool other\n", "hello"}) {
    QApplication::clipboard()->setText(wrong);
    test::action(window_, "Paste settings").trigger();
    EXPECT_THAT(notice(), HasSubstr("error")) << wrong;
    EXPECT_EQ(window_.state().settings, state.settings) << wrong;
  }
}

TEST_F(StudyWindowTest, ExportsWhatItShows) {
  open({fit()});
  for (const auto& [name, start] : {std::pair("a.svg", "<svg "), {"a.png", "\x89PNG"}, {"a.pdf", "%PDF-"}}) {
    const QString file = path(name);
    EXPECT_EQ(message_of([&] { window_.export_figure(file); }), "") << name;
    EXPECT_THAT(test::bytes_of(folder_.path(name)), StartsWith(start));
  }
  EXPECT_THAT(test::bytes_of(folder_.path("a.svg")), HasSubstr("fill=\"#fff\""))
      << "on white in the dark theme";
  EXPECT_EQ(message_of([&] { window_.export_data(path("v.csv")); }), "");
  EXPECT_THAT(test::bytes_of(folder_.path("v.csv")), StartsWith("file,x,y,z,value,f\na.fit,0,0,1,0.159155,"));
  EXPECT_EQ(message_of([&] { window_.export_data(path("v.fit")); }), "");
  EXPECT_EQ(test::bytes_of(folder_.path("v.fit")).substr(0, 31), "diffuse kd=0.5\nviewer (0.5, 0)\n");
  EXPECT_THAT(message_of([&] { window_.export_figure(path("none/a.svg")); }).toStdString(),
              HasSubstr("none/a.svg"));
  EXPECT_THAT(notice(), HasSubstr("none/a.svg"));
  EXPECT_THAT(message_of([&] { window_.export_figure(path("a.gif")); }).toStdString(),
              HasSubstr("must end in"));
}

TEST_F(StudyWindowTest, IsExportedByItsDialog) {
  open({fit()});
  const QString typed = path("typed.svg");
  EXPECT_EQ(message_of([&] {
              test::action(window_, "Export figure...").trigger();
              auto* dialog = window_.findChild<QFileDialog*>();
              ASSERT_NE(dialog, nullptr);
              auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
              name->setText(typed);
              QTest::keyClick(name, Qt::Key_Return);
            }),
            "");
  EXPECT_THAT(test::bytes_of(typed.toStdString()), StartsWith("<svg "));
}

TEST_F(StudyWindowTest, HasTheColoursOfTheTheme) {
  open({fit()});
  const auto middle_of_edge = [this] { return QColor(window_.figure().image().pixel(2, 2)).lightness(); };
  EXPECT_LT(middle_of_edge(), 60);
  apply(Theme::Light, *qApp);
  ASSERT_TRUE(QTest::qWaitFor([&] { return is_done() && middle_of_edge() > 200; }));
  apply(Theme::Dark, *qApp);
}

TEST_F(StudyWindowTest, NeverBlocksForLong) {
  const QString file = fit();
  test::Watchdog watchdog;
  watchdog.longest();
  open({file});
  for (int i = 0; i < 20; ++i) {
    QTest::keyClick(&window_.figure(), Qt::Key_Left);
    QTest::qWait(10);
  }
  ASSERT_TRUE(is_done());
  EXPECT_LT(watchdog.longest().milliseconds, 100) << "milliseconds; 50 on a machine that does nothing else";
}

}  // namespace
}  // namespace editor
