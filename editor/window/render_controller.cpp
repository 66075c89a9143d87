#include "editor/window/render_controller.h"

#include <QAction>
#include <QMenu>
#include <QToolBar>

#include "editor/controls/actions.h"
#include "editor/document/render_camera.h"
#include "editor/options/options_window.h"
#include "editor/panels/camera_panel.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/scene_view.h"

namespace editor {

using options::RenderOptions;

namespace {

RenderOptions with_camera(const OpDocument& document, const transport::View& camera) {
  RenderOptions now = document.valid_options();
  place_render_camera(now, camera);
  return now;
}

double aspect_of(const RenderOptions& render_options) {
  return static_cast<double>(render_options.size.width) / render_options.size.height;
}

}  // namespace

RenderController::RenderController(Document& document, SceneView& view, RenderPanel& panel,
                                   CameraPanel& cameras, QWidget& window)
    : QObject(&window), document_(document), view_(view), panel_(panel) {
  make_actions(window);
  connect(&document_, &Document::scene_replaced, this, &RenderController::take_scene);
  connect(&document_.options(), &OpDocument::changed, this, &RenderController::show_camera);
  connect(&panel_, &RenderPanel::options_requested, this, &RenderController::show_options);
  connect(&view_, &SceneView::camera_moved, this, &RenderController::follow_view);
  connect(&cameras, &CameraPanel::add_requested, this,
          [this, &cameras] { cameras.add(view_.camera().view()); });
  connect(&cameras, &CameraPanel::place_requested, this,
          [this, &cameras] { cameras.place(view_.camera().view()); });
  connect(&cameras, &CameraPanel::look_requested, this,
          [this](const transport::View& camera) { view_.set_camera(ViewCamera(camera)); });
  connect(&cameras, &CameraPanel::render_camera_chosen, follow_, [this] { follow_->setChecked(false); });
}

RenderController::~RenderController() = default;

OptionsWindow* RenderController::options_window() const { return options_window_; }

void RenderController::make_actions(QWidget& window) {
  follow_ = new_switch(window,
                       {tr("Camera follows &the view"), "follow", QKeySequence("Ctrl+Alt+F"),
                        tr("Lock the render camera to the 3D view")},
                       true, [this](bool) {
                         follow_view();
                         show_camera();
                       });
  from_view_ = new_action(window,
                          {tr("Align &camera to view"), "camera", QKeySequence("Ctrl+Alt+0"),
                           tr("Move the render camera to the viewpoint of the 3D view")},
                          [this] {
                            follow_->setChecked(false);
                            move_camera(view_.camera().view());
                          });
  look_through_ = new_action(window,
                             {tr("Loo&k through the camera"),
                              {},
                              QKeySequence("Ctrl+0"),
                              tr("View the scene through the render camera")},
                             [this] { view_.set_camera(ViewCamera(camera())); });
  framing_ = new_switch(window,
                        {tr("Framing guides"),
                         {},
                         QKeySequence("Ctrl+Alt+G"),
                         tr("Draw the border of the rendered image and its thirds over the 3D view")},
                        false, [this](bool) { show_camera(); });
}

void RenderController::fill(QMenu& menu) { menu.addActions({follow_, from_view_, look_through_, framing_}); }

void RenderController::fill(QToolBar& bar) { bar.addActions({follow_, from_view_}); }

transport::View RenderController::camera() const { return render_camera(document_); }

void RenderController::move_camera(const transport::View& camera) {
  panel_.set_view(camera);
  document_.options().set_options(tr("Move the camera"), with_camera(document_.options(), camera), "camera");
  document_.finish_gesture();
}

/// The 3D view of an opened scene starts at its render camera; for other scenes the camera is that of the
/// view.
void RenderController::take_scene() {
  const bool has_camera = document_.options().valid_options().eye.has_value();
  follow_->setChecked(!has_camera);
  if (has_camera) {
    view_.set_camera(ViewCamera(camera()));
  } else {
    view_.frame_all();
  }
  follow_view();
  show_camera();
}

void RenderController::show_camera() {
  view_.set_framing(framing_->isChecked() ? std::optional(aspect_of(document_.options().valid_options()))
                                          : std::nullopt);
  if (follow_->isChecked() || document_.objects().faces == 0) return view_.set_render_camera({});
  view_.set_render_camera(camera(), aspect_of(document_.options().valid_options()));
}

void RenderController::follow_view() {
  if (!follow_->isChecked() || document_.objects().faces == 0) return;
  const transport::View camera = view_.camera().view();
  panel_.set_view(camera);
  document_.options().follow(with_camera(document_.options(), camera));
}

void RenderController::show_options() {
  if (options_window_ == nullptr) {
    options_window_ = new OptionsWindow(&document_.options(), qobject_cast<QWidget*>(parent()));
    options_window_->setWindowFlag(Qt::Window);
    options_window_->setAttribute(Qt::WA_DeleteOnClose);
  }
  options_window_->show();
  options_window_->raise();
  options_window_->activateWindow();
}

}  // namespace editor
