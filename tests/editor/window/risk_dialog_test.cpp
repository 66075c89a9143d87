// Finds and repairs the risks of a scene through the whole window, by pointer and keyboard.
#include "editor/window/risk_dialog.h"

#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using convert::RiskKind;
using test::Minute;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A cube about the origin with one face turned, a face twice and a face without area; and a lamp inside.
const std::string Risky = R"(
light begin rgb (1, 1, 1) (-0.1, 0, -0.1) (0.2, 0, 0) (0, 0, 0.2) end
begin mesh "solid"
  brdf diffuse kd=0.5
  begin vertexs
    (-1, -1, -1) (1, -1, -1) (-1, 1, -1) (1, 1, -1) (-1, -1, 1) (1, -1, 1) (-1, 1, 1) (1, 1, 1)
  end vertexs
  begin faces
    (0, 4, 6, 2) (1, 3, 7, 5) (0, 1, 5, 4) (2, 6, 7, 3) (0, 2, 3, 1) (6, 7, 5, 4)
  end faces
end mesh
begin mesh "sheet"
  brdf diffuse kd=0.5
  begin vertexs (5, 0, 0) (6, 0, 0) (5, 1, 0) (7, 0, 0) end vertexs
  begin faces (0, 1, 2) (1, 2, 0) (0, 3, 1) end faces
end mesh
)";

class Risks : public Authoring {
 protected:
  void open_text(const std::string& text) {
    std::ofstream(folder_.path("scene.grf")) << text;
    open(path("scene.grf"));
  }

  RiskDialog& open_dialog() {
    QTest::keyClick(&window_, Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
    auto* dialog = window_.findChild<RiskDialog*>();
    if (dialog == nullptr || !QTest::qWaitForWindowActive(dialog)) throw std::runtime_error("no dialog");
    wait_for(*dialog);
    return *dialog;
  }

  static void wait_for(RiskDialog& dialog) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return dialog.is_up_to_date(); }, Minute));
  }

  static std::vector<RiskKind> kinds(const RiskDialog& dialog) {
    std::vector<RiskKind> kinds;
    for (const convert::Risk& risk : dialog.risks()) kinds.push_back(risk.kind);
    return kinds;
  }

  static QPushButton& button(RiskDialog& dialog, const QString& text) {
    for (auto* each : dialog.findChildren<QPushButton*>()) {
      if (each->text().remove('&').startsWith(text)) return *each;
    }
    throw std::runtime_error("no such button");
  }

  static void choose(RiskDialog& dialog, int row) {
    auto& list = *dialog.findChild<QTreeWidget*>();
    const QRect place = list.visualItemRect(list.topLevelItem(row));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, place.center());
  }

  void repair(RiskDialog& dialog, int row) {
    choose(dialog, row);
    QTest::mouseClick(&button(dialog, "Repair"), Qt::LeftButton);
    wait_for(dialog);
  }
};

TEST_F(Risks, AreListedSelectedAndRepaired) {
  open_text(Risky);
  RiskDialog& dialog = open_dialog();
  ASSERT_THAT(kinds(dialog),
              ElementsAre(RiskKind::DuplicateFaces, RiskKind::InwardFaces, RiskKind::FacesWithoutArea));
  choose(dialog, 0);
  EXPECT_EQ(document().selection().count(), 1U);
  EXPECT_TRUE(document().selection().has({1, 1}));
  choose(dialog, 1);
  EXPECT_EQ(document().selection().count(), 1U);
  EXPECT_TRUE(document().selection().has({0, 5}));
  repair(dialog, 1);
  // A solid with outward fronts encloses the lamp.
  ASSERT_THAT(kinds(dialog),
              ElementsAre(RiskKind::LampInSolid, RiskKind::DuplicateFaces, RiskKind::FacesWithoutArea));
  EXPECT_EQ(document().undo_stack().undoText(), "Repair: Fronts point inward");
  choose(dialog, 0);
  EXPECT_FALSE(button(dialog, "Repair").isEnabled()) << "nobody knows where the lamp shall be";
  repair(dialog, 1);
  repair(dialog, 1);
  EXPECT_THAT(kinds(dialog), ElementsAre(RiskKind::LampInSolid));
  EXPECT_EQ(document().objects().meshes.at(1).mesh->face_count(), 1U);
  for (int step = 0; step < 3; ++step) document().undo_stack().undo();
  wait_for(dialog);
  EXPECT_EQ(dialog.risks().size(), 3U) << "each repair is one step";
}

TEST_F(Risks, IncludeDuplicateMeshesAndNormals) {
  open_text(R"(
begin mesh "a"
  brdf diffuse kd=0.5
  begin vertexs normal (0, 0, -1) (0, 0, 0) normal (0, 0, -1) (1, 0, 0) normal (0, 0, -1) (0, 1, 0) end vertexs
  begin faces (0, 1, 2) end faces
end mesh
begin mesh "b"
  texture "wood.png"
  brdf diffuse kd=0.5
  begin vertexs (3, 0, 0) (4, 0, 0) (3, 1, 0) end vertexs
  begin faces (0, 1, 2) end faces
end mesh
begin mesh "c"
  brdf diffuse kd=0.5
  begin vertexs (3, 0, 0) (4, 0, 0) (3, 1, 0) end vertexs
  begin faces (0, 1, 2) end faces
end mesh
)");
  RiskDialog& dialog = open_dialog();
  ASSERT_THAT(kinds(dialog),
              ElementsAre(RiskKind::DuplicateMesh, RiskKind::NormalsAgainstFaces, RiskKind::UvWithoutArea));
  repair(dialog, 0);
  EXPECT_EQ(document().objects().meshes.size(), 2U);
  repair(dialog, 0);
  EXPECT_EQ(document().objects().meshes.at(0).mesh->geometry->normals[0], grf::Vec3f(0, 0, 1));
  repair(dialog, 0);
  EXPECT_THAT(kinds(dialog), IsEmpty());
}

TEST_F(Risks, AreSearchedForValuesThatAreNotFinite) {
  open_text(R"(
light begin rgb (5, 5, 5) (-1, 3, -1) (2, 0, 0) (0, 0, 2) end
begin mesh "floor"
  brdf diffuse kd=0.5
  begin vertexs (-3, 0, 3) (3, 0, 3) (3, 0, -3) (-3, 0, -3) end vertexs
  begin faces (0, 1, 2, 3) end faces
end mesh
)");
  RiskDialog& dialog = open_dialog();
  EXPECT_THAT(kinds(dialog), IsEmpty());
  QPushButton& search = button(dialog, "Find values");
  QTest::mouseClick(&search, Qt::LeftButton);
  EXPECT_FALSE(search.isEnabled());
  ASSERT_TRUE(QTest::qWaitFor([&] { return search.isEnabled(); }, Minute));
  bool is_told = false;
  for (auto* label : dialog.findChildren<QLabel*>()) is_told |= label->text().contains("samples are finite");
  EXPECT_TRUE(is_told);
}

}  // namespace
}  // namespace editor
