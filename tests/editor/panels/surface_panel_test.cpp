#include "editor/panels/surface_panel.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QToolButton>
#include <QtTest>
#include <algorithm>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/appearance/theme.h"
#include "editor/controls/number_box.h"
#include "editor/controls/scaled_slider.h"
#include "editor/document/brdf_mime.h"
#include "editor/document/light_edits.h"
#include "editor/panels/texture_preview.h"
#include "grf/write.h"
#include "renderer/reflectance/scheme.h"
#include "tests/editor/panels/panel_scene.h"
#include "tests/editor/scene_of.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

class SurfacePanels : public testing::Test {
 protected:
  SurfacePanels() : catalogue_(reflectance::catalogue()), panel_(document_, catalogue_) {
    QImage image(8, 4, QImage::Format_RGB32);
    image.fill(Qt::red);
    image.save(QString::fromStdString(folder_.path("wood.png")));
    document_.take(scene_of(PanelScene), QString::fromStdString(folder_.path("scene.grf")), {});
    panel_.resize(360, 720);
    panel_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&panel_));
  }

  void select(std::initializer_list<FaceId> faces) {
    FaceSelection selection(document_.objects());
    for (const FaceId& face : faces) selection.set(face);
    document_.select(selection);
  }
  /// The control with that accessible name.
  template <class Widget>
  Widget* find(const QString& name) const {
    for (Widget* widget : panel_.findChildren<Widget*>()) {
      if (widget->accessibleName() == name) return widget;
    }
    ADD_FAILURE() << "no control is called " << name.toStdString();
    return nullptr;
  }
  void click(const QString& button) { QTest::mouseClick(find<QToolButton>(button), Qt::LeftButton); }
  void type(QWidget* field, const QString& text) {
    field->setFocus();
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
  }
  /// Opens a list and takes an entry, by the keyboard: a list ignores clicks that come too soon after it
  /// opened.
  void choose(const QString& list, const QString& text) {
    auto* box = find<QComboBox>(list);
    QTest::mouseClick(box, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(box->view()->window()));
    const QModelIndex index = box->model()->index(box->findText(text), 0);
    ASSERT_TRUE(index.isValid());
    box->view()->setCurrentIndex(index);
    QTest::keyClick(box->view(), Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([box] { return !box->view()->isVisible(); }));
  }
  /// Whether a visible label contains the words.
  bool says(const QString& words) const {
    const auto labels = panel_.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&words](const QLabel* label) {
      return label->isVisible() && label->text().contains(words);
    });
  }
  const grf::Mesh& sides() const { return *document_.objects().meshes[1].mesh; }

  const test::TemporaryFolder folder_;
  Document document_;
  const grf::Catalogue catalogue_;
  SurfacePanel panel_;
};

TEST_F(SurfacePanels, SayWhatToDoWithoutASelection) {
  EXPECT_EQ(panel_.findChild<QStackedWidget*>()->currentIndex(), 0);
  select({{1, 0}});
  EXPECT_EQ(panel_.findChild<QStackedWidget*>()->currentIndex(), 1);
}

TEST_F(SurfacePanels, MakeAWholeSurfaceAndUndoIt) {
  QApplication::setDoubleClickInterval(1);  // the second click is no double click
  const grf::Scene before = document_.scene();
  select({{1, 0}, {1, 1}});
  choose("BRDF", "new ward");
  EXPECT_EQ(std::get<grf::BrdfModel>(*sides().surface(0).brdf).keyword, "ward");
  type(find<NumberBox>("Power"), "60");
  const std::vector<Emitter> emitters = emitters_of(document_.objects());
  ASSERT_EQ(emitters.size(), 2U);
  EXPECT_NEAR(emitters[1].power, 60, 1e-3);
  EXPECT_EQ(emitters[1].count, 2U);
  EXPECT_NEAR(find<NumberBox>("Radiance, red")->value(), 60 / (4 * std::numbers::pi), 1e-4);
  type(find<QComboBox>("Texture")->lineEdit(), "wood.png");
  EXPECT_EQ(document_.objects().meshes[1].flat_surfaces[0].texture, folder_.path("wood.png"));
  const grf::Scene after = document_.scene();
  EXPECT_EQ(document_.undo_stack().count(), 3);
  while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), before);
  EXPECT_EQ(grf::to_text(document_.scene()), grf::to_text(before));
  while (document_.undo_stack().canRedo()) document_.undo_stack().redo();
  EXPECT_EQ(document_.scene(), after);
}

TEST_F(SurfacePanels, EditTheOpacity) {
  using Kind = grf::Opacity::Kind;
  const auto opacity = [](Kind kind, float value) { return std::optional(grf::Opacity{kind, value}); };
  select({{1, 0}, {1, 1}});
  EXPECT_EQ(find<QComboBox>("Kind of opacity")->currentText(), "Uniform");
  EXPECT_EQ(find<NumberBox>("Opacity")->value(), 1);
  EXPECT_FALSE(find<QToolButton>("Reset the opacity")->isEnabled());
  type(find<NumberBox>("Opacity"), "0.25");
  EXPECT_EQ(sides().surface(0).opacity, opacity(Kind::Number, 0.25F));
  EXPECT_EQ(sides().surface(1).opacity, opacity(Kind::Number, 0.25F));
  choose("Kind of opacity", "Cut out by alpha");
  EXPECT_EQ(sides().surface(0).opacity, opacity(Kind::Mask, 0.5F));
  EXPECT_EQ(find<NumberBox>("Opacity")->value(), 0.5);
  select({{1, 1}});
  choose("Kind of opacity", "Blended by alpha");
  EXPECT_EQ(sides().surface(0).opacity, opacity(Kind::Mask, 0.5F));
  EXPECT_EQ(sides().surface(1).opacity, opacity(Kind::Blend, 1));
  select({{1, 0}, {1, 1}});
  EXPECT_EQ(find<QComboBox>("Kind of opacity")->currentIndex(), -1) << "mixed";
  click("Reset the opacity");
  EXPECT_EQ(sides().surface(0).opacity, std::nullopt);
  EXPECT_EQ(sides().surface(1).opacity, std::nullopt);
}

TEST_F(SurfacePanels, ShowWhatFacesHave) {
  select({{1, 1}});
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "gold");
  EXPECT_FALSE(find<QToolButton>("Define the BRDF")->isEnabled());
  EXPECT_EQ(find<QToolButton>("Define the BRDF")->toolTip(), "The BRDF is a named definition already.");
  select({{1, 0}});
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "diffuse kd=0.8");
  select({{1, 0}, {1, 1}});
  EXPECT_EQ(find<QComboBox>("BRDF")->currentIndex(), -1);
  EXPECT_EQ(find<QComboBox>("BRDF")->placeholderText(), "mixed");
  EXPECT_FALSE(find<QToolButton>("Edit the BRDF")->isEnabled());
}

TEST_F(SurfacePanels, DefineABrdf) {
  select({{1, 0}});
  click("Define the BRDF");
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "my_diffuse");
  EXPECT_THAT(grf::to_text(document_.scene()), testing::HasSubstr("def my_diffuse = brdf diffuse kd=0.8"));
  EXPECT_TRUE(document_.selection().has({1, 0}));
  document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
}

TEST_F(SurfacePanels, CopyFromAFace) {
  QSignalSpy picks(&panel_, &SurfacePanel::pick_requested);
  select({{1, 0}});
  click("Pick the BRDF from a face");
  ASSERT_EQ(picks.count(), 1);
  panel_.take_from({1, 1});
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "gold");
  select({{0, 0}});
  click("Copy surface from a face");
  panel_.take_from({1, 1});
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "gold");
}

TEST_F(SurfacePanels, TakeADroppedBrdf) {
  select({{1, 0}});
  const auto bring = [this](const QMimeData& data) {
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&panel_, &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&panel_, &drop);
  };
  grf::BrdfModel ward = {{"ward", {{"sx", 0.2F, {}}}, {}}, {}, {}, {}};
  bring(*mime_of(ward, "gold"));
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "gold");
  bring(*mime_of(ward));
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "ward sx=0.2");
  ward.arguments[0].value = -1.0F;
  bring(*mime_of(ward));
  EXPECT_EQ(find<QComboBox>("BRDF")->currentText(), "ward sx=0.2");
  EXPECT_TRUE(says("'sx' of 'ward'"));
  EXPECT_EQ(document_.undo_stack().count(), 2);
}

TEST_F(SurfacePanels, CheckParametersOfASamplingScheme) {
  select({{1, 0}});
  QApplication::setDoubleClickInterval(1);
  choose("Sampling scheme", "new hemisphere");
  const int steps = document_.undo_stack().count();
  auto* exponent = find<NumberBox>("exp");
  ASSERT_TRUE(exponent->isVisible());
  type(exponent, "20");
  EXPECT_EQ(grf::to_text(std::get<grf::PdfModel>(*sides().surface(0).pdf)), "hemisphere exp=20");
  EXPECT_EQ(document_.undo_stack().count(), steps + 1);
  auto* slider = find<ScaledSlider>("exp");
  QWidget* next = find<QComboBox>("Sampling scheme");
  for (int i = 0; i < 12 && next != slider; ++i) next = next->nextInFocusChain();
  EXPECT_EQ(next, slider) << "Tab leads on to the parameters";
  const int y = slider->height() / 2;
  QTest::mousePress(slider, Qt::LeftButton, {}, {4, y});
  for (int x = 8; x < slider->width() - 4; x += 4) QTest::mouseMove(slider, {x, y});
  QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() - 5, y});
  EXPECT_EQ(document_.undo_stack().count(), steps + 2) << "a drag is one step";
  EXPECT_NE(grf::to_text(std::get<grf::PdfModel>(*sides().surface(0).pdf)), "hemisphere exp=20");
  document_.undo_stack().undo();
  EXPECT_EQ(exponent->text(), "20");
}

TEST_F(SurfacePanels, ShowAnUnknownSamplingSchemeAsOne) {
  select({{1, 0}});
  QApplication::setDoubleClickInterval(1);
  SurfaceEdit edit;
  edit.pdf = AttributeEdit<grf::PdfAttribute>::set(grf::PdfModel{{"Owm", {}, {}}});
  document_.edit_surfaces("Assign scheme Owm", edit);
  EXPECT_EQ(find<QComboBox>("Sampling scheme")->currentText(), "Owm (unknown)");
  EXPECT_TRUE(says("unknown PDF 'Owm'"));
  const grf::Scene before = document_.scene();
  choose("Sampling scheme", "Owm (unknown)");
  EXPECT_EQ(document_.scene(), before);
  choose("Sampling scheme", "BRDF default");
  EXPECT_FALSE(says("unknown PDF"));
}

TEST_F(SurfacePanels, GiveColoursAndWhatVerticesHave) {
  select({{1, 0}});
  type(find<NumberBox>("Colour, green"), "0.5");
  EXPECT_EQ(std::get<grf::Colour>(*sides().surface(0).colour), grf::Colour(0.5F));
  type(find<NumberBox>("Irradiance, red"), "3");
  type(find<NumberBox>("Vertex colour, red"), "0.25");
  EXPECT_EQ(sides().geometry->colours[sides().face(0)[0]], grf::Colour(0.25F));
  EXPECT_EQ(std::get<grf::Colour>((*sides().irradiance)[sides().face(0)[0]]), grf::Colour(3));
  click("Smooth normals");
  EXPECT_TRUE(sides().geometry->normals.has(sides().face(0)[0]));
  click("Flip the faces");
  EXPECT_EQ(sides().geometry->normals[sides().face(0)[0]], grf::Vec3f(0, 0, -1));
  click("Flat faces");
  click("Clear the irradiance");
  click("Clear the vertex colours");
  EXPECT_TRUE(sides().geometry->normals.empty() && sides().geometry->colours.empty() &&
              sides().irradiance->empty());
  while (document_.undo_stack().canUndo()) document_.undo_stack().undo();
  EXPECT_EQ(document_.scene(), scene_of(PanelScene));
}

TEST_F(SurfacePanels, TakeArithmeticAndUnits) {
  select({{1, 0}});
  auto* power = find<NumberBox>("Power");
  EXPECT_FALSE(power->has_value());
  EXPECT_EQ(power->findChild<QLineEdit*>()->placeholderText(), "none");
  type(power, "0.5kW/2");
  EXPECT_NEAR(emitters_of(document_.objects())[1].power, 250, 1e-3);
  EXPECT_EQ(power->text(), "250 W");
  type(power, "-1");
  EXPECT_TRUE(power->toolTip().startsWith("Range: 0 W to any."));
  EXPECT_EQ(document_.undo_stack().count(), 1);
  QTest::keyClick(power, Qt::Key_Escape);
  EXPECT_EQ(power->text(), "250 W");
}

TEST_F(SurfacePanels, MakeOneStepOfManyOfABox) {
  select({{1, 0}});
  auto* power = find<NumberBox>("Power");
  type(power, "60");
  for (int i = 0; i < 3; ++i) QTest::keyClick(power, Qt::Key_Up);
  EXPECT_NEAR(emitters_of(document_.objects())[1].power, 90, 1e-3) << "live";
  QSignalSpy edited(power, &NumberBox::edited);
  ASSERT_TRUE(QTest::qWaitFor([&edited] { return edited.count() > 0; }));
  EXPECT_EQ(document_.undo_stack().count(), 2);
  QTest::keyClick(power, Qt::Key_Up);
  EXPECT_EQ(document_.undo_stack().count(), 3) << "steps after a pause are others";
}

TEST_F(SurfacePanels, ShowTheTextureWithItsFaces) {
  select({{1, 0}});
  type(find<QComboBox>("Texture")->lineEdit(), "wood.png");
  auto* preview = panel_.findChild<TexturePreview*>();
  ASSERT_TRUE(QTest::qWaitFor([preview] { return preview->has_image(); }));
  EXPECT_TRUE(preview->isVisible());
  const QVector<QPolygonF> outlines = uv_outlines(document_.objects(), document_.selection());
  ASSERT_EQ(outlines.size(), 1);
  EXPECT_EQ(outlines.front().boundingRect(), QRectF(0, 0, 1, 1));
  click("Remove the texture");
  EXPECT_FALSE(preview->isVisible());
}

TEST_F(SurfacePanels, FollowTheTheme) {
  select({{1, 0}});
  const auto lightness = [this] { return panel_.grab().toImage().pixelColor(5, 600).lightness(); };
  EXPECT_LT(lightness(), 100);
  apply(Theme::Light, *qApp);
  EXPECT_TRUE(QTest::qWaitFor([&lightness] { return lightness() > 200; }));
  apply(Theme::Dark, *qApp);
  EXPECT_TRUE(QTest::qWaitFor([&lightness] { return lightness() < 100; }));
}

TEST_F(SurfacePanels, AllControlsHaveNamesAndToolTips) {
  select({{1, 0}});
  for (const QWidget* widget : panel_.findChildren<QWidget*>()) {
    const bool is_control = widget->focusPolicy() != Qt::NoFocus && widget->focusProxy() == nullptr;
    const bool is_own = qobject_cast<const QToolButton*>(widget) || qobject_cast<const NumberBox*>(widget) ||
                        qobject_cast<const QComboBox*>(widget);
    if (!is_control || !is_own || !widget->isVisible()) continue;
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
    EXPECT_FALSE(widget->toolTip().isEmpty()) << widget->accessibleName().toStdString();
  }
}

}  // namespace
}  // namespace editor
