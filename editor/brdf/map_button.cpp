#include "editor/brdf/map_button.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>

#include "editor/appearance/icons.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/text.h"
#include "renderer/image/image_file.h"

namespace editor {

MapButton::MapButton(const grf::ParameterInfo& parameter, QWidget* parent)
    : QToolButton(parent),
      usual_channel_(parameter.kind == grf::ParameterKind::Reflectance ? grf::ImageChannel::Rgb
                                                                       : grf::ImageChannel::Red),
      name_(text_of(parameter.name)),
      channels_(new QActionGroup(this)) {
  setIcon(editor::icon("texture"));
  setAutoRaise(true);
  setCheckable(true);
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(tr("%1, image").arg(name_));
  auto* menu = new QMenu(this);
  menu->setToolTipsVisible(true);
  menu->addAction(tr("Choose an image..."), this, &MapButton::choose)
      ->setToolTip(tr("Choose the file of an image that varies %1 over the faces").arg(name_));
  remove_ = menu->addAction(tr("Remove the image"), this, [this] { emit edited(std::nullopt); });
  remove_->setToolTip(tr("All faces have the number of %1 again").arg(name_));
  menu->addSeparator();
  if (usual_channel_ == grf::ImageChannel::Rgb) add_channel(grf::ImageChannel::Rgb, tr("Colour"));
  add_channel(grf::ImageChannel::Red, tr("Red channel"));
  add_channel(grf::ImageChannel::Green, tr("Green channel"));
  add_channel(grf::ImageChannel::Blue, tr("Blue channel"));
  add_channel(grf::ImageChannel::Alpha, tr("Alpha channel"));
  menu->addActions(channels_->actions());
  setMenu(menu);
  show_maps({std::nullopt});
}

void MapButton::add_channel(grf::ImageChannel channel, const QString& title) {
  QAction* action = channels_->addAction(title);
  action->setCheckable(true);
  action->setData(static_cast<int>(channel));
  action->setToolTip(channel == grf::ImageChannel::Rgb
                         ? tr("%1 varies by the colour of the image, as a texture does").arg(name_)
                         : tr("%1 varies by this channel of the image, as its file stores it").arg(name_));
  connect(action, &QAction::triggered, this, [this, channel] {
    if (!map_ || map_->channel == channel) return;
    grf::ParameterMap map = *map_;
    map.channel = channel;
    emit edited(map);
  });
}

void MapButton::show_maps(const std::vector<std::optional<grf::ParameterMap>>& maps) {
  const bool is_common = std::ranges::all_of(maps, [&](const auto& map) { return map == maps.front(); });
  const bool has_some = std::ranges::any_of(maps, [](const auto& map) { return map.has_value(); });
  map_ = is_common ? maps.front() : std::nullopt;
  setChecked(has_some);
  const QString file = map_ ? QString::fromStdString(map_->file) : QString();
  setToolTip(!is_common ? tr("The images of %1 are mixed").arg(name_)
             : map_     ? tr("%1 varies by the image %2, times the number, in previews and renders")
                          .arg(name_, QFileInfo(file).fileName())
                    : tr("Vary %1 over the faces by an image: choose it, or drop it on the row").arg(name_));
  remove_->setEnabled(has_some);
  for (QAction* action : channels_->actions()) {
    action->setEnabled(map_.has_value());
    action->setChecked(map_ && action->data().toInt() == static_cast<int>(map_->channel));
  }
}

void MapButton::take(const QString& file) {
  emit edited(grf::ParameterMap{file.toStdString(), map_ ? map_->channel : usual_channel_});
}

void MapButton::choose() {
  const QString filter = QString::fromStdString(image::readable_name_patterns());
  auto* dialog = new QFileDialog(window(), tr("Image of %1").arg(name_), {},
                                 tr("Images (%1);;All files (*)").arg(filter));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &MapButton::take);
  dialog->open();
}

}  // namespace editor
