// A view in a window, and helpers for its tests.
#pragma once

#include <QApplication>
#include <QTest>
#include <memory>
#include <string>
#include <vector>

#include "editor/view/scene_view.h"
#include "grf/read.h"
#include "tests/editor/pointer.h"

namespace test {

/// Waits until the condition holds, or for so many seconds; returns whether it does.
template <class Condition>
bool wait_for(const Condition& condition, int seconds = 120) {
  return QTest::qWaitFor(condition, seconds * 1000);
}

inline editor::SceneObjects objects_of_text(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text, "scene.grf", diagnostics);
  return scene ? editor::objects_of(*scene, "scene.grf") : editor::SceneObjects();
}

inline editor::SceneObjects objects_of_file(const std::string& path) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read(path, diagnostics);
  return scene ? editor::objects_of(*scene, path) : editor::SceneObjects();
}

/// A cube about the origin with sides of 2, each in a colour of its own: front, back, right, left, top,
/// bottom.
inline std::string cube_text(const std::string& attributes = {}) {
  return "begin mesh \"cube\" " + attributes + R"(
    begin vertices
      uv (0,0) (-1,-1,1) uv (1,0) (1,-1,1) uv (1,1) (1,1,1) uv (0,1) (-1,1,1)
      uv (1,0) (-1,-1,-1) uv (0,0) (1,-1,-1) uv (0,1) (1,1,-1) uv (1,1) (-1,1,-1)
    end vertices
    begin faces
      rgb (0.8,0.2,0.2) 4 (0,1,2,3)
      rgb (0.2,0.8,0.2) 4 (5,4,7,6)
      rgb (0.2,0.2,0.8) 4 (1,5,6,2)
      rgb (0.8,0.8,0.2) 4 (4,0,3,7)
      rgb (0.2,0.8,0.8) 4 (3,2,6,7)
      rgb (0.8,0.2,0.8) 4 (4,5,1,0)
    end faces
  end mesh
)";
}

/// A camera in front of the origin that sees the whole scene.
inline editor::ViewCamera front_camera(double distance = 8) {
  transport::View view;
  view.eye = grf::Vec3d(0, 0, distance);
  view.target = grf::Vec3d(0);
  view.field_of_view = 40;
  return editor::ViewCamera(view);
}

/// A view of 800 x 600 pixels.
class ShownView {
 public:
  explicit ShownView(const editor::SceneObjects& objects, const editor::ViewCamera& camera = front_camera(),
                     const editor::GraphicsDriver& driver = {})
      : view(nullptr, driver) {
    view.resize(800, 600);
    view.set_camera(camera);
    view.set_grid(false);
    view.show(std::make_shared<const editor::SceneObjects>(objects));
    view.show();
    is_shown = QTest::qWaitForWindowExposed(&view) && complete();
  }

  bool complete() {
    QTest::qWait(0);  // what is on its way to the view arrives
    return wait_for([this] { return view.is_complete(); });
  }

  QPoint pixel_of(const grf::Vec3d& point) const {
    const auto place = view.camera().place_of(point, double(view.width()) / view.height());
    return {int((0.5 + 0.5 * place->x) * view.width()), int((0.5 - 0.5 * place->y) * view.height())};
  }

  void drag(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const std::vector<QPoint>& way) {
    QTest::mousePress(&view, button, modifiers, way.front());
    for (const QPoint& point : way) move(point, button, modifiers);
    QTest::mouseRelease(&view, button, modifiers, way.back());
    wait_for([this] { return !view.is_selecting(); });
  }

  void move(const QPoint& point, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    test::move_pointer(view, point, button, modifiers);
  }

  editor::SceneView view;
  bool is_shown = false;
};

}  // namespace test
