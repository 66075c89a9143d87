// A user's workflow through the whole window: from a model to an image, by mouse and keyboard.
#include "tests/editor/window/authoring.h"

#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QToolButton>
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/controls/notice_bar.h"
#include "editor/controls/number_box.h"
#include "editor/document/brdf_mime.h"
#include "editor/document/model_import.h"
#include "editor/document/object_placement.h"
#include "editor/image/image_browser.h"
#include "editor/options/options_window.h"
#include "editor/panels/message_panel.h"
#include "editor/panels/surface_panel.h"
#include "editor/rendering/render_panel.h"
#include "editor/view/scene_view.h"
#include "editor/window/file_actions.h"
#include "editor/window/render_controller.h"
#include "grf/read.h"
#include "renderer/options/op_file.h"
#include "tests/cli/grfconvert.h"
#include "tests/editor/scene_of.h"
#include "tests/editor/window/window_driver.h"
#include "tests/support/camera_image.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using test::BunnyFile;
using test::Minute;
using testing::HasSubstr;

const QString Texture = GRANADA_SOURCE_DIR "/samples/garden/paving.png";

bool is_ward(const grf::Surface& surface) {
  const auto* model = surface.brdf ? std::get_if<grf::BrdfModel>(&*surface.brdf) : nullptr;
  return model != nullptr && model->keyword == "ward";
}

void choose(QComboBox& list, const QString& text) {
  const int index = list.findText(text, Qt::MatchContains);
  ASSERT_GE(index, 0) << text.toStdString();
  list.setFocus();
  list.setCurrentIndex(index);
  emit list.activated(index);
}

TEST_F(Authoring, AddsPrimitiveShapes) {
  document().take(
      scene_of("begin mesh \"ground\"\nbegin vertexs\n(-10,0,-10) (10,0,-10) (10,0,10)\nend vertexs\n"
               "begin faces\n(2,1,0)\nend faces\nend mesh\n"),
      {}, {});
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.view().is_complete(); }, Minute));
  const grf::Scene before = document().scene();
  std::size_t count = 1;
  for (const char* name : {"plane", "box", "sphere", "cylinder", "disc", "torus"}) {
    test::action(window_, QString("Add a %1").arg(name)).trigger();
    ASSERT_EQ(document().objects().meshes.size(), ++count);
    EXPECT_EQ(document().objects().meshes.back().mesh->name, name);
    EXPECT_EQ(document().undo_stack().undoText(), QString("Add %1").arg(name));
    ASSERT_EQ(document().selected_objects().size(), 1U);
    const grf::ScenePath& path = document().selected_objects().front();
    EXPECT_EQ(path, document().objects().meshes.back().path);
    const grf::Box3d bounds = object_bounds(document().objects(), path);
    const grf::Vec3d size = bounds.size();
    EXPECT_NEAR(std::max({size.x, size.y, size.z}), 5, 1e-5) << "a quarter of 20";
    EXPECT_NEAR(bounds.min.y, 0, 1e-5) << name;
    const grf::Vec3d centre = window_.view().camera().target();
    EXPECT_NEAR(bounds.center().x, centre.x, 1e-5) << name;
    EXPECT_NEAR(bounds.center().z, centre.z, 1e-5) << name;
  }
  while (document().undo_stack().canUndo()) document().undo_stack().undo();
  EXPECT_TRUE(document().scene() == before);
}

TEST_F(Authoring, AddsAStudioThatReplacesTheGreySky) {
  open(BunnyFile);
  const grf::Scene before = document().scene();
  EXPECT_NE(document().options().valid_options().background, grf::Vec3f(0)) << "a grey sky";
  test::action(window_, "Add a studio").trigger();
  EXPECT_EQ(document().objects().lights.size(), 2U);
  EXPECT_EQ(document().objects().meshes.back().mesh->name, "floor");
  EXPECT_EQ(document().options().valid_options().background, grf::Vec3f(0)) << "the studio replaces the sky";
  document().undo_stack().undo();
  EXPECT_TRUE(document().scene() == before);
  EXPECT_NE(document().options().valid_options().background, grf::Vec3f(0));
}

TEST_F(Authoring, KeepsWhatIsEditedWhileAMeshIsSubdivided) {
  open(BunnyFile);
  test::action(window_, "All").trigger();
  test::action(window_, "Subdivide (Loop)").trigger();
  SurfaceEdit red;
  red.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(1, 0, 0));
  document().edit_surfaces("Colour", red);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(document().objects().faces, 4 * 69666U);
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.colour.has_value(); }), 4 * 69666U);
  test::action(window_, "Smooth vertices").trigger();
  document().undo_stack().undo();
  ASSERT_EQ(document().objects().faces, 69666U);
  const grf::Scene before = document().scene();
  ASSERT_TRUE(are_jobs_done());
  EXPECT_TRUE(document().scene() == before) << "the mesh that was smoothed is no more";
  EXPECT_THAT(window_.notice().text().toStdString(), HasSubstr("edited meanwhile"));
}

TEST_F(Authoring, CancelsTheSubdivisionOfAMesh) {
  open(BunnyFile);
  test::action(window_, "Subdivide (Loop)").trigger();
  EXPECT_FALSE(test::action(window_, "Smooth vertices").isEnabled());
  Docks::show(window_.findChild<QDockWidget*>("jobs"));
  test::named<QToolButton>(window_, "Cancel Subdivide").click();
  EXPECT_TRUE(window_.jobs().jobs().empty());
  EXPECT_TRUE(test::action(window_, "Smooth vertices").isEnabled());
  QTest::qWait(1000);
  EXPECT_EQ(document().objects().faces, 69666U);
  EXPECT_FALSE(document().undo_stack().canUndo());
}

TEST_F(Authoring, SubdividesAndSmoothsAModel) {
  open(BunnyFile);
  ASSERT_EQ(document().objects().faces, 69666U);
  const auto area = [this] { return document().objects().meshes[0].mesh->geometry.area(); };
  const auto shown = [this] {
    return QTest::qWaitFor([this] { return window_.view().is_complete(); }, Minute);
  };
  test::action(window_, "Subdivide (Loop)").trigger();
  EXPECT_EQ(document().objects().faces, 69666U) << "the window goes on";
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(document().objects().faces, 4 * 69666U);
  EXPECT_EQ(document().undo_stack().undoText(), "Subdivide");
  const double rough = area();
  test::action(window_, "Smooth vertices").trigger();
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(document().objects().faces, 4 * 69666U);
  EXPECT_LT(area(), rough);
  EXPECT_TRUE(shown());
  document().undo_stack().undo();
  document().undo_stack().undo();
  EXPECT_EQ(document().objects().faces, 69666U);

  document().clear();
  test::action(window_, "Subdivide (Catmull-Clark)").trigger();
  EXPECT_EQ(document().objects().faces, 0U);
  EXPECT_FALSE(document().is_modified());
}

TEST_F(Authoring, GoesFromAModelToASceneAndBack) {
  open(BunnyFile);
  ASSERT_EQ(document().objects().faces, 69666U);
  const grf::Scene imported = document().scene();

  // Assigns Ward to the faces of a box.
  const QPoint middle = window_.view().rect().center();
  test::drag(window_.view(), middle, middle + QPoint(90, 70));
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_.view().is_selecting(); }, Minute));
  const std::size_t in_box = document().selection().count();
  ASSERT_GT(in_box, 50U);
  ASSERT_LT(in_box, 20000U);
  choose(test::named<QComboBox>(window_.surface_panel(), "BRDF"), "ward");
  EXPECT_EQ(faces_where(is_ward), in_box);

  // Drags a parameter: one undo step.
  const int steps = document().undo_stack().count();
  std::vector<grf::BrdfModel> models = window_.brdf_editor().models();
  ASSERT_EQ(models.size(), 1U);
  for (const double roughness : {0.3, 0.25, 0.2}) {
    models[0].arguments = {grf::Argument{"sx", grf::Value(static_cast<float>(roughness)), {}}};
    emit window_.brdf_editor().changing(models);
  }
  emit window_.brdf_editor().edited(models);
  EXPECT_EQ(document().undo_stack().count(), steps + 1);

  // Makes two faces emit.
  select_two_faces();
  ASSERT_EQ(document().selection().count(), 2U);
  auto& power = test::named<QAbstractSpinBox>(window_.surface_panel(), "Power");
  power.setFocus();
  QTest::keyClick(&power, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(&power, "20*3");
  QTest::keyClick(&power, Qt::Key_Return);
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.emission.has_value(); }), 2U);

  // Assigns a texture to all faces.
  test::action(window_, "All").trigger();
  ASSERT_EQ(document().selection().count(), 69666U);
  auto& texture = test::named<QComboBox>(window_.surface_panel(), "Texture");
  texture.setFocus();
  QTest::keyClicks(texture.lineEdit(), Texture);
  QTest::keyClick(texture.lineEdit(), Qt::Key_Return);

  // Undo all, redo all.
  const grf::Scene done = document().scene();
  EXPECT_FALSE(done == imported);
  while (document().undo_stack().canUndo())
    test::action(window_, "Undo " + document().undo_stack().undoText()).trigger();
  EXPECT_TRUE(document().scene() == imported);
  while (document().undo_stack().canRedo())
    test::action(window_, "Redo " + document().undo_stack().redoText()).trigger();
  EXPECT_TRUE(document().scene() == done);

  // Save, reopen, compare.
  const QString file = path("bunny.grf");
  window_.files().save_as(file);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_FALSE(document().is_modified());
  const grf::Scene saved = document().scene();
  open(file);
  EXPECT_TRUE(document().scene() == saved);
  EXPECT_EQ(faces_where(is_ward), in_box);
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.texture.has_value(); }), 69666U);
}

TEST_F(Authoring, GoesFromASceneToAnImage) {
  QFile::copy(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf", path("box.grf"));
  open(path("box.grf"));
  options::RenderOptions small = document().options().valid_options();
  small.size = {96, 72};
  small.samples = 4;
  small.eye = grf::Vec3f(278, 273, -800);
  small.target = grf::Vec3f(278, 273, 0);
  small.field_of_view = 39.3076F;
  document().options().set_options("Change render options", small);

  QTest::keyClick(&window_, Qt::Key_F5);
  const auto is_whole = [&] {
    const auto image = window_.render_panel().preview().image();
    return image != nullptr && image->width == 96;
  };
  ASSERT_TRUE(QTest::qWaitFor(is_whole, Minute));
  test::expect_cornell_box(*window_.render_panel().preview().image());

  QSignalSpy finished(&window_.render_panel().final_render(), &FinalRender::finished);
  QTest::keyClick(&window_, Qt::Key_F6);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !finished.empty(); }, Minute));
  grf::Diagnostics diagnostics;
  const auto image = image::read_image(folder_.path("box.exr"), diagnostics);
  ASSERT_TRUE(image) << diagnostics.to_text();
  test::expect_cornell_box(*image);
  EXPECT_TRUE(QFile::exists(path("box.op")));
  emit window_.render_panel().image_opened(path("box.exr"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return window_.image_browser().names().size() == 1; }, Minute));
  EXPECT_TRUE(window_.image_browser().isVisible());
}

TEST_F(Authoring, KeepsOptionsAsStepsOfUndo) {
  open(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf");
  const options::RenderOptions before = document().options().valid_options();
  EXPECT_FALSE(document().is_modified());
  window_.view().setFocus();
  QTest::keyClick(&window_.view(), Qt::Key_Left);
  test::action(window_, "Align camera to view").trigger();
  ASSERT_TRUE(document().is_modified());
  EXPECT_FALSE(document().options().valid_options() == before);
  document().undo_stack().undo();
  EXPECT_TRUE(document().options().valid_options() == before);
}

TEST_F(Authoring, WritesAnOpFileByTheGenerator) {
  QFile::copy(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf", path("box.grf"));
  folder_.add("box.op", "# mine\nBPT_Scene box.grf\nBPT_Depth 3 # few\n");
  open(path("box.grf"));
  ASSERT_EQ(document().options().valid_options().depth, 3);
  window_.render_panel().options_action()->trigger();
  OptionsWindow* generator = window_.render_controller().options_window();
  ASSERT_NE(generator, nullptr);
  OpDocument& text = generator->editor().document();
  text.set_plain_text("# mine\nBPT_Scene box.grf\nBPT_Depth 7 # few\n");
  EXPECT_EQ(document().options().valid_options().depth, 7);
  ASSERT_TRUE(generator->editor().save());
  EXPECT_EQ(test::bytes_of(folder_.path("box.op")), "# mine\nBPT_Scene box.grf\nBPT_Depth 7 # few\n");
  grf::Diagnostics diagnostics;
  const auto read = options::read_op_file(folder_.path("box.op"), diagnostics);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->depth, 7);
  generator->close();
}

TEST_F(Authoring, ShowsTheOptionsOfTheSceneInTheGenerator) {
  folder_.add("one.op", "BPT_Depth 3\n");
  folder_.add("two.op", "BPT_Depth 9\n");
  for (const char* file : {"one.grf", "two.grf"}) {
    QFile::copy(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf", path(file));
  }
  open(path("one.grf"));
  window_.render_panel().options_action()->trigger();
  OpDocument& text = window_.render_controller().options_window()->editor().document();
  options::RenderOptions now = document().options().valid_options();
  now.samples = 12;
  document().options().set_options("In the dock", now);
  EXPECT_EQ(text.valid_options().samples, 12) << "which the dock changed";
  const options::OptionInfo& depth = *options::find_option("BPT_Depth");
  text.set_words(depth, {"4"});
  EXPECT_EQ(document().options().valid_options().samples, 12) << "which the window left alone";
  EXPECT_EQ(document().options().valid_options().depth, 4);
  document().undo_stack().undo();
  EXPECT_EQ(text.op_text().words_of(depth)->front(), "3");
  document().undo_stack().undo();
  open(path("two.grf"));
  EXPECT_EQ(text.valid_options().depth, 9);
  window_.render_controller().options_window()->close();
}

TEST_F(Authoring, ListsWhatIsWrongWithAFileThatIsNotOpened) {
  open(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf");
  const grf::Scene before = document().scene();
  folder_.add("broken.grf", "begin mesh \"a\"\n  nonsense\nend mesh\n");
  window_.files().open(path("broken.grf"));
  ASSERT_TRUE(are_jobs_done());
  EXPECT_TRUE(document().scene() == before);
  EXPECT_THAT(window_.notice().text().toStdString(), HasSubstr("broken.grf:2:"));
  EXPECT_GT(window_.message_panel().error_count(), 0U);
  test::named<QPushButton>(window_.notice(), "Messages").click();
  EXPECT_TRUE(window_.message_panel().isVisible());
  open(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf");
  EXPECT_EQ(window_.message_panel().error_count(), 0U);
}

TEST_F(Authoring, LivesOnWhenAnImportCrashes) {
  test::crash_on_findings();
  open(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf");
  const grf::Scene before = document().scene();
  const std::string crashing =
      folder_.add("crashing.md5mesh", "MD5Version 10\n}\nmesh {\nnumverts 1\nnumtris 1\n}\n");
  window_.open({QString::fromStdString(crashing)});
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.notice().isVisible(); }, Minute));
  EXPECT_THAT(window_.notice().text().toStdString(), HasSubstr("crashing.md5mesh"));
  EXPECT_TRUE(document().scene() == before);
}

TEST_F(Authoring, GivesAFaceABrdfThatIsDroppedOnIt) {
  open(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf");
  grf::Diagnostics diagnostics;
  const auto data = mime_of(*grf::read_brdf("phong ks=0.3 n=20", "dragged", diagnostics));
  const QPoint middle = window_.view().rect().center();
  QDragEnterEvent enter(middle, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window_.view(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(middle, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window_.view(), &drop);
  EXPECT_EQ(document().selection().count(), 1U);
  EXPECT_EQ(faces_where([](const grf::Surface& surface) {
              const auto* model = surface.brdf ? std::get_if<grf::BrdfModel>(&*surface.brdf) : nullptr;
              return model != nullptr && model->keyword == "phong";
            }),
            1U);
}

/// Presses a key in the focused widget, an open list or a dialog.
void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
  const QWidget* open = QApplication::activePopupWidget();
  if (open == nullptr) open = QApplication::activeModalWidget();
  QWidget* focused = open == nullptr ? QApplication::focusWidget() : open->focusWidget();
  ASSERT_NE(focused, nullptr);
  QTest::keyClick(focused, key, modifiers);
}

TEST_F(Authoring, CanBeUsedByKeyboardAlone) {
  QFile::copy(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf", path("box.grf"));
  folder_.add("box.op", "BPT_Scene box.grf\nBPT_Image_Resolution 80 64\nBPT_Samples 4\n");
  {
    const test::FileTyping typing(path("box.grf"));
    press(Qt::Key_O, Qt::ControlModifier);
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().objects().faces == 18; }, Minute));
  }
  window_.activateWindow();  // as a window manager does
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  press(Qt::Key_A, Qt::ControlModifier);
  ASSERT_EQ(document().selection().count(), 18U);
  // Focuses the Surface dock, and in it the list of BRDFs.
  press(Qt::Key_3, Qt::ControlModifier);
  const auto* list = &test::named<QComboBox>(window_.surface_panel(), "BRDF");
  for (int i = 0; i < 3 && QApplication::focusWidget() != list; ++i) press(Qt::Key_Tab);
  ASSERT_EQ(QApplication::focusWidget(), list);
  press(Qt::Key_Down, Qt::AltModifier);
  ASSERT_TRUE(QTest::qWaitFor([] { return QApplication::activePopupWidget() != nullptr; }, Minute));
  for (int i = 0; i < list->count() && !list->view()->currentIndex().data().toString().contains("ward");
       ++i) {
    press(Qt::Key_Down);
  }
  press(Qt::Key_Return);
  EXPECT_EQ(faces_where(is_ward), 18U);
  QSignalSpy shown(&window_.render_panel().preview(), &Preview::image_changed);
  press(Qt::Key_F5);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shown.empty(); }, Minute));
  QSignalSpy finished(&window_.render_panel().final_render(), &FinalRender::finished);
  press(Qt::Key_F6);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !finished.empty(); }, Minute));
  EXPECT_TRUE(QFile::exists(path("box.exr")));
  press(Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_FALSE(document().is_modified());
  EXPECT_THAT(test::bytes_of(folder_.path("box.grf")), HasSubstr("ward"));
}

/// A scene without a BRDF.
const char OneFace[] =
    "begin mesh begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) end faces end "
    "mesh\n";

/// Assigns a BRDF of the library: Ctrl+4, arrows to its page, Tab to its list, Return.
TEST_F(Authoring, TakesABrdfOutOfTheLibraryByKeyboardAlone) {
  folder_.add("one.grf", OneFace);
  open(path("one.grf"));
  press(Qt::Key_A, Qt::ControlModifier);
  press(Qt::Key_4, Qt::ControlModifier);
  const auto name = [] { return QApplication::focusWidget()->accessibleName(); };
  ASSERT_EQ(name(), "Sphere");
  for (int i = 0; i < 3 && name() != "Library"; ++i) press(Qt::Key_Right);
  ASSERT_EQ(name(), "Library");
  press(Qt::Key_Space);
  for (int i = 0; i < 5 && name() != "BRDFs of the library"; ++i) press(Qt::Key_Tab);
  ASSERT_EQ(name(), "BRDFs of the library");
  press(Qt::Key_Home);
  press(Qt::Key_Down);
  press(Qt::Key_Return);
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.brdf.has_value(); }), 1U);
}

TEST_F(Authoring, SaysHowManyFacesAreSelected) {
  const auto counts = [this] {
    for (const QLabel* label : window_.findChildren<QLabel*>()) {
      if (label->accessibleName() == "Counts") return label->text().toStdString();
    }
    return std::string();
  };
  open(GRANADA_SOURCE_DIR "/samples/cornell_box/cornell_box.grf");
  EXPECT_THAT(counts(), HasSubstr("0 of 18 faces selected"));
  folder_.add("one.grf", OneFace);
  open(path("one.grf"));
  press(Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(counts(), "1 of 1 face selected  \u00b7  1 triangle");
}

}  // namespace
}  // namespace editor
