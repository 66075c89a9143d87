// Tangents, terminator offsets, irradiance and memory.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/transport/scene_helpers.h"

namespace {

using transport::CompiledScene;
using transport::Rgb;
using transport::SurfacePoint;
using transport::Vec3f;

SurfacePoint down_at(const CompiledScene& scene, float x, float y) {
  return scene.intersect({Vec3f(x, y, 100), Vec3f(0, 0, -1)}).value();
}

TEST(Tangent, PointsAlongIncreasingU) {
  const std::string corners = "uv (0,0) (0,0,0) uv (0,1) (1,0,0) uv (-1,1) (1,1,0) uv (-1,0) (0,1,0)";
  const CompiledScene scene = test::scene_of(test::quad("brdf ward sx=0.1 sy=0.3", corners));
  EXPECT_LT((down_at(scene, 0.3F, 0.6F).tangent.normalized() - Vec3f(0, -1, 0)).length(), 1e-5F);
  const CompiledScene isotropic = test::scene_of(test::quad("brdf ward sx=0.1 sy=0.1", corners));
  EXPECT_EQ(down_at(isotropic, 0.3F, 0.6F).tangent, Vec3f(0));
}

TEST(Tangent, RunsRoundTheObjectsAxisWithoutUv) {
  const std::string sphere = test::sphere("brdf ward sx=0.1 sy=0.3", 32, true);
  const CompiledScene scene = test::scene_of(sphere);
  const SurfacePoint point = down_at(scene, 0.5F, 0.3F);
  const Vec3f parallel = Vec3f(0, 1, 0).cross(point.shading_normal).normalized();
  EXPECT_LT((point.tangent.normalized() - parallel).length(), 1e-4F);
  // The object's axis rotates with it: z is up here.
  const CompiledScene turned = test::scene_of("transform rotation (1.5707964,0,0) begin " + sphere + " end");
  const SurfacePoint seen = down_at(turned, 0.5F, 0.3F);
  const Vec3f turned_parallel = Vec3f(0, 0, 1).cross(seen.shading_normal).normalized();
  EXPECT_LT((seen.tangent.normalized() - turned_parallel).length(), 1e-4F);
}

// Where a texture is mirrored, u increases in the other direction.
TEST(Tangent, PointsAlongIncreasingUOfMirroredUv) {
  const CompiledScene scene = test::scene_of(test::quad(
      "brdf ward sx=0.1 sy=0.3", "uv (0,0) (0,0,0) uv (-1,0) (1,0,0) uv (-1,1) (1,1,0) uv (0,1) (0,1,0)"));
  EXPECT_LT((down_at(scene, 0.3F, 0.6F).tangent.normalized() - Vec3f(-1, 0, 0)).length(), 1e-5F);
  EXPECT_LT((down_at(scene, 0.6F, 0.3F).tangent.normalized() - Vec3f(-1, 0, 0)).length(), 1e-5F);
}

// A reflection of x maps the tangent t to (-t.x, t.y, t.z): it reverses the one along x, and maps the one
// around the y axis, y x n, to -(y x n) of the mapped normal.
TEST(Tangent, IsMappedWithItsObjectThatIsMirrored) {
  const std::string brdf = "brdf ward sx=0.1 sy=0.3";
  const std::string sheet =
      test::quad(brdf, "uv (0,0) (0,0,5) uv (1,0) (1,0,5) uv (1,1) (1,1,5) uv (0,1) (0,1,5)");
  const std::string text =
      "def ball = " + test::sphere(brdf, 32, true) + "def sheet = " + sheet +
      "begin transform scale (-1,1,1) begin use ball transform translation (5,0,0) begin "
      "use sheet end end transform translation (50,0,0) begin use ball end end";
  for (const std::size_t most_copied : {0, 1'000'000}) {
    grf::Diagnostics diagnostics;
    transport::CompileSettings settings;
    settings.most_copied_triangles = most_copied;
    const auto scene =
        transport::compile(grf::read_text(text, "test.grf", diagnostics).value(), diagnostics, settings);
    ASSERT_TRUE(scene) << diagnostics.to_text();
    ASSERT_EQ(scene->instance_count(), most_copied == 0 ? 2U : 0U);
    const Vec3f along_u = down_at(*scene, -5.3F, 0.6F).tangent.normalized();
    EXPECT_LT((along_u - Vec3f(-1, 0, 0)).length(), 1e-5F);
    const SurfacePoint point = down_at(*scene, 0.5F, 0.3F);
    const Vec3f expected = -Vec3f(0, 1, 0).cross(point.shading_normal).normalized();
    EXPECT_LT((point.tangent.normalized() - expected).length(), 1e-4F) << most_copied;
  }
}

TEST(Frame, HasItsTangentInThePlaneOfTheNormal) {
  const Vec3f normal = Vec3f(1, 2, 3).normalized();
  const reflectance::Frame frame(normal, Vec3f(0, 5, 0));
  EXPECT_NEAR(frame.x.dot(normal), 0, 1e-6);
  EXPECT_NEAR(frame.x.cross(frame.y).dot(normal), 1, 1e-6);
  EXPECT_GT(frame.x.y, 0);
  EXPECT_NEAR(reflectance::Frame(normal, normal).x.length(), 1, 1e-6);
  EXPECT_NEAR(reflectance::Frame(normal, Vec3f(0)).x.length(), 1, 1e-6);
}

TEST(RaisedPoint, LiesOnTheSphereThatTrianglesStandFor) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf diffuse", 8, true));
  int raised = 0;
  for (int i = 0; i < 400; ++i) {
    const SurfacePoint point =
        down_at(scene, 0.04F * static_cast<float>(i % 20) - 0.4F, 0.04F * static_cast<float>(i / 20) - 0.4F);
    if (point.terminator_offset == Vec3f(0)) continue;
    ++raised;
    EXPECT_GT((point.position + point.terminator_offset).length(), 0.96F);
    EXPECT_LT((point.position + point.terminator_offset).length(), 1.06F);  // between tangent planes
  }
  EXPECT_GT(raised, 300);
}

// From inside, a sphere is concave.
TEST(RaisedPoint, IsNoneWhereTheSurfaceIsHollow) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf diffuse", 8, true));
  for (int i = 0; i < 100; ++i) {
    const float x = 0.01F * static_cast<float>(i);
    EXPECT_EQ(scene.intersect({Vec3f(0), Vec3f(x, 0.3F, 1)})->terminator_offset, Vec3f(0));
  }
}

// A wall that nearly touches the sphere stays between the sphere and what is behind the wall.
TEST(RaisedPoint, DoesNotPassThroughAWall) {
  const std::string wall = test::quad("brdf diffuse", "(-2,-2,0.985) (2,-2,0.985) (2,2,0.985) (-2,2,0.985)");
  const CompiledScene scene = test::scene_of(test::sphere("brdf diffuse", 8, true) + wall);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const float x = 0.5F * static_cast<float>(i % 50) / 50 - 0.25F;
    const float y = 0.5F * static_cast<float>(i / 50) / 50 - 0.25F;
    const Vec3f eye(3, 0, 0.98F);
    const auto point = scene.intersect({eye, Vec3f(x, y, 0.97F) - eye});
    if (!point) continue;
    const Vec3f grazing = Vec3f(point->position.x, point->position.y, 0).normalized();
    const Vec3f under = (grazing - 1e-3F * point->geometric_normal).normalized();
    std::uint64_t rays = 0;
    const auto start = scene.start_of(*point, under, point->geometric_normal, rays);
    ++met;
    if (start) {
      EXPECT_LT(start->origin.z, 0.985F);
    }
  }
  EXPECT_GT(met, 100);
}

// On a coarse sphere, directions just below a triangle start from the offset point, which takes a ray to test
// whether the offset is unoccluded; those above it start from the triangle.
TEST(RaisedPoint, TakesARayWhereItIsUsed) {
  const CompiledScene scene = test::scene_of(test::sphere("brdf diffuse", 8, true));
  const auto point = scene.intersect({Vec3f(0.1F, 0.2F, 3), Vec3f(0, 0, -1)});
  ASSERT_TRUE(point && point->terminator_offset.length() > 0);
  const Vec3f normal = point->geometric_normal;
  const Vec3f along = normal.cross(Vec3f(1, 0, 0)).normalized();
  std::uint64_t rays = 0;
  ASSERT_TRUE(scene.start_of(*point, along + 0.01F * normal, normal, rays));
  EXPECT_EQ(rays, 0U);
  ASSERT_TRUE(scene.start_of(*point, along - 0.01F * normal, normal, rays));
  EXPECT_EQ(rays, 1U);
  EXPECT_FALSE(scene.start_of(*point, along + 0.01F * normal, -normal, rays)) << "from inside it is hollow";
  EXPECT_EQ(rays, 1U);
}

// The shadow terminator on a coarse sphere is where it would be on the sphere, as far as a mesh permits.
TEST(RaisedPoint, LetsLightEndSoftly) {
  const std::string lamp = "light begin rgb (100,100,100) (50,-5,-5) (0,0,10) (0,10,0) end ";
  test::RenderSetup setup;
  setup.samples = 64;
  setup.depth = 1;
  setup.width = setup.height = 48;
  const auto brightness = [&](int rows) {
    return test::mean_radiance(
        test::render(test::scene_of(lamp + test::sphere("brdf diffuse kd=1", rows, true)), setup));
  };
  EXPECT_NEAR(brightness(12).mean / brightness(96).mean, 1, 0.03);
}

TEST(Irradiance, IsInterpolatedWhereAllCornersHaveItAndItWasAskedFor) {
  const std::string text =
      "begin mesh brdf diffuse begin vertexs irad (1,2,3) (0,0,0) begin list ray (0,0,1) irad (1,0,0) ray "
      "(1,0,0) irad "
      "(2,0,0) end list (1,0,0) irad (0,0,0) (0,1,0) (1,1,0) end vertexs begin faces (0,1,2) (1,3,2) end "
      "faces end mesh";
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text, "test.igrf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  transport::CompileSettings settings;
  settings.has_irradiance = true;
  const auto compiled = transport::compile(*scene, diagnostics, settings);
  ASSERT_TRUE(compiled);
  const auto irradiance = down_at(*compiled, 0.25F, 0.25F).irradiance;
  ASSERT_TRUE(irradiance);
  EXPECT_LT((*irradiance - Rgb(1.25F, 1, 1.5F)).length(), 1e-5F);
  EXPECT_FALSE(down_at(*compiled, 0.75F, 0.75F).irradiance);
  EXPECT_FALSE(down_at(*transport::compile(*scene, diagnostics), 0.25F, 0.25F).irradiance);
}

TEST(Memory, IsLessThanTheLimitForEachTriangle) {
  constexpr std::uint32_t Side = 708;  // a million triangles
  grf::MeshDraft mesh;
  for (std::uint32_t i = 0; i < Side * Side; ++i) {
    mesh.normals.set(i, Vec3f(0, 0, 1));
    mesh.positions.emplace_back(static_cast<float>(i % Side), static_cast<float>(i / Side), 0.0F);
  }
  for (std::uint32_t i = 0; i + Side < Side * Side; ++i) {
    if (i % Side + 1 < Side) mesh.add_face(std::array{i, i + 1, i + Side + 1, i + Side}, 0);
  }
  grf::Scene scene;
  scene.contents.blocks.push_back({grf::Shared<grf::Mesh>(std::move(mesh)), {}, {}});
  grf::Diagnostics diagnostics;
  const auto compiled = transport::compile(scene, diagnostics);
  const std::size_t triangles = compiled->triangle_count();
  EXPECT_EQ(triangles, 2U * (Side - 1) * (Side - 1));
  // Indices and surface; a position and a normal per two triangles.
  EXPECT_LT(static_cast<double>(compiled->bytes()) / static_cast<double>(triangles), 28.2);
}

}  // namespace
