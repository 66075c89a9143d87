#include "editor/brdf/brdf_editor.h"

#include <QComboBox>
#include <QLineEdit>
#include <QTest>

#include <gmock/gmock.h>

#include "editor/brdf/parameter_row.h"
#include "editor/controls/scaled_slider.h"
#include "grf/read.h"
#include "tests/editor/brdf/brdf_of.h"

namespace editor {
namespace {

using Models = std::vector<grf::BrdfModel>;

class Editor : public testing::Test {
 protected:
  void SetUp() override {
    editor.resize(360, 800);
    editor.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&editor));
  }

  BrdfEditor editor;
};

TEST_F(Editor, FitsANarrowDockWithEachModelAndView) {
  for (const auto view : {BrdfEditor::View::Sphere, BrdfEditor::View::Lobe, BrdfEditor::View::Plots,
                          BrdfEditor::View::Library}) {
    editor.set_view(view);
    EXPECT_LE(editor.minimumSizeHint().width(), 360) << static_cast<int>(view);
  }
  for (const grf::ModelInfo& info : reflectance::brdf_infos()) {
    grf::BrdfModel model;
    model.keyword = info.keyword;
    editor.set_models({model});
    EXPECT_LE(editor.form().minimumSizeHint().width(), 344) << info.keyword;
  }
}

TEST_F(Editor, MovesTheViewsWhileASliderIsDragged) {
  editor.set_models({brdf_model("diffuse kd=0.2")});
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return editor.sphere().image().side > 0 && !editor.sphere().is_busy(); }, 20000));
  const auto middle = [&] {
    const SphereImage& image = editor.sphere().image();
    const auto side = static_cast<std::size_t>(image.side);
    return image.radiance[side / 2 * side + side / 2].x;
  };
  const float before = middle();
  int changes = 0;
  int edits = 0;
  QObject::connect(&editor, &BrdfEditor::changing, [&](const Models&) { ++changes; });
  QObject::connect(&editor, &BrdfEditor::edited, [&](const Models&) { ++edits; });
  auto* slider = editor.form().findChild<ParameterRow*>()->findChild<ScaledSlider*>();
  const int y = slider->height() / 2;
  QTest::mousePress(slider, Qt::LeftButton, {}, {8, y});
  for (int x = 12; x < slider->width() - 4; x += 6) QTest::mouseMove(slider, {x, y});
  EXPECT_GT(changes, 3);
  EXPECT_EQ(edits, 0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return middle() > 2 * before; }, 20000));
  QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() - 5, y});
  EXPECT_EQ(edits, 1);
}

TEST_F(Editor, UnfoldsInALargeWindow) {
  editor.set_models({brdf_model("ward")});
  EXPECT_FALSE(editor.is_unfolded());
  editor.resize(1400, 900);
  ASSERT_TRUE(QTest::qWaitFor([&] { return editor.is_unfolded(); }));
  EXPECT_TRUE(editor.sphere().isVisible() && editor.lobe().isVisible() && editor.plots().isVisible() &&
              editor.library().isVisible());
}

TEST_F(Editor, TakesABrdfFromTheLibraryForAll) {
  editor.set_models({brdf_model("ward"), brdf_model("phong")});
  editor.set_view(BrdfEditor::View::Library);
  Models taken;
  QObject::connect(&editor, &BrdfEditor::edited, [&](const Models& models) { taken = models; });
  emit editor.library().chosen(brdf_model("oren s=0.5"), {});
  EXPECT_THAT(taken, testing::ElementsAre(brdf_model("oren s=0.5"), brdf_model("oren s=0.5")));
  EXPECT_EQ(editor.models(), taken);
}

TEST_F(Editor, SaysWhyABrdfIsNotShown) {
  const auto said = [this] { return editor.sphere().accessibleDescription(); };
  editor.set_models({});
  EXPECT_EQ(said(), "Select faces to see their BRDF.");
  editor.set_models({brdf_model("ward sx=-2")});
  EXPECT_TRUE(said().contains("'sx' of 'ward'")) << said().toStdString();
  EXPECT_EQ(editor.lobe().accessibleDescription(), said());
  editor.set_models({brdf_model("wrad")});
  EXPECT_TRUE(said().contains("'wrad'")) << said().toStdString();
  const auto* chooser = editor.form().findChild<QComboBox*>();
  EXPECT_EQ(chooser->lineEdit()->placeholderText(), "wrad (unknown)");
  editor.set_models({brdf_model("ward")});
  EXPECT_EQ(said(), "");
}

TEST_F(Editor, IsEmptyWithoutASelection) {
  editor.set_models({});
  EXPECT_EQ(editor.sphere().image().side, 0);
  EXPECT_TRUE(editor.plots().curves().curves.empty());
  for (const QComboBox* chooser : editor.form().findChildren<QComboBox*>()) {
    EXPECT_FALSE(chooser->isEnabled());
    EXPECT_FALSE(chooser->toolTip().isEmpty());
  }
}

}  // namespace
}  // namespace editor
