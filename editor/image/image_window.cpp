#include "editor/image/image_window.h"

#include <QAction>
#include <QMenuBar>
#include <QStatusBar>

#include "editor/appearance/theme.h"

namespace editor {

ImageWindow::ImageWindow(QWidget* parent)
    : QMainWindow(parent), browser_(new ImageBrowser(this)), server_(new ImageServer(this)) {
  setWindowTitle(tr("Images - wannabe"));
  setCentralWidget(browser_);
  resize(130 * Grid, 90 * Grid);
  make_menus();
  connect(server_, &ImageServer::received, browser_, &ImageBrowser::show_image);
  connect(server_, &ImageServer::dropped, browser_, &ImageBrowser::remove_image);
  connect(server_, &ImageServer::failed, this, [this](const QString& why) { statusBar()->showMessage(why); });
}

void ImageWindow::listen(const display::Address& address) {
  const bool listens = server_->listen(address);
  const QString place = QString::fromStdString((listens ? server_->address() : address).text());
  statusBar()->showMessage(listens
                               ? tr("Listening for renders with BPT_DisplayWindow on %1.").arg(place)
                               : tr("Cannot listen for renders on %1: %2.").arg(place, server_->problem()));
}

void ImageWindow::make_menus() {
  QMenu* file = menuBar()->addMenu(tr("&File"));
  // The window has no other contents, so the shortcuts work everywhere in it.
  const auto add = [&](QAction* action, const QKeySequence& key) {
    action->setShortcut(key);
    action->setShortcutContext(Qt::WindowShortcut);
    file->addAction(action);
  };
  add(browser_->tools().open, QKeySequence::Open);
  add(browser_->tools().save, QKeySequence::SaveAs);
  add(browser_->tools().copy, QKeySequence::Copy);
  file->addSeparator();
  QAction* close = file->addAction(tr("&Close"), this, &QWidget::close);
  close->setShortcut(QKeySequence::Close);
  close->setToolTip(tr("Close this window"));
  QMenu* view = menuBar()->addMenu(tr("&View"));
  view->addActions(browser_->tools().of_view);
  view->addSeparator();
  const ImageTools& tools = browser_->tools();
  view->addActions({tools.flip, tools.swap, tools.next_layer, tools.previous_layer});
}

}  // namespace editor
