// The choice of the Render dock where final renders are made.
#include <QAbstractItemView>
#include <QComboBox>
#include <QUrl>

#include "editor/controls/form_widgets.h"
#include "editor/rendering/render_panel.h"

namespace editor {

QComboBox* RenderPanel::make_machines(QWidget* parent) {
  machines_ = narrow_list(tr("Machines of final renders"),
                          tr("Where final renders are made; the image is the same, to the last bit. Edit > "
                             "Preferences > Farm names the farm"),
                          14, parent);
  machines_->setObjectName("machines");
  machines_->insertItem(ThisMachine, tr("On this machine"));
  machines_->view()->setAccessibleName(machines_->accessibleName());
  machines_->view()->setToolTip(machines_->toolTip());
  machines_->hide();
  return machines_;
}

void RenderPanel::set_farm(const FarmAccess& farm) {
  farm_ = farm;
  const bool was_on_farm = machines_->currentIndex() == OnFarm;
  machines_->removeItem(OnFarm);
  if (!farm.server.isEmpty()) {
    machines_->insertItem(OnFarm, tr("On the farm %1").arg(QUrl(farm.server).host()));
    machines_->setItemData(OnFarm, farm.server, Qt::ToolTipRole);
    if (was_on_farm) machines_->setCurrentIndex(OnFarm);
  }
  machines_->setVisible(!farm.server.isEmpty());
}

}  // namespace editor
