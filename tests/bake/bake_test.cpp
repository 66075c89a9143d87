// Irradiance at vertices against known values.
#include "renderer/bake/bake.h"

#include <array>
#include <cmath>
#include <numbers>
#include <thread>

#include <gtest/gtest.h>

#include "grf/write.h"
#include "renderer/bake/checkpoint.h"
#include "renderer/bake/hemisphere_cells.h"
#include "tests/bake/bake_helpers.h"
#include "tests/support/temporary_folder.h"

namespace {

using bake::Bake;
using bake::BakeSettings;
using bake::HemisphereCells;
using Imath::V3d;
using std::numbers::pi;
using test::bake_settings;
using test::BakeScene;
using test::irradiance_of_polygon;
using transport::Rgb;
using transport::Vec3f;

const std::string Floor = test::quad("brdf diffuse kd=0.5", "(0,0,0) (1,0,0) (1,1,0) (0,1,0)");

TEST(Bake, IsPiUnderAWhiteSky) {
  const BakeScene scene(Floor);
  BakeSettings settings = bake_settings(100, 1);
  settings.integrator.background = Rgb(1, 2, 0.5F);
  Bake bake(scene.compiled, scene.points, settings);
  bake.run();
  ASSERT_EQ(bake.value_count(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(bake.irradiance(i)[k], pi * settings.integrator.background[k], 1e-5);
    }
  }
  EXPECT_LT(*bake.estimated_error(), 1e-6);
}

// The sheet covers nearly all of the sky.
TEST(Bake, CountsTheLightThatFacesLetPass) {
  const BakeScene scene(Floor + test::quad("rgb (0,0,0) brdf diffuse opacity 0.25",
                                           "(-999,-999,1) (999,-999,1) (999,999,1) (-999,999,1)"));
  BakeSettings settings = bake_settings(4096, 2);
  settings.integrator.background = Rgb(1);
  Bake bake(scene.compiled, scene.points, settings);
  bake.run();
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(bake.irradiance(i).x, 0.75 * pi, 0.03 * pi);
}

// With many bounces, a path sums the geometric series of the walls: pi L (1 + kd + kd^2 + ...).
TEST(Bake, IsPiTimesTheRadianceInAClosedBox) {
  const BakeScene scene(test::room("brdf diffuse kd=0.5 light rgb (0.5,0.5,0.5)", 1));
  Bake bake(scene.compiled, scene.points, bake_settings(2048, 40));
  bake.run();
  for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
    EXPECT_NEAR(bake.irradiance(i).x, pi, 0.03 * pi) << "vertex " << i;
  }
  EXPECT_LT(*bake.estimated_error(), 0.02);
}

TEST(Bake, IsThatOfAParallelogramByLambertsFormula) {
  const std::string light = "light begin rgb (3,3,3) (0.2,0.1,1.5) (0.3,0.9,0.2) (1.2,-0.1,0.1) end\n";
  const std::array<V3d, 4> corners = {V3d(0.2, 0.1, 1.5), V3d(0.5, 1.0, 1.7), V3d(1.7, 0.9, 1.8),
                                      V3d(1.4, 0.0, 1.6)};
  for (const int directions : {0, 7}) {
    const BakeScene scene(Floor + light);
    BakeSettings settings = bake_settings(4096, 1);
    settings.directions = directions;
    Bake bake(scene.compiled, scene.points, settings);
    bake.run();
    const V3d places[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
      const double expected = 3 * irradiance_of_polygon(places[i], V3d(0, 0, 1), corners);
      // The point is a thousandth of the way off the vertex.
      EXPECT_NEAR(bake.irradiance(i).x, expected, 3e-3 * expected) << "vertex " << i;
    }
  }
}

// The back of the floor, and a floor under a lid, are dark.
TEST(Bake, IsOfTheFrontAlone) {
  const BakeScene back(test::quad("brdf diffuse", "(0,0,0) (0,1,0) (1,1,0) (1,0,0)") +
                       "light begin (0,0,1) (0,1,0) (1,0,0) end\n");
  Bake bake(back.compiled, back.points, bake_settings(64, 3));
  bake.run();
  for (const Rgb& value : test::values_of(bake)) EXPECT_EQ(value, Rgb(0));

  const BakeScene closed(test::room("brdf diffuse kd=0.9", 3));
  BakeSettings settings = bake_settings(256, 10);
  settings.integrator.background = Rgb(1000);
  Bake inside(closed.compiled, closed.points, settings);
  inside.run();
  for (const Rgb& value : test::values_of(inside)) EXPECT_EQ(value, Rgb(0));
}

// On a smooth sphere vertex normals count: without a terminator, the whole sky on one side is visible.
TEST(Bake, SeesAllOfTheSkyFromASmoothSphere) {
  const BakeScene scene(test::sphere("brdf diffuse", 8, true));
  BakeSettings settings = bake_settings(512, 1);
  settings.integrator.background = Rgb(1);
  Bake bake(scene.compiled, scene.points, settings);
  bake.run();
  for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
    if (!bake.has_value(i)) continue;
    EXPECT_NEAR(bake.irradiance(i).x, pi, 0.01 * pi) << "vertex " << i;
  }
}

/// A closed block whose bottom is at this height.
std::string block(double bottom, double half_width, double height) {
  std::string vertices;
  for (const double z : {bottom, bottom + height}) {
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
      vertices += fmt::format("({},{},{}) ", x * half_width, y * half_width, z);
    }
  }
  return "begin mesh brdf diffuse kd=0.5 begin vertexs " + vertices +
         "end vertexs begin faces (3,2,1,0) (4,5,6,7) (0,1,5,4) (1,2,6,5) (2,3,7,6) (3,0,4,7) end faces end "
         "mesh\n";
}

/// A floor of 4 x 4 squares, from -2 to 2.
std::string floor_of_squares() {
  std::string text = "begin mesh brdf diffuse kd=0.5 begin vertexs\n";
  for (int i = 0; i < 25; ++i) text += fmt::format("({},{},0)\n", i % 5 - 2, i / 5 - 2);
  text += "end vertexs begin faces\n";
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) {
      text += fmt::format("({},{},{},{})\n", 5 * i + k, 5 * i + k + 1, 5 * i + k + 6, 5 * i + k + 5);
    }
  }
  return text + "end faces end mesh\n";
}

/// The irradiance at the floor's centre under a white sky.
double in_the_middle(const std::string& above) {
  const BakeScene scene(floor_of_squares() + above);
  BakeSettings settings = bake_settings(256, 1);
  settings.integrator.background = Rgb(1);
  Bake bake(scene.compiled, scene.points, settings);
  bake.run();
  return bake.irradiance(12).x;
}

// The faces around the floor's centre extend beyond the block: there they must be as bright as the floor
// beside it, where more than half of the sky is visible.
TEST(Bake, IsNotDarkInAFloorUnderWhatStandsOnIt) {
  for (const double bottom : {0.0, -0.1, 1e-5}) {
    const double shown = in_the_middle(block(bottom, 0.4, 2));
    EXPECT_GT(shown, 0.5 * pi) << "bottom at " << bottom;
    EXPECT_LT(shown, 0.9 * pi) << "bottom at " << bottom;
  }
  EXPECT_NEAR(in_the_middle(""), pi, 1e-4);
}

// An object in the air casts a shadow, and a fully covered floor is dark.
TEST(Bake, IsDarkUnderWhatHangsOrCoversAll) {
  EXPECT_LT(in_the_middle(block(0.1, 0.9, 1)), 0.1 * pi);
  const std::string sheet =
      test::quad("brdf diffuse", "(-0.9,-0.9,0.1) (0.9,-0.9,0.1) (0.9,0.9,0.1) (-0.9,0.9,0.1)");
  EXPECT_LT(in_the_middle(sheet), 0.1 * pi);
  EXPECT_EQ(in_the_middle(block(0, 3, 1)), 0);
}

TEST(Bake, ListsAddUpToTheSingleValue) {
  const BakeScene scene(test::room("brdf diffuse kd=0.7", 2) +
                        "light begin rgb (5,4,3) (0.3,0.99,0.3) (0.4,0,0) (0,0,0.4) end\n");
  BakeSettings settings = bake_settings(200);
  Bake single(scene.compiled, scene.points, settings);
  single.run();
  for (const int directions : {1, 6, 33}) {
    settings.directions = directions;
    Bake list(scene.compiled, scene.points, settings);
    list.run();
    for (std::size_t i = 0; i < list.vertex_count(); ++i) {
      Rgb sum(0);
      for (int k = 0; k < directions; ++k) sum += list.irradiance(i, k);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(sum[k], single.irradiance(i)[k], 1e-5F * single.irradiance(i)[k]);
      EXPECT_EQ(list.directions(i).size(), static_cast<std::size_t>(directions));
    }
  }
}

// With directions, nearly all irradiance of a small bright light is in the cell around it.
TEST(Bake, ListsSayWhereLightComesFrom) {
  const BakeScene scene(test::quad("brdf diffuse", "(0,0,0) (0,0,-1) (1,0,-1) (1,0,0)") +
                        "light begin rgb (9e6,9e6,9e6) (600,800,0) (0,0,-1) (1,0,0) end\n");
  BakeSettings settings = bake_settings(64, 1);
  settings.directions = 100;
  Bake bake(scene.compiled, scene.points, settings);
  bake.run();
  const auto directions = bake.directions(0);
  for (int k = 0; k < 100; ++k) {
    const float cosine = directions[static_cast<std::size_t>(k)].dot(Vec3f(0.6F, 0.8F, 0));
    if (bake.irradiance(0, k).x > 0.5F * bake.irradiance(0).x) {
      EXPECT_GT(cosine, 0.95F);
    }
    if (cosine < 0.9F) {
      EXPECT_EQ(bake.irradiance(0, k).x, 0);
    }
  }
}

TEST(HemisphereCells, AreOfEqualAreaAboutTheirCentres) {
  for (const int count : {1, 2, 3, 4, 5, 7, 16, 100, 333}) {
    const HemisphereCells cells(count);
    std::vector<int> hits(static_cast<std::size_t>(count));
    constexpr int Side = 1000;
    for (int i = 0; i < Side * Side; ++i) {
      const Vec3f v = reflectance::cosine_direction(
          {(static_cast<float>(i % Side) + 0.5F) / Side, (static_cast<float>(i / Side) + 0.5F) / Side});
      ++hits[static_cast<std::size_t>(cells.cell_of(v))];
    }
    const double expected = double(Side) * Side / count;
    for (int k = 0; k < count; ++k) {
      EXPECT_NEAR(hits[static_cast<std::size_t>(k)], expected, 0.05 * expected) << k << " of " << count;
      EXPECT_EQ(cells.cell_of(cells.centre(k)), k) << "of " << count;
      EXPECT_NEAR(cells.centre(k).length(), 1, 1e-6);
    }
    EXPECT_LT(cells.cell_of(Vec3f(0.6F, 0, -0.8F)), count);
  }
}

const std::string LitRoom = test::room("brdf diffuse kd=0.7", 3) +
                            "light begin rgb (50,50,50) (0.4,0.99,0.4) (0.1,0,0) (0,0,0.1) end\n";

TEST(Bake, IsTheSameOnAnyNumberOfThreads) {
  const BakeScene scene(LitRoom);
  std::vector<std::vector<Rgb>> all;
  for (const int threads : {1, 2, 7}) {
    BakeSettings settings = bake_settings(300);
    settings.threads = threads;
    settings.directions = 4;
    settings.seed = 3;
    Bake bake(scene.compiled, scene.points, settings);
    bake.run();
    all.push_back(test::values_of(bake));
  }
  EXPECT_EQ(all[0], all[1]);
  EXPECT_EQ(all[0], all[2]);
}

TEST(Bake, ReachesTheErrorAndStops) {
  const BakeScene scene(LitRoom);
  BakeSettings settings = bake_settings(transport::RenderSettings::Unlimited);
  settings.target_error = 0.004;
  Bake bake(scene.compiled, scene.points, settings);
  bake.run();
  EXPECT_EQ(bake.end(), transport::RenderEnd::TargetError);
  EXPECT_LE(*bake.estimated_error(), 0.004);
  EXPECT_GT(bake.samples_per_vertex(), 64);
  EXPECT_LT(bake.samples_per_vertex(), 20'000);
}

/// The true error of a bake, as its estimate counts it.
double error_against(const Bake& bake, const Bake& reference) {
  double sum = 0;
  for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
    const double exact = reference.irradiance(i).x / pi;
    const double difference = bake.irradiance(i).x / pi - exact;
    sum += difference * difference / (exact * exact + 0.01);
  }
  return sum / static_cast<double>(bake.vertex_count());
}

// Over many seeds, the mean is unbiased and the error estimate is right on average.
TEST(Bake, PlacesSamplesWithoutBiasAndKnowsItsError) {
  const BakeScene scene(LitRoom);
  BakeSettings settings = bake_settings(1 << 14);
  Bake reference(scene.compiled, scene.points, settings);
  reference.run();
  constexpr int Seeds = 40;
  double mean = 0;
  double squares = 0;
  double estimated = 0;
  double measured = 0;
  for (int seed = 1; seed <= Seeds; ++seed) {
    settings = bake_settings(128);
    settings.seed = static_cast<std::uint32_t>(seed);
    Bake bake(scene.compiled, scene.points, settings);
    bake.run();
    double ratio = 0;
    for (std::size_t i = 0; i < bake.vertex_count(); ++i) {
      ratio += bake.irradiance(i).x / reference.irradiance(i).x / static_cast<double>(bake.vertex_count());
    }
    mean += ratio / Seeds;
    squares += ratio * ratio / Seeds;
    estimated += *bake.estimated_error() * *bake.estimated_error() / Seeds;
    measured += error_against(bake, reference) / Seeds;
  }
  const double deviation = std::sqrt((squares - mean * mean) / (Seeds - 1));
  EXPECT_NEAR(mean, 1, 4 * deviation + 2e-3);
  EXPECT_LT(deviation, 5e-3);
  EXPECT_NEAR(estimated / measured, 1, 0.15);
}

// A hole in a black ceiling, which few samples find: the sample count of a half must not depend on whether it
// has found the hole, or the mean would be too small.
TEST(Bake, LetsNoHalfDecideOverItself) {
  const std::string black = "brdf diffuse kd=0";
  const BakeScene scene(test::quad(black, "(0,0,0) (1,0,0) (1,1,0) (0,1,0)") +
                        test::quad(black, "(-50,-50,1) (-50,50,1) (0.3,50,1) (0.3,-50,1)") +
                        test::quad(black, "(0.7,-50,1) (0.7,50,1) (50,50,1) (50,-50,1)") +
                        test::quad(black, "(0.3,-50,1) (0.3,0.3,1) (0.7,0.3,1) (0.7,-50,1)") +
                        test::quad(black, "(0.3,0.7,1) (0.3,50,1) (0.7,50,1) (0.7,0.7,1)"));
  const std::array hole = {V3d(0.3, 0.3, 1), V3d(0.7, 0.3, 1), V3d(0.7, 0.7, 1), V3d(0.3, 0.7, 1)};
  const double expected = irradiance_of_polygon(V3d(0), V3d(0, 0, 1), hole);
  BakeSettings settings = bake_settings(512, 1);
  settings.integrator.background = Rgb(1);
  constexpr int Seeds = 200;
  double sum = 0;
  double squares = 0;
  for (int seed = 1; seed <= Seeds; ++seed) {
    settings.seed = static_cast<std::uint32_t>(seed);
    Bake bake(scene.compiled, scene.points, settings);
    bake.run();
    double mean = 0;
    for (std::size_t i = 0; i < 4; ++i) mean += bake.irradiance(i).x / 4;
    sum += mean;
    squares += mean * mean;
  }
  const double mean = sum / Seeds;
  const double deviation = std::sqrt((squares / Seeds - mean * mean) / (Seeds - 1));
  EXPECT_LT(deviation, 0.02 * expected);
  EXPECT_NEAR(mean, expected, 4 * deviation);
}

class BakeCheckpoint : public testing::Test {
 protected:
  const transport::Fingerprint ours_{{1}, {2}, {3}};
  const test::TemporaryFolder folder_;
  const std::string path_ = folder_.path("state");
  const BakeScene scene_{LitRoom};

  std::vector<Rgb> resumed(const BakeSettings& settings) const {
    Bake bake(scene_.compiled, scene_.points, settings);
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(resume_from_checkpoint(path_, ours_, bake, diagnostics)) << diagnostics.to_text();
    bake.run();
    return test::values_of(bake);
  }
  void keep(const Bake& bake) const {
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(write_checkpoint(path_, ours_, bake, diagnostics)) << diagnostics.to_text();
  }
  std::string refusal(const transport::Fingerprint& fingerprint, const BakeSettings& settings) const {
    Bake bake(scene_.compiled, scene_.points, settings);
    grf::Diagnostics diagnostics;
    EXPECT_FALSE(resume_from_checkpoint(path_, fingerprint, bake, diagnostics));
    return diagnostics.to_text();
  }
};

// The checkpoint is written while workers continue, and stopped at any moment.
TEST_F(BakeCheckpoint, ResumesToTheSameValues) {
  for (const bool has_target : {false, true}) {
    BakeSettings settings = bake_settings(1500);
    settings.directions = 3;
    if (has_target) settings.target_error = 0.015;
    Bake whole(scene_.compiled, scene_.points, settings);
    whole.run();
    const auto expected = test::values_of(whole);
    for (const int milliseconds : {2, 10, 30}) {
      Bake part(scene_.compiled, scene_.points, settings);
      std::thread worker([&] { part.run(); });
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
      keep(part);
      EXPECT_EQ(resumed(settings), expected);
      part.stop();
      worker.join();
      keep(part);
      EXPECT_EQ(resumed(settings), expected);
    }
  }
}

TEST_F(BakeCheckpoint, GoesOnFromAFinishedOne) {
  for (const int first : {10, 64, 301}) {
    Bake part(scene_.compiled, scene_.points, bake_settings(first));
    part.run();
    keep(part);
    Bake whole(scene_.compiled, scene_.points, bake_settings(700));
    whole.run();
    EXPECT_EQ(resumed(bake_settings(700)), test::values_of(whole));
  }
}

TEST_F(BakeCheckpoint, RefusesWhatBelongsToSomethingElse) {
  Bake bake(scene_.compiled, scene_.points, bake_settings(100));
  bake.run();
  keep(bake);
  const BakeSettings same = bake_settings(100);
  EXPECT_NE(refusal({{1}, {9}, {3}}, same).find("it belongs to a bake of a scene with other contents"),
            std::string::npos);
  EXPECT_NE(refusal({{9}, {2}, {3}}, same).find("a bake with other options"), std::string::npos);
  EXPECT_NE(refusal({{1}, {2}, {9}}, same).find("by another build of bpt"), std::string::npos);
  EXPECT_NE(refusal(ours_, bake_settings(50)).find("it has 100 samples per vertex, more than the 50"),
            std::string::npos);
  BakeSettings list = same;
  list.directions = 2;
  EXPECT_NE(refusal(ours_, list).find("with other options"), std::string::npos);
  std::string bytes = test::bytes_of(path_);
  ++bytes[bytes.size() / 2];
  folder_.add("state", bytes);
  EXPECT_NE(refusal(ours_, same).find("it is damaged"), std::string::npos);
}

/// Writes a baked scene as text, and reads it back.
grf::Scene read_back(const bake::BakedScene& baked) {
  grf::Diagnostics diagnostics;
  auto scene = grf::read_text(grf::to_text(baked.scene), "test.igrf", diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  return std::move(*scene);
}

TEST(BakedScene, SurvivesItsFile) {
  for (const int directions : {0, 5}) {
    const BakeScene scene(LitRoom);
    BakeSettings settings = bake_settings(64);
    settings.directions = directions;
    Bake bake(scene.compiled, scene.points, settings);
    bake.run();
    const bake::BakedScene baked = bake::with_irradiance(scene.scene, bake);
    EXPECT_TRUE(grf::has_irradiance(baked.scene.contents));
    EXPECT_EQ(baked.copies, 0U);
    EXPECT_EQ(read_back(baked), baked.scene);
    EXPECT_FALSE(grf::has_irradiance(scene.scene.contents));
  }
}

// Each placement has its own irradiance, and directions rotate with the mesh.
TEST(BakedScene, KeepsPlacesOfAUsedMeshApart) {
  const std::string text =
      "def tile = begin mesh brdf diffuse begin vertexs (0,0,0) (1,0,0) (1,1,0) (0,1,0) end vertexs\n"
      "begin faces (0,1,2,3) end faces end mesh\n"
      "def tile$2 = rgb (1,1,1) begin\n"
      "use tile\n"
      "transform rotation (1.5707964,0,0) translation (5,0,0) begin use tile end\n"
      "end\n"
      "light begin rgb (1,1,1) (0,0,1) (0,1,0) (1,0,0) end\n";
  const BakeScene scene(text);
  BakeSettings settings = bake_settings(64, 1);
  settings.directions = 1;
  Bake bake(scene.compiled, scene.points, settings);
  bake.run();
  ASSERT_EQ(bake.vertex_count(), 8U);
  const bake::BakedScene baked = bake::with_irradiance(scene.scene, bake);
  EXPECT_EQ(baked.shared_meshes, 1U);
  EXPECT_EQ(baked.copies, 1U);
  const grf::Scene again = read_back(baked);
  std::vector<const grf::Mesh*> meshes;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement&, const grf::Block&) {
    meshes.push_back(&mesh);
  };
  grf::visit(again, visitor);
  ASSERT_EQ(meshes.size(), 2U);
  const auto value = [&](std::size_t mesh) {
    return std::get<std::vector<grf::DirectionalIrradiance>>((*meshes[mesh]->irradiance)[0]).at(0);
  };
  EXPECT_GT(value(0).irradiance.x, 0.4);
  EXPECT_EQ(value(1).irradiance.x, 0);
  for (const std::size_t mesh : {0U, 1U}) EXPECT_NEAR(value(mesh).direction.z, 1, 1e-6);
}

}  // namespace
