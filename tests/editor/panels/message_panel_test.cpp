#include "editor/panels/message_panel.h"

#include <QListView>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QtTest>

#include <gtest/gtest.h>

#include "renderer/reflectance/scheme.h"
#include "tests/editor/panels/panel_scene.h"
#include "tests/editor/scene_of.h"

namespace editor {
namespace {

class MessagePanels : public testing::Test {
 protected:
  MessagePanels() : panel_(document_, reflectance::catalogue()) {
    document_.take(scene_of(PanelScene), {}, {});
    panel_.resize(700, 240);
    panel_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel_));
    wait();
  }

  void wait() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return panel_.check().is_up_to_date(); }));
  }

  Document document_;
  MessagePanel panel_;
};

TEST_F(MessagePanels, CheckTheSceneAfterEdits) {
  EXPECT_EQ(panel_.error_count(), 0U);
  FaceSelection faces(document_.objects());
  faces.set({1, 0});
  document_.select(faces);
  SurfaceEdit edit;
  grf::BrdfModel wrong;
  wrong.keyword = "wrad";
  edit.brdf = AttributeEdit<grf::BrdfAttribute>::set(wrong);
  document_.edit_surfaces("Assign", edit);
  wait();
  EXPECT_EQ(panel_.error_count(), 1U);
  document_.undo_stack().undo();
  wait();
  EXPECT_EQ(panel_.error_count(), 0U);
}

TEST_F(MessagePanels, SayOnceWhatTheScreenCannotDoUntilAnotherSceneOpens) {
  const std::size_t before = panel_.warning_count();
  panel_.add_warning("the driver refuses a shader");
  panel_.add_warning("the driver refuses a shader");
  panel_.add_warning("a texture is too large");
  EXPECT_EQ(panel_.warning_count(), before + 2);
  document_.take(scene_of(PanelScene), {}, {});
  wait();
  EXPECT_EQ(panel_.warning_count(), before);
}

TEST_F(MessagePanels, LeadToWhatWasWrittenThere) {
  grf::Diagnostics diagnostics;
  grf::SourceLocation location = document_.objects().meshes[1].mesh->surfaces.back().location;
  diagnostics.error(location, "something is wrong here");
  panel_.show_diagnostics(diagnostics);
  QSignalSpy places(&panel_, &MessagePanel::place_requested);
  const QModelIndex first = panel_.view()->model()->index(0, 0);
  const QPoint place = panel_.view()->visualRect(first).center();
  QTest::mouseClick(panel_.view()->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseDClick(panel_.view()->viewport(), Qt::LeftButton, {}, place);
  ASSERT_EQ(places.count(), 1);
  EXPECT_EQ(places.front().front().value<grf::SourceLocation>().line, location.line);
  EXPECT_TRUE(document_.selection().has({1, 0}));
  EXPECT_FALSE(document_.selection().has({0, 0}));
}

TEST_F(MessagePanels, SayThatNothingIsWrong) {
  document_.take(scene_of("light begin (0,0,0) (1,0,0) (0,1,0) end\n"), {}, {});
  wait();
  const int page = panel_.findChild<QStackedWidget*>()->currentIndex();
  EXPECT_EQ(page, panel_.error_count() + panel_.warning_count() == 0 ? 0 : 1);
}

}  // namespace
}  // namespace editor
