// The page Effects through the whole window, by pointer and keyboard.
#include "editor/rendering/effects_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/number_box.h"
#include "editor/image/image_browser.h"
#include "editor/image/image_tools.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using testing::ElementsAre;
using transport::Effect;

/// A diffuse plane that fills the image, in the light of a background of 1; the plane's vertices have half of
/// its colour. Before it is a dim lamp that faces the eye, and behind it a mesh without colours.
class EffectsOfAScene : public Authoring {
 protected:
  EffectsOfAScene() {
    std::ofstream(folder_.path("scene.grf"))
        << "begin mesh \"plain\" brdf diffuse begin vertexs (-1,-1,-2) (1,-1,-2) (1,1,-2) end vertexs begin "
           "faces (0,1,2) end faces end mesh\n"
           "begin mesh \"coloured\" brdf diffuse kd=0.8 begin vertexs rgb (0.5,0.5,0.5) (-9,-9,0) rgb "
           "(0.5,0.5,0.5) (9,-9,0) rgb (0.5,0.5,0.5) (9,9,0) rgb (0.5,0.5,0.5) (-9,9,0) end vertexs begin "
           "faces (0,1,2) (0,2,3) end faces end mesh\n"
           "light begin rgb (0.01,0.01,0.01) (-0.1,-0.1,3) (0.2,0,0) (0,0.2,0) end\n";
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 0 4\nBPT_VLook 0 0 0\nBPT_Background 1 1 1\n"
           "BPT_Image_Resolution 64 48\n";
    open(path("scene.grf"));
    QTest::keyClick(&window_, Qt::Key_D, Qt::ControlModifier | Qt::AltModifier);
    page_ = window_.findChild<EffectsPage*>();
    EXPECT_TRUE(QTest::qWaitFor([this] { return table().topLevelItemCount() > 0; }, test::Minute));
  }

  QTreeWidget& table() { return page_->table(); }
  QTreeWidgetItem& row(Effect effect) { return *table().topLevelItem(static_cast<int>(effect)); }
  /// The middle of a cell, or its check box.
  void click(Effect effect, EffectsPage::Column column, bool on_box = false) {
    table().scrollToItem(&row(effect));
    QRect cell = table().visualItemRect(&row(effect));
    cell.setLeft(table().header()->sectionViewportPosition(column));
    cell.setWidth(table().header()->sectionSize(column));
    const QPoint at = on_box ? QPoint(cell.left() + 10, cell.center().y()) : cell.center();
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, at);
  }
  QPushButton& button(const QString& text) {
    for (QPushButton* each : page_->findChildren<QPushButton*>()) {
      if (each->text() == text) return *each;
    }
    throw std::runtime_error("no button " + text.toStdString());
  }
  bool has_measured() {
    return QTest::qWaitFor([this] { return !page_->is_measuring(); }, 5 * test::Minute) &&
           page_->shares_of(Effect::VertexColours) != nullptr;
  }
  void measure() {
    test::named<NumberBox>(*page_, "Time of the measurement").setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(QApplication::focusWidget(), "0.3");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    QTest::mouseClick(&button("Measure"), Qt::LeftButton);
  }
  const options::RenderOptions& options() { return document().options().valid_options(); }
  QString state() { return test::named<QLabel>(*page_, "State of the measurement").text(); }

  EffectsPage* page_ = nullptr;
};

TEST_F(EffectsOfAScene, AreSelectedByTheFacesThatCallForThem) {
  EXPECT_EQ(table().topLevelItemCount(), static_cast<int>(transport::EffectInfos.size()));
  EXPECT_EQ(row(Effect::VertexColours).text(EffectsPage::Name), "Vertex colours");
  EXPECT_THAT(row(Effect::VertexColours).text(EffectsPage::Why).toStdString(),
              testing::StartsWith("Needed: 2 faces that a path can hit have vertex colours"));
  EXPECT_EQ(row(Effect::Textures).text(EffectsPage::Why), "Not needed: no face has a texture");
  click(Effect::VertexColours, EffectsPage::Why);
  EXPECT_EQ(document().selection().count(0), 0U) << "it has no colours";
  EXPECT_EQ(document().selection().count(1), 2U);
  EXPECT_TRUE(document().selected_objects().empty());
  click(Effect::AreaLights, EffectsPage::Why);
  EXPECT_TRUE(document().selection().empty());
  ASSERT_EQ(document().selected_objects().size(), 1U);
  EXPECT_EQ(document().selected_objects().front(), document().objects().lights.front().path);
  click(Effect::VertexColours, EffectsPage::Name);
  QTest::mouseClick(&button("Select faces"), Qt::LeftButton);
  EXPECT_EQ(document().selection().count(), 2U);
  QTest::keyClick(&table(), Qt::Key_Return);
  EXPECT_FALSE(page_->isVisible()) << "the scene is shown";
}

// The plane's radiance is 0.4, and 0.8 without vertex colours. The lamp, a square of 0.2 at a distance of 1,
// covers a fraction of the image with a radiance of 0.01.
TEST_F(EffectsOfAScene, HaveSharesOfTheLight) {
  const double height = 2 * std::tan(M_PI / 8);
  const double lamp = 0.04 / (height * height * 64 / 48);
  const double plane = 0.4 * (1 - lamp);
  const double light = plane + 0.01 * lamp;
  measure();
  EXPECT_TRUE(page_->is_measuring());
  EXPECT_TRUE(button("Stop measuring").isEnabled());
  ASSERT_TRUE(has_measured()) << state().toStdString();
  const EffectShares& colours = *page_->shares_of(Effect::VertexColours);
  ASSERT_TRUE(colours.light);
  EXPECT_NEAR(colours.light->share, -plane / light, 0.01);
  EXPECT_NEAR(*colours.difference, 0.4 * std::sqrt(1 - lamp) / light, 0.01);
  const EffectShares& background = *page_->shares_of(Effect::Background);
  ASSERT_TRUE(background.light);
  EXPECT_NEAR(background.light->share, plane / light, 0.0002);
  EXPECT_EQ(row(Effect::Background).text(EffectsPage::Light), "99.9 %");
  EXPECT_THAT(row(Effect::Background).text(EffectsPage::Time).toStdString(), testing::HasSubstr(" %"));
  EXPECT_FALSE(row(Effect::VertexColours).icon(EffectsPage::Difference).isNull());
  EXPECT_EQ(row(Effect::Textures).text(EffectsPage::Light), "") << "nothing to measure";
  EXPECT_THAT(state().toStdString(), testing::StartsWith("Measured on a small image"));
}

TEST_F(EffectsOfAScene, AreSwitchedByOneUndoStepEach) {
  const int steps = document().undo_stack().index();
  click(Effect::VertexColours, EffectsPage::Name, true);
  EXPECT_THAT(options().without, ElementsAre("vertex_colours"));
  EXPECT_EQ(document().undo_stack().index(), steps + 1);
  ASSERT_TRUE(QTest::qWaitFor(
      [this] {
        return row(Effect::VertexColours).text(EffectsPage::Why) == "Not needed: it is switched off";
      },
      test::Minute));
  EXPECT_EQ(row(Effect::VertexColours).checkState(EffectsPage::Name), Qt::Unchecked);
  table().setCurrentItem(&row(Effect::Background));
  QTest::keyClick(&table(), Qt::Key_Space);
  EXPECT_THAT(options().without, testing::UnorderedElementsAre("vertex_colours", "background"));
  QTest::mouseClick(&button("Switch all on"), Qt::LeftButton);
  EXPECT_TRUE(options().without.empty());
  EXPECT_EQ(document().undo_stack().index(), steps + 3);
  for (int i = 0; i < 3; ++i) document().undo_stack().undo();
  EXPECT_TRUE(options().without.empty());
  EXPECT_TRUE(QTest::qWaitFor(
      [this] { return row(Effect::VertexColours).checkState(EffectsPage::Name) == Qt::Checked; },
      test::Minute));
}

TEST_F(EffectsOfAScene, AreComparedWithTheFullImage) {
  EXPECT_FALSE(button("Difference to the full image").isEnabled()) << "nothing is measured";
  measure();
  ASSERT_TRUE(has_measured());
  click(Effect::VertexColours, EffectsPage::Name);
  QTest::mouseClick(&button("Difference to the full image"), Qt::LeftButton);
  ImageBrowser& images = window_.image_browser();
  EXPECT_FALSE(page_->isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return images.names().size() == 2; }, test::Minute));
  EXPECT_TRUE(images.names().contains("Vertex colours: full image"));
  EXPECT_THAT(images.shown_path().toStdString(), testing::EndsWith("vertex_colours_without.exr"));
}

TEST_F(EffectsOfAScene, AreOutdatedByEdits) {
  measure();
  ASSERT_TRUE(has_measured());
  options::RenderOptions other = options();
  other.depth = 1;
  document().options().set_options("Change depth", other);
  EXPECT_THAT(state().toStdString(), testing::HasSubstr("have changed since"));
  QTest::mouseClick(&button("Measure"), Qt::LeftButton);
  EXPECT_TRUE(page_->is_measuring());
  QTest::mouseClick(&button("Stop measuring"), Qt::LeftButton);
  EXPECT_FALSE(page_->is_measuring());
}

options::RenderOptions switched(options::RenderOptions from, Effect effect, bool is_on) {
  switch_effect(from, effect, is_on);
  return from;
}

// By the table of groups in EFFECTS.md: `indirect` is both kinds of interreflection.
TEST(SwitchEffect, ReplacesGroupsByTheirOtherEffects) {
  options::RenderOptions options;
  options.without = {"textures", "indirect"};
  EXPECT_THAT(switched(options, Effect::DiffuseInterreflection, true).without,
              ElementsAre("textures", "glossy_interreflection"));
  options.without.clear();
  options.only = {"area_lights", "indirect"};
  EXPECT_THAT(switched(options, Effect::GlossyInterreflection, false).only,
              ElementsAre("area_lights", "diffuse_interreflection"));
  EXPECT_THAT(switched(options, Effect::Textures, true).only,
              ElementsAre("area_lights", "indirect", "textures"));
  EXPECT_EQ(switched(options, Effect::Textures, false), options) << "it is off already";
  options.without = {"textures"};
  const options::RenderOptions both = switched(options, Effect::Textures, true);
  EXPECT_TRUE(both.effects().has(Effect::Textures));
  EXPECT_TRUE(both.without.empty());
}

}  // namespace
}  // namespace editor
