#include "editor/brdf/brdf_plots.h"

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <qcustomplot.h>

#include "editor/brdf/compiled_brdf.h"
#include "grf/read.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/presets.h"
#include "tests/editor/brdf/brdf_of.h"

namespace editor {
namespace {

grf::PdfModel pdf(const std::string& text) {
  grf::Diagnostics diagnostics;
  return *grf::read_pdf(text, "test", diagnostics);
}

plot::AlbedoCurve albedo_of(const reflectance::Brdf& brdf) {
  return plot::albedo_curve(reflectance::Reflector(brdf, reflectance::OwnScheme()), 1024);
}

TEST(LobeCurves, HaveTheDensityOfAScheme) {
  const SharedBrdf ward = compiled_brdf_of("ward sx=0.2");
  const LobeCurves curves = lobe_curves(*ward, {30}, pdf("diffuse"), {});
  const plot::LobeCurve& curve = curves.curves.front();
  ASSERT_EQ(curve.pdfs.size(), curve.degrees.size());
  for (std::size_t i = 0; i < curve.degrees.size(); i += 37) {
    EXPECT_NEAR(curve.pdfs[i], std::cos(curve.degrees[i] * std::numbers::pi / 180) / std::numbers::pi, 1e-4);
  }
  const LobeCurves refused = lobe_curves(*ward, {30}, pdf("specular"), {});
  EXPECT_FALSE(refused.scheme_error.isEmpty());
  EXPECT_TRUE(refused.curves.front().pdfs.empty());
}

TEST(AlbedoCurves, WarnOfGainInTheModelsWords) {
  const SharedBrdf minnaert = compiled_brdf_of("minnaert k=0.8 kd=1");
  const plot::AlbedoCurve curve = albedo_of(*minnaert);
  EXPECT_NEAR(curve.along_x.front().x, 1.111, 0.01);
  EXPECT_GT(curve.largest.albedo, 1.5F);
  const EnergyNote words = energy_note(*minnaert, curve.largest);
  EXPECT_TRUE(words.is_warning);
  const auto info = reflectance::info_of<reflectance::Minnaert>();
  EXPECT_TRUE(words.text.contains(QString::fromStdString(std::string(info.not_conserving))));
  const SharedBrdf matte = compiled_brdf_of("diffuse kd=0.5");
  EXPECT_FALSE(energy_note(*matte, albedo_of(*matte).largest).is_warning);
}

class Plots : public testing::Test {
 protected:
  void SetUp() override {
    plots.resize(360, 480);
    plots.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&plots));
  }
  bool settles() {
    return QTest::qWaitFor([&] { return !plots.is_busy(); });
  }
  QCustomPlot& plot() { return *plots.findChild<QCustomPlot*>(); }

  BrdfPlots plots;
};

TEST_F(Plots, SayWhatToDoWithoutABrdf) {
  plots.set_brdf(nullptr, "Choose a BRDF.");
  ASSERT_TRUE(settles());
  bool says = false;
  for (const QLabel* label : plots.findChildren<QLabel*>())
    says |= label->isVisible() && label->text() == "Choose a BRDF.";
  EXPECT_TRUE(says);
}

TEST_F(Plots, DrawTheValuesInAllKinds) {
  const SharedBrdf one = compiled_brdf_of("phong n=30 ks=0.4 kd=(0.6, 0.3, 0.1)");
  plots.set_brdf(one);
  ASSERT_TRUE(settles());
  EXPECT_EQ(plot().legend->itemCount(), 4);
  plots.set_kind(BrdfPlots::Kind::Cartesian);
  ASSERT_EQ(plot().graphCount(), 4);
  for (auto* combo : plots.findChildren<QComboBox*>()) {
    if (combo->accessibleName() == "Channel") combo->setCurrentIndex(1);
  }
  const auto point = *plot().graph(1)->data()->findBegin(20, false);
  EXPECT_NEAR(point.value,
              reflectance::evaluate(*one, plot::direction_at(-30), plot::direction_at(point.key)).x, 1e-6);
  plots.set_kind(BrdfPlots::Kind::Albedo);
  ASSERT_TRUE(settles());
  ASSERT_EQ(plot().graphCount(), 3);
}

TEST_F(Plots, TakeViewsAndScheme) {
  plots.set_brdf(compiled_brdf_of("ward"));
  auto* views = plots.findChild<QLineEdit*>();
  views->setText("0, 45");
  emit views->editingFinished();
  plots.set_scheme(pdf("hemisphere exp=20"));
  ASSERT_TRUE(settles());
  ASSERT_EQ(plots.curves().curves.size(), 2U);
  EXPECT_FALSE(plots.curves().curves[1].pdfs.empty());
}

TEST_F(Plots, FollowTheLatestBrdfAlone) {
  for (int i = 1; i <= 20; ++i) plots.set_brdf(compiled_brdf_of("diffuse kd=" + std::to_string(0.05 * i)));
  QSignalSpy updated(&plots, &BrdfPlots::updated);
  ASSERT_TRUE(settles());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !plots.curves().curves.empty(); }));
  EXPECT_FLOAT_EQ(plots.curves().curves[0].values[0].x, 1 / reflectance::Pi);
  EXPECT_LE(updated.count(), 2);
}

TEST_F(Plots, AreWritten) {
  plots.set_brdf(compiled_brdf_of("ward"));
  ASSERT_TRUE(settles());
  const QTemporaryDir folder;
  for (const char* ending : {"svg", "png", "pdf", "csv"}) {
    QFile file(folder.filePath(QString("plot.") + ending));
    EXPECT_EQ(plots.export_to(file.fileName()), "") << ending;
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << ending;
    EXPECT_GT(file.size(), 1000) << ending;
  }
  EXPECT_NE(plots.export_to(folder.filePath("plot.xyz")), "");
  EXPECT_NE(plots.export_to(folder.filePath("none/plot.png")), "");
}

}  // namespace
}  // namespace editor
