#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/image/image_file.h"
#include "tests/job/preview_helpers.h"
#include "tests/support/temporary_folder.h"

namespace {

using job::PreviewRequest;
using job::PreviewScene;
using testing::HasSubstr;

class PreviewSceneTest : public testing::Test {
 protected:
  bool prepare(const PreviewRequest& request) {
    return scene_.prepare(request, {}, diagnostics_).has_value();
  }

  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;
  PreviewScene scene_;
};

TEST_F(PreviewSceneTest, CompilesNothingWhereTheViewAloneChanges) {
  PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  ASSERT_TRUE(prepare(request)) << diagnostics_.to_text();
  request.options.eye = grf::Vec3f(1, 2, 5);
  request.options.size = {40, 30};
  request.options.samples = 3;
  request.scene = test::scene_of_text(test::Corner);  // equal, and another one
  ASSERT_TRUE(prepare(request));
  request.view = transport::View{.eye = grf::Vec3d(2, 2, 2)};
  ASSERT_TRUE(prepare(request));
  EXPECT_EQ(scene_.compilations(), 1);
  request.options.scheme = "hemisphere";
  ASSERT_TRUE(prepare(request)) << diagnostics_.to_text();
  EXPECT_EQ(scene_.compilations(), 2) << "another sampling scheme has other tables";
}

TEST_F(PreviewSceneTest, HasTheLensOfTheSelectedCameraInAnotherView) {
  PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  request.options.lens_radius = 0.5F;
  request.options.cameras = {
      {"close up", grf::Vec3f(0, 0, 4), grf::Vec3f(0), grf::Vec3f(0, 1, 0), 30, 0.25F, 3}};
  request.view = transport::View{.eye = grf::Vec3d(2, 2, 2)};
  auto settings = scene_.prepare(request, {}, diagnostics_);
  ASSERT_TRUE(settings) << diagnostics_.to_text();
  EXPECT_EQ(settings->view.lens_radius, 0.5F);
  request.options.camera = "close up";
  settings = scene_.prepare(request, {}, diagnostics_);
  ASSERT_TRUE(settings) << diagnostics_.to_text();
  EXPECT_EQ(settings->view.eye, grf::Vec3d(2, 2, 2));
  EXPECT_EQ(settings->view.lens_radius, 0.25F);
  EXPECT_EQ(settings->view.focus_distance, 3);
}

TEST_F(PreviewSceneTest, KeepsWhatCastsRaysWhereSurfacesAloneChange) {
  PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  ASSERT_TRUE(prepare(request)) << diagnostics_.to_text();
  const transport::RayCaster before = scene_.compiled().caster();
  grf::Mesh& mesh = test::first_mesh(request.scene).edit();
  mesh.surfaces[0].colour = grf::Colour(0.5F, 0, 0);
  ASSERT_TRUE(prepare(request)) << diagnostics_.to_text();
  EXPECT_EQ(scene_.compilations(), 2);
  EXPECT_TRUE(scene_.compiled().caster().shares(before));
  grf::Geometry geometry = *mesh.geometry;
  geometry.positions[0].y = 0.25F;
  mesh.geometry = std::move(geometry);
  request.scene = grf::Scene(request.scene);
  ASSERT_TRUE(prepare(request)) << diagnostics_.to_text();
  EXPECT_FALSE(scene_.compiled().caster().shares(before));
}

TEST_F(PreviewSceneTest, ReadsTexturesAnewThatChanged) {
  const std::string path = folder_.path("scene.grf");
  const auto write = [&](const transport::Rgb& colour) {
    image::ImageFile file;
    file.image = {2, 2, std::vector<transport::Rgb>(4, colour)};
    ASSERT_TRUE(image::keep_image(file, folder_.path("paper.pfm"), {}, diagnostics_));
  };
  write(transport::Rgb(0.25F));
  PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  request.path = path;
  // The texture is set in memory, so its path was not read from a file.
  test::first_mesh(request.scene).edit().surfaces[0].texture = grf::Texture{"paper.pfm", {}};
  ASSERT_TRUE(prepare(request)) << diagnostics_.to_text();
  const auto first = scene_.compiled().textures().at(0).texture;
  EXPECT_NEAR(first->lookup({0.5F, 0.5F}, 0).x, 0.25, 1e-3);
  test::first_mesh(request.scene).edit().surfaces[0].colour = grf::Colour(0.5F);
  ASSERT_TRUE(prepare(request));
  EXPECT_EQ(scene_.compiled().textures().at(0).texture, first);
  write(transport::Rgb(0.75F));
  std::filesystem::last_write_time(folder_.path("paper.pfm"),
                                   std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
  ASSERT_TRUE(prepare(request)) << "the same request reads files anew";
  EXPECT_NEAR(scene_.compiled().textures().at(0).texture->lookup({0.5F, 0.5F}, 0).x, 0.75, 1e-3);
}

TEST_F(PreviewSceneTest, SaysWhatIsWrong) {
  PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  request.path = folder_.path("scene.grf");
  test::first_mesh(request.scene).edit().surfaces[0].texture = grf::Texture{"lost.png", {}};
  EXPECT_FALSE(prepare(request));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("lost.png"));
  request = test::request(test::scene_of_text(test::Corner));
  grf::BrdfModel unknown;
  unknown.keyword = "velvety";
  test::first_mesh(request.scene).edit().surfaces[0].brdf = unknown;
  EXPECT_FALSE(prepare(request));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("velvety"));
  EXPECT_FALSE(prepare(test::request({})));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("nothing to render"));
  request = test::request(test::scene_of_text(test::Corner));
  request.options.environment = folder_.path("no_sky.exr");
  EXPECT_FALSE(prepare(request));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("no_sky.exr"));
  EXPECT_TRUE(prepare(test::request(test::scene_of_text(test::Corner)))) << "and recovers";
}

}  // namespace
