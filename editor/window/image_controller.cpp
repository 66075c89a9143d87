#include "editor/window/image_controller.h"

#include <QAction>
#include <QFileInfo>
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
/// Milliseconds after a render in which parts of its image may still arrive.
constexpr int LateTime = 2000;

}  // namespace

ImageController::ImageController(RenderPanel& render, Pages& pages, QMenu& menu, QObject* parent)
    : QObject(parent), render_(render), pages_(pages), menu_(menu), server_(new ImageServer(this)) {
  menu_.menuAction()->setVisible(false);
  if (!server_->listen()) server_->listen(display::free_address());  // another viewer uses the default one
  render_.final_render().set_display(QString::fromStdString(server_->address().text()));
  connect(server_, &ImageServer::received, this, &ImageController::take_sent);
  // The images of the editor's own renders are shown from their files.
  connect(server_, &ImageServer::dropped, this, [this](const QString& name) {
    if (browser_ != nullptr && !render_.final_render().has_rendered(name)) browser_->remove_image(name);
  });
  connect_renders();
}

void ImageController::connect_renders() {
  connect(&render_, &RenderPanel::image_opened, this,
          [this](const QString& path) { browser().open_files({path}); });
  connect(&render_, &RenderPanel::images_requested, this, [this] { browser(); });
  connect(&render_, &RenderPanel::comparison_requested, this, &ImageController::compare_with_last);
  // The file has layers, which the images that are sent of it do not have.
  connect(&render_.final_render(), &FinalRender::finished, this, [this](const FinalRenderResult& result) {
    late_.setRemainingTime(LateTime);
    if (pages_.indexOf(browser_) >= 0) browser_->reload(result.image);
  });
  connect(&render_, &RenderPanel::preview_opened, this, [this] {
    if (render_.preview().image()) browser().show_image(PreviewName, render_.preview().image());
  });
  connect(&render_.preview(), &Preview::image_changed, this, [this](const auto& image) {
    if (browser_ != nullptr && browser_->isVisible() && browser_->names().contains(PreviewName)) {
      browser_->show_image(PreviewName, image);
    }
  });
}

/// An image that arrives after its render has ended, perhaps while the next one is running, is not shown: its
/// file was loaded.
void ImageController::take_sent(const QString& name, const std::shared_ptr<const image::Image>& image) {
  FinalRender& final_render = render_.final_render();
  final_render.show(name, image);
  if (!final_render.has_rendered(name)) return browser().show_image(name, image);
  const bool is_running = final_render.is_running();
  const bool is_late = is_running ? name != final_render.output() : !late_.hasExpired();
  if (!is_late && pages_.indexOf(browser_) >= 0) browser_->show_image_of(name, image);
}

void ImageController::compare_with_last() {
  const FinalRenderResult* result =
      render_.last_render_of(browser_ != nullptr ? browser_->shown_path() : QString());
  if (result == nullptr) return;
  browser().compare(result->image, result->former, tr("%1, before").arg(QFileInfo(result->image).fileName()));
}

ImageBrowser& ImageController::browser() {
  if (browser_ == nullptr) {
    browser_ = new ImageBrowser(&pages_);
    const ImageTools& tools = browser_->tools();
    menu_.addActions({tools.open, tools.save, tools.copy});
    menu_.addSeparator();
    menu_.addActions(tools.of_view);
    menu_.addSeparator();
    menu_.addActions({tools.flip, tools.swap, tools.next_layer, tools.previous_layer});
    menu_.menuAction()->setVisible(true);
  }
  pages_.show_page(*browser_, tr("Images"), tr("View and compare images of renders and files"));
  return *browser_;
}

}  // namespace editor
