#include "editor/window/pages.h"

#include <QTabBar>

#include "editor/controls/tab_order.h"
#include "editor/window/scene_comparison.h"
#include "editor/window/source_view.h"

namespace editor {

Pages::Pages(QWidget* parent) : QTabWidget(parent) {
  setDocumentMode(true);
  setFocusPolicy(Qt::NoFocus);  // it would pass the focus to its tab bar, even if hidden
  tabBar()->setAutoHide(true);
  setTabsClosable(true);
  setAccessibleName(tr("Pages"));
  tabBar()->setAccessibleName(tr("Pages"));
  tabBar()->setToolTip(tr("Pages: the scene, images, and the source text of files"));
  connect(this, &QTabWidget::tabCloseRequested, this, [this](int page) {
    if (page > 0) removeTab(page);
  });
}

void Pages::add_scene(QWidget* page) {
  addTab(page, tr("Scene"));
  setTabToolTip(0, tr("3D view of the scene"));
  for (const auto side : {QTabBar::LeftSide, QTabBar::RightSide}) tabBar()->setTabButton(0, side, nullptr);
}

void Pages::show_page(QWidget& page, const QString& title, const QString& tip) {
  if (indexOf(&page) < 0) {
    setTabToolTip(addTab(&page, title), tip);
    lead_tab_through({this});
  }
  setCurrentWidget(&page);
}

void Pages::show_source(const grf::SourceLocation& location) {
  if (source_ == nullptr) source_ = new SourceView(this);
  show_page(*source_, tr("Source"), tr("Source text of the file that a message refers to"));
  source_->show(location);
}

void Pages::show_differences(const grf::Scene& scene, const QString& path) {
  if (comparison_ == nullptr) comparison_ = new SceneComparison(this);
  show_page(*comparison_, tr("Compare"), tr("Differences between the scene and its file"));
  comparison_->compare(scene, path);
}

}  // namespace editor
