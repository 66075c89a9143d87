// Pictures for a review of alignment, legibility and hints.
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QPainter>
#include <QSettings>
#include <QTest>
#include <algorithm>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/image/image_browser.h"
#include "editor/image/image_window.h"
#include "editor/options/options_window.h"
#include "editor/panels/surface_panel.h"
#include "editor/view/scene_view.h"
#include "editor/window/export_dialog.h"
#include "editor/window/import_dialog.h"
#include "editor/window/viewer_window.h"
#include "tests/editor/screenshots/pictures.h"
#include "tests/editor/screenshots/stage.h"
#include "tests/editor/window/window_driver.h"

namespace screenshots {
namespace {

using editor::BrdfEditor;
using editor::DisplayMode;
using editor::Grid;

constexpr std::pair<BrdfEditor::View, const char*> BrdfViews[] = {{BrdfEditor::View::Sphere, "sphere"},
                                                                  {BrdfEditor::View::Lobe, "lobe"},
                                                                  {BrdfEditor::View::Plots, "plots"},
                                                                  {BrdfEditor::View::Library, "library"}};

/// The BRDF dock in each of its views, and enlarged, with all of them.
void take_brdf_dock(Stage& stage, const QString& suffix, const Take& take) {
  for (const auto& [view, name] : BrdfViews) {
    stage.show_brdf(view);
    take(QString("brdf_%1%2").arg(name, suffix), stage.dock("brdf").grab());
  }
}

void take_unfolded_brdf(Stage& stage, const QString& name, const Take& take) {
  QDockWidget& dock = stage.dock("brdf");
  dock.setFloating(true);
  dock.resize(150 * Grid, 90 * Grid);
  stage.settle();
  take(name, dock.grab());
  dock.setFloating(false);
  stage.settle();
}

void docks(const Take& take) {
  Stage stage;
  stage.show_models();
  take("window", stage.picture());
  for (const char* name : {"scene", "lights", "surface"}) take(name, stage.dock(name).grab());
  take_brdf_dock(stage, "", take);
  take_unfolded_brdf(stage, "brdf_unfolded", take);
  stage.hide_docks({"brdf"});
  take("surface_whole", stage.dock("surface").grab());
  stage.hide_docks({"surface"});
  take("brdf_whole", stage.dock("brdf").grab());
}

void small_window(const Take& take) {
  Stage stage({1024, 768});
  stage.show_models();
  take("window_small", stage.picture());
  stage.dock("render");
  take("window_small_render", stage.picture());
}

/// Without a scene, and without a selection.
void empty(const Take& take) {
  Stage stage;
  take("window_empty", stage.picture());
  for (const char* name : {"scene", "lights", "surface"})
    take(QString("%1_empty").arg(name), stage.dock(name).grab());
  take_brdf_dock(stage, "_empty", take);
  for (const char* name : {"render", "messages", "jobs"})
    take(QString("%1_empty").arg(name), stage.dock(name).grab());
  stage.window().image_browser();
  stage.settle();
  take("images_empty", stage.picture());
}

/// A running render, a queued one, and a save.
void jobs(const Take& take) {
  Stage stage;
  stage.open(Samples + "cornell_box/cornell_box.grf");
  editor::JobList& jobs = stage.window().jobs();
  const auto render = [](editor::Job& job) { job.show_progress(0.43, 75); };
  jobs.add({"Render cornell_box.exr", "pictures", render, {}, "Stop this render and keep its image"});
  jobs.add({"Render cornell_box_large.exr", "pictures", render, {}, "Stop this render and keep its image"});
  jobs.add({"Save cornell_box.grf", "files", [](editor::Job&) {}, {}, {}});
  QTest::qWait(300);  // until the status line shows it
  take("jobs", stage.dock("jobs").grab());
  take("jobs_window", stage.picture());
}

void lights(const Take& take) {
  Stage stage;
  stage.open(Samples + "cornell_box/cornell_box.grf");
  take("scene_unselected", stage.dock("scene").grab());
  take("surface_unselected", stage.dock("surface").grab());
  take("lights_unselected", stage.dock("lights").grab());
  auto& list = *stage.dock("lights").findChild<QAbstractItemView*>();
  list.setCurrentIndex(list.model()->index(0, 0));
  stage.settle();
  take("lights_selected", stage.dock("lights").grab());
}

void render(const Take& take) {
  Stage stage;
  const auto copy = [&stage](const QString& name) {
    QFile file(Samples + "cornell_box/" + name);
    expect(file.open(QIODevice::ReadOnly), name + " cannot be read");
    return stage.add(qPrintable("scenes/" + name), file.readAll());
  };
  copy("cornell_box.op");
  stage.open_as_rendered(copy("cornell_box.grf"));
  stage.preview({320, 320}, 16);
  take("render_preview", stage.dock("render").grab());
  stage.render({320, 320}, 16);
  take("render_final", stage.dock("render").grab());
  take("render_window", stage.picture());
}

void mistakes(const Take& take) {
  Stage stage({1280, 800});
  stage.show_mistake();
  take("source", stage.picture());
  take("messages", stage.dock("messages").grab());
  stage.hide_docks({"messages"});
  take("surface_mistake", stage.dock("surface").grab());
  const std::pair<const char*, const char*> wrong[] = {{"range", "ward sx=-2"},
                                                       {"name", "ward roughness=0.2"},
                                                       {"model", "wrad"},
                                                       {"file", "measured \"gone.binary\""}};
  for (const auto& [name, brdf] : wrong) {
    stage.open(stage.add("scenes/wrong.grf",
                         QByteArray("begin mesh \"table\"\n  brdf ") + brdf +
                             "\n  begin vertexs\n    (-1, 0, 1)\n    (1, 0, 1)\n    (1, 0, -1)\n  "
                             "end\n  begin faces\n    (0, 1, 2)\n  end\nend\n"));
    test::action(stage.window(), "All").trigger();
    stage.settle();
    take_brdf_dock(stage, QString("_mistake_%1").arg(name), take);
    take(QString("surface_mistake_%1").arg(name), stage.dock("surface").grab());
  }
}

void images(const Take& take) { take("images", compared_images()); }

/// A dialog, once the pictures and lists in it are complete.
QPixmap dialog_picture(QDialog& dialog) {
  dialog.show();
  expect(QTest::qWaitForWindowExposed(&dialog), "the dialog did not show");
  for (const auto* view : dialog.findChildren<editor::SceneView*>()) {
    expect(QTest::qWaitFor([view] { return view->is_complete(); }, Minute), "the model is not drawn");
  }
  QTest::qWait(500);
  return dialog.grab();
}

void dialogs(const Take& take) {
  editor::SceneLoader loader;
  std::shared_ptr<const editor::LoadedScene> loaded;
  QObject::connect(&loader, &editor::SceneLoader::loaded, &loader,
                   [&loaded](const auto& scene) { loaded = scene; });
  loader.start("/usr/share/assimp/models/OBJ/spider.obj");
  expect(QTest::qWaitFor([&loaded] { return loaded != nullptr; }, Minute), "the model was not read");
  editor::ImportDialog import(loaded, nullptr);
  take("import_dialog", dialog_picture(import));
  editor::Document document;
  document.take_import(loaded->model);
  QSettings().setValue("export/format", "stl");
  editor::ExportDialog exporting(editor::export_request(document), "spider", nullptr);
  take("export_dialog", dialog_picture(exporting));
}

void windows(const Take& take) {
  take("options", option_window());
  take("viewer", viewer_window());
  const auto shown = [](QWidget& window) {
    window.show();
    expect(QTest::qWaitForWindowExposed(&window), "the window did not show");
    QTest::qWait(100);
    return window.grab();
  };
  editor::ViewerWindow viewer;
  take("viewer_empty", shown(viewer));
  editor::OptionsWindow options;
  take("options_empty", shown(options));
  editor::ImageWindow images;
  take("image_window_empty", shown(images));
  take("shortcuts", shortcut_list());
}

/// The study tools, each with the states of the sample studies.
void studies(const Take& take) {
  for (const QFileInfo& file : QDir(Samples + "studies/tools").entryInfoList({"*.study"}, QDir::Files)) {
    take("study_" + file.completeBaseName(), study_window(file.filePath()));
  }
}

/// All display modes of one scene with data for each.
void modes(const Take& take) {
  Stage stage({1280, 800});
  stage.hide_all_docks();
  stage.open(Samples + "garden/garden.grf");
  stage.act("Look through the camera");
  const char* const names[] = {"points",   "wireframe",      "solid",      "solid_with_edges",
                               "textured", "vertex_colours", "irradiance", "brdf"};
  for (int mode = 0; mode < 8; ++mode) {
    stage.draw_as(static_cast<DisplayMode>(mode));
    take(QString("mode_%1").arg(names[mode]), stage.picture());
  }
}

/// Each control of a window with the focus, on one sheet.
QPixmap focused_controls(Stage& stage) {
  constexpr QSize Largest(44 * Grid, 16 * Grid);
  constexpr int Margin = Grid / 2;
  QPixmap sheet(QSize(1280, 1000) * stage.window().devicePixelRatioF());
  sheet.setDevicePixelRatio(stage.window().devicePixelRatioF());
  sheet.fill(QApplication::palette().color(QPalette::Window));
  QPainter painter(&sheet);
  QPoint place(Grid, Grid);
  int height = 0;
  stage.window().setAttribute(Qt::WA_KeyboardFocusChange);  // as after Tab
  for (auto* each : stage.window().findChildren<QWidget*>()) {
    const bool is_part = each->parentWidget()->focusProxy() == each ||
                         qobject_cast<QAbstractSpinBox*>(each->parentWidget()) != nullptr;
    const bool takes_focus =
        each->isVisible() && each->isEnabled() && (each->focusPolicy() & Qt::TabFocus) != 0;
    if (is_part || !takes_focus) continue;
    each->setFocus(Qt::TabFocusReason);
    QTest::qWait(1);
    const QRect part(each->mapTo(&stage.window(), QPoint()), each->size().boundedTo(Largest));
    const QPixmap picture = stage.window().grab(part.adjusted(-Margin, -Margin, Margin, Margin));
    if (place.x() + part.width() + 4 * Grid > 1280) {
      place = {Grid, place.y() + height + Grid};
      height = 0;
    }
    painter.drawPixmap(place, picture);
    place.rx() += part.width() + 2 * Grid;
    height = std::max(height, part.height() + Grid);
  }
  return sheet;
}

void focus(const Take& take) {
  Stage stage;
  stage.show_models();
  stage.hide_docks({"surface"});
  for (const auto& [view, name] : BrdfViews) {
    stage.show_brdf(view);
    take(QString("focus_brdf_%1").arg(name), focused_controls(stage));
    stage.hide_docks({"scene", "lights"});
  }
  stage.hide_docks({"brdf"});
  stage.dock("surface");
  stage.dock("render");
  take("focus_surface", focused_controls(stage));
}

}  // namespace

std::vector<ReviewGroup> review_groups() {
  return {{"docks", docks},     {"small", small_window}, {"empty", empty},       {"jobs", jobs},
          {"lights", lights},   {"render", render},      {"mistakes", mistakes}, {"images", images},
          {"dialogs", dialogs}, {"windows", windows},    {"studies", studies},   {"modes", modes},
          {"focus", focus}};
}

}  // namespace screenshots
