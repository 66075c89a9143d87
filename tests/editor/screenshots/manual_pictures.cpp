// The pictures of the editor's manual: the real window in the states that the manual describes.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>
#include <QTreeWidget>
#include <utility>

#include "editor/appearance/theme.h"
#include "editor/controls/text.h"
#include "editor/image/image_browser.h"
#include "editor/image/screen_controls.h"
#include "editor/options/options_window.h"
#include "editor/panels/camera_panel.h"
#include "editor/panels/face_query_dialog.h"
#include "editor/panels/scene_tree.h"
#include "editor/panels/texture_row.h"
#include "editor/panels/uv_panel.h"
#include "editor/panels/uv_view.h"
#include "editor/rendering/cost_page.h"
#include "editor/rendering/effects_page.h"
#include "editor/rendering/forecast_row.h"
#include "editor/rendering/noise_window.h"
#include "editor/rendering/render_panel.h"
#include "editor/tools/tool_windows.h"
#include "editor/window/file_actions.h"
#include "editor/window/risk_dialog.h"
#include "editor/window/viewer_window.h"
#include "editor/window/welcome_controller.h"
#include "grf/text_file.h"
#include "tests/editor/screenshots/pictures.h"
#include "tests/editor/screenshots/stage.h"
#include "tests/editor/window/window_driver.h"

namespace screenshots {
namespace {

using editor::BrdfEditor;
using editor::DisplayMode;

const QString Bunny = "/usr/share/glmark2/models/bunny.obj";

QPixmap window_with(BrdfEditor::View view, QSize size) {
  Stage stage(size);
  stage.show_models();
  stage.show_brdf(view);
  stage.draw_as(DisplayMode::Brdf);
  return stage.picture();
}

QPixmap empty_window() {
  Stage stage;
  return stage.picture();
}

/// A session's first page, after two files were opened.
QPixmap welcome_page() {
  Stage stage;
  for (const char* name : {"kitchen.grf", "vase.grf"})
    editor::add_recent_file(stage.add(name, "# a scene\n"));
  stage.window().welcome().show_page();
  stage.settle();
  return stage.picture();
}

/// A step of a lesson, with its control marked.
QPixmap lesson() {
  Stage stage;
  stage.open(Samples + "layers/layers.grf");
  stage.window().welcome().start_lesson(1);
  stage.select_patch({0.42, 0.45}, 0);
  QTest::qWait(500);
  stage.act("Expand to whole mesh");
  QTest::qWait(500);
  stage.settle();
  return stage.picture();
}

QPixmap render_window() {
  Stage stage;
  stage.open_as_rendered(Samples + "plaza/plaza.grf");
  stage.preview({480, 320}, 48);
  const auto& forecast = *stage.window().findChild<editor::ForecastRow*>();
  expect(QTest::qWaitFor([&] { return forecast.forecasts().front().seconds.has_value(); }, 5 * Minute),
         "the render was not forecast");
  return stage.picture();
}

/// The error of the pixels of a few samples, in the view.
QPixmap error_view() {
  Stage stage({1280, 800});
  stage.open_as_rendered(Samples + "authored/still_life.grf");
  auto& document = stage.window().document().options();
  options::RenderOptions few = document.valid_options();
  few.samples = 16;
  document.follow(few);
  stage.window().render_panel().error_action()->setChecked(true);
  stage.draw_as(DisplayMode::Rendered);
  expect(QTest::qWaitFor([&] { return stage.window().view().note().contains("100 %"); }, Minute),
         "the view was not rendered");
  stage.settle();
  QTest::qWait(300);  // the last image is converted
  return stage.picture();
}

/// Where the noise of a sample is from, with all changes tried.
QPixmap noise_window() {
  Stage stage;
  stage.open_as_rendered(Samples + "authored/still_life.grf");
  stage.window().render_panel().noise_action()->trigger();
  auto& noise = *stage.window().render_panel().findChild<editor::NoiseWindow*>();
  expect(QTest::qWaitFor([&] { return !noise.is_running() && noise.result(); }, 5 * Minute),
         "no noise was found");
  noise.try_all();
  expect(QTest::qWaitFor([&] { return !noise.is_running(); }, 10 * Minute), "the changes were not tried");
  return noise.grab();
}

/// The study of the manual's example: which scheme for the still life.
QPixmap cost_page() {
  Stage stage({1280, 900});
  stage.open(Samples + "gallery/simple_scene.grf");
  editor::CostPage& page = stage.window().cost_page();
  page.open(Samples + "studies/cost/still_life.json");
  stage.hide_all_docks();
  stage.settle();
  return stage.picture();
}

QPixmap effects_page() {
  Stage stage({1280, 800});
  stage.open_as_rendered(Samples + "garden/garden.grf");
  stage.hide_docks({"surface", "brdf", "uv"});
  stage.act("Effects");
  auto& page = *stage.window().findChild<editor::EffectsPage*>();
  expect(QTest::qWaitFor([&] { return page.table().topLevelItemCount() > 0; }, Minute), "no plan was made");
  QTest::mouseClick(page.findChild<QPushButton*>("measure"), Qt::LeftButton);
  expect(page.is_measuring() && QTest::qWaitFor([&] { return !page.is_measuring(); }, 10 * Minute),
         "the effects were not measured");
  page.table().setCurrentItem(page.table().topLevelItem(3));
  stage.settle();
  return stage.picture();
}

QPixmap dock_with_models(const QString& name) {
  Stage stage;
  stage.show_models();
  return stage.dock(name).grab();
}

QPixmap brdf_dock(BrdfEditor::View view) {
  Stage stage;
  stage.show_models();
  stage.show_brdf(view);
  return stage.dock("brdf").grab();
}

QPixmap placing() {
  Stage stage({1280, 800});
  stage.open_as_rendered(Samples + "teapot/scene.grf");
  stage.act("Rotate gizmo");
  stage.orbit(0.3, 0, 1);
  stage.select_patch({0.44, 0.56}, 0);
  stage.dock("object");
  stage.settle();
  return stage.picture();
}

/// Faces of the teapot with the image of the garden's path.
QPixmap uv_dock() {
  Stage stage({1280, 800});
  stage.open_as_rendered(Samples + "teapot/scene.grf");
  stage.select_patch({0.44, 0.56}, 6);
  editor::assign_texture(stage.window().document(), Samples + "garden/paving.png");
  stage.act("Project along the normal");
  QDockWidget& dock = stage.dock("uv");
  dock.setFloating(true);
  dock.resize(46 * editor::Grid, 50 * editor::Grid);
  const auto& view = stage.window().uv_panel().view();
  expect(QTest::qWaitFor([&view] { return !view.image().image().isNull(); }, Minute), "no texture");
  stage.settle();
  return dock.grab();
}

QPixmap cameras() {
  Stage stage({1280, 800});
  stage.open(Samples + "teapot/scene.grf");
  stage.act("Look through the camera");
  auto& panel = *stage.dock("cameras").findChild<editor::CameraPanel*>();
  const transport::View camera = stage.window().view().camera().view();
  panel.add(camera);
  panel.focus_on(camera.target);
  stage.act("Framing guides");
  stage.settle();
  return stage.picture();
}

/// A lantern with mistakes that models from elsewhere have.
const char* const Lantern = R"(light begin rgb (5, 5, 5) (-0.1, 0, -0.1) (0, 0, 0.2) (0.2, 0, 0) end
begin mesh "shade"
  brdf diffuse kd=0.5
  begin vertexs
    (-1, -1, -1) (1, -1, -1) (-1, 1, -1) (1, 1, -1) (-1, -1, 1) (1, -1, 1) (-1, 1, 1) (1, 1, 1)
  end vertexs
  begin faces
    (0, 4, 6, 2) (1, 3, 7, 5) (0, 1, 5, 4) (2, 6, 7, 3) (0, 2, 3, 1) (4, 5, 7, 6)
  end faces
end mesh
begin mesh "foot"
  brdf phong n=10 ks=0.6 kd=0.9
  begin vertexs
    (-1, -2, -1) (1, -2, -1) (-1, -1, -1) (1, -1, -1) (-1, -2, 1) (1, -2, 1) (-1, -1, 1) (1, -1, 1) (3, -2, 1)
  end vertexs
  begin faces
    (0, 4, 6, 2) (1, 3, 7, 5) (0, 1, 5, 4) (2, 6, 7, 3) (0, 2, 3, 1) (6, 7, 5, 4) (4, 5, 8)
  end faces
end mesh
)";

/// The dialog of Scene > Check, with one risk selected.
QPixmap checking() {
  Stage stage({1280, 800});
  stage.open(stage.add("lantern.grf", Lantern));
  stage.act("Check...");
  auto* dialog = stage.window().findChild<editor::RiskDialog*>();
  expect(QTest::qWaitFor([dialog] { return dialog->is_up_to_date(); }, Minute), "the scene was not checked");
  dialog->resize(90 * editor::Grid, 36 * editor::Grid);
  auto* list = dialog->findChild<QTreeWidget*>();
  list->setCurrentItem(list->topLevelItem(2));
  stage.settle();
  return dialog->grab();
}

/// The preview in the view, denoised, with a gizmo and selected faces over it.
QPixmap rendered_view() {
  Stage stage({1280, 800});
  stage.open_as_rendered(Samples + "teapot/scene.grf");
  stage.act("Rotate gizmo");
  stage.select_patch({0.44, 0.56}, 2);
  auto& document = stage.window().document().options();
  options::RenderOptions few = document.valid_options();
  few.samples = 16;
  document.follow(few);
  stage.act("Denoise the view");
  stage.draw_as(DisplayMode::Rendered);
  expect(QTest::qWaitFor([&] { return stage.window().view().note().contains("100 %"); }, Minute),
         "the view was not rendered");
  stage.settle();
  QTest::qWait(300);  // the last image is converted
  return stage.picture();
}

/// Faces that the brush has painted, and the dialog that selects similar ones.
QPixmap choosing_faces() {
  Stage stage({1280, 800});
  stage.open_as_rendered(Samples + "teapot/scene.grf");
  stage.act("Brush");
  editor::SceneView& view = stage.window().view();
  const auto at = [&view](double x, double y) {
    return QPoint(qRound(x * view.width()), qRound(y * view.height()));
  };
  test::drag(view, at(0.36, 0.6), at(0.52, 0.62));
  stage.settle();
  stage.act("Select faces by...");
  auto* dialog = stage.window().findChild<editor::FaceQueryDialog*>();
  test::named<QCheckBox>(*dialog, "Same BRDF").click();
  test::named<QCheckBox>(*dialog, "Same normal").click();
  stage.settle();
  QTest::qWait(200);  // the faces are counted
  QPixmap picture = stage.picture();
  QPainter painter(&picture);
  const QPoint corner(24, 130);
  painter.drawPixmap(corner, dialog->grab());
  painter.setPen(editor::colours_of(editor::theme_of(dialog->palette())).faint_text);
  painter.drawRect(QRect(corner, dialog->size()));
  return picture;
}

/// Objects in a group, one of them hidden and one locked.
QPixmap scene_list() {
  Stage stage({1280, 800});
  stage.open_as_rendered(Samples + "cornell_box/cornell_box.grf");
  editor::Document& document = stage.window().document();
  const auto& instances = *document.objects().instances;
  document.select_objects({instances[0].path, instances[1].path});
  stage.act("Group");
  editor::EditorState state = document.editor_state();
  state.hidden.set_mesh(0);
  state.locked.set_mesh(1);
  document.set_editor_state(std::move(state));
  QTreeView& list = *stage.window().scene_tree().view();
  list.expandToDepth(1);
  stage.settle();
  return stage.picture();
}

QPixmap lights_dock() {
  Stage stage;
  stage.open(Samples + "cornell_box/cornell_box.grf");
  auto& list = *stage.window().findChild<QDockWidget*>("lights")->findChild<QAbstractItemView*>();
  list.setCurrentIndex(list.model()->index(0, 0));
  stage.settle();
  return stage.dock("lights").grab();
}

QPixmap messages() {
  Stage stage({1280, 800});
  stage.show_mistake();
  return stage.picture();
}

/// The eight display modes, each with its name.
QPixmap display_modes() {
  Stage stage({1100, 800});
  stage.hide_all_docks();
  const std::pair<const char*, QString> modes[] = {
      {"Points", "bunny/scene.grf"},          {"Wireframe", "shapes/knot.grf"},
      {"Solid", "teapot/teapot.grf"},         {"Solid with edges", "shapes/sphere.grf"},
      {"Textured", "garden/garden.grf"},      {"Vertex colours", "garden/garden.grf"},
      {"Irradiance", "baked_room/room.igrf"}, {"BRDF", "models/models.grf"}};
  constexpr int Columns = 4;
  const QSize tile(400, 300);
  QPixmap sheet(Columns * tile.width(), 2 * tile.height());
  QPainter painter(&sheet);
  int number = 0;
  for (const auto& [mode, file] : modes) {
    stage.open(number == 0 ? Bunny : Samples + file);
    const QFileInfo scene(Samples + file);
    const bool has_camera = scene.dir().exists(scene.completeBaseName() + ".op");
    if (number > 0 && has_camera) stage.act("Look through the camera");
    stage.draw_as(static_cast<DisplayMode>(number));
    const QRect place(QPoint(number % Columns * tile.width(), number / Columns * tile.height()), tile);
    const QPixmap shown =
        stage.window().view().grab().scaled(tile, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    const QSize cut = (shown.size() - tile) / 2;
    painter.drawPixmap(place.topLeft(), shown, QRect({cut.width(), cut.height()}, tile));
    const editor::ThemeColours colours = editor::colours_of(editor::theme_of(QApplication::palette()));
    const QRect label = place.adjusted(0, tile.height() - 3 * editor::Grid, 0, 0);
    painter.fillRect(label, colours.window);
    painter.setPen(colours.text);
    painter.drawText(label, Qt::AlignCenter, mode);
    ++number;
  }
  return sheet;
}

}  // namespace

QPixmap compared_images() {
  Stage stage;
  stage.open(Samples + "plaza/plaza.grf");
  editor::ImageBrowser& images = stage.window().image_browser();
  stage.preview({480, 320}, 4);
  images.show_image("4 samples", stage.window().render_panel().preview().image());
  stage.window().render_panel().stop_action()->trigger();
  stage.preview({480, 320}, 64);
  images.show_image("64 samples", stage.window().render_panel().preview().image());
  images.select_image("64 samples");
  images.select_reference("4 samples");
  images.set_comparison(editor::Comparison::Wipe);
  stage.hide_all_docks();
  return stage.picture();
}

QPixmap option_window() {
  editor::OptionsWindow window;
  expect(window.editor().open(Samples + "plaza/plaza.op"), "no options");
  window.resize(1200, 800);
  window.show();
  expect(QTest::qWaitForWindowExposed(&window), "the window did not show");
  QTest::qWait(100);
  return window.grab();
}

QPixmap viewer_window() {
  editor::ViewerWindow window;
  window.resize(1100, 720);
  window.show();
  QSignalSpy opened(&window, &editor::ViewerWindow::opened);
  window.open(Samples + "teapot/teapot.grf");
  expect(!opened.empty() || opened.wait(Minute), "the viewer opened nothing");
  test::action(window, "BRDF").trigger();
  expect(QTest::qWaitFor([&] { return window.view().is_complete(); }, Minute), "the viewer shows nothing");
  return window.grab();
}

QPixmap study_window(const QString& state_file) {
  grf::Diagnostics diagnostics;
  const std::string path = state_file.toStdString();
  const auto text = grf::read_file(path, diagnostics);
  const auto state = text ? studies::read_state(*text, path, diagnostics) : std::nullopt;
  expect(state.has_value(), editor::text_of(diagnostics));
  const auto tool = studies::study_tool(state->settings.keyword);
  expect(tool.has_value(), "no tool of that name");
  const auto window = editor::new_tool_window(*tool);
  window->resize(1200, 720);
  window->show();
  window->open({state_file});
  expect(QTest::qWaitFor([&] { return !window->is_busy(); }, Minute), "the study is not done");
  return window->grab();
}

QPixmap shortcut_list() {
  Stage stage;
  stage.act("Keyboard shortcuts");
  return stage.window().findChild<QDialog*>("shortcuts")->grab();
}

std::vector<Picture> manual_pictures() {
  const auto window = [] { return window_with(BrdfEditor::View::Lobe, {1600, 1000}); };
  return {
      {"window", window},
      {"window_empty", empty_window},
      {"welcome", welcome_page},
      {"lesson", lesson},
      {"render", render_window},
      {"cost", cost_page},
      {"effects", effects_page},
      {"images", compared_images},
      {"options", option_window},
      {"viewer", viewer_window},
      {"tool_minibpt", [] { return study_window(Samples + "studies/tools/beyond_equal_time.study"); }},
      {"tool_brdfviewer", [] { return study_window(Samples + "studies/tools/figure_6_7.study"); }},
      {"tool_emviewer", [] { return study_window(Samples + "studies/tools/figure_6_5.study"); }},
      {"tool_rejection", [] { return study_window(Samples + "studies/tools/figure_6_6_brdf.study"); }},
      {"tool_subdivision", [] { return study_window(Samples + "studies/tools/figure_6_10.study"); }},
      {"tool_fitplot", [] { return study_window(Samples + "studies/tools/figure_6_11.study"); }},
      {"shortcuts", shortcut_list},
      {"modes", display_modes},
      {"messages", messages},
      {"checking", checking},
      {"scene", [] { return dock_with_models("scene"); }},
      {"lights", lights_dock},
      {"choosing", choosing_faces},
      {"scene_list", scene_list},
      {"placing", placing},
      {"cameras", cameras},
      {"rendered", rendered_view},
      {"error", error_view},
      {"noise", noise_window},
      {"uv", uv_dock},
      {"surface", [] { return dock_with_models("surface"); }},
      {"brdf_sphere", [] { return brdf_dock(BrdfEditor::View::Sphere); }},
      {"brdf_lobe", [] { return brdf_dock(BrdfEditor::View::Lobe); }},
      {"brdf_plots", [] { return brdf_dock(BrdfEditor::View::Plots); }},
      {"brdf_library", [] { return brdf_dock(BrdfEditor::View::Library); }},
  };
}

}  // namespace screenshots
