// Runs `bpt render` with BPT_DisplayWindow while no viewer listens: the image view opens and shows the image.
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QPixmap>
#include <QProcess>
#include <QScreen>
#include <QTest>
#include <csignal>
#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

constexpr int Minute = 60'000;
constexpr const char* Bpt = GRANADA_BIN_DIR "/bpt";
constexpr int Width = 320;
constexpr int Height = 240;

/// The processes on this test's screen.
std::vector<pid_t> image_views() {
  std::vector<pid_t> found;
  const QByteArray screen = "DISPLAY=" + qgetenv("DISPLAY");
  for (const QString& name : QDir("/proc").entryList(QDir::Dirs)) {
    bool is_process = false;
    const pid_t process = name.toInt(&is_process);
    if (!is_process || QFile::symLinkTarget("/proc/" + name + "/exe") != GRANADA_BIN_DIR "/wannabe") continue;
    QFile environment("/proc/" + name + "/environ");
    if (!environment.open(QIODevice::ReadOnly)) continue;
    if (environment.readAll().split('\0').contains(screen)) found.push_back(process);
  }
  return found;
}

bool is_alive(pid_t process) {
  QFile state(QString("/proc/%1/stat").arg(process));
  return state.open(QIODevice::ReadOnly) && !state.readAll().contains(") Z ");
}

class DisplayWindow : public testing::Test {
 protected:
  DisplayWindow() {
    qunsetenv("GRANADA_DISPLAY_PORT");
    qputenv("XDG_RUNTIME_DIR", QByteArray::fromStdString(folder_.path()));
  }
  ~DisplayWindow() override {
    for (const pid_t process : image_views()) {
      ::kill(process, SIGTERM);
      EXPECT_TRUE(QTest::qWaitFor([&] { return !is_alive(process); }, Minute));
    }
  }

  /// The options of an image of one colour.
  std::string options(const std::string& name, const std::string& colour, int samples) const {
    folder_.add("scene.grf",
                "begin mesh brdf diffuse kd=0\nbegin vertexs (0,0,9) (1,0,9) (0,1,9) end vertexs\n"
                "begin faces (0,1,2) end faces end mesh\n");
    return folder_.add(name + ".op",
                       "BPT_Scene scene.grf\nBPT_Viewer 0 0 0\nBPT_VLook 0 0 -1\nBPT_DisplayWindow true\n"
                       "BPT_Image_Resolution " +
                           std::to_string(Width) + " " + std::to_string(Height) + "\nBPT_Background " +
                           colour + "\nBPT_Samples " + std::to_string(samples) + "\nBPT_Output_Image " +
                           name + ".pfm\n");
  }
  void render(const std::string& name, const std::string& colour) const {
    const test::Outcome outcome = test::run({Bpt, "render", options(name, colour, 1)});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(fs::exists(folder_.path(name + ".pfm")));
  }

  static int pixels_of(QRgb colour) {
    const QImage screen = QGuiApplication::primaryScreen()->grabWindow(0).toImage();
    int count = 0;
    for (int y = 0; y < screen.height(); ++y) {
      for (int x = 0; x < screen.width(); ++x) count += screen.pixel(x, y) == colour ? 1 : 0;
    }
    return count;
  }
  static bool shows(QRgb colour) {
    return QTest::qWaitFor([&] { return pixels_of(colour) >= Width * Height / 2; }, Minute);
  }

  test::TemporaryFolder folder_;
};

// Both renders end before a window can open.
TEST_F(DisplayWindow, OpensTheImageViewOnce) {
  render("green", "0 1 0");
  EXPECT_TRUE(shows(qRgb(0, 255, 0)));
  const std::vector<pid_t> views = image_views();
  ASSERT_EQ(views.size(), 1U);
  render("magenta", "1 0 1");
  EXPECT_TRUE(shows(qRgb(255, 0, 255)));
  EXPECT_EQ(image_views(), views);
}

TEST_F(DisplayWindow, LeavesTheImageViewToItself) {
  QProcess bpt;
  bpt.start(Bpt, {"render", QString::fromStdString(options("blue", "0 0 1", 100'000'000))});
  EXPECT_TRUE(shows(qRgb(0, 0, 255))) << "while it forms";
  ASSERT_EQ(bpt.state(), QProcess::Running);
  const std::vector<pid_t> views = image_views();
  ASSERT_EQ(views.size(), 1U);
  EXPECT_EQ(::getsid(views[0]), views[0]) << "keys of the terminal would reach it";
  for (const char* stream : {"0", "1", "2"}) {
    EXPECT_EQ(QFile::symLinkTarget(QString("/proc/%1/fd/%2").arg(views[0]).arg(stream)), "/dev/null");
  }
  ::kill(static_cast<pid_t>(bpt.processId()), SIGINT);
  ASSERT_TRUE(bpt.waitForFinished(Minute));
  EXPECT_EQ(bpt.exitCode(), 130);
  EXPECT_EQ(bpt.readAllStandardError(), "");
  EXPECT_EQ(image_views(), views);
  EXPECT_TRUE(shows(qRgb(0, 0, 255)));
}

}  // namespace
