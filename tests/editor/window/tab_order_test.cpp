// Tests the order in which Tab leads through the main window.
#include <QDockWidget>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include "editor/brdf/brdf_editor.h"
#include "editor/controls/notice_bar.h"
#include "editor/image/image_browser.h"
#include "editor/image/image_pane.h"
#include "editor/panels/light_panel.h"
#include "editor/panels/message_panel.h"
#include "editor/rendering/effects_page.h"
#include "editor/view/scene_view.h"
#include "editor/window/file_actions.h"
#include "editor/window/source_view.h"
#include "grf/read.h"
#include "tests/editor/window/accessibility.h"
#include "tests/editor/window/window_driver.h"

namespace editor {
namespace {

/// Faces whose rows in the docks differ as much as possible.
const std::string ManyRows = R"(def gold = brdf ward sx=0.2
def dull = brdf diffuse kd=0.3
def red = rgb (1, 0, 0)
begin
begin mesh
  begin vertexs
    (0, 0, 0) (2, 0, 0) (2, 1, 0) (0, 1, 0)
  end vertexs
  begin faces
    brdf phong n=20 ks=(0.1, 0.2, 0.3)
    pdf adaptive mode=reject
    rgb red
    (0, 1, 2)
    brdf combine 0.4 gold, 0.6 dull
    light rgb (1, 2, 3)
    (0, 2, 3)
    brdf ashikhmin ex=20
    light none
    (0, 1, 3)
    brdf diffuse
    (1, 2, 3)
  end faces
end mesh
end
)";

/// Tests of the tab order in the whole window.
class TabOrder : public Accessibility {
 protected:
  TabOrder() : window_(QString::fromStdString(folder_.path("sessions"))) {
    window_.resize(1900, 1150);
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
  }

  void open() {
    QSignalSpy replaced(&window_.document(), &Document::scene_replaced);
    window_.files().open(QString::fromStdString(folder_.add("rows.grf", ManyRows)));
    if (replaced.empty() && !replaced.wait(60'000)) throw std::runtime_error("the scene cannot be read");
  }

  void select_face(std::uint32_t face) {
    FaceSelection selection(window_.document().objects());
    selection.set({0, face});
    window_.document().select(std::move(selection));
  }

  QDockWidget& dock(const QString& name) { return *window_.findChild<QDockWidget*>(name); }

  void expect_all_views_of_brdfs() {
    using View = BrdfEditor::View;
    for (const View view : {View::Lobe, View::Plots, View::Library, View::Sphere}) {
      SCOPED_TRACE(static_cast<int>(view));
      window_.brdf_editor().set_view(view);
      check_controls(window_);
    }
  }

  test::TemporaryFolder folder_;
  MainWindow window_;
};

TEST_F(TabOrder, LeadsToAllOfAFreshWindow) {
  expect_tab_leads_to_all(window_.view());
  for (const char* name : {"render", "messages"}) {
    SCOPED_TRACE(name);
    Docks::show(&dock(name));
    expect_tab_leads_to_all(window_.view());
  }
}

TEST_F(TabOrder, LeadsToAllOfWhatFacesHave) {
  open();
  expect_tab_leads_to_all(window_.view());
  test::action(window_, "All").trigger();
  expect_tab_leads_to_all(window_.view());
  for (std::uint32_t face = 0; face < 4; ++face) {  // each with its own form, which is created and removed
    SCOPED_TRACE(face);
    select_face(face);
    check_controls(window_);
  }
  grf::Diagnostics diagnostics;
  window_.brdf_editor().set_models({*grf::read_brdf("measured \"a.binary\"", "test", diagnostics)});
  check_controls(window_);
  test::action(window_, "Add a light").trigger();
  window_.findChild<LightPanel*>()->choose(window_.document().objects().lights.back().path);
  expect_tab_leads_to_all(window_.view());
}

TEST_F(TabOrder, LeadsToAllOfTheBrdfEditorInEachOfItsShapes) {
  open();
  select_face(0);
  expect_all_views_of_brdfs();
  ASSERT_FALSE(window_.brdf_editor().is_unfolded());
  window_.resizeDocks({&dock("brdf")}, {1000}, Qt::Horizontal);
  ASSERT_TRUE(QTest::qWaitFor([this] { return window_.brdf_editor().is_unfolded(); }));
  expect_all_views_of_brdfs();
  select_face(1);
  expect_tab_leads_to_all(window_.view());
  window_.resizeDocks({&dock("brdf")}, {360}, Qt::Horizontal);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !window_.brdf_editor().is_unfolded(); }));
  expect_all_views_of_brdfs();
}

TEST_F(TabOrder, LeadsToAllOfNoticesAndPages) {
  open();
  window_.notice().show_notice(NoticeBar::Kind::Information, "Something", {{"Mend it", "Mends it", {}}});
  expect_tab_leads_to_all(window_.view());
  expect_tab_leads_to_all(window_.image_browser().pane());
  test::action(window_, "Effects").trigger();
  expect_tab_leads_to_all(window_.findChild<EffectsPage*>()->table());
  const std::string path = folder_.path("rows.grf");
  emit window_.message_panel().place_requested(grf::whole_file(path));
  QPlainTextEdit& text = *window_.findChild<SourceView*>()->text();
  ASSERT_TRUE(QTest::qWaitFor([&text] { return text.isVisible(); }));
  expect_tab_leads_to_all(text);
}

TEST_F(TabOrder, BeginsWhereAltAndALetterLead) {
  open();
  select_face(0);
  for (const auto& [letter, name] : {std::pair(Qt::Key_B, "BRDF"), std::pair(Qt::Key_O, "Colour, red"),
                                     std::pair(Qt::Key_A, "Irradiance, red")}) {
    window_.show_scene();
    QTest::keyClick(&window_.view(), letter, Qt::AltModifier);
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    EXPECT_EQ(QApplication::focusWidget()->accessibleName(), name);
  }
}

TEST_F(TabOrder, StaysWhereDocksAreMoved) {
  open();
  select_face(0);
  for (const char* name : {"scene", "brdf"}) {
    SCOPED_TRACE(name);
    dock(name).setFloating(true);
    window_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
    expect_tab_leads_to_all(window_.view());
    dock(name).setFloating(false);
    expect_tab_leads_to_all(window_.view());
  }
  window_.tabifyDockWidget(&dock("scene"), &dock("surface"));
  expect_tab_leads_to_all(window_.view());
  test::action(window_, "Reset layout").trigger();
  expect_tab_leads_to_all(window_.view());
}

}  // namespace
}  // namespace editor
