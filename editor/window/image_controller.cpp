#include "editor/window/image_controller.h"

#include <QAction>
#include <QMenu>
#include <memory>

#include "editor/image/image_browser.h"
#include "editor/image/image_server.h"
#include "editor/rendering/render_panel.h"
#include "editor/window/pages.h"

namespace editor {
namespace {

/// The name of the preview in the list of images.
const char PreviewName[] = "preview";

}  // namespace

ImageController::ImageController(RenderPanel& render, Pages& pages, QMenu& menu, QObject* parent)
    : QObject(parent), render_(render), pages_(pages), menu_(menu), server_(new ImageServer(this)) {
  menu_.menuAction()->setVisible(false);
  if (!server_->listen()) server_->listen(0);  // another viewer uses the default port
  render_.final_render().set_display(QString("127.0.0.1:%1").arg(server_->port()));
  connect(server_, &ImageServer::received, this,
          [this](const QString& name, const std::shared_ptr<const transport::Image>& image) {
            render_.final_render().show(name, image);
            const bool is_ours = name == render_.final_render().output();
            if (!is_ours) return browser().show_image(name, image);
            if (pages_.indexOf(browser_) >= 0) browser_->show_image_of(name, image);
          });
  connect_renders();
}

void ImageController::connect_renders() {
  connect(&render_, &RenderPanel::image_opened, this,
          [this](const QString& path) { browser().open_files({path}); });
  connect(&render_, &RenderPanel::preview_opened, this, [this] {
    if (render_.preview().image()) browser().show_image(PreviewName, render_.preview().image());
  });
  connect(&render_.preview(), &Preview::image_changed, this, [this](const auto& image) {
    if (browser_ != nullptr && browser_->isVisible() && browser_->names().contains(PreviewName)) {
      browser_->show_image(PreviewName, image);
    }
  });
}

ImageBrowser& ImageController::browser() {
  if (browser_ == nullptr) {
    browser_ = new ImageBrowser(&pages_);
    const ImageTools& tools = browser_->tools();
    menu_.addActions({tools.open, tools.save, tools.copy});
    menu_.addSeparator();
    menu_.addActions(tools.of_view);
    menu_.addSeparator();
    menu_.addActions({tools.flip, tools.swap});
    menu_.menuAction()->setVisible(true);
  }
  pages_.show_page(*browser_, tr("Images"), tr("View and compare images of renders and files"));
  return *browser_;
}

}  // namespace editor
