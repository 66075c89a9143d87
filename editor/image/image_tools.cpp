#include "editor/image/image_tools.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/image/image_selection.h"
#include "editor/image/screen_controls.h"

namespace editor {

ImageTools::ImageTools(ImagePane& pane, QWidget* parent)
    : QWidget(parent), pane_(pane), controls_(new ScreenControls) {
  make_actions();
  add_keys();
  auto* column = tight_layout<QVBoxLayout>(this, 0);
  column->addWidget(make_actions_row());
  column->addWidget(make_comparison_row());
}

QAction* ImageTools::add_action(const QString& icon_name, const QString& text, const QString& help,
                                const QKeySequence& key, const std::function<void()>& work) {
  auto* action = new QAction(icon_name.isEmpty() ? QIcon() : icon(icon_name), text, this);
  action->setShortcut(key);
  action->setShortcutContext(Qt::WidgetShortcut);
  const QString keys = key.isEmpty() ? QString() : tr(" (%1)").arg(key.toString(QKeySequence::NativeText));
  action->setToolTip(text + keys + "\n" + help);
  if (work) connect(action, &QAction::triggered, this, work);
  pane_.addAction(action);
  return action;
}

void ImageTools::make_actions() {
  open = add_action("open", tr("Open images"),
                    tr("Open image files: exr, hdr, pfm, raw, png, jpg, tga or webp."), {});
  save = add_action(
      "save_as", tr("Save image as"),
      tr("Save image A: linear as exr, hdr, pfm and raw, with the exposure applied as png, jpg and tga."),
      {});
  copy = add_action("copy", tr("Copy image"), tr("Copy the image to the clipboard as the screen shows it."),
                    QKeySequence::Copy);
  remove = add_action("close", tr("Close image"), tr("Remove image A from the list; its file is kept."),
                      Qt::Key_Delete);
  const QString zoom_help = tr("The wheel also zooms, about the pointer.");
  of_view = {
      add_action("fit", tr("Fit"), tr("Fit the whole image into the view."), Qt::Key_0,
                 [this] { pane_.fit(); }),
      add_action("actual_size", tr("Actual size"), tr("Show one image pixel per screen pixel."), Qt::Key_1,
                 [this] { pane_.show_actual_size(); }),
      add_action("zoom_in", tr("Zoom in"), zoom_help, Qt::Key_Plus, [this] { pane_.zoom_by(2); }),
      add_action("zoom_out", tr("Zoom out"), zoom_help, Qt::Key_Minus, [this] { pane_.zoom_by(0.5); })};
  of_view[2]->setShortcuts({Qt::Key_Plus, Qt::Key_Equal});  // they share a key on many keyboards
  flip = add_action("flip", tr("Flip to B"), tr("Show B in place of A until pressed again."), Qt::Key_Space);
  flip->setCheckable(true);
  swap = add_action("swap", tr("Swap A and B"), tr("Exchange the image and the reference."), Qt::Key_X);
  next_layer = add_action({}, tr("Next layer"), tr("Show the next layer of the image."), Qt::Key_L,
                          [this] { step_layer(1); });
  previous_layer = add_action({}, tr("Previous layer"), tr("Show the previous layer of the image."),
                              Qt::SHIFT | Qt::Key_L, [this] { step_layer(-1); });
}

/// Adds shortcuts without buttons: they operate the controls.
void ImageTools::add_keys() {
  const auto add_step = [this](const QKeySequence& key, const QString& text, const QString& help,
                               float stops) {
    add_action({}, text, help, key,
               [this, stops] { controls_->set_exposure(controls_->settings().exposure + stops); });
  };
  add_step(Qt::Key_E, tr("Brighter"), tr("Increase the exposure by half a stop"), 0.5F);
  add_step(Qt::SHIFT | Qt::Key_E, tr("Darker"), tr("Decrease the exposure by half a stop"), -0.5F);
  const auto add_channel = [this](Qt::Key key, const QString& text, const QString& help,
                                  ImageChannel channel) {
    add_action({}, text, help, key, [this, channel] { controls_->set_channel(channel); });
  };
  add_channel(Qt::Key_C, tr("Colour"), tr("Show all three channels"), ImageChannel::Colour);
  add_channel(Qt::Key_R, tr("Red"), tr("Show the red channel"), ImageChannel::Red);
  add_channel(Qt::Key_G, tr("Green"), tr("Show the green channel"), ImageChannel::Green);
  add_channel(Qt::Key_B, tr("Blue"), tr("Show the blue channel"), ImageChannel::Blue);
  add_channel(Qt::Key_Y, tr("Luminance"), tr("Show the luminance in grey"), ImageChannel::Luminance);
  add_action({}, tr("False colour"), tr("Show the luminance in false colours"), Qt::Key_P,
             [this] { controls_->set_false_colour(true); });
}

QToolBar* ImageTools::make_bar() {
  auto* bar = new QToolBar(this);
  bar->setIconSize({2 * Grid, 2 * Grid});
  return bar;
}

QToolBar* ImageTools::make_actions_row() {
  QToolBar* tools = make_bar();
  tools->addActions({open, save, copy, remove});
  tools->addSeparator();
  tools->addActions(of_view);
  auto* zoom = new QLabel(tr("100 %"), tools);
  zoom->setAlignment(Qt::AlignCenter);
  zoom->setFixedWidth(zoom->fontMetrics().horizontalAdvance(QStringLiteral("00000.0 %")) + Grid);
  zoom->setToolTip(tr("Zoom: screen pixels per image pixel."));
  connect(&pane_, &ImagePane::zoomed, zoom,
          [zoom](double factor) { zoom->setText(tr("%1 %").arg(100 * factor, 0, 'g', 4)); });
  tools->addWidget(zoom);
  tools->addSeparator();
  tools->addWidget(controls_);
  return tools;
}

QToolBar* ImageTools::make_comparison_row() {
  QToolBar* tools = make_bar();
  images_ = narrow_list(tr("Image A"), tr("The displayed image."), 12, tools);
  references_ = narrow_list(tr("Image B"), {}, 12, tools);
  comparison_ = narrow_list(tr("Comparison"), {}, 12, tools);
  comparison_->addItems({tr("Only A"), tr("Wipe"), tr("Side by side"), tr("Signed difference"),
                         tr("Absolute difference"), tr("Relative difference")});
  const auto add = [&](const QString& text, QComboBox* list) {
    auto* label = new QLabel(text, tools);
    label->setContentsMargins(Grid, 0, Grid / 2, 0);
    tools->addWidget(label);
    tools->addWidget(list);
  };
  add(tr("A"), images_);
  add(tr("B"), references_);
  tools->addActions({swap, flip});
  add(tr("Compare"), comparison_);
  layers_ = narrow_list(tr("Layer"), {}, 8, tools);
  add(tr("Layer"), layers_);
  connect(images_, &QComboBox::textActivated, this, &ImageTools::image_chosen);
  connect(references_, &QComboBox::activated, this,
          [this](int index) { emit reference_chosen(references_->itemData(index).toString()); });
  connect(comparison_, &QComboBox::currentIndexChanged, this, &ImageTools::comparison_changed);
  connect(layers_, &QComboBox::activated, this,
          [this](int index) { emit layer_chosen(layers_->itemData(index).toString()); });
  return tools;
}

void ImageTools::show_selection(const ImageSelection& selection) {
  const QSignalBlocker block_images(images_);
  const QSignalBlocker block_references(references_);
  images_->clear();
  references_->clear();
  references_->addItem(tr("none"), QString());
  for (const QString& name : selection.names()) {
    images_->addItem(name);
    references_->addItem(name, name);
  }
  images_->setCurrentIndex(images_->findText(selection.image().name));
  references_->setCurrentIndex(std::max(0, references_->findData(selection.reference().name)));
  const bool has_image = selection.image().image != nullptr;
  const bool has_reference = selection.reference().image != nullptr;
  const bool has_several = selection.entries().size() > 1;
  for (QAction* action : {save, copy, remove}) action->setEnabled(has_image);
  for (QAction* action : {flip, swap}) action->setEnabled(has_reference);
  enable(comparison_,
         tr("How A and B are compared: only A, with a wipe line that can be dragged, side by side, or as a "
            "difference."),
         has_reference ? QString() : tr("Choose an image as B first."));
  show_layers(selection);
  images_->setEnabled(has_image);
  enable(references_, tr("The reference that A is compared with."),
         has_several ? QString() : tr("Open a second image to compare with."));
}

void ImageTools::show_layers(const ImageSelection& selection) {
  const QSignalBlocker block(layers_);
  layers_->clear();
  layers_->addItem(tr("image"), QString());
  for (const QString& name : selection.layers()) layers_->addItem(name, name);
  layers_->setCurrentIndex(std::max(0, layers_->findData(selection.layer())));
  const bool has_layers = layers_->count() > 1;
  for (QAction* action : {next_layer, previous_layer}) action->setEnabled(has_layers);
  enable(layers_, tr("The layer of A and B that is shown. Keys L and Shift+L."),
         has_layers ? QString()
                    : tr("Image A has no layers: the render option BPT_Layers adds them to an exr."));
}

/// Goes around at the ends.
void ImageTools::step_layer(int step) {
  const int count = layers_->count();
  emit layer_chosen(layers_->itemData((layers_->currentIndex() + step + count) % count).toString());
}

Comparison ImageTools::comparison() const { return static_cast<Comparison>(comparison_->currentIndex()); }

void ImageTools::set_comparison(Comparison comparison) {
  comparison_->setCurrentIndex(static_cast<int>(comparison));
}

Arrangement ImageTools::arrangement() const {
  if (flip->isChecked()) return Arrangement::Reference;
  if (comparison() == Comparison::Wipe) return Arrangement::Wipe;
  return comparison() == Comparison::SideBySide ? Arrangement::SideBySide : Arrangement::Alone;
}

std::optional<Difference> ImageTools::difference() const {
  if (comparison() < Comparison::Signed) return std::nullopt;
  return static_cast<Difference>(comparison_->currentIndex() - static_cast<int>(Comparison::Signed));
}

}  // namespace editor
