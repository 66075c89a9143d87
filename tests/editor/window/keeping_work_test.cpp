// Tests that no work is lost: to a bake, to another program, to closing the window.
#include <QAbstractButton>
#include <QMessageBox>
#include <QPlainTextEdit>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/document/light_edits.h"
#include "editor/rendering/irradiance_bake.h"
#include "editor/rendering/render_panel.h"
#include "grf/read.h"
#include "tests/editor/answer.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using test::Minute;
using testing::HasSubstr;

using KeepingWork = Authoring;

/// A lit floor, half of which is in an included file.
void add_lit_floor(const test::TemporaryFolder& folder) {
  const std::string floor =
      "begin mesh begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs begin faces (0,1,2,3) end faces "
      "end mesh\n";
  folder.add("floor.grf", floor);
  folder.add("scene.grf",
             "light begin (0,0,1) (1,0,0) (0,1,0) end\ninclude \"floor.grf\"\n"
             "transform translation (1,0,0) begin " +
                 floor + "end\n");
  folder.add("other.grf", "light begin (0,0,1) (1,0,0) (0,1,0) end\n" + floor);
}

std::size_t lit_vertices(const Document& document) {
  std::size_t count = 0;
  for (const MeshObject& object : document.objects().meshes) {
    for (std::size_t i = 0; i < object.mesh->geometry->positions.size(); ++i) {
      if (object.mesh->irradiance->has(i)) ++count;
    }
  }
  return count;
}

TEST_F(KeepingWork, BakesIrradianceIntoTheSceneAsItIsAndSavesItAsIgrf) {
  add_lit_floor(folder_);
  open(path("scene.grf"));
  test::action(window_, "Bake irradiance").trigger();
  document().replace("Add an observer", add_observer(document().scene(), {0, 0, 5}));  // meanwhile
  ASSERT_TRUE(QTest::qWaitFor([this] { return lit_vertices(document()) == 8; }, Minute));
  EXPECT_EQ(document().objects().observers.size(), 1U);
  EXPECT_EQ(document().undo_stack().undoText(), "Bake irradiance");
  {
    const test::FileTyping accepts("");
    test::action(window_, "Save").trigger();
  }
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_.files().is_saving(); }, Minute));
  EXPECT_EQ(document().path(), path("scene.igrf"));
  EXPECT_FALSE(document().is_modified());
  grf::Diagnostics diagnostics;
  const auto saved = grf::read(folder_.path("scene.igrf"), diagnostics);
  ASSERT_TRUE(saved) << diagnostics.to_text();
  EXPECT_EQ(*saved, document().scene());
  const auto& blocks = saved->contents.blocks;
  EXPECT_TRUE(std::any_of(blocks.begin(), blocks.end(), [](const grf::Block& block) {
    const auto* include = std::get_if<grf::Include>(&block.content);
    return include != nullptr && include->file == "floor.igrf";
  }));
  EXPECT_TRUE(QFile::exists(path("floor.grf")));
  document().undo_stack().undo();
  EXPECT_EQ(lit_vertices(document()), 0U);
}

TEST_F(KeepingWork, OffersToReloadKeepOrCompareWhatAnotherProgramWrote) {
  add_lit_floor(folder_);
  open(path("scene.grf"));
  const auto press = [this](const QString& text) {
    for (QAbstractButton* button : window_.notice().findChildren<QAbstractButton*>()) {
      if (button->text() == text) return button->click();
    }
    FAIL() << "no button " << text.toStdString();
  };
  const auto told = [this] {
    return QTest::qWaitFor(
        [this] {
          return window_.notice().isVisible() && window_.notice().text().contains("Another program");
        },
        Minute);
  };
  folder_.add("scene.grf", "light begin (0,0,9) (1,0,0) (0,1,0) end\ninclude \"floor.grf\"\n");
  ASSERT_TRUE(told());
  press("Compare");
  auto& comparison = test::named<QPlainTextEdit>(window_, "Differences between the scene and its file");
  ASSERT_TRUE(QTest::qWaitFor([&] { return comparison.toPlainText().contains("@@"); }, Minute));
  EXPECT_THAT(comparison.toPlainText().toStdString(), HasSubstr("(0, 0, 9)"));
  EXPECT_EQ(document().objects().meshes.size(), 2U) << "which changes nothing";
  folder_.add("scene.grf", "include \"floor.grf\"\n");
  ASSERT_TRUE(told());
  press("Reload");
  ASSERT_TRUE(QTest::qWaitFor([this] { return document().objects().meshes.size() == 1; }, Minute));
  EXPECT_FALSE(document().is_modified());
  folder_.add("floor.grf", "light begin (0,0,9) (1,0,0) (0,1,0) end\n");
  ASSERT_TRUE(told());
  press("Keep mine");
  EXPECT_TRUE(window_.files().outside_changes().files().empty());
  EXPECT_EQ(document().objects().meshes.size(), 1U);
}

TEST_F(KeepingWork, ClosesOnceTheSceneIsWritten) {
  QFile::copy("/usr/share/glmark2/models/bunny.obj", path("bunny.obj"));
  open(path("bunny.obj"));
  window_.files().save_as(path("bunny.grf"));
  EXPECT_FALSE(window_.close()) << "it is being written";
  EXPECT_TRUE(window_.isVisible());
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_.isVisible(); }, Minute));
  EXPECT_FALSE(document().is_modified());
  grf::Diagnostics diagnostics;
  EXPECT_EQ(*grf::read(folder_.path("bunny.grf"), diagnostics), document().scene());
}

TEST_F(KeepingWork, ClosesAfterSavingWhereTheAuthorSaysSo) {
  add_lit_floor(folder_);
  open(path("scene.grf"));
  document().replace("Add an observer", add_observer(document().scene(), {0, 0, 5}));
  test::answer(QMessageBox::Save);
  window_.close();
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_.isVisible(); }, Minute));
  grf::Diagnostics diagnostics;
  EXPECT_EQ(*grf::read(folder_.path("scene.grf"), diagnostics), document().scene());
}

TEST_F(KeepingWork, AsksBeforeClosingEndsARenderOrABake) {
  add_lit_floor(folder_);
  folder_.add("scene.op", "BPT_Scene scene.grf\nBPT_Image_Resolution 64 64\nBPT_Samples 2000000000\n");
  open(path("scene.grf"));
  QStringList asked;
  QMessageBox::StandardButton button = QMessageBox::Cancel;
  QTimer answers;
  answers.callOnTimeout([&] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (question == nullptr) return;
    asked << question->text();
    // The bake may have finished by then, and is not saved.
    QAbstractButton* answer = question->button(button);
    (answer != nullptr ? answer : question->button(QMessageBox::Discard))->click();
  });
  answers.start(20);
  window_.render_panel().render_action()->trigger();
  EXPECT_FALSE(window_.close());
  EXPECT_EQ(asked, QStringList("A render is running."));
  EXPECT_TRUE(window_.isVisible());
  window_.render_panel().final_render().stop();
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return !window_.render_panel().final_render().is_running(); }, Minute));
  test::action(window_, "Bake irradiance").trigger();
  button = QMessageBox::Close;
  EXPECT_TRUE(window_.close());
  EXPECT_TRUE(asked.contains("Irradiance is being baked."));
}

TEST_F(KeepingWork, GivesNoIrradianceToASceneThatWasOpenedMeanwhile) {
  add_lit_floor(folder_);
  open(path("scene.grf"));
  test::action(window_, "Bake irradiance").trigger();
  grf::Diagnostics diagnostics;
  const auto other = grf::read(folder_.path("other.grf"), diagnostics);
  ASSERT_TRUE(other) << diagnostics.to_text();
  document().take(*other, path("other.grf"), {});
  const auto* bake = window_.findChild<IrradianceBake*>();
  ASSERT_NE(bake, nullptr);
  ASSERT_TRUE(QTest::qWaitFor([bake] { return !bake->is_running(); }, Minute));
  EXPECT_EQ(document().scene(), *other);
  EXPECT_EQ(document().path(), path("other.grf"));
  EXPECT_FALSE(document().is_modified());
  EXPECT_THAT(window_.notice().text().toStdString(), HasSubstr("baked irradiance was discarded"));
}

}  // namespace
}  // namespace editor
