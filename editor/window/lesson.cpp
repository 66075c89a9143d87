#include "editor/window/lesson.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "editor/brdf/brdf_editor.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/scene_view.h"
#include "editor/window/lesson_guide.h"
#include "editor/window/main_window.h"
#include "editor/window/sample_scenes.h"

namespace editor {
namespace {

using Begin = std::function<std::function<bool()>(MainWindow&)>;
using Target = std::function<LessonTarget(MainWindow&)>;

LessonTarget the_view(MainWindow& window) {
  window.show_scene();
  return {&window.view()};
}

/// A dock by its name in the settings, which is shown.
Target dock(const char* name) {
  return [name](MainWindow& window) -> LessonTarget {
    auto* found = window.findChild<QDockWidget*>(name);
    Docks::show(found);
    return {found};
  };
}

/// The entry of a menu in the menu bar. The function returns its title when the language is known.
Target menu(QString (*title)()) {
  return [title](MainWindow& window) -> LessonTarget {
    for (QAction* entry : window.menuBar()->actions()) {
      if (entry->text() == title()) return {window.menuBar(), window.menuBar()->actionGeometry(entry)};
    }
    return {window.menuBar()};
  };
}

Begin when_camera_moves() {
  return [](MainWindow& window) {
    return [&view = window.view(), before = window.view().camera()] { return !(view.camera() == before); };
  };
}

/// True once at least so many faces are selected that were not before.
Begin when_faces_are_selected(std::size_t least) {
  return [least](MainWindow& window) {
    return [&document = window.document(), before = window.document().selection().count(), least] {
      const std::size_t now = document.selection().count();
      return now >= least && now != before;
    };
  };
}

/// True after an edit, but not after an undo.
Begin when_scene_is_edited() {
  return [](MainWindow& window) {
    return [&stack = window.document().undo_stack(), before = window.document().undo_stack().index()] {
      return stack.index() > before;
    };
  };
}

Begin when_meshes_are_added(std::size_t least) {
  return [least](MainWindow& window) {
    return [&document = window.document(), before = window.document().objects().meshes.size(), least] {
      return document.objects().meshes.size() >= before + least;
    };
  };
}

Lesson look_around() {
  return {LessonGuide::tr("Look around"),
          LessonGuide::tr("Orbit, zoom, select faces and see what they are made of"),
          true,
          {{LessonGuide::tr("Drag with the middle mouse button to orbit, with Shift to pan. The arrow keys "
                            "do the same."),
            the_view, when_camera_moves()},
           {LessonGuide::tr("Turn the wheel to zoom about the pointer. The keys + and - zoom, too."),
            the_view, when_camera_moves()},
           {LessonGuide::tr("Click a face of the model to select it. A drag from a face selects all faces in "
                            "a box; Shift adds, Ctrl removes."),
            the_view, when_faces_are_selected(1)},
           {LessonGuide::tr("This is the surface of the selected faces: BRDF, colour, texture, emitted light "
                            "and normals. Point at a field to read what it means, then press Next."),
            dock("surface"),
            {}},
           {LessonGuide::tr("Press F in the view to frame the selected faces, and Home to frame the whole "
                            "scene."),
            the_view, when_camera_moves()}}};
}

Lesson assign_brdfs() {
  return {LessonGuide::tr("Change a material"),
          LessonGuide::tr("Give faces another BRDF, adjust its parameters, and take it back"),
          true,
          {{LessonGuide::tr("Click a face in the view."), the_view, when_faces_are_selected(1)},
           {LessonGuide::tr("Press Ctrl+M to select the whole mesh: the menu Select has this and many other "
                            "ways to select."),
            menu([] { return MainWindow::tr("&Select"); }), when_faces_are_selected(2)},
           {LessonGuide::tr("Open Library in the BRDF dock, and double-click a BRDF to assign it to the "
                            "selected faces."),
            dock("brdf"), when_scene_is_edited()},
           {LessonGuide::tr("Drag a slider of the BRDF's parameters. The sphere, the lobe, the plots and the "
                            "view follow it."),
            dock("brdf"), when_scene_is_edited()},
           {LessonGuide::tr("Press Ctrl+Z to undo the last change. The History dock lists all of them."),
            menu([] { return MainWindow::tr("&Edit"); }), [](MainWindow& window) {
              return [&stack = window.document().undo_stack(),
                      before = window.document().undo_stack().index()] { return stack.index() < before; };
            }}}};
}

Lesson light_a_scene() {
  return {LessonGuide::tr("Light a scene"),
          LessonGuide::tr("Add a shape and a studio, and watch the path-traced preview while a light moves"),
          false,
          {{LessonGuide::tr("Choose Scene > Add a sphere. A model that is dropped on the window will do, "
                            "too."),
            menu([] { return MainWindow::tr("S&cene"); }), when_meshes_are_added(1)},
           {LessonGuide::tr("Choose Scene > Add a studio: a floor, a soft box and a rim light in proportion "
                            "to what is there."),
            menu([] { return MainWindow::tr("S&cene"); }), when_scene_is_edited()},
           {LessonGuide::tr("Press F5 to start the preview, which follows each edit."), dock("render"),
            [](MainWindow& window) {
              return [&preview = window.render_panel().preview()] { return preview.is_on(); };
            }},
           {LessonGuide::tr("Select a light in the list, and change its power, its size or where it is. Aim "
                            "points it at what you click."),
            dock("lights"), when_scene_is_edited()}}};
}

Lesson render_to_an_error() {
  return {LessonGuide::tr("Render as accurately as you need"),
          LessonGuide::tr("Know what an error costs in time before the render, and choose one"),
          true,
          {{LessonGuide::tr("Save the scene in a folder of your own by File > Save as: the image is written "
                            "beside it."),
            menu([] { return MainWindow::tr("&File"); }),
            [](MainWindow& window) {
              return [&document = window.document()] {
                return !document.path().isEmpty() && !document.path().startsWith(samples_folder() + '/') &&
                       !document.is_modified();
              };
            }},
           {LessonGuide::tr("The Render dock forecasts how long the image takes until its error is 5, 2 or "
                            "1 %, from a short probe. Wait until the times are there, and click one of them "
                            "to take it as the target."),
            dock("render"),
            [](MainWindow& window) {
              return [&options = window.document().options(),
                      before = window.document().options().valid_options().target_error] {
                return options.valid_options().target_error != before;
              };
            }},
           {LessonGuide::tr("Press F6 to render. The dock shows the estimated error, and the image so far."),
            dock("render"),
            [](MainWindow& window) {
              return [&render = window.render_panel().final_render()] { return render.is_running(); };
            }},
           {LessonGuide::tr("Open Images by Ctrl+7 to see the image, its error and its layers, and to "
                            "compare it with the render before."),
            menu([] { return MainWindow::tr("&Window"); }),
            {}}}};
}

}  // namespace

std::vector<Lesson> lessons() {
  return {look_around(), assign_brdfs(), light_a_scene(), render_to_an_error()};
}

}  // namespace editor
