// Works through the tasks of editor/TASKS.md in the real window, by pointer and keyboard alone, and counts
// gestures.
#include <QClipboard>
#include <QComboBox>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/document/object_placement.h"
#include "editor/document/texture_coordinates.h"
#include "editor/panels/light_panel.h"
#include "editor/rendering/render_panel.h"
#include "grf/write.h"
#include "tests/editor/window/authoring.h"
#include "tests/editor/window/gestures.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using grf::Vec3d;
using test::Minute;

struct GestureCounts {
  int wannabe = 0;
  int blender = 0;
};

/// The rows of the table of the document, by task.
std::map<std::string, GestureCounts> documented_counts() {
  std::ifstream file(GRANADA_SOURCE_DIR "/editor/TASKS.md");
  std::map<std::string, GestureCounts> counts;
  for (std::string line; std::getline(file, line);) {
    std::istringstream row(line);
    std::string skipped, task, wannabe, blender;
    std::getline(row, skipped, '|');
    std::getline(row, task, '|');
    std::getline(row, wannabe, '|');
    std::getline(row, blender, '|');
    const auto is_number = [](const std::string& cell) {
      return cell.find_first_of("0123456789") != std::string::npos &&
             cell.find_first_not_of(" 0123456789") == std::string::npos;
    };
    if (is_number(wannabe) && is_number(blender))
      counts[task.substr(1, task.size() - 2)] = {std::stoi(wannabe), std::stoi(blender)};
  }
  return counts;
}

/// A picture of the window after each task is saved in the folder GRANADA_PICTURES of the environment, if it
/// is set, for people to look at.
class Tasks : public Authoring, protected test::Gestures {
 protected:
  Tasks() : Gestures(window_) {}

  void TearDown() override {
    const QString folder = qEnvironmentVariable("GRANADA_PICTURES");
    if (folder.isEmpty()) return;
    const char* const name = testing::UnitTest::GetInstance()->current_test_info()->name();
    EXPECT_TRUE(is_drawn());
    EXPECT_TRUE(window_.grab().save(QString("%1/%2.png").arg(folder, name)));
  }

  void expect_count(const std::string& task) {
    const auto counts = documented_counts();
    const auto row = counts.find(task);
    ASSERT_NE(row, counts.end()) << "editor/TASKS.md has no task '" << task << "'";
    EXPECT_EQ(row->second.wannabe, gestures()) << "editor/TASKS.md has another count";
  }
  QString write(const std::string& name, const std::string& text) {
    return QString::fromStdString(folder_.add(name, text));
  }
  grf::Box3d bounds_of(const std::string& name) {
    for (const MeshInstance& instance : *document().objects().instances) {
      const MeshObject& object = document().objects().meshes[instance.mesh];
      if (object.mesh->name == name) return object_bounds(document().objects(), instance.path);
    }
    throw std::runtime_error("no mesh is called " + name);
  }
};

/// A box in OBJ; `reversed` has a bit for each face that points inward.
std::string obj_box(const Vec3d& corner, const Vec3d& size, unsigned reversed = 0) {
  std::ostringstream text;
  for (int i = 0; i < 8; ++i) {
    text << "v " << corner.x + size.x * (i & 1) << ' ' << corner.y + size.y * (i >> 1 & 1) << ' '
         << corner.z + size.z * (i >> 2 & 1) << '\n';
  }
  const char* const faces[] = {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"};
  const char* const other_way[] = {"2 4 3 1", "7 8 6 5", "5 6 2 1", "4 8 7 3", "3 7 5 1", "6 8 4 2"};
  for (unsigned i = 0; i < 6; ++i)
    text << "f " << ((reversed >> i & 1U) != 0 ? other_way[i] : faces[i]) << '\n';
  return text.str();
}

std::string grf_box(const std::string& name, const std::string& attributes, const Vec3d& corner,
                    const Vec3d& size) {
  std::ostringstream text;
  text << "begin mesh \"" << name << "\" " << attributes << " begin vertexs ";
  for (int i = 0; i < 8; ++i) {
    text << '(' << corner.x + size.x * (i & 1) << ',' << corner.y + size.y * (i >> 1 & 1) << ','
         << corner.z + size.z * (i >> 2 & 1) << ") ";
  }
  text << "end vertexs begin faces (0,2,3,1) (4,5,7,6) (0,1,5,4) (2,6,7,3) (0,4,6,2) (1,3,7,5) end faces end "
          "mesh\n";
  return text.str();
}

TEST_F(Tasks, PlaceThreeModelsOnATable) {
  open(write("table.grf", grf_box("table", "", {-4, 0, -3}, {8, 1, 6})));
  const QStringList models = {write("vase.obj", obj_box({-3, 0, 4}, {1, 1.5, 1})),
                              write("cup.obj", obj_box({-0.5, 0, 4}, {0.6, 0.6, 0.6})),
                              write("bowl.obj", obj_box({2, 0, 4}, {1.2, 0.5, 1.2}))};
  import(models, Qt::ShiftModifier);
  const std::map<std::string, Vec3d> places = {
      {"vase", {-2.5, 1, -1}}, {"cup", {0, 1, -1}}, {"bowl", {2.5, 1, -1}}};
  for (const auto& [name, place] : places) {
    const grf::Box3d box = bounds_of(name);
    click_view({box.center().x, box.center().y, box.max.z});
    press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    click_view(place);
    const grf::Box3d now = bounds_of(name);
    EXPECT_NEAR(now.min.y, 1, 1e-3) << name;
    EXPECT_NEAR(now.center().x, place.x, 0.05) << name;
    EXPECT_NEAR(now.center().z, place.z, 0.05) << name;
  }
  expect_count("place three models on a table");
}

TEST_F(Tasks, LightAProduct) {
  import({write("product.obj", obj_box({0, 0, 0}, {1, 2, 1}))});
  press(Qt::Key_F5);
  EXPECT_EQ(document().objects().lights.size(), 2U);
  EXPECT_EQ(document().objects().meshes.size(), 2U);
  EXPECT_TRUE(
      QTest::qWaitFor([this] { return window_.render_panel().preview().image() != nullptr; }, Minute));
  expect_count("light a product");
}

TEST_F(Tasks, ChangeTheCushionsToVelvet) {
  open(write("sofa.grf", "def cushion = brdf diffuse kd=0.4 begin\n" +
                             grf_box("seat", "brdf phong", {0, 0, 0}, {6, 1, 3}) +
                             grf_box("left", "brdf cushion", {0.5, 1, 0.5}, {2, 0.7, 2}) +
                             grf_box("right", "brdf cushion", {3.5, 1, 0.5}, {2, 0.7, 2}) + "end\n"));
  click_view({1.5, 1.35, 2.5});
  press(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().selection().count(), 12U);
  click(test::named<QWidget>(window_, "Library"));
  auto& search = test::named<QLineEdit>(window_, "Search the library");
  click(search);
  type(search, "velvet");
  auto& tiles = test::named<QListWidget>(window_, "BRDFs of the library");
  QListWidgetItem* velvet = nullptr;
  for (int i = 0; i < tiles.count(); ++i) {
    if (!tiles.item(i)->isHidden() && tiles.item(i)->text() == "velvet") velvet = tiles.item(i);
  }
  ASSERT_NE(velvet, nullptr);
  double_click(*tiles.viewport(), tiles.visualItemRect(velvet).center());
  // All cushions have the definition that was edited.
  EXPECT_THAT(grf::to_text(document().scene()), testing::HasSubstr("cushion = brdf ashikhmin ex=1"));
  expect_count("change the sofa's cushions to velvet");
}

TEST_F(Tasks, FindAndFixFlippedNormals) {
  open(write("flipped.obj", obj_box({0, 0, 0}, {1, 1, 1}, 0b010110)));
  press(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().selection().count(), 3U);
  press(Qt::Key_N, Qt::ShiftModifier);
  test::action(window_, "Select inward faces").trigger();
  EXPECT_EQ(document().selection().count(), 0U);
  expect_count("find and fix flipped normals");
}

TEST_F(Tasks, ScaleAModelFromMillimetres) {
  const auto use_millimetres = [this](ImportDialog& dialog) {
    auto& unit = test::named<QComboBox>(dialog, "Unit");
    click(unit);
    type(unit, "mm");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);  // ends what is typed
  };
  import({write("part.obj", obj_box({0, 0, 0}, {1000, 2000, 500}))}, {}, use_millimetres);
  EXPECT_NEAR(document().objects().mesh_bounds.size().y, 2, 1e-5);
  expect_count("scale a model from millimetres");
}

TEST_F(Tasks, PutALogoOnAFace) {
  open(write("box.grf", grf_box("box", "", {0, 0, 0}, {1, 1, 1})));
  drop(window_.view(), {GRANADA_SOURCE_DIR "/samples/garden/paving.png"}, pixel({0.5, 0.5, 1}));
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.texture.has_value(); }), 1U);
  // The face shows the image upright, once.
  EXPECT_EQ(uv_bounds(document().objects(), document().selection()), UvBounds({0, 0}, {1, 1}));
  EXPECT_EQ(window_.view().mode(), DisplayMode::Textured);
  document().undo_stack().undo();
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.texture.has_value(); }), 0U);
  EXPECT_TRUE(uv_bounds(document().objects(), document().selection()).isEmpty());
  document().undo_stack().redo();
  expect_count("put a logo on a face");
}

TEST_F(Tasks, MatchALampsHighlight) {
  open(write("ball.grf", grf_box("box", "brdf phong", {-1, 0, -1}, {2, 2, 2}) +
                             "light begin rgb (9,9,9) (-0.5,6,-0.5) (1,0,0) (0,0,1) end\n"));
  auto& lights = test::named<QTreeWidget>(window_, "Lights of the scene");
  click(*lights.viewport(), lights.visualItemRect(lights.topLevelItem(0)).center());
  for (QPushButton* button : window_.findChildren<QPushButton*>()) {
    if (button->text() == "Highlight" && button->isVisible()) click(*button);
  }
  const Vec3d wanted(0.3, 1.2, 1);
  click_view(wanted);
  // The mirror direction at that point leads to the middle of the lamp.
  const grf::AreaLight& light = document().objects().lights.at(0).light;
  const Vec3d centre = Vec3d(light.corner) + (Vec3d(light.edge1) + Vec3d(light.edge2)) / 2;
  const Vec3d eye = window_.view().camera().eye();
  const Vec3d away = (wanted - eye).normalized();
  const Vec3d mirrored(away.x, away.y, -away.z);
  EXPECT_GT((centre - wanted).normalized().dot(mirrored), 0.999);
  expect_count("match a lamp's highlight");
}

TEST_F(Tasks, RenderThreeCameras) {
  write("scene.op",
        "BPT_Scene scene.grf\nBPT_Image_Resolution 16 12\nBPT_Samples 1\n"
        "BPT_Cameras front 0.5 0.5 5  0.5 0.5 0  0 1 0  30 0 0\n"
        "BPT_Cameras side 5 0.5 0.5  0.5 0.5 0  0 1 0  30 0 0\n"
        "BPT_Cameras top 0.5 5 0.5  0.5 0.5 0.4  0 1 0  30 0 0\n");
  open(write("scene.grf", grf_box("box", "light rgb (1,1,1)", {0, 0, 0}, {1, 1, 1})));
  QTimer::singleShot(100, &window_, [this] { press(*QApplication::activeModalWidget(), Qt::Key_Return); });
  press(Qt::Key_F6, Qt::ControlModifier);
  ASSERT_TRUE(are_jobs_done());
  for (const char* name : {"scene_front.exr", "scene_side.exr", "scene_top.exr"}) {
    EXPECT_TRUE(QFileInfo::exists(path(name))) << name;
  }
  expect_count("render three cameras");
}

TEST_F(Tasks, ReimportAChangedModel) {
  open(write("part.obj", obj_box({0, 0, 0}, {1, 1, 1})));
  write("part.obj", obj_box({0, 0, 0}, {1, 3, 1}));
  click_view({0.5, 0.5, 1});
  press(Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(document().objects().mesh_bounds.size().y, 3);
  expect_count("reimport a changed model");
}

TEST_F(Tasks, SendAMaterialToAColleague) {
  open(write("mine.grf", grf_box("box", "brdf ward sx=0.1 sy=0.3", {0, 0, 0}, {1, 1, 1})));
  click_view({0.5, 0.5, 1});
  press(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  open(write("theirs.grf", grf_box("box", "", {0, 0, 0}, {1, 1, 1})));
  click_view({0.5, 0.5, 1});
  press(Qt::Key_V, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.brdf.has_value(); }), 1U);
  expect_count("send a material to a colleague");
}

TEST(TaskCounts, AreHalfOfBlendersInTheSum) {
  const auto counts = documented_counts();
  EXPECT_EQ(counts.size(), 10U);
  int wannabe = 0, blender = 0;
  for (const auto& [task, count] : counts) {
    wannabe += count.wannabe;
    blender += count.blender;
  }
  EXPECT_LE(2 * wannabe, blender);
  std::ifstream file(GRANADA_SOURCE_DIR "/editor/TASKS.md");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  EXPECT_THAT(text, testing::HasSubstr("| **sum** | **" + std::to_string(wannabe) + "** | **" +
                                       std::to_string(blender) + "** |"));
}

}  // namespace
}  // namespace editor
