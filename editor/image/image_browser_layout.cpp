// The controls of the image view, and where they stand.
#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/image/image_browser.h"
#include "editor/image/scale_bar.h"
#include "editor/image/screen_controls.h"

namespace editor {

QAction* ImageBrowser::add_action(const QString& icon_name, const QString& text, const QString& help,
                                  const QKeySequence& key) {
  auto* action = new QAction(icon(icon_name), text, this);
  action->setShortcut(key);
  action->setShortcutContext(Qt::WidgetShortcut);
  const QString keys = key.isEmpty() ? QString() : tr(" (%1)").arg(key.toString(QKeySequence::NativeText));
  action->setToolTip(text + keys + "\n" + help);
  pane_->addAction(action);
  return action;
}

void ImageBrowser::make_actions() {
  open_ = add_action("open", tr("Open images"),
                     tr("Shows images of files: exr, hdr, pfm, raw, png, jpg or tga."), {});
  save_ = add_action(
      "save_as", tr("Save image as"),
      tr("Writes image A: linear to exr, hdr, pfm and raw, with the exposure to png, jpg and tga."), {});
  copy_ = add_action("copy", tr("Copy image"), tr("Puts the image on the clipboard as the screen shows it."),
                     QKeySequence::Copy);
  remove_ = add_action("close", tr("Close image"), tr("Takes image A off the list; its file stays."),
                       Qt::Key_Delete);
  QAction* fit = add_action("fit", tr("Fit"), tr("Shows all of the image."), Qt::Key_0);
  QAction* actual =
      add_action("actual_size", tr("Actual size"), tr("One pixel on one of the screen."), Qt::Key_1);
  QAction* in =
      add_action("zoom_in", tr("Zoom in"), tr("Also with the wheel, about the pointer."), Qt::Key_Plus);
  QAction* out =
      add_action("zoom_out", tr("Zoom out"), tr("Also with the wheel, about the pointer."), Qt::Key_Minus);
  flip_ = add_action("flip", tr("Flip to B"), tr("Shows B in the place of A until it is pressed again."),
                     Qt::Key_Space);
  flip_->setCheckable(true);
  swap_ = add_action("swap", tr("Swap A and B"), tr("Makes the image the reference."), Qt::Key_X);
  in->setShortcuts({Qt::Key_Plus, Qt::Key_Equal});  // they share a key on many keyboards
  view_actions_ = {fit, actual, in, out};
  comparison_actions_ = {flip_, swap_};
  connect(open_, &QAction::triggered, this, &ImageBrowser::ask_for_files);
  connect(save_, &QAction::triggered, this, &ImageBrowser::ask_for_name);
  connect(copy_, &QAction::triggered, this, &ImageBrowser::copy);
  connect(remove_, &QAction::triggered, this, [this] { remove_image(image_name_); });
  connect(fit, &QAction::triggered, pane_, &ImagePane::fit);
  connect(actual, &QAction::triggered, pane_, &ImagePane::show_actual_size);
  connect(in, &QAction::triggered, pane_, [this] { pane_->zoom_by(2); });
  connect(out, &QAction::triggered, pane_, [this] { pane_->zoom_by(0.5); });
  connect(flip_, &QAction::toggled, this, [this] { show_on_pane(); });
  connect(swap_, &QAction::triggered, this, &ImageBrowser::swap);
}

/// Keys of the view that need no button: they work the controls.
void ImageBrowser::add_keys() {
  const auto add = [this](const QKeySequence& key, const QString& text, const QString& tip,
                          const auto& work) {
    auto* action = new QAction(text, this);
    action->setToolTip(tip);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, work);
    pane_->addAction(action);
  };
  constexpr float Step = 0.5F;
  add(Qt::Key_E, tr("Brighter"), tr("Shows half a stop more"),
      [this] { controls_->set_exposure(controls_->settings().exposure + Step); });
  add(Qt::SHIFT | Qt::Key_E, tr("Darker"), tr("Shows half a stop less"),
      [this] { controls_->set_exposure(controls_->settings().exposure - Step); });
  add(Qt::Key_C, tr("Colour"), tr("Shows all three channels"),
      [this] { controls_->set_channel(ImageChannel::Colour); });
  add(Qt::Key_R, tr("Red"), tr("Shows the red channel"),
      [this] { controls_->set_channel(ImageChannel::Red); });
  add(Qt::Key_G, tr("Green"), tr("Shows the green channel"),
      [this] { controls_->set_channel(ImageChannel::Green); });
  add(Qt::Key_B, tr("Blue"), tr("Shows the blue channel"),
      [this] { controls_->set_channel(ImageChannel::Blue); });
  add(Qt::Key_Y, tr("Luminance"), tr("Shows how bright pixels are"),
      [this] { controls_->set_channel(ImageChannel::Luminance); });
  add(Qt::Key_P, tr("False colour"), tr("Shows luminance as colours"),
      [this] { controls_->set_false_colour(true); });
}

QToolBar* ImageBrowser::make_tools() {
  auto* tools = new QToolBar(this);
  tools->setIconSize({2 * Grid, 2 * Grid});
  tools->addActions({open_, save_, copy_, remove_});
  tools->addSeparator();
  for (QAction* action : view_actions_) tools->addAction(action);
  zoom_ = new QLabel(tr("100 %"), tools);
  zoom_->setAlignment(Qt::AlignCenter);
  zoom_->setFixedWidth(zoom_->fontMetrics().horizontalAdvance(QStringLiteral("00000.0 %")) + Grid);
  zoom_->setToolTip(tr("Pixels of the screen for one of the image."));
  tools->addWidget(zoom_);
  tools->addSeparator();
  tools->addWidget(controls_);
  return tools;
}

QWidget* ImageBrowser::make_comparison_row() {
  auto* tools = new QToolBar(this);
  tools->setIconSize({2 * Grid, 2 * Grid});
  const auto make_list = [&](const QString& name, const QString& help) {
    auto* list = new QComboBox(tools);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(12);
    list->setAccessibleName(name);
    list->setToolTip(help);
    return list;
  };
  image_list_ = make_list(tr("Image A"), tr("The image that is shown."));
  reference_list_ = make_list(tr("Image B"), {});
  comparison_ = make_list(tr("Comparison"), {});
  comparison_->addItems({tr("A alone"), tr("Wipe"), tr("Side by side"), tr("Signed difference"),
                         tr("Absolute difference"), tr("Relative difference")});
  const auto add = [&](const QString& text, QComboBox* list) {
    auto* label = new QLabel(text, tools);
    label->setContentsMargins(Grid, 0, Grid / 2, 0);
    tools->addWidget(label);
    tools->addWidget(list);
  };
  add(tr("A"), image_list_);
  add(tr("B"), reference_list_);
  tools->addActions({swap_, flip_});
  add(tr("Compare"), comparison_);
  connect(image_list_, &QComboBox::textActivated, this, &ImageBrowser::select_image);
  connect(reference_list_, &QComboBox::activated, this,
          [this](int index) { select_reference(reference_list_->itemData(index).toString()); });
  connect(comparison_, &QComboBox::currentIndexChanged, this, [this] { show_selection(); });
  fill_lists();
  return tools;
}

void ImageBrowser::fill_lists() {
  const QSignalBlocker block_images(image_list_);
  const QSignalBlocker block_references(reference_list_);
  image_list_->clear();
  reference_list_->clear();
  reference_list_->addItem(tr("none"), QString());
  for (const ImageEntry& entry : entries_) {
    image_list_->addItem(entry.name);
    reference_list_->addItem(entry.name, entry.name);
  }
}

void ImageBrowser::lay_out() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_tools());
  column->addWidget(make_comparison_row());
  message_row_ = new QWidget(this);
  auto* message = new QHBoxLayout(message_row_);
  message->setContentsMargins(Grid, Grid / 2, Grid, Grid / 2);
  message_ = new QLabel(message_row_);
  message_->setWordWrap(true);
  message_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* hide = new QToolButton(message_row_);
  hide->setIcon(icon("close"));
  hide->setAutoRaise(true);
  hide->setAccessibleName(tr("Hide the message"));
  hide->setToolTip(tr("Hide the message"));
  connect(hide, &QToolButton::clicked, message_row_, &QWidget::hide);
  message->addWidget(message_, 1);
  message->addWidget(hide);
  message_row_->hide();
  colour_message();
  column->addWidget(message_row_);
  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  middle->addWidget(pane_, 1);
  middle->addWidget(scale_bar_);
  column->addLayout(middle, 1);
  values_ = new QLabel(this);
  figures_ = new QLabel(this);
  for (QLabel* line : {values_, figures_}) {
    line->setContentsMargins(Grid, Grid / 2, Grid, line == figures_ ? Grid / 2 : 0);
    line->setTextInteractionFlags(Qt::TextSelectableByMouse);
    line->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addWidget(line);
  }
  values_->setAccessibleName(tr("Values of the pixel"));
  values_->setToolTip(tr("What the pixel under the pointer holds, linear"));
  figures_->setAccessibleName(tr("Figures of the image"));
  figures_->setToolTip(tr("Of the whole image: its range and mean, or how far it is from the other one"));
}

}  // namespace editor
