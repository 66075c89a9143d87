// Importing models through the whole window: the dialog of the options, several files, drops.
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QUrl>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/window/export_dialog.h"
#include "editor/window/import_dialog.h"
#include "tests/editor/window/authoring.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using test::Minute;
using testing::ElementsAre;
using testing::IsEmpty;

QString shown_size(const ImportDialog& dialog) {
  return test::named<QLabel>(dialog, "Resulting size").text();
}

bool comes_to_show(const ImportDialog& dialog, const QString& size) {
  return QTest::qWaitFor([&] { return shown_size(dialog).startsWith(size); }, Minute);
}

/// Uses each import dialog once it has shown the model, until this is destroyed.
class DialogUser {
 public:
  explicit DialogUser(std::function<void(ImportDialog&)> use) {
    timer_.callOnTimeout([this, use = std::move(use)] {
      auto* dialog = qobject_cast<ImportDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || dialog == used_) return;
      used_ = dialog;
      EXPECT_TRUE(comes_to_show(*dialog, "1"));
      ++count_;
      use(*dialog);
    });
    timer_.start(20);
  }
  int count() const { return count_; }

 private:
  QTimer timer_;
  QPointer<ImportDialog> used_;
  int count_ = 0;
};

class Importing : public Authoring {
 protected:
  /// A triangle of 1000 by 2000 in the plane x z, in two objects.
  QString model(const std::string& name) {
    return QString::fromStdString(
        folder_.add(name, "v 0 0 0\nv 1000 0 0\nv 0 0 2000\nv 0 0 -1\nf 1 2 3\no rest\nf 1 2 4\n"));
  }
  void drop(const QStringList& files, Qt::KeyboardModifiers modifiers = {}) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls.append(QUrl::fromLocalFile(file));
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&window_, &enter);
    QDropEvent event(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&window_, &event);
    QTest::qWait(50);
    ASSERT_TRUE(are_jobs_done());
  }
  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const MeshObject& object : document().objects().meshes) names.push_back(object.name);
    return names;
  }
};

TEST_F(Importing, AsksHowADroppedModelIsImported) {
  const DialogUser user([](ImportDialog& dialog) {
    EXPECT_TRUE(comes_to_show(dialog, "1000 × 0 × 2001 m, 2 faces"));
    auto& up = test::named<QComboBox>(dialog, "Up axis");
    up.setFocus();
    QTest::keyClick(&up, Qt::Key_Down);
    EXPECT_TRUE(comes_to_show(dialog, "1000 × 2001 × "));
    auto& unit = test::named<QComboBox>(dialog, "Unit");
    unit.setFocus();
    for (int i = 0; i < 4; ++i) QTest::keyClick(&unit, Qt::Key_Up);
    EXPECT_TRUE(comes_to_show(dialog, "1 × 2.001 × "));
    auto& objects = test::named<QListWidget>(dialog, "Objects");
    EXPECT_EQ(objects.item(0)->text(), "chair (1 face)");
    objects.setFocus();
    objects.setCurrentRow(1);
    QTest::keyClick(&objects, Qt::Key_Space);
    QTest::keyClick(&dialog, Qt::Key_Return);  // before the result is there
  });
  drop({model("chair.obj")});
  EXPECT_EQ(user.count(), 1);
  EXPECT_THAT(names(), ElementsAre("chair"));
  const grf::Box3d& bounds = document().objects().mesh_bounds;
  EXPECT_NEAR(bounds.max.x, 1, 1e-6);
  EXPECT_NEAR(bounds.max.y, 2, 1e-6);
  EXPECT_TRUE(document().is_modified());
}

TEST_F(Importing, AppendsSeveralFilesInOneStepAndAsksOnce) {
  const grf::Scene before = document().scene();
  const DialogUser user([](ImportDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
  drop({model("chair.obj"), model("table.obj")}, Qt::ShiftModifier);
  EXPECT_EQ(user.count(), 1);
  EXPECT_THAT(names(), ElementsAre("chair", "rest", "table", "rest"));
  EXPECT_EQ(document().undo_stack().count(), 1);
  EXPECT_EQ(document().undo_stack().undoText(), "Append 2 files");
  document().undo_stack().undo();
  EXPECT_TRUE(document().scene() == before);
  drop({model("lamp.obj")}, Qt::ShiftModifier);
  drop({model("lamp.obj")}, Qt::ShiftModifier);
  EXPECT_EQ(document().undo_stack().count(), 2) << "two drops are two steps";
}

TEST_F(Importing, ReadsAChangedModelAgain) {
  const QString file = model("chair.obj");
  open(file);
  test::action(window_, "All").trigger();
  SurfaceEdit red;
  red.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(1, 0, 0));
  document().edit_surfaces("Colour", red);
  document().select_objects({document().objects().instances->at(0).path});
  const QSignalSpy done(&window_.files(), &FileActions::done);
  folder_.add("chair.obj", "v 0 0 0\nv 500 0 0\nv 0 0 2000\nf 1 2 3\nf 1 3 2\no rest\nf 1 2 3\n");
  QTest::keyClick(&window_, Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(document().undo_stack().undoText(), "Reimport chair.obj");
  EXPECT_EQ(document().objects().mesh_bounds.max.x, 500);
  EXPECT_EQ(document().objects().faces, 3U);
  EXPECT_EQ(faces_where([](const grf::Surface& surface) { return surface.colour.has_value(); }), 3U)
      << "the whole mesh is red";
  ASSERT_EQ(done.size(), 1);
  EXPECT_THAT(done[0][0].toString().toStdString(), testing::HasSubstr("chair has 1 more face,"));
  document().undo_stack().undo();
  EXPECT_EQ(document().objects().mesh_bounds.max.x, 1000);
  document().select_objects({});
  QTest::keyClick(&window_, Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
  EXPECT_TRUE(window_.jobs().jobs().empty());
  EXPECT_THAT(window_.notice().text().toStdString(),
              testing::HasSubstr("Select an object that was imported"));
}

TEST_F(Importing, OpensTheFilesThatAreTyped) {
  const DialogUser user([](ImportDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Return); });
  {
    const test::FileTyping typing("\"" + model("chair.obj") + "\" \"" + model("table.obj") + "\"");
    test::action(window_, "Append...").trigger();
  }
  QTest::qWait(50);
  ASSERT_TRUE(are_jobs_done());
  EXPECT_EQ(user.count(), 1);
  EXPECT_THAT(names(), ElementsAre("chair", "rest", "table", "rest"));
}

TEST_F(Importing, DoesNotAskAgainButOnRequest) {
  {
    const DialogUser user([](ImportDialog& dialog) {
      auto& unit = test::named<QComboBox>(dialog, "Unit");
      unit.setFocus();
      for (int i = 0; i < 4; ++i) QTest::keyClick(&unit, Qt::Key_Up);
      EXPECT_EQ(unit.currentText(), "mm");
      auto& skips = test::named<QCheckBox>(dialog, "Do not show again");
      skips.setFocus();
      QTest::keyClick(&skips, Qt::Key_Space);
      QTest::keyClick(&dialog, Qt::Key_Return);
    });
    drop({model("chair.obj")});
    EXPECT_EQ(user.count(), 1);
  }
  const DialogUser user([](ImportDialog& dialog) {
    EXPECT_EQ(test::named<QComboBox>(dialog, "Unit").currentText(), "mm");
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  drop({model("table.obj")}, Qt::ShiftModifier);
  EXPECT_EQ(user.count(), 0);
  EXPECT_NEAR(document().objects().mesh_bounds.max.x, 1, 1e-6) << "with the remembered unit";
  ASSERT_EQ(names().size(), 4U);
  drop({model("lamp.obj")}, Qt::ShiftModifier | Qt::ControlModifier);
  EXPECT_EQ(user.count(), 1);
  EXPECT_EQ(names().size(), 4U) << "cancelled";
}

TEST_F(Importing, KeepsTheSceneWhenItIsCancelled) {
  const DialogUser user([](ImportDialog& dialog) { QTest::keyClick(&dialog, Qt::Key_Escape); });
  drop({model("chair.obj")});
  EXPECT_EQ(user.count(), 1);
  EXPECT_THAT(names(), IsEmpty());
  EXPECT_FALSE(document().is_modified());
}

/// Drops a file on a place of the view.
void drop_on_view(SceneView& view, const QString& file, QPoint place) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&view, &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&view, &drop);
}

TEST_F(Importing, TakesADroppedImageAsTextureOrEnvironment) {
  const QString image = GRANADA_SOURCE_DIR "/samples/garden/paving.png";
  open(test::BunnyFile);
  const auto textured = [this] {
    return faces_where([](const grf::Surface& surface) { return surface.texture.has_value(); });
  };
  select_two_faces();
  ASSERT_EQ(document().selection().count(), 2U);
  const QPoint middle = window_.view().rect().center();
  drop_on_view(window_.view(), image, middle);
  EXPECT_EQ(textured(), 2U) << "the selected faces, of which it hits one";
  EXPECT_EQ(document().objects().meshes[0].flat_surfaces.back().texture, image.toStdString());
  document().undo_stack().undo();
  EXPECT_EQ(textured(), 0U);
  document().select(FaceSelection(document().objects()));
  drop_on_view(window_.view(), image, middle);
  EXPECT_EQ(textured(), 1U) << "only the face";
  document().undo_stack().undo();

  const options::RenderOptions before = document().options().valid_options();
  ASSERT_FALSE(window_.view().face_at(QPointF(3, 3)).has_value());
  drop_on_view(window_.view(), image, QPoint(3, 3));
  EXPECT_EQ(textured(), 0U);
  EXPECT_EQ(document().options().valid_options().environment, image.toStdString());
  EXPECT_EQ(document().undo_stack().undoText(), "Set environment");
  document().undo_stack().undo();
  EXPECT_EQ(document().options().valid_options().environment, before.environment);
}

TEST_F(Importing, TellsTheLossesOfAnExportBeforeItIsWritten) {
  open(QString::fromStdString(
      folder_.add("scene.grf",
                  "begin mesh \"a\" brdf ward\nbegin vertexs (0, 0, 0) (1, 0, 0) (1, 1, 0) "
                  "(0, 1, 0) end\nbegin faces (0, 1, 2, 3) end\nend\n")));
  QSettings().setValue("export/format", "glb");
  const std::vector<std::string> before = folder_.names();
  QTimer::singleShot(0, [&] {
    ASSERT_TRUE(QTest::qWaitFor(
        [] { return qobject_cast<ExportDialog*>(QApplication::activeModalWidget()) != nullptr; }, Minute));
    auto& dialog = static_cast<ExportDialog&>(*QApplication::activeModalWidget());
    auto& summary = test::named<QLabel>(dialog, "Summary of losses");
    EXPECT_TRUE(QTest::qWaitFor([&] { return summary.text() == "Nothing will be lost."; }, Minute))
        << summary.text().toStdString();
    auto& format = test::named<QComboBox>(dialog, "Format");
    format.setFocus();
    QTest::keyClicks(&format, "Stereo");
    auto& file = test::named<QLineEdit>(dialog, "File");
    EXPECT_EQ(file.text(), path("scene.stl"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return summary.text() == "This will be lost:"; }, Minute));
    EXPECT_GT(test::named<QListWidget>(dialog, "Losses").count(), 2);
    file.setFocus();
    file.selectAll();
    QTest::keyClicks(&file, path("out.obj"));
    EXPECT_TRUE(format.currentText().contains("OBJ")) << format.currentText().toStdString();
    EXPECT_EQ(folder_.names(), before) << "nothing is written yet";
    QTest::keyClick(&dialog, Qt::Key_Return);
  });
  test::action(window_, "Export...").trigger();
  ASSERT_TRUE(are_jobs_done());
  EXPECT_THAT(folder_.names(), testing::Contains("out.obj"));
}

}  // namespace
}  // namespace editor
