#pragma once

#include <QMainWindow>

#include "editor/image/image_browser.h"
#include "editor/image/image_server.h"

namespace editor {

/// The image view as a separate window, which also displays renders in progress of `bpt` with
/// BPT_DisplayWindow.
class ImageWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit ImageWindow(QWidget* parent = nullptr);

  ImageBrowser& browser() { return *browser_; }
  /// Listens for renders; the status bar shows the address, or why it failed.
  void listen(const display::Address& address = display::default_address());
  const ImageServer& server() const { return *server_; }

 private:
  void make_menus();

  ImageBrowser* browser_;
  ImageServer* server_;
};

}  // namespace editor
