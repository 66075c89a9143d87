// The accuracy of images in the Render dock: the error of their pixels, and where their noise is from.
#include <QAction>
#include <QHBoxLayout>
#include <QLabel>

#include "editor/controls/actions.h"
#include "editor/controls/form_widgets.h"
#include "editor/image/scale_bar.h"
#include "editor/rendering/fitted_image.h"
#include "editor/rendering/noise_window.h"
#include "editor/rendering/render_panel.h"
#include "editor/rendering/render_settings_row.h"

namespace editor {

void RenderPanel::make_accuracy_actions() {
  error_action_ =
      new_switch(*this,
                 {tr("Show error of pi&xels"),
                  {},
                  QKeySequence("Ctrl+Alt+X"),
                  tr("Show the relative error of the preview's pixels in false colours, as it falls")},
                 false, [this](bool is_shown) {
                   image_->set_error_shown(is_shown);
                   error_scale_->setVisible(is_shown);
                 });
  noise_action_ =
      new_action(*this,
                 {tr("Where is the &noise from…"),
                  {},
                  QKeySequence("Ctrl+Alt+Y"),
                  tr("Measure which lamps, bounces and BRDFs the noise comes from, and what helps")},
                 [this] { show_noise(); });
}

QWidget* RenderPanel::make_picture() {
  auto* picture = new QWidget(this);
  auto* row = tight_layout<QHBoxLayout>(picture, 0);
  image_ = new FittedImage(picture);
  image_->set_hint(tr("Press F5 for a preview that follows your edits, F6 to render the final image"));
  error_scale_ = new ScaleBar(picture);
  error_scale_->setAccessibleName(tr("Scale of the error in the Render dock"));
  error_scale_->set_settings(error_screen_settings());
  error_scale_->hide();
  row->addWidget(image_, 1);
  row->addWidget(error_scale_);
  return picture;
}

QLabel* RenderPanel::make_visible_noise(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setAccessibleName(tr("Visible noise"));
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  label->setToolTip(
      tr("95 % of the pixels differ by less than this from the converged image, in units of CIEDE2000: below "
         "1 "
         "the eye sees no difference. It sees %1 pixels per degree, as on a full HD screen of 24 inches from "
         "63 cm, with the exposure of the render options. Estimated from two halves of the samples")
          .arg(image::Viewing::DefaultPixelsPerDegree));
  return label;
}

void RenderPanel::show_visible_noise(const std::optional<VisibleNoiseReport>& noise) {
  visible_noise_->setText(noise ? visible_noise_text(*noise) : QString());
}

void RenderPanel::show_noise() {
  settings_->commit();
  if (noise_window_ == nullptr) {
    noise_window_ = new NoiseWindow(
        document_, [this] { return final_request(); }, program_, this);
    noise_window_->setAttribute(Qt::WA_DeleteOnClose);
    noise_window_->measure();
  }
  noise_window_->show();
  noise_window_->raise();
  noise_window_->activateWindow();
}

}  // namespace editor
