// The window that shows where the noise is from, through the main window, by pointer and keyboard.
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/op_document.h"
#include "editor/rendering/noise_window.h"
#include "editor/rendering/render_panel.h"
#include "editor/rendering/share_delegate.h"
#include "tests/editor/window/authoring.h"

namespace editor {
namespace {

using testing::HasSubstr;

/// A plate with a narrow lobe, which is sampled badly, and a diffuse wall beside it; an area light behind a
/// black one, and a mesh that emits.
const char* const Scene =
    "light begin rgb (3,2,1) (-9,9,-9) (18,0,0) (0,0,18) end\n"
    "light begin rgb (9,9,9) (4,3,-1) (1,0,0) (0,0,1) end\n"
    "begin mesh \"plate\" brdf phong n=200 ks=0.9 kd=0 pdf diffuse begin vertexs (-9,0,9) (0,0,9) (0,0,-9) "
    "(-9,0,-9) end vertexs begin faces (0,1,2,3) end faces end mesh\n"
    "begin mesh \"floor\" brdf diffuse kd=0.5 begin vertexs (0,0,9) (9,0,9) (9,0,-9) (0,0,-9) end vertexs "
    "begin "
    "faces (0,1,2,3) end faces end mesh\n"
    "begin mesh \"glow\" brdf diffuse kd=0.1 begin vertexs (2,0.1,0) (2,0.1,-1) (2,1,-1) (2,1,0) (3,0.1,0) "
    "(3,1,0) end vertexs begin faces (1,0,3,2) light rgb (0,3,3) (0,4,5,3) end faces end mesh\n";

class Noise : public Authoring {
 protected:
  Noise() {
    std::ofstream(folder_.path("scene.grf")) << Scene;
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0 6 6\nBPT_VLook 0 0 0\nBPT_FieldOfView 30\n"
           "BPT_Image_Resolution 24 20\nBPT_Samples 16\nBPT_Depth 2\n";
    open(path("scene.grf"));
  }

  void open_noise() {
    QTest::keyClick(&window_, Qt::Key_Y, Qt::ControlModifier | Qt::AltModifier);
    noise_ = window_.render_panel().findChild<NoiseWindow*>();
    ASSERT_NE(noise_, nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(noise_));
  }
  bool has_ended() {
    return QTest::qWaitFor([this] { return !noise_->is_running(); }, test::Minute);
  }
  QTreeWidget& list(const char* name) {
    for (QTreeWidget* one : noise_->findChildren<QTreeWidget*>()) {
      if (one->accessibleName() == name) return *one;
    }
    throw std::runtime_error(name);
  }
  QTreeWidget& shares() { return list("Shares of the noise"); }
  QTreeWidget& changes() { return list("Changes of settings"); }
  QPushButton& button(const char* name) {
    for (QPushButton* one : noise_->findChildren<QPushButton*>()) {
      if (one->accessibleName() == name) return *one;
    }
    throw std::runtime_error(name);
  }
  std::string text(const char* name) {
    for (QLabel* one : noise_->findChildren<QLabel*>()) {
      if (one->accessibleName() == name) return one->text().toStdString();
    }
    throw std::runtime_error(name);
  }
  static void click(QTreeWidget& list, QTreeWidgetItem& item) {
    list.scrollToItem(&item);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(&item).center());
  }
  /// Whether something is drawn in a column of an item, besides its ground.
  static bool is_drawn(QTreeWidget& list, QTreeWidgetItem& item, int column) {
    list.scrollToItem(&item);
    QRect place = list.visualItemRect(&item);
    place.setLeft(list.columnViewportPosition(column));
    place.setWidth(list.columnWidth(column));
    const QImage image = list.viewport()->grab(place).toImage();
    const QRgb ground = image.pixel(0, 0);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image.pixel(x, y) != ground) return true;
      }
    }
    return false;
  }
  static QTreeWidgetItem& item(QTreeWidget& list, const QString& text) {
    const auto found = list.findItems(text, Qt::MatchStartsWith | Qt::MatchRecursive);
    if (found.isEmpty()) throw std::runtime_error(text.toStdString());
    return *found.front();
  }
  /// The names of the meshes with selected faces, and how many.
  std::string selected() {
    std::string names;
    const FaceSelection& selection = document().selection();
    for (const std::uint32_t mesh : selection.meshes()) {
      names += document().objects().meshes[mesh].name + " " + std::to_string(selection.count(mesh)) + " ";
    }
    return names;
  }

  NoiseWindow* noise_ = nullptr;
};

TEST_F(Noise, IsSharedOutAndItsPartsAreSelected) {
  open_noise();
  EXPECT_TRUE(noise_->is_running());
  EXPECT_TRUE(button("Stop").isEnabled());
  ASSERT_TRUE(has_ended());
  ASSERT_TRUE(noise_->result()) << text("State of the measurement");
  EXPECT_THAT(text("State of the measurement"), HasSubstr("16 samples per pixel, in 24 x 20 pixels"));
  ASSERT_EQ(shares().topLevelItemCount(), 3);
  const QTreeWidgetItem& lamps = *shares().topLevelItem(0);
  EXPECT_EQ(lamps.childCount(), 3);
  double noise = 0;
  for (int i = 0; i < lamps.childCount(); ++i) {
    noise += lamps.child(i)->data(1, ShareDelegate::FractionRole).toDouble();
  }
  EXPECT_NEAR(noise, 1, 1e-6);
  for (int column = 0; column < 3; ++column) {
    EXPECT_TRUE(is_drawn(shares(), *shares().topLevelItem(0)->child(0), column)) << column;
  }
  EXPECT_THAT(text("Advice"), HasSubstr(" of the noise and "));

  click(shares(), item(shares(), "Area light 1"));
  ASSERT_EQ(document().selected_objects().size(), 1U);
  EXPECT_EQ(document().selected_objects()[0], document().objects().lights[0].path);
  click(shares(), item(shares(), "Area light 2"));
  ASSERT_EQ(document().selected_objects().size(), 1U);
  EXPECT_EQ(document().selected_objects()[0], document().objects().lights[1].path);
  click(shares(), item(shares(), "Lamp \"glow\""));
  EXPECT_EQ(selected(), "glow 1 ") << "of its two faces, the one that emits";
  click(shares(), item(shares(), "phong"));
  EXPECT_EQ(selected(), "plate 1 ");
  // By keyboard: the row below.
  shares().setCurrentItem(&item(shares(), "diffuse kd=0.5"));
  EXPECT_EQ(selected(), "floor 1 ");
}

TEST_F(Noise, TriesAndAppliesTheSchemeOfABrdf) {
  open_noise();
  ASSERT_TRUE(has_ended());
  EXPECT_FALSE(button("Apply").isEnabled());
  QTreeWidgetItem& own = item(changes(), "Sampled by own instead of diffuse: phong n=200 ks=0.9 kd=0");
  click(changes(), own);
  EXPECT_FALSE(button("Apply").isEnabled()) << "it was not tried";
  QTest::mouseClick(&button("Try"), Qt::LeftButton);
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(own.text(4), "pays") << text("State of the measurement");
  EXPECT_LT(own.text(1).toDouble(), 0.5) << "a cosine seldom finds a narrow lobe";
  EXPECT_THAT(text("Advice"), HasSubstr("Sampled by own instead of diffuse: phong n=200 ks=0.9 kd=0: 0."));
  ASSERT_TRUE(button("Apply").isEnabled());

  const int step = document().undo_stack().index();
  QTest::mouseClick(&button("Apply"), Qt::LeftButton);
  EXPECT_EQ(document().undo_stack().index(), step + 1);
  EXPECT_THAT(text("State of the measurement"), HasSubstr("Measure again"));
  EXPECT_FALSE(button("Try all").isEnabled()) << "what was measured was another scene";
  const auto has_own = [](const grf::Surface& surface) {
    const auto* pdf = surface.pdf ? std::get_if<grf::PdfModel>(&*surface.pdf) : nullptr;
    return pdf != nullptr && pdf->keyword == "own";
  };
  EXPECT_EQ(faces_where(has_own), 1U) << "those of the other BRDFs keep theirs";
  document().undo_stack().undo();
  EXPECT_EQ(faces_where(has_own), 0U);

  document().undo_stack().redo();
  QTest::mouseClick(&button("Measure"), Qt::LeftButton);
  ASSERT_TRUE(has_ended());
  EXPECT_TRUE(changes()
                  .findItems("Sampled by own instead of diffuse: phong n=200 ks=0.9 kd=0", Qt::MatchExactly)
                  .isEmpty());
}

TEST_F(Noise, TriesAllAndAppliesAnOption) {
  open_noise();
  ASSERT_TRUE(has_ended());
  QTest::mouseClick(&button("Try all"), Qt::LeftButton);
  ASSERT_TRUE(has_ended());
  for (int i = 0; i < changes().topLevelItemCount(); ++i) {
    QTreeWidgetItem& change = *changes().topLevelItem(i);
    EXPECT_NE(change.text(4), "") << change.text(0).toStdString();
    for (int column = 0; column < 5; ++column) EXPECT_TRUE(is_drawn(changes(), change, column)) << column;
  }
  click(changes(), item(changes(), "Split count: 4 instead of 2"));
  QTest::mouseClick(&button("Apply"), Qt::LeftButton);
  EXPECT_EQ(document().options().valid_options().split_count, 4);
  document().undo_stack().undo();
  EXPECT_EQ(document().options().valid_options().split_count, 2);
}

TEST_F(Noise, IsOutdatedByEditsAndStopped) {
  open_noise();
  QTest::mouseClick(&button("Stop"), Qt::LeftButton);
  EXPECT_FALSE(noise_->is_running());
  QTest::mouseClick(&button("Measure"), Qt::LeftButton);
  ASSERT_TRUE(has_ended());
  EXPECT_TRUE(shares().isEnabled());
  options::RenderOptions deeper = document().options().valid_options();
  deeper.depth = 3;
  document().options().set_options("Depth", deeper);
  EXPECT_FALSE(shares().isEnabled());
  EXPECT_THAT(text("State of the measurement"), HasSubstr("measure again"));
  QTest::mouseClick(&button("Measure"), Qt::LeftButton);
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(shares().topLevelItem(1)->childCount(), 4) << "0 to 3 bounces";
}

TEST_F(Noise, SaysWhyItIsNotMeasured) {
  options::RenderOptions naive = document().options().valid_options();
  naive.integrator = "naive";
  document().options().set_options("Naive", naive);
  open_noise();
  ASSERT_TRUE(has_ended());
  EXPECT_THAT(text("State of the measurement"), HasSubstr("for the integrator `path` only"));
  EXPECT_FALSE(button("Try all").isEnabled());
}

}  // namespace
}  // namespace editor
