// A screen that nobody sees, for programs that show windows.
#pragma once

#include <QProcess>
#include <QSize>
#include <QTemporaryDir>

namespace test {

/// An X server without a display (Xvfb) that lives as long as this, with OpenGL in software, and settings in
/// a folder that is removed. To be made before the QApplication: nobody's desktop is touched, and nothing is
/// seen of what another program left.
class OwnScreen {
 public:
  OwnScreen() = default;
  ~OwnScreen();
  OwnScreen(const OwnScreen&) = delete;
  OwnScreen& operator=(const OwnScreen&) = delete;

  /// Pixels. False if there is no Xvfb that can be started; else the environment says where all is.
  bool start(QSize size);

 private:
  QProcess server_;
  QTemporaryDir home_;
};

}  // namespace test
