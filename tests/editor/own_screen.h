// A virtual screen for programs that show windows.
#pragma once

#include <QProcess>
#include <QSize>
#include <QTemporaryDir>

namespace test {

/// A virtual X server (Xvfb) for the lifetime of this object, with software OpenGL, and settings in a
/// temporary folder. Created before the QApplication, it isolates the program from the user's desktop and
/// settings.
class OwnScreen {
 public:
  OwnScreen() = default;
  ~OwnScreen();
  OwnScreen(const OwnScreen&) = delete;
  OwnScreen& operator=(const OwnScreen&) = delete;

  /// Starts the server; the size is in pixels. Returns false if Xvfb cannot be started; else sets the
  /// environment.
  bool start(QSize size);

 private:
  QProcess server_;
  QTemporaryDir home_;
};

}  // namespace test
