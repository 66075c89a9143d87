#include "editor/window/render_link.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QToolBar>
#include <QUndoCommand>
#include <utility>

#include "editor/document/light_edits.h"
#include "editor/options/options_window.h"
#include "editor/rendering/render_files.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/scene_view.h"
#include "editor/window/actions.h"

namespace editor {

using options::RenderOptions;

namespace {

double aspect_of(const RenderOptions& render_options) {
  return static_cast<double>(render_options.size.width) / render_options.size.height;
}

/// Radiance of the sky over a scene in which nothing emits.
const grf::Vec3f PlainSky = grf::Vec3f(0.7F);

}  // namespace

class RenderLink::OptionsCommand : public QUndoCommand {
 public:
  OptionsCommand(RenderLink& link, RenderOptions before, RenderOptions after, const QString& text,
                 QString key)
      : QUndoCommand(text),
        link_(&link),
        before_(std::move(before)),
        after_(std::move(after)),
        key_(std::move(key)) {}

  int id() const override { return 3; }
  void undo() override {
    if (link_) link_->apply(before_);
  }
  void redo() override {
    if (link_) link_->apply(after_);
  }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& later = static_cast<const OptionsCommand&>(*other);
    if (key_.isEmpty() || key_ != later.key_) return false;
    after_ = later.after_;
    return true;
  }

 private:
  QPointer<RenderLink> link_;
  RenderOptions before_;
  RenderOptions after_;
  QString key_;
};

RenderLink::RenderLink(Document& document, SceneView& view, RenderPanel& panel, QWidget& window)
    : QObject(&window), document_(document), view_(view), panel_(panel), options_(panel.options()) {
  make_actions(window);
  connect(&document_, &Document::taken, this, &RenderLink::take_scene);
  connect(&document_, &Document::changed, this, [this] {
    take_plain_sky();
    panel_.set_scene(document_.scene(), document_.path());
  });
  connect(&document_, &Document::path_changed, this,
          [this] { panel_.set_scene(document_.scene(), document_.path()); });
  connect(&document_, &Document::saved, this, &RenderLink::save_options);
  connect(&panel_, &RenderPanel::options_changed, this, [this](const RenderOptions& now) {
    if (!is_taking_ && !(now == options_)) change(now, tr("Change render options"), {});
  });
  connect(&panel_, &RenderPanel::options_requested, this, &RenderLink::show_options);
  connect(&view_, &SceneView::camera_moved, this, &RenderLink::follow_view);
}

RenderLink::~RenderLink() = default;

OptionsWindow* RenderLink::options_window() const { return options_window_; }

void RenderLink::make_actions(QWidget& window) {
  follow_ = new_switch(window,
                       {tr("Camera &follows the view"), "follow", QKeySequence("Ctrl+Alt+F"),
                        tr("Previews and renders see what the 3D view sees")},
                       true, [this](bool) {
                         follow_view();
                         show_camera();
                       });
  from_view_ = new_action(window,
                          {tr("&Camera from the view"), "camera", QKeySequence("Ctrl+Alt+0"),
                           tr("Places the camera of renders where the 3D view is seen from")},
                          [this] {
                            follow_->setChecked(false);
                            move_camera(view_.camera().view(), true);
                          });
  look_through_ = new_action(
      window,
      {tr("&Look through the camera"), {}, QKeySequence("Ctrl+0"), tr("Sees the scene as renders do")},
      [this] { view_.set_camera(ViewCamera(camera())); });
}

void RenderLink::fill(QMenu& menu) { menu.addActions({follow_, from_view_, look_through_}); }

void RenderLink::fill(QToolBar& bar) { bar.addActions({follow_, from_view_}); }

transport::View RenderLink::camera() const {
  const RenderOptions& now = panel_.options();
  auto view =
      transport::view_of(document_.objects().bounds, now.field_of_view, static_cast<float>(aspect_of(now)));
  view.up = now.up;
  if (now.viewer) view.eye = grf::Vec3d(*now.viewer);
  if (now.target) view.target = grf::Vec3d(*now.target);
  return view;
}

void RenderLink::move_camera(const transport::View& camera, bool is_done) {
  RenderOptions now = options_;
  now.viewer = grf::Vec3f(camera.eye);
  now.target = grf::Vec3f(camera.target);
  now.up = camera.up;
  now.field_of_view = camera.field_of_view;
  change(now, tr("Move the camera"), "camera");
  panel_.set_view(camera);
  if (is_done) document_.finish_gesture();
}

/// The 3D view of a scene that was opened begins where its camera is; of others the camera is the view's.
void RenderLink::take_scene() {
  is_taking_ = true;
  panel_.open_scene(document_.scene(), document_.path());
  is_taking_ = false;
  options_ = panel_.options();
  are_options_saved_ = true;
  const bool has_camera = options_.viewer.has_value();
  follow_->setChecked(!has_camera);
  if (has_camera) {
    view_.set_camera(ViewCamera(camera()));
  } else {
    view_.frame_all();
  }
  give_plain_sky();
  follow_view();
  show_camera();
}

/// A model without lights would be black.
void RenderLink::give_plain_sky() {
  const bool is_dark = emitters_of(document_.objects()).empty() && options_.environment.empty() &&
                       options_.background == grf::Vec3f(0) && document_.objects().faces > 0;
  const bool has_options = !document_.path().isEmpty() && QFileInfo::exists(op_file_beside(document_.path()));
  has_plain_sky_ = is_dark && !has_options;
  if (!has_plain_sky_) return;
  options_.background = PlainSky;
  panel_.set_options(options_);
  emit lit_by_a_plain_sky();
}

void RenderLink::take_plain_sky() {
  if (!has_plain_sky_ || options_.background != PlainSky || emitters_of(document_.objects()).empty()) return;
  has_plain_sky_ = false;
  options_.background = grf::Vec3f(0);
  panel_.set_options(options_);
}

void RenderLink::change(const RenderOptions& now, const QString& text, const QString& key) {
  are_options_saved_ = false;
  document_.undo_stack().push(new OptionsCommand(*this, options_, now, text, key));
}

void RenderLink::apply(const RenderOptions& render_options) {
  options_ = render_options;
  are_options_saved_ = false;
  if (!(panel_.options() == render_options)) panel_.set_options(render_options);
  show_camera();
}

void RenderLink::show_camera() {
  if (follow_->isChecked() || document_.objects().faces == 0) return view_.set_render_camera({});
  view_.set_render_camera(camera(), aspect_of(panel_.options()));
}

void RenderLink::follow_view() {
  if (!follow_->isChecked() || document_.objects().faces == 0) return;
  panel_.set_view(view_.camera().view());
  options_ = panel_.options();
}

/// Together with the scene, so that nothing is lost; what is not of this editor stays as it is in the file.
void RenderLink::save_options() {
  if (are_options_saved_) return;
  if (panel_.write_op_file()) {
    are_options_saved_ = true;
  } else {
    emit told(tr("The options could not be written: the log of the render says why"));
  }
}

void RenderLink::show_options() {
  if (options_window_ == nullptr) {
    options_window_ = new OptionsWindow(qobject_cast<QWidget*>(parent()));
    options_window_->setWindowFlag(Qt::Window);
    options_window_->setAttribute(Qt::WA_DeleteOnClose);
    const QString path = document_.path().isEmpty() ? QString() : op_file_beside(document_.path());
    OpDocument& text = options_window_->editor().document();
    if (path.isEmpty() || !QFileInfo::exists(path) || !options_window_->editor().open(path)) {
      grf::Diagnostics unheard;  // there is no text yet that could be wrong
      text.start(op_text_of(options_, path, {}, unheard).value_or(std::string()), path);
    }
    connect(&options_window_->editor(), &OptionsEditor::edited, this, [this](RenderOptions now) {
      now.scene = options_.scene;
      if (!(now == options_)) change(now, tr("Change render options"), "options window");
    });
  }
  options_window_->show();
  options_window_->raise();
  options_window_->activateWindow();
}

}  // namespace editor
