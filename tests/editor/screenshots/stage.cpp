#include "tests/editor/screenshots/stage.h"

#include <QDockWidget>
#include <QListView>
#include <QSettings>
#include <QSignalSpy>
#include <QThreadPool>
#include <stdexcept>

#include "editor/panels/message_panel.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/environment_store.h"
#include "editor/window/file_actions.h"
#include "editor/window/render_controller.h"
#include "tests/editor/window/window_driver.h"

namespace screenshots {

using editor::DisplayMode;

void expect(bool holds, const QString& what) {
  if (!holds) throw std::runtime_error(what.toStdString());
}

Stage::Stage(QSize size) {
  QSettings().clear();
  qputenv("HOME", folder_.path().c_str());
  window_ = std::make_unique<editor::MainWindow>(QString::fromStdString(folder_.path("sessions")));
  window_->resize(size);
  window_->show();
  window_->activateWindow();
  expect(QTest::qWaitForWindowActive(window_.get()), "the window did not show");
  settle();
}

Stage::~Stage() { window_->document().clear(); }

QString Stage::add(const char* name, const QByteArray& bytes) const {
  return QString::fromStdString(folder_.add(name, bytes.toStdString()));
}

void Stage::open(const QString& file) {
  window_->document().clear();  // avoids the question about unsaved changes
  QSignalSpy replaced(&window_->document(), &editor::Document::scene_replaced);
  window_->files().open(file);
  expect(!replaced.empty() || replaced.wait(Minute), file + " did not open");
  settle();
}

void Stage::act(const QString& name) {
  test::action(*window_, name).trigger();
  settle();
}

void Stage::open_as_rendered(const QString& file) {
  open(file);
  act("Look through the camera");
  draw_as(DisplayMode::Brdf);
}

void Stage::draw_as(DisplayMode mode) {
  QTest::keyClick(window_.get(), static_cast<Qt::Key>(Qt::Key_1 + static_cast<int>(mode)), Qt::AltModifier);
  expect(window_->view().mode() == mode, "the view is drawn in another mode");
  settle();
}

void Stage::orbit(double to_the_right, double upwards, double nearer) {
  editor::ViewCamera camera = window_->view().camera();
  camera.orbit(to_the_right, upwards);
  camera.zoom(nearer, {0, 0}, 1);
  window_->view().move_camera(camera);
  settle();
}

void Stage::select_patch(QPointF place, int rings) {
  const QSize size = window_->view().size();
  QTest::mouseClick(&window_->view(), Qt::LeftButton, {},
                    QPointF(place.x() * size.width(), place.y() * size.height()).toPoint());
  expect(window_->document().selection().count() == 1, "no face is under the pointer");
  for (int ring = 0; ring < rings; ++ring) test::action(*window_, "Grow").trigger();
  settle();
}

void Stage::show_models() {
  open(Samples + "models/models.grf");
  act("Look through the camera");
  orbit(0.35, -0.35, 0.9);
  select_patch({0.307, 0.6}, 6);
}

void Stage::show_brdf(editor::BrdfEditor::View view) {
  window_->brdf_editor().set_view(view);
  settle();
}

QDockWidget& Stage::dock(const QString& name) {
  auto* found = window_->findChild<QDockWidget*>(name);
  editor::Docks::show(found);
  settle();
  return *found;
}

void Stage::hide_docks(const QStringList& names) {
  for (const QString& name : names) window_->findChild<QDockWidget*>(name)->hide();
  settle();
}

void Stage::hide_all_docks() {
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) dock->hide();
  settle();
}

void Stage::show_mistake() {
  open(add("scenes/lamp.grf", R"(// A lamp over a table.
def wood = brdf ward sx=0.2 ks=0.1 kd=(0.4, 0.25, 0.1)
begin
  light begin
    rgb (20, 19, 17)
    (-0.5, 2, -0.5)
    (1, 0, 0)
    (0, 0, 1)
  end

  begin mesh "table"
    brdf wood
    pdf Owm
    begin vertexs
      (-1, 0, 1)
      (1, 0, 1)
      (1, 0, -1)
      (-1, 0, -1)
    end vertexs
    begin faces
      (0, 1, 2, 3)
    end faces
  end mesh
end
)"));
  dock("messages");
  editor::MessagePanel& panel = window_->message_panel();
  expect(QTest::qWaitFor([&] { return panel.error_count() > 0; }, Minute), "the mistake was not found");
  panel.view()->setFocus();
  panel.view()->setCurrentIndex(panel.view()->model()->index(0, 0));
  QTest::keyClick(panel.view(), Qt::Key_Return);
  settle();
}

void Stage::take_settings(QSize size, int samples) {
  options::RenderOptions few = window_->document().options().valid_options();
  few.size = {size.width(), size.height()};
  few.samples = samples;
  window_->document().options().set_options("Take settings", few);
}

void Stage::preview(QSize size, int samples) {
  take_settings(size, samples);
  bool is_done = false;
  const auto watched =
      QObject::connect(&window_->render_panel().preview(), &editor::Preview::state_changed,
                       [&](job::PreviewState state) { is_done = state == job::PreviewState::Done; });
  window_->render_panel().preview_action()->trigger();
  expect(QTest::qWaitFor([&] { return is_done; }, 5 * Minute), "the preview did not end");
  QObject::disconnect(watched);
  settle();
}

void Stage::render(QSize size, int samples) {
  take_settings(size, samples);
  QSignalSpy finished(&window_->render_panel().final_render(), &editor::FinalRender::finished);
  window_->render_panel().render_action()->trigger();
  expect(!finished.empty() || finished.wait(5 * Minute), "the render did not end");
  settle();
}

void Stage::settle() {
  const auto is_idle = [this] {
    const bool is_drawn = window_->view().is_complete() || !window_->view().isVisible();
    return is_drawn && window_->environment().is_complete() &&
           QThreadPool::globalInstance()->activeThreadCount() == 0 &&
           !window_->brdf_editor().lobe().is_busy() && !window_->brdf_editor().sphere().is_busy();
  };
  // Finished work may start more work.
  for (int turn = 0; turn < 5; ++turn) {
    QTest::qWait(20);
    expect(QTest::qWaitFor(is_idle, 5 * Minute), "the window has work without an end");
  }
}

}  // namespace screenshots
