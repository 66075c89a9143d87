// The page Cost through the whole window, by pointer and keyboard.
#include <QCheckBox>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/controls/notice_bar.h"
#include "editor/controls/number_box.h"
#include "editor/image/image_browser.h"
#include "editor/rendering/cost_page.h"
#include "tests/editor/window/authoring.h"
#include "tests/support/paths.h"

namespace editor {
namespace {

using testing::HasSubstr;

// error_A = 0.4 N^-1/2, which is 0.05 at 64 samples; error_B = 0.8 N^-1/2 has that at 256. A takes 1/32 s per
// sample, B 1/64 s, so that B has 128 samples in the time of 64 of A.
TEST(CostPictures, HaveEqualTimeOrError) {
  CostCurve a{"A", {{16, 0.5, 0.1}, {64, 2, 0.05}}, {}, {}, 0.4, 0.5, {}, {}};
  CostCurve b{"B", {{16, 0.25, 0.2}, {64, 1, 0.1}}, {}, {}, 0.8, 0.5, {}, {}};
  EXPECT_EQ(samples_at_equal_time(a, b).value().a, 64);
  EXPECT_EQ(samples_at_equal_time(a, b).value().b, 128);
  EXPECT_EQ(samples_at_equal_error(a, b).value().b, 256);
  EXPECT_EQ(samples_at_equal_error(b, a).value().b, 16);
  b.exponent = 0.01;
  EXPECT_FALSE(samples_at_equal_error(a, b)) << "it would need 16^100 samples";
  b.exponent = -0.1;
  EXPECT_FALSE(samples_at_equal_error(a, b)) << "it does not fall";
}

/// A shiny plate under a lamp. Without light sampling, directions by the cosine seldom meet the lobe, of
/// about 0.05 rad, which the BRDF's own sampler meets each time: it wins by orders of magnitude.
class Cost : public Authoring {
 protected:
  Cost() { open_scene("32 24"); }

  void open_scene(const std::string& size) {
    std::ofstream(folder_.path("scene.grf"))
        << "begin mesh brdf ward sx=0.05 ks=0.5 kd=0 begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end "
           "vertexs begin faces (0,1,2,3) end faces end mesh\n"
           "light begin (0,0,0.6) (0,1,0) (1,0,0) end\n";
    std::ofstream(folder_.path("scene.op"))
        << "BPT_Scene scene.grf\nBPT_Viewer 0.5 -1 0.6\nBPT_VLook 0.5 0.5 0\nBPT_Image_Resolution " << size
        << "\nBPT_Depth 1\n";
    open(path("scene.grf"));
    QTest::keyClick(&window_, Qt::Key_8, Qt::ControlModifier | Qt::AltModifier);
    page_ = window_.findChild<CostPage*>();
    ASSERT_NE(page_, nullptr);
    if (test::named<QCheckBox>(*page_, "Compare path").isChecked()) {
      toggle("Compare path");
      toggle("Compare naive");
    }
  }

  CostPage& page() { return *page_; }
  QPushButton& button(const char* name) { return test::named<QPushButton>(page(), name); }
  void click(const char* name) {
    ASSERT_TRUE(button(name).isEnabled()) << name << ": " << button(name).toolTip().toStdString();
    QTest::mouseClick(&button(name), Qt::LeftButton);
  }
  void toggle(const char* name) {
    auto& box = test::named<QCheckBox>(page(), name);
    QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(8, box.height() / 2));
  }
  void toggle_scheme(const QString& scheme) {
    auto& list = test::named<QListWidget>(page(), "Compared schemes");
    list.setFocus();
    list.setCurrentItem(list.findItems(scheme, Qt::MatchExactly).front());
    QTest::keyClick(&list, Qt::Key_Space);
  }
  void set_rounds(const char* rounds) {
    auto& box = test::named<NumberBox>(page(), "Rounds");
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, rounds);
    QTest::keyClick(&box, Qt::Key_Return);
  }
  void set_samples(const char* samples) {
    auto& field = test::named<QLineEdit>(page(), "Compared samples");
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, samples);
  }
  bool has_ended() {
    return QTest::qWaitFor([this] { return !page().is_running(); }, 3 * test::Minute);
  }
  std::string verdict() { return test::named<QLabel>(page(), "Verdict").text().toStdString(); }
  std::string notice() { return page().findChild<NoticeBar*>()->text().toStdString(); }
  const options::RenderOptions& options() { return document().options().valid_options(); }
  QJsonObject saved(const char* name) {
    page().save(path(name));
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << notice();
    return QJsonDocument::fromJson(file.readAll()).object();
  }

  CostPage* page_ = nullptr;
};

TEST_F(Cost, FindsTheWinnerAndTakesIt) {
  open_scene("160 120");  // renders of milliseconds: the time of shorter ones is mostly that of threads
  set_rounds("8");
  EXPECT_FALSE(button("Take the winner").isEnabled());
  click("Start the study");
  ASSERT_TRUE(has_ended());
  ASSERT_TRUE(page().study().winner) << verdict() << notice();
  EXPECT_THAT(verdict(), HasSubstr("Own wins"));
  const auto& table = test::named<QTableWidget>(page(), "Efficiencies");
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(table.item(1, 0)->text().toStdString(), "Own");
  EXPECT_THAT(table.item(0, 2)->text().toStdString(), testing::MatchesRegex(".+ to .+"));
  const CostCurve& own = page().study().curves[1];
  EXPECT_GT(own.efficiency->value, 10 * page().study().curves[0].efficiency->value);
  EXPECT_THAT(test::named<QPlainTextEdit>(page(), "Settings of the winner").toPlainText().toStdString(),
              HasSubstr("BPT_Pdf_Name Own"));
  ASSERT_EQ(options().scheme, "");
  const int steps = document().undo_stack().index();
  click("Take the winner");
  EXPECT_EQ(options().scheme, "Own");
  EXPECT_EQ(options().integrator, "naive");
  EXPECT_EQ(document().undo_stack().index(), steps + 1);
  document().undo_stack().undo();
  EXPECT_EQ(options().scheme, "");
  EXPECT_EQ(options().integrator, "path");
}

// `Auto` is the own sampler of this BRDF.
TEST_F(Cost, NamesNoWinnerAmongEquals) {
  toggle_scheme("Diffuse");
  toggle_scheme("Auto");
  set_rounds("2");
  click("Start the study");
  ASSERT_TRUE(has_ended());
  ASSERT_EQ(page().study().curves.size(), 2U) << notice();
  EXPECT_EQ(page().study().curves[1].name, "Auto");
  EXPECT_THAT(verdict(), HasSubstr("No clear winner"));
  EXPECT_FALSE(button("Take the winner").isEnabled());
}

TEST_F(Cost, IsLiveAndStopsAndContinues) {
  open_scene("160 120");
  set_samples("4,16,256");
  set_rounds("100");
  click("Start the study");
  EXPECT_FALSE(button("Start the study").isEnabled());
  const auto points = [this] {
    std::size_t count = 0;
    for (const CostCurve& curve : page().study().curves) count += curve.rows.size();
    return count;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return points() > 0; }, 3 * test::Minute)) << notice();
  EXPECT_TRUE(page().is_running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return points() == 6; }, 3 * test::Minute));
  EXPECT_TRUE(page().is_running());
  click("Stop the study");
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(points(), 6U);
  const QJsonObject stopped = saved("stopped.json");
  page().open(path("stopped.json"));
  toggle_scheme("Hemisphere");
  set_rounds("1");
  click("Continue the study");
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(notice(), "");
  const QJsonArray rows = saved("continued.json")["rows"].toArray();
  ASSERT_EQ(rows.size(), 9);
  for (const QJsonValue& before : stopped["rows"].toArray()) {
    const bool is_kept = std::any_of(rows.begin(), rows.end(), [&](const QJsonValue& row) {
      return row["settings"] == before["settings"] && row["seeds"] == before["seeds"] &&
             row["rounds"] == before["rounds"];
    });
    EXPECT_TRUE(is_kept);
  }
}

// The figures of the manual's example are those of the study that it shows.
TEST_F(Cost, ShowsTheStudyOfTheManual) {
  page().open(GRANADA_SOURCE_DIR "/samples/studies/cost/still_life.json");
  EXPECT_THAT(verdict(), HasSubstr("Own, path wins"));
  EXPECT_TRUE(test::named<QCheckBox>(page(), "Compare path").isChecked()) << "the form follows the study";
  EXPECT_TRUE(test::named<QCheckBox>(page(), "Compare naive").isChecked());
  QFile manual(GRANADA_SOURCE_DIR "/editor/MANUAL.md");
  ASSERT_TRUE(manual.open(QIODevice::ReadOnly));
  const std::string text = manual.readAll().toStdString();
  const auto& table = test::named<QTableWidget>(page(), "Efficiencies");
  ASSERT_EQ(table.rowCount(), 4);
  for (int row = 0; row < 4; ++row) {
    std::string line = "|";
    for (int column = 0; column < 4; ++column)
      line += " " + table.item(row, column)->text().toStdString() + " |";
    EXPECT_THAT(text, HasSubstr(line));
  }
  const auto& curves = page().study().curves;
  const auto pair = samples_at_equal_time(curves[0], curves[2]);
  ASSERT_TRUE(pair);
  EXPECT_THAT(text, HasSubstr(std::to_string(pair->b) + " samples of *Diffuse, path*"));
}

TEST_F(Cost, SavesFigureTableAndStudy) {
  click("Start the study");
  ASSERT_TRUE(has_ended());
  const QJsonObject study = saved("kept.json");
  EXPECT_EQ(study["reference"].toObject()["image"].toString(), "kept-reference.pfm");
  EXPECT_EQ(QImage(path("kept-reference.pfm")).isNull(), true);
  EXPECT_TRUE(QFile::exists(path("kept-reference.pfm")));
  page().save(path("kept.csv"));
  page().save(path("kept.png"));
  page().save(path("kept.pdf"));
  QFile table(path("kept.csv"));
  ASSERT_TRUE(table.open(QIODevice::ReadOnly));
  EXPECT_EQ(table.readAll().count('\n'), 1 + 6);
  EXPECT_GT(QImage(path("kept.png")).width(), 800);
  QFile figure(path("kept.pdf"));
  ASSERT_TRUE(figure.open(QIODevice::ReadOnly));
  EXPECT_TRUE(figure.read(5) == "%PDF-");
  page().save(path("kept.txt"));
  EXPECT_THAT(notice(), HasSubstr("expected a name that ends with"));
  page().open(path("scene.op"));
  EXPECT_THAT(notice(), HasSubstr("is no study"));
}

TEST_F(Cost, MeasuresTheFramedRegion) {
  toggle("Only the preview region");
  click("Start the study");
  EXPECT_THAT(notice(), HasSubstr("no region is framed"));
  window_.show_scene();
  QTest::keyClick(&window_, Qt::Key_9, Qt::AltModifier);
  QTest::keyClick(&window_, Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
  QTest::keyClick(&window_.view(), Qt::Key_Return);
  const int width = window_.view().width();
  const int height = window_.view().height();
  QTest::keyClick(&window_, Qt::Key_3, Qt::AltModifier);
  window_.cost_page();
  set_samples("1,2");
  set_rounds("1");
  click("Start the study");
  ASSERT_TRUE(has_ended());
  const QJsonObject study = saved("region.json");
  ASSERT_EQ(study["width"].toInt(), width) << notice();
  const QJsonArray crop = study["crop"].toArray();
  ASSERT_EQ(crop.size(), 4);
  EXPECT_NEAR(crop[0].toInt(), width / 4, 1) << "Return chooses the middle half";
  EXPECT_NEAR(crop[3].toInt(), height / 2, 1);
}

TEST_F(Cost, ComparesPicturesInImages) {
  click("Start the study");
  ASSERT_TRUE(has_ended());
  const auto pair = samples_at_equal_time(page().study().curves[0], page().study().curves[1]);
  ASSERT_TRUE(pair);
  click("At equal time");
  const QString other = QString("Own, %1 samples").arg(std::pow(std::lround(std::sqrt(pair->b)), 2));
  const auto has_names = [&] {
    const auto* browser = window_.findChild<ImageBrowser*>();
    return browser != nullptr && browser->names().contains(other) && browser->names().size() == 2;
  };
  ASSERT_TRUE(QTest::qWaitFor(has_names, test::Minute)) << notice();
  const QString shown = window_.image_browser().shown_path();
  EXPECT_THAT(shown.toStdString(), HasSubstr("Diffuse, 64 samples"));
}

}  // namespace
}  // namespace editor
