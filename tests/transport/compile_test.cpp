#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/task_scheduler_observer.h>

#include "renderer/parallel/loops.h"
#include "renderer/transport/camera.h"
#include "tests/transport/scene_helpers.h"

namespace {

using transport::CompiledScene;
using transport::Rgb;
using transport::Vec3f;

const std::string UnitQuad = test::quad("brdf diffuse kd=0.5", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)");

std::optional<transport::SurfacePoint> down_at(const CompiledScene& scene, float x, float y) {
  return scene.intersect({Vec3f(x, y, 100), Vec3f(0, 0, -1)});
}

TEST(Compile, PutsGeometryIntoTheWorld) {
  const CompiledScene scene =
      test::scene_of("transform scale (2,2,2) translation (10,0,1) begin " + UnitQuad + " end");
  EXPECT_EQ(scene.bounds().min, Vec3f(10, 0, 1));
  EXPECT_EQ(scene.bounds().max, Vec3f(12, 2, 1));
  EXPECT_EQ(scene.triangle_count(), 2U);
  ASSERT_TRUE(down_at(scene, 11, 1));
  EXPECT_EQ(down_at(scene, 11, 1)->geometric_normal, Vec3f(0, 0, 1));
  EXPECT_FALSE(down_at(scene, 9, 1));
}

// A reflected mesh keeps its front relative to its vertex normals.
TEST(Compile, KeepsFrontsUnderMirroringTransforms) {
  const CompiledScene scene = test::scene_of("transform scale (-1,1,1) begin " + UnitQuad + " end");
  EXPECT_EQ(down_at(scene, -0.5F, 0.5F)->geometric_normal, Vec3f(0, 0, 1));
  const CompiledScene lit =
      test::scene_of("transform scale (-1,1,1) begin light begin (0,0,0) (1,0,0) (0,1,0) end end");
  EXPECT_EQ(down_at(lit, -0.5F, 0.5F)->geometric_normal, Vec3f(0, 0, 1));
}

TEST(Compile, InterpolatesNormalsWhereAllCornersHaveOne) {
  const std::string smooth =
      "begin mesh begin vertexs normal (1,0,1) (0,0,0) normal (-1,0,1) (2,0,0) "
      "normal (0,0,1) (0,2,0) end vertexs begin faces (0,1,2) end faces end mesh";
  const CompiledScene scene = test::scene_of(smooth);
  EXPECT_NEAR((down_at(scene, 1, 0.001F)->shading_normal - Vec3f(0, 0, 1)).length(), 0, 1e-2);
  EXPECT_NEAR((down_at(scene, 0.001F, 0.001F)->shading_normal - Vec3f(1, 0, 1).normalized()).length(), 0,
              1e-2);
  const std::string flat =
      "begin mesh begin vertexs normal (1,0,1) (0,0,0) (2,0,0) "
      "normal (0,0,1) (0,2,0) end vertexs begin faces (0,1,2) end faces end mesh";
  EXPECT_EQ(down_at(test::scene_of(flat), 0.1F, 0.1F)->shading_normal, Vec3f(0, 0, 1));
}

TEST(Compile, MultipliesFaceAndVertexColours) {
  const CompiledScene scene = test::scene_of(
      "begin mesh rgb (0.5, 1, 1) begin vertexs rgb (1,0,0) (0,0,0) rgb (1,0,0) (2,0,0) rgb (1,0,0) (0,2,0) "
      "end vertexs begin faces (0,1,2) end faces end mesh");
  EXPECT_NEAR((down_at(scene, 0.3F, 0.3F)->colour - Rgb(0.5F, 0, 0)).length(), 0, 1e-6);
}

TEST(Compile, MakesEmittersOfLightsAndOfFacesThatEmit) {
  const CompiledScene scene =
      test::scene_of("light begin rgb (2,2,2) (5,0,0) (1,0,0) (0,1,0) end\n" +
                     test::quad("light rgb (1,1,1)", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)"));
  ASSERT_EQ(scene.lights().size(), 3U);  // one parallelogram, two triangles
  EXPECT_FLOAT_EQ(scene.lights()[0].power(), 2);
  EXPECT_FLOAT_EQ(scene.lights()[1].power(), 0.5);
  EXPECT_FLOAT_EQ(scene.lights()[2].power(), 0.5);
  const auto point = down_at(scene, 0.25F, 0.5F);
  EXPECT_EQ(scene.reflector(*point->surface), nullptr);  // emits, has no BRDF: black
}

TEST(Compile, SharesReflectorsAndLooksNamesUpInTheirScope) {
  const CompiledScene scene = test::scene_of(
      "def a = brdf diffuse kd=1 begin " + test::quad("brdf a", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)") +
      "def a = brdf diffuse kd=0 begin " + test::quad("brdf a", "(2,0,0) (3,0,0) (3,1,0) (2,1,0)") +
      "end end");
  const Vec3f u = Vec3f(0, 0, 1);
  EXPECT_GT(scene.reflector(*down_at(scene, 0.5F, 0.5F)->surface)->evaluate(u, u).x, 0);
  EXPECT_EQ(scene.reflector(*down_at(scene, 2.5F, 0.5F)->surface)->evaluate(u, u).x, 0);
}

TEST(Compile, MakesOneReflectorForEachPairOfBrdfAndScheme) {
  const CompiledScene scene =
      test::scene_of(test::quad("brdf ward sx=0.1", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)") +
                     test::quad("brdf ward sx=0.1 pdf diffuse", "(2,0,0) (3,0,0) (3,1,0) (2,1,0)") +
                     test::quad("brdf ward sx=0.1 pdf diffuse", "(4,0,0) (5,0,0) (5,1,0) (4,1,0)"));
  ASSERT_EQ(scene.tables().size(), 2U);
  EXPECT_EQ(scene.tables()[0].scheme, "auto");
  EXPECT_EQ(scene.tables()[1].brdf, "ward sx=0.1");
  EXPECT_EQ(scene.tables()[1].scheme, "diffuse");
  EXPECT_EQ(scene.tables()[1].bytes, 0U);
  EXPECT_EQ(scene.reflector(*down_at(scene, 2.5F, 0.5F)->surface),
            scene.reflector(*down_at(scene, 4.5F, 0.5F)->surface));
}

TEST(Compile, TakesASchemeInPlaceOfTheScenes) {
  grf::Diagnostics diagnostics;
  const auto scene =
      grf::read_text(test::quad("brdf ward sx=0.1", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)") +
                         test::quad("brdf phong n=5 pdf auto", "(2,0,0) (3,0,0) (3,1,0) (2,1,0)"),
                     "test.grf", diagnostics);
  transport::CompileSettings settings;
  settings.scheme.emplace();
  settings.scheme->model.keyword = "diffuse";
  const auto compiled = transport::compile(scene.value(), diagnostics, settings);
  ASSERT_TRUE(compiled) << diagnostics.to_text();
  ASSERT_EQ(compiled->tables().size(), 2U);
  for (const transport::TableInfo& table : compiled->tables()) EXPECT_EQ(table.scheme, "diffuse");
  settings.scheme->model.keyword = "specular";
  EXPECT_FALSE(transport::compile(scene.value(), diagnostics, settings));
  EXPECT_EQ(diagnostics.error_count(), 2U);
}

TEST(Compile, RefusesASchemeThatCannotServeTheBrdf) {
  try {
    test::scene_of(test::quad("brdf ward pdf specular", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("use 'diffuse' or 'auto'"), std::string::npos) << error.what();
  }
}

void expect_same_emitters(const CompiledScene& a, const CompiledScene& b) {
  EXPECT_EQ(a.triangle_count(), b.triangle_count());
  EXPECT_EQ(a.bounds(), b.bounds());
  ASSERT_EQ(a.lights().size(), b.lights().size());
  for (std::uint32_t i = 0; i < a.lights().size(); ++i) {
    EXPECT_FLOAT_EQ(a.lights()[i].power(), b.lights()[i].power());
  }
}

const std::string LightShape =
    "begin vertexs (0,0,2) (0,1,2) (1,1,2) (1,0,2) end vertexs begin faces rgb (4,4,4) (0,1,2) rgb (1,2,3) "
    "(0,2,3) "
    "rgb none (3,2,1) rgb (0,0,0) (0,1,3) end faces end ";
const std::string EmittingShape =
    "begin mesh begin vertexs (0,0,2) (0,1,2) (1,1,2) (1,0,2) end vertexs begin faces light rgb (4,4,4) "
    "(0,1,2) light rgb "
    "(1,2,3) (0,2,3) light rgb (1,1,1) (3,2,1) light rgb (0,0,0) (0,1,3) end faces end mesh ";

TEST(Compile, MakesOfAMeshLightWhatItMakesOfFacesThatEmit) {
  const CompiledScene light = test::scene_of("mesh light begin " + LightShape + UnitQuad);
  const CompiledScene faces = test::scene_of(EmittingShape + UnitQuad);
  EXPECT_EQ(light.lights().size(), 3U);
  expect_same_emitters(light, faces);
  for (const float x : {0.2F, 0.8F}) {
    const transport::Ray up{Vec3f(x, 0.5F, 1), Vec3f(0, 0, 1)};
    const auto a = light.intersect(up);
    const auto b = faces.intersect(up);
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->surface->emission, b->surface->emission);
    EXPECT_EQ(a->geometric_normal, b->geometric_normal);
    EXPECT_EQ(light.reflector(*a->surface), nullptr) << "it reflects nothing";
  }
}

TEST(Compile, LooksTheRadianceOfMeshLightsUpInTheirScope) {
  const CompiledScene scene = test::scene_of(
      "def c = rgb (7,0,0) begin mesh light begin rgb c begin vertexs (0,0,2) (0,1,2) (1,0,2) end begin "
      "faces (0,1,2) end "
      "end " +
      UnitQuad + "end");
  const auto point = scene.intersect({Vec3f(0.25F, 0.25F, 1), Vec3f(0, 0, 1)});
  ASSERT_TRUE(point);
  EXPECT_EQ(point->surface->emission, Rgb(7, 0, 0));
}

TEST(Compile, TurnsMeshLightsRoundUnderMirroringTransforms) {
  const std::string light =
      "mesh light begin begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end end ";
  const CompiledScene scene = test::scene_of("transform scale (-1,1,1) begin " + light + "end " + UnitQuad);
  EXPECT_EQ(down_at(scene, -0.25F, 0.25F)->geometric_normal, Vec3f(0, 0, 1));
}

std::string placed_by(const std::string& mesh) {
  return mesh + "transform scale (1,2,-3) rotation (0.3,0.7,1) translation (3,0,0) begin " + mesh + "end " +
         "def paint = rgb (0,0,1) begin transform translation (0,5,0) begin " + mesh + "end end ";
}

TEST(Compile, MakesOfAnInstanceWhatItMakesOfTheMeshWrittenOut) {
  const std::string mesh =
      "begin mesh rgb paint brdf ward begin vertexs normal (0,1,2) (0,0,0) (1,0,0) normal (0,0,1) (1,1,0) "
      "(0,1,0) end vertexs "
      "begin faces (0,1,2) light rgb (3,3,3) (0,2,3) end faces end mesh ";
  const CompiledScene used =
      test::scene_of("def paint = rgb (1,0,0) shape = " + mesh + "begin " + placed_by("use shape ") + "end");
  const CompiledScene written = test::scene_of("def paint = rgb (1,0,0) begin " + placed_by(mesh) + "end");
  EXPECT_EQ(used.triangle_count(), 6U);
  expect_same_emitters(used, written);
  const auto a = down_at(used, 0.9F, 0.1F);
  const auto b = down_at(written, 0.9F, 0.1F);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->shading_normal, b->shading_normal);
  EXPECT_EQ(a->colour, b->colour);
  EXPECT_EQ(down_at(used, 0.9F, 5.1F)->colour, Rgb(1, 0, 0)) << "by the name where it is defined";
  EXPECT_EQ(down_at(written, 0.9F, 5.1F)->colour, Rgb(0, 0, 1));
}

TEST(Compile, RendersAMeshLightAndAnInstanceAsWhatTheyStandFor) {
  const std::string room = test::quad("brdf diffuse kd=0.5", "(-2,-2,0) (2,-2,0) (2,2,0) (-2,2,0)");
  const std::string long_way =
      room + EmittingShape + "transform translation (-1,-1,0) begin " + EmittingShape + "end ";
  const std::string short_way = "def lamp = " + EmittingShape + "begin " + room + "mesh light begin " +
                                LightShape + "transform translation (-1,-1,0) begin use lamp end end";
  test::RenderSetup setup;
  setup.eye = transport::Vec3f(0, -3, 1);
  setup.width = setup.height = 8;
  const transport::Film a = test::render(test::scene_of(short_way), setup);
  const transport::Film b = test::render(test::scene_of(long_way), setup);
  EXPECT_GT(test::mean_radiance(b).mean, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(test::mean_radiance(a).mean),
                  static_cast<float>(test::mean_radiance(b).mean));
}

/// Counts the workers that help the calling thread in loops outside of any job.
class HelpersOutsideJobs : public tbb::task_scheduler_observer {
 public:
  HelpersOutsideJobs() { observe(true); }
  HelpersOutsideJobs(const HelpersOutsideJobs&) = delete;
  HelpersOutsideJobs& operator=(const HelpersOutsideJobs&) = delete;
  ~HelpersOutsideJobs() override { observe(false); }

  void on_scheduler_entry(bool is_worker) override { count_ += is_worker ? 1 : 0; }
  int count() const { return count_; }

 private:
  std::atomic<int> count_ = 0;
};

/// A floor of this many tiles per side, all of which emit.
std::string shining_tiles(int side) {
  std::string text = "begin mesh light rgb (1,1,1) begin vertexs\n";
  for (int i = 0; i <= side * (side + 2); ++i) {
    text += fmt::format("({},{},0)\n", i % (side + 1), i / (side + 1));
  }
  text += "end vertexs begin faces\n";
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int corner = y * (side + 1) + x;
      text += fmt::format("({},{},{},{})\n", corner, corner + 1, corner + side + 2, corner + side + 1);
    }
  }
  return text + "end faces end mesh\n";
}

// Building the acceleration structure and the light tree takes long here, and could use all threads.
TEST(Compile, UsesNoOtherThreadsThanItsSettingsSay) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(shining_tiles(100), "test.grf", diagnostics);
  transport::CompileSettings settings;
  settings.threads = 1;
  const HelpersOutsideJobs helpers;
  ASSERT_TRUE(transport::compile(scene.value(), diagnostics, settings)) << diagnostics.to_text();
  EXPECT_EQ(helpers.count(), 0);
  parallel::for_each_index(100, [](int) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
  // With one core there are no helpers.
  EXPECT_EQ(helpers.count() > 0, std::thread::hardware_concurrency() > 1) << "would have been seen";
}

TEST(Camera, LooksThroughTheMiddleOfTheImage) {
  transport::View view;
  view.eye = Vec3f(1, 2, 3);
  view.target = Vec3f(1, 2, -5);
  view.field_of_view = 90;
  const transport::Camera camera(view, 200, 100);
  EXPECT_NEAR((camera.ray(100, 50).direction - Vec3f(0, 0, -1)).length(), 0, 1e-6);
  EXPECT_NEAR((camera.ray(100, 0).direction - Vec3f(0, 1, -1).normalized()).length(), 0, 1e-6);
  EXPECT_NEAR((camera.ray(200, 50).direction - Vec3f(2, 0, -1).normalized()).length(), 0, 1e-6);
}

TEST(Camera, HasAnUpwardEvenAlongItsUpVector) {
  transport::View view;
  view.eye = Vec3f(0, 5, 0);
  const transport::Camera camera(view, 100, 100);
  EXPECT_NEAR((camera.ray(50, 50).direction - Vec3f(0, -1, 0)).length(), 0, 1e-6);
  EXPECT_NEAR(camera.ray(50, 0).direction.z / camera.ray(50, 0).direction.y, -0.4142, 1e-3);
}

TEST(Camera, SeesTheWholeSceneWhenNobodyPlacesIt) {
  const grf::Box3f bounds(Vec3f(-1, -2, -3), Vec3f(4, 5, 6));
  for (const float aspect : {0.3F, 1.0F, 3.0F}) {
    const transport::View view =
        transport::view_of(grf::Box3d(grf::Vec3d(bounds.min), grf::Vec3d(bounds.max)), 45, aspect);
    const Vec3f forward((view.target - view.eye).normalized());
    const float narrow = std::atan(std::tan(static_cast<float>(M_PI) / 8) * std::min(1.0F, aspect));
    for (int i = 0; i < 8; ++i) {
      const Vec3f corner((i & 1) != 0 ? 4.0F : -1.0F, (i & 2) != 0 ? 5.0F : -2.0F,
                         (i & 4) != 0 ? 6.0F : -3.0F);
      EXPECT_LE(std::acos((corner - Vec3f(view.eye)).normalized().dot(forward)), narrow + 1e-5F);
    }
    // No farther away than where the sphere around the box fits, of diameter sqrt(5^2 + 7^2 + 9^2).
    EXPECT_NEAR((view.eye - view.target).length(), std::sqrt(155.0) / 2 / std::sin(narrow), 1e-3);
  }
}

}  // namespace
