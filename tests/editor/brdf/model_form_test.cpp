#include "editor/brdf/model_form.h"

#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <gmock/gmock.h>

#include "editor/brdf/map_button.h"
#include "editor/brdf/model_values.h"
#include "editor/brdf/parameter_row.h"
#include "editor/brdf/parameter_rows.h"
#include "editor/controls/number_box.h"
#include "editor/controls/scaled_slider.h"
#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/scheme.h"
#include "tests/editor/brdf/brdf_of.h"

namespace editor {
namespace {

using Models = std::vector<grf::BrdfModel>;

/// What a form reported.
struct Reports {
  std::vector<Models> changing, edited;

  explicit Reports(BrdfForm& form) {
    QObject::connect(&form, &BrdfForm::changing,
                     [this](const Models& models) { changing.push_back(models); });
    QObject::connect(&form, &BrdfForm::edited, [this](const Models& models) { edited.push_back(models); });
  }
};

ParameterRow* row_of(const QWidget& form, std::string_view name) {
  for (ParameterRow* row : form.findChildren<ParameterRow*>()) {
    if (row->parameter().name == name && row->isVisibleTo(&form)) return row;
  }
  return nullptr;
}

NumberBox* box_of(const QWidget& form, const QString& name) {
  for (NumberBox* box : form.findChildren<NumberBox*>()) {
    if (box->accessibleName() == name) return box;
  }
  return nullptr;
}

void type(NumberBox* box, const QString& text) {
  box->selectAll();
  QTest::keyClicks(box, text);
  QTest::keyClick(box, Qt::Key_Return);
}

void show(QWidget& form) {
  form.resize(360, 500);
  form.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&form));
}

TEST(BrdfForm, HasARowForEachParameterOfEachModel) {
  BrdfForm form;
  show(form);
  Reports reports(form);
  for (const grf::ModelInfo& info : reflectance::brdf_infos()) {
    grf::BrdfModel model;
    model.keyword = info.keyword;
    form.set_models({model});
    for (const grf::ParameterInfo& parameter : info.parameters) {
      const ParameterRow* row = row_of(form, parameter.name);
      ASSERT_NE(row, nullptr) << info.keyword << ' ' << parameter.name;
      for (const QWidget* control : row->findChildren<QWidget*>()) {
        if (control->focusPolicy() == Qt::NoFocus || control->inherits("QLineEdit")) continue;
        EXPECT_FALSE(control->accessibleName().isEmpty()) << info.keyword << ' ' << parameter.name;
        EXPECT_FALSE(control->toolTip().isEmpty()) << info.keyword << ' ' << parameter.name;
      }
    }
    EXPECT_EQ(form.models(), Models{model});
  }
  EXPECT_TRUE(reports.edited.empty() && reports.changing.empty());
}

/// Drops a file on a widget, as a file manager does.
void drop_file(QWidget& widget, const QString& file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(QPoint(2, 2), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&widget, &enter);
  if (!enter.isAccepted()) return;
  QDropEvent drop(QPointF(2, 2), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&widget, &drop);
}

TEST(BrdfForm, VariesAParameterByAnImage) {
  BrdfForm form;
  show(form);
  Reports reports(form);
  grf::BrdfModel model = brdf_model("gltf roughness=0.8");
  model.location = grf::whole_file("/home/scenes/room.grf");
  form.set_models({model});
  ParameterRow* roughness = row_of(form, "roughness");
  drop_file(*roughness, "/home/scenes/images/worn.png");
  ASSERT_EQ(reports.edited.size(), 1U);
  EXPECT_EQ(grf::to_text(reports.edited.back()[0]), "gltf roughness=texture \"images/worn.png\" r * 0.8");
  drop_file(*row_of(form, "metallic"), "/home/scenes/worn.png");
  EXPECT_EQ(grf::to_text(reports.edited.back()[0]),
            "gltf roughness=texture \"images/worn.png\" r * 0.8 metallic=texture \"worn.png\" r");
  drop_file(*row_of(form, "baseColor"), "/home/scenes/notes.txt");
  EXPECT_EQ(reports.edited.size(), 2U) << "no image";
  auto* button = roughness->findChild<MapButton*>();
  EXPECT_THAT(button->toolTip().toStdString(), testing::HasSubstr("worn.png"));
  const auto press = [&](const QString& title) {
    for (QAction* action : button->menu()->actions()) {
      if (action->text() == title) action->trigger();
    }
  };
  press("Green channel");
  EXPECT_EQ(grf::to_text(form.models()[0]),
            "gltf roughness=texture \"images/worn.png\" g * 0.8 metallic=texture \"worn.png\" r");
  type(box_of(form, "roughness"), "0.5");
  EXPECT_EQ(grf::to_text(form.models()[0]),
            "gltf roughness=texture \"images/worn.png\" g * 0.5 metallic=texture \"worn.png\" r");
  press("Remove the image");
  EXPECT_EQ(grf::to_text(form.models()[0]), "gltf roughness=0.5 metallic=texture \"worn.png\" r");
  form.set_models({brdf_model("glass")});
  EXPECT_EQ(row_of(form, "ior")->findChild<MapButton*>(), nullptr);
}

TEST(BrdfForm, KeepsTheDefaultsThatAreTypedIn) {
  for (const grf::ModelInfo& info : reflectance::brdf_infos()) {
    if (info.argument_kind != grf::ModelInfo::ArgumentKind::Parameters) continue;
    BrdfForm form;
    show(form);
    grf::BrdfModel model;
    model.keyword = info.keyword;
    form.set_models({model});
    EXPECT_TRUE(form.errors().empty()) << info.keyword;
    const auto before = reflectance::make_brdf(model);
    for (const grf::ParameterInfo& parameter : info.parameters) {
      set_value(model, parameter, value_of(model, info, parameter));
    }
    form.set_models({model});
    EXPECT_TRUE(form.errors().empty()) << info.keyword;
    EXPECT_EQ(brdf_model(grf::to_text(form.models().front())), model);
    const reflectance::Vec3f u(0.6F, 0, 0.8F);
    const reflectance::Vec3f v(-0.48F, 0.36F, 0.8F);
    EXPECT_EQ(reflectance::evaluate(*before, u, v),
              reflectance::evaluate(*reflectance::make_brdf(model), u, v));
  }
}

TEST(BrdfForm, ReportsADragManyTimesAndItsEndOnce) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("ward sx=0.2")});
  Reports reports(form);
  auto* slider = row_of(form, "ks")->findChild<ScaledSlider*>();
  const int y = slider->height() / 2;
  QTest::mousePress(slider, Qt::LeftButton, {}, {4, y});
  for (int x = 8; x < slider->width() - 4; x += 4) QTest::mouseMove(slider, {x, y});
  EXPECT_GE(reports.changing.size(), 5U);
  EXPECT_EQ(reports.edited.size(), 0U);
  QTest::mouseRelease(slider, Qt::LeftButton, {}, {slider->width() - 5, y});
  ASSERT_EQ(reports.edited.size(), 1U);
  EXPECT_EQ(reports.edited[0], reports.changing.back());
  EXPECT_EQ(reports.edited[0], form.models());
}

TEST(BrdfForm, ShowsWhereADefaultComesFrom) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("ward sx=0.2")});
  EXPECT_EQ(box_of(form, "sy")->text(), "0.2");
  type(box_of(form, "sx"), "0.1*3");
  EXPECT_EQ(box_of(form, "sy")->text(), "0.3");
  EXPECT_EQ(form.models()[0], brdf_model("ward sx=0.3"));
}

TEST(BrdfForm, TakesDegrees) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("oren")});
  type(box_of(form, "s"), "18deg");
  EXPECT_EQ(box_of(form, "s")->full_text(), "0.3141593 rad");
}

TEST(BrdfForm, SaysWhatCheckSaysAndReportsWhenItIsRight) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("ward")});
  Reports reports(form);
  type(box_of(form, "sx"), "11");
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(grf::check(brdf_model("ward sx=11"), reflectance::brdf_infos(), "BRDF", diagnostics));
  const QString expected = QString::fromStdString(diagnostics.entries()[0].message);
  EXPECT_THAT(form.errors(), testing::ElementsAre(expected));
  EXPECT_EQ(box_of(form, "sx")->message(), expected);
  bool is_shown = false;
  for (const QLabel* label : form.findChildren<QLabel*>())
    is_shown |= label->isVisible() && label->text() == expected;
  EXPECT_TRUE(is_shown);
  EXPECT_EQ(reports.edited.size(), 0U);
  type(box_of(form, "sx"), "1");
  EXPECT_TRUE(form.errors().empty());
  EXPECT_EQ(reports.edited.size(), 1U);
}

TEST(BrdfForm, SaysWhatIsWrongTogether) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("lafortune n=100")});
  Reports reports(form);
  type(box_of(form, "Cz"), "5");
  ASSERT_EQ(form.errors().size(), 1U);
  EXPECT_EQ(reports.edited.size(), 0U);
  type(box_of(form, "n"), "10");
  EXPECT_TRUE(form.errors().empty());
  ASSERT_EQ(reports.edited.size(), 1U);
  EXPECT_EQ(reports.edited[0][0], brdf_model("lafortune n=10 Cz=5"));
}

TEST(BrdfForm, EditsAReflectanceAsRgb) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("diffuse kd=0.4")});
  auto* split = row_of(form, "kd")->findChild<QToolButton*>();
  ASSERT_TRUE(split->isCheckable());
  QTest::mouseClick(split, Qt::LeftButton);
  EXPECT_EQ(form.models()[0], brdf_model("diffuse kd=(0.4, 0.4, 0.4)"));
  type(box_of(form, "kd, green"), "1/4");
  EXPECT_EQ(form.models()[0], brdf_model("diffuse kd=(0.4, 0.25, 0.4)"));
  QTest::mouseClick(split, Qt::LeftButton);
  EXPECT_FALSE(std::holds_alternative<grf::Colour>(form.models()[0].arguments[0].value));
}

TEST(BrdfForm, ShowsMixedValuesAndChangesOneOfAll) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("phong n=10 ks=0.3"), brdf_model("phong n=20 ks=0.3")});
  EXPECT_FALSE(box_of(form, "n")->has_value());
  EXPECT_TRUE(box_of(form, "ks")->has_value());
  type(box_of(form, "ks"), "0.1");
  EXPECT_THAT(form.models(),
              testing::ElementsAre(brdf_model("phong n=10 ks=0.1"), brdf_model("phong n=20 ks=0.1")));
  form.set_models({brdf_model("phong"), brdf_model("ward")});
  EXPECT_TRUE(form.findChildren<ParameterRow*>().empty() || row_of(form, "n") == nullptr);
}

TEST(BrdfForm, ChoosesAModelForAll) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("phong n=10"), brdf_model("ward")});
  Reports reports(form);
  auto* chooser = form.findChild<QComboBox*>();
  chooser->setFocus();
  chooser->lineEdit()->selectAll();
  QTest::keyClicks(chooser->lineEdit(), "Oren-Nayar (oren)");
  QTest::keyClick(chooser->lineEdit(), Qt::Key_Return);
  ASSERT_EQ(reports.edited.size(), 1U);
  EXPECT_THAT(form.models(), testing::ElementsAre(brdf_model("oren"), brdf_model("oren")));
}

TEST(BrdfForm, BringsDefaultsBack) {
  BrdfForm form;
  show(form);
  form.set_models({brdf_model("phong n=10 ks=0.3")});
  std::size_t pressed = 0;
  for (QToolButton* button : row_of(form, "n")->findChildren<QToolButton*>()) {
    if (button->menu() != nullptr) continue;
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_FALSE(button->isEnabled());
    ++pressed;
  }
  EXPECT_EQ(pressed, 1U);
  EXPECT_EQ(form.models()[0], brdf_model("phong ks=0.3"));
}

TEST(BrdfForm, MakesSumsOfWhatIsDefined) {
  BrdfForm form;
  show(form);
  form.set_definitions({{"clay", brdf_model("oren"), {}, {}}, {"varnish", brdf_model("ward"), {}, {}}});
  grf::BrdfModel sum;
  sum.keyword = "combine";
  form.set_models({sum});
  EXPECT_FALSE(form.errors().empty());
  Reports reports(form);
  for (QToolButton* button : form.findChildren<QToolButton*>()) {
    if (button->accessibleName() != "Add a BRDF to the sum") continue;
    QTest::mouseClick(button, Qt::LeftButton);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  ASSERT_EQ(reports.edited.size(), 2U);
  EXPECT_EQ(grf::to_text(form.models()[0]), "combine 1 clay, 0.5 varnish");
  form.set_definitions({});
  ASSERT_EQ(form.errors().size(), 2U);
  EXPECT_TRUE(form.errors()[0].contains("clay"));
}

TEST(BrdfForm, MakesLayersOfWhatIsDefined) {
  BrdfForm form;
  show(form);
  form.set_definitions({{"clay", brdf_model("oren"), {}, {}}, {"varnish", brdf_model("ward"), {}, {}}});
  grf::BrdfModel layer;
  layer.keyword = "layer";
  form.set_models({layer});
  ASSERT_EQ(form.errors().size(), 1U);
  EXPECT_TRUE(form.errors()[0].contains("base=NAME top=NAME"));
  Reports reports(form);
  const auto list_of = [&form](const QString& name) -> QComboBox* {
    for (QComboBox* list : form.findChildren<QComboBox*>()) {
      if (list->accessibleName() == "BRDF of the layer " + name) return list;
    }
    return nullptr;
  };
  QComboBox* base = list_of("base");
  QComboBox* top = list_of("top");
  ASSERT_TRUE(base != nullptr && top != nullptr);
  QTest::keyClick(base, Qt::Key_Down);
  EXPECT_TRUE(reports.edited.empty());
  QTest::keyClick(top, Qt::Key_Down);
  QTest::keyClick(top, Qt::Key_Down);
  ASSERT_EQ(reports.edited.size(), 2U);
  EXPECT_EQ(grf::to_text(form.models()[0]), "layer base=clay top=varnish");
  form.set_models({brdf_model("phong")});
  EXPECT_FALSE(base->isVisibleTo(&form));
  form.set_definitions({});
}

TEST(ParameterRows, HaveARowForEachParameterOfEachScheme) {
  ParameterRows rows;
  rows.show();
  const std::vector<grf::ModelInfo> infos = reflectance::scheme_infos();
  for (const grf::ModelInfo& info : infos) {
    grf::PdfModel model;
    model.keyword = info.keyword;
    rows.show_models(&info, {&model});
    for (const grf::ParameterInfo& parameter : info.parameters) {
      EXPECT_NE(row_of(rows, parameter.name), nullptr) << info.keyword << ' ' << parameter.name;
    }
  }
}

}  // namespace
}  // namespace editor
