#include "editor/window/effects_controller.h"

#include <QAction>
#include <QTreeWidget>

#include "editor/controls/actions.h"
#include "editor/document/document.h"
#include "editor/image/image_browser.h"
#include "editor/rendering/effects_page.h"
#include "editor/rendering/render_panel.h"
#include "editor/window/main_window.h"
#include "editor/window/pages.h"

namespace editor {

EffectsController::EffectsController(Document& document, RenderPanel& render, Pages& pages,
                                     MainWindow& window)
    : QObject(&window), document_(document), render_(render), pages_(pages), window_(window) {
  action_ = new_action(window,
                       {tr("E&ffects"), "albedo", QKeySequence("Ctrl+Alt+D"),
                        tr("Show which effects the scene needs, what they cost and what they contribute")},
                       [this] { page(); });
}

EffectsPage& EffectsController::page() {
  if (page_ == nullptr) {
    page_ = new EffectsPage(
        document_, [this] { return render_.final_request(); }, bundled_program("bpt"), &pages_);
    connect(page_, &EffectsPage::status_message, this, &EffectsController::status_message);
    connect(page_, &EffectsPage::scene_requested, &window_, &MainWindow::show_scene);
    connect(page_, &EffectsPage::comparison_requested, this,
            [this](const QString& without, const QString& full, const QString& full_name) {
              ImageBrowser& browser = window_.image_browser();
              browser.set_comparison(Comparison::Signed);
              browser.compare(without, full, full_name);
            });
  }
  pages_.show_page(*page_, tr("Effects"), tr("Effects of the scene: need, cost and contribution"));
  page_->table().setFocus(Qt::ShortcutFocusReason);
  return *page_;
}

}  // namespace editor
