#include "editor/rendering/irradiance_bake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"
#include "grf/relocate.h"
#include "grf/visit.h"
#include "grf/write.h"
#include "tests/editor/rendering/rendering_helpers.h"

namespace {

using editor::IrradianceBake;
using editor::IrradianceBakeResult;
using testing::HasSubstr;
using testing::Not;

/// The scene without the data that a bake adds.
grf::Scene without_irradiance(grf::Scene scene) {
  std::erase_if(scene.contents.blocks,
                [](const grf::Block& block) { return std::holds_alternative<grf::Params>(block.content); });
  test::first_mesh(scene).edit().irradiance = {};
  return scene;
}

options::RenderOptions with_samples(int samples) {
  options::RenderOptions render_options;
  render_options.samples = samples;
  return render_options;
}

class IrradianceBakeTest : public testing::Test {
 protected:
  IrradianceBakeTest() {
    QObject::connect(&bake_, &IrradianceBake::finished,
                     [this](const editor::BakedIrradiance& irradiance, const IrradianceBakeResult& result) {
                       scene_ = irradiance.applied_to(edited_, folder_.path("scene.grf")).scene;
                       result_ = result;
                     });
    QObject::connect(&bake_, &IrradianceBake::failed,
                     [this](const QString& why) { why_ = why.toStdString(); });
  }

  QString path(const char* name) const { return QString::fromStdString(folder_.path(name)); }
  bool ends() {
    return QTest::qWaitFor([this] { return !bake_.is_running(); }, test::Minute);
  }
  void bake(const grf::Scene& scene, const QString& file, const options::RenderOptions& options = {}) {
    edited_ = scene;
    bake_.start(scene, file, options);
  }
  float irradiance(std::size_t vertex) {
    return std::get<grf::Colour>((*test::first_mesh(*scene_)->irradiance)[vertex]).x;
  }

  test::TemporaryFolder folder_;
  IrradianceBake bake_;
  const grf::Scene corner_ = test::scene_of_text(test::Corner);
  grf::Scene edited_;  ///< the scene after the bake
  std::optional<grf::Scene> scene_;
  IrradianceBakeResult result_;
  std::string why_;
};

TEST_F(IrradianceBakeTest, GivesTheSceneIrradianceAndChangesNothingElse) {
  QSignalSpy progress(&bake_, &IrradianceBake::progressed);
  bake(corner_, path("scene.grf"), with_samples(256));  // no such file
  ASSERT_TRUE(ends());
  ASSERT_TRUE(scene_) << why_;
  EXPECT_EQ(without_irradiance(*scene_), corner_);
  for (std::size_t vertex = 0; vertex < 6; ++vertex) {
    EXPECT_GT(irradiance(vertex), 0.3F);
    EXPECT_LT(irradiance(vertex), 1.5F);
  }
  EXPECT_EQ(result_.summary.vertices, 6);
  EXPECT_NEAR(result_.summary.samples, 256, 1);
  EXPECT_GT(*result_.summary.estimated_error, 0);
  EXPECT_FALSE(result_.is_stopped);
  EXPECT_EQ(result_.messages.toStdString(), "");
  ASSERT_FALSE(progress.empty());
  EXPECT_EQ(progress.back()[0].toDouble(), 1);
  EXPECT_TRUE(folder_.names().empty()) << "and leaves nothing beside the scene";
}

TEST_F(IrradianceBakeTest, NamesFilesAsTheSceneDoes) {
  folder_.add("maps/paper.pfm", std::string("PF\n1 1\n-1.0\n") + std::string(12, '\1'));
  const std::string absolute = folder_.path("maps/paper.pfm");
  grf::Scene scene = corner_;
  grf::Mesh& mesh = test::first_mesh(scene).edit();
  mesh.surfaces[0].texture = grf::Texture{"maps/paper.pfm", {}};
  grf::Geometry geometry = *mesh.geometry;
  geometry.uvs.set(0, grf::Vec2f(0.5F));
  mesh.geometry = std::move(geometry);
  mesh.surfaces.push_back(mesh.surfaces[0]);
  mesh.surfaces[1].texture = grf::Texture{absolute, {}};
  mesh.surface_of_face.edit()[1] = 1;
  options::RenderOptions render_options = with_samples(4);
  render_options.environment = "maps/paper.pfm";
  bake(scene, path("scene.grf"), render_options);
  ASSERT_TRUE(ends());
  ASSERT_TRUE(scene_) << why_;
  EXPECT_EQ(without_irradiance(*scene_), scene);
  EXPECT_THAT(result_.messages.toStdString(), HasSubstr("corners without uv"));
  EXPECT_THAT(result_.messages.toStdString(), Not(HasSubstr("scene.grf:")));
}

TEST_F(IrradianceBakeTest, HeedsTheOptions) {
  options::RenderOptions render_options;
  render_options.target_error = 0.05F;
  bake(corner_, {}, render_options);
  ASSERT_TRUE(ends());
  ASSERT_TRUE(scene_) << why_;
  EXPECT_LE(*result_.summary.estimated_error, 0.05F);
  const double rough = result_.summary.samples;
  render_options.target_error = 0.01F;
  bake(corner_, {}, render_options);
  ASSERT_TRUE(ends());
  EXPECT_LE(*result_.summary.estimated_error, 0.01F);
  EXPECT_GT(result_.summary.samples, 2 * rough);
}

TEST_F(IrradianceBakeTest, WritesRepeatedMeshesOutAndSaysSo) {
  const grf::Scene scene = test::scene_of_text(
      "light begin (-1,3,-1) (2,0,0) (0,0,2) end\n"
      "def tile = begin mesh brdf diffuse begin vertexs (0,0,1) (1,0,0) (0,0,0) end vertexs\n"
      "begin faces (0,1,2) end faces end mesh begin\n"
      "use tile transform translation (0,1,0) begin use tile end end\n");
  bake(scene, path("scene.grf"), with_samples(4));
  ASSERT_TRUE(ends());
  ASSERT_TRUE(scene_) << why_;
  EXPECT_THAT(result_.messages.toStdString(), HasSubstr("1 mesh is placed by 'use' more than once"));
  EXPECT_THAT(grf::to_text(*scene_), HasSubstr("use tile$2"));
}

TEST_F(IrradianceBakeTest, KeepsWhatThereIsWhenItIsStopped) {
  QSignalSpy progress(&bake_, &IrradianceBake::progressed);
  bake(corner_, path("scene.grf"), with_samples(2'000'000'000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return progress.size() > 1; }, test::Minute));
  bake_.stop();
  ASSERT_TRUE(ends());
  ASSERT_TRUE(scene_) << why_;
  EXPECT_TRUE(result_.is_stopped);
  EXPECT_LT(result_.summary.samples, 2'000'000'000);
  EXPECT_EQ(without_irradiance(*scene_), corner_);
}

TEST_F(IrradianceBakeTest, CanBeStoppedAtOnce) {
  bake(corner_, path("scene.grf"), with_samples(2'000'000'000));
  bake(corner_, path("scene.grf"));
  EXPECT_THAT(why_, HasSubstr("stop that first"));
  bake_.stop();
  ASSERT_TRUE(ends());
  EXPECT_FALSE(scene_);
  EXPECT_THAT(why_, HasSubstr("stopped before"));
}

TEST_F(IrradianceBakeTest, SaysWhatIsWrongWithTheScene) {
  grf::Scene scene = corner_;
  test::first_mesh(scene).edit().surfaces[0].texture = grf::Texture{"lost.png", {}};
  bake(scene, path("scene.grf"));
  ASSERT_TRUE(ends());
  EXPECT_FALSE(scene_);
  EXPECT_THAT(why_, HasSubstr("error: cannot read '" + folder_.path("lost.png")));
  EXPECT_THAT(why_, Not(HasSubstr("scene.grf"))) << "which is the snapshot";
  bake(test::scene_of_text("light begin (0,0,1) (0,1,0) (1,0,0) end"), {});
  ASSERT_TRUE(ends());
  EXPECT_THAT(why_, HasSubstr("the scene has no mesh"));
  bake(corner_, {}, with_samples(4));
  ASSERT_TRUE(ends());
  EXPECT_TRUE(scene_) << "and bakes again: " << why_;
}

TEST_F(IrradianceBakeTest, SaysThatTheRendererIsMissing) {
  for (const char* program : {"", "/nowhere/bpt"}) {
    IrradianceBake bake{QString(program)};
    QSignalSpy failed(&bake, &IrradianceBake::failed);
    bake.start(corner_, {});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.empty(); }, test::Minute));
    EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("bpt"));
    EXPECT_FALSE(bake.is_running());
  }
}

}  // namespace
