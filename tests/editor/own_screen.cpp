#include "tests/editor/own_screen.h"

namespace test {

OwnScreen::~OwnScreen() {
  server_.terminate();
  server_.waitForFinished();
}

bool OwnScreen::start(QSize size) {
  // The server prints the number of a free display.
  server_.setProcessChannelMode(QProcess::SeparateChannels);
  const QString screen = QString("%1x%2x24").arg(size.width()).arg(size.height());
  server_.start("Xvfb", {"-displayfd", "1", "-screen", "0", screen, "-nolisten", "tcp", "-dpi", "96"});
  if (!server_.waitForStarted() || !server_.waitForReadyRead()) return false;
  qputenv("DISPLAY", ":" + server_.readLine().trimmed());
  for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"}) {
    qputenv(name, home_.path().toLocal8Bit());
  }
  qputenv("QT_QPA_PLATFORM", "xcb");
  qputenv("QT_QPA_PLATFORMTHEME", "");
  qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
  return true;
}

}  // namespace test
