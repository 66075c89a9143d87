#include "renderer/plan/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "renderer/reflectance/merl_table.h"
#include "tests/plan/plan_scenes.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

namespace {

using image::Image;
using test::depth;
using test::Effect;
using test::Floor;
using test::Lamp;
using test::OutOfView;
using test::Place;
using test::PlannedRender;
using test::PlannedScene;
using test::wall;

/// Behind the eye, facing the same way as the eye.
const std::string BehindEye = "(-9,-9,9)(-9,9,9)(9,9,9)(9,-9,9)";
/// An existing file that the scene can name, without measurements.
const std::string Data = "\"" GRANADA_SOURCE_DIR "/CMakeLists.txt\"";
const std::string LampBehindWall = "light begin rgb (2,3,4) (-1,-1,-1) (0,2,0) (2,0,0) end\n";

const std::string MeshLamp =
    "mesh light begin begin vertexs (-1,2,0.5)(1,2,0.5)(1,2,2.5)(-1,2,2.5) end vertexs begin faces (0,1,2,3) "
    "end faces end ";

std::string cube(const std::string& attributes) {
  return "begin mesh " + attributes +
         " begin vertexs (-0.5,-0.5,-0.5)(0.5,-0.5,-0.5)(0.5,0.5,-0.5)(-0.5,0.5,-0.5)(-0.5,-0.5,0.5)"
         "(0.5,-0.5,0.5)(0.5,0.5,0.5)(-0.5,0.5,0.5) end vertexs begin faces (4,5,6,7)(1,0,3,2)(0,4,7,3)"
         "(5,1,2,6)(7,6,2,3)(0,1,5,4) end faces end mesh\n";
}

std::string rotated(const std::string& mesh) {
  return "transform rotation (0.3,0.7,1.1) translation (0.1,0.2,0.3) begin " + mesh + " end ";
}

std::string upright(const std::string& of_vertex, const std::string& attributes = "brdf diffuse kd=0.5") {
  return "begin mesh " + attributes + " begin vertexs " + of_vertex + "(-1,-1,0)" + of_vertex + "(1,-1,0)" +
         of_vertex + "(1,1,0)" + of_vertex +
         "(-1,1,0) end vertexs begin faces (0,1,2,3) end faces end mesh\n";
}

PlannedRender under_background() {
  PlannedRender setup;
  setup.background = 1;
  return setup;
}
PlannedRender under_environment() {
  PlannedRender setup;
  setup.environment = 1;
  return setup;
}
PlannedRender with_irradiance() {
  PlannedRender setup;
  setup.uses_irradiance = true;
  return setup;
}
PlannedRender with_instances() {
  PlannedRender setup;
  setup.most_copied_triangles = 0;
  return setup;
}
PlannedRender inside() {
  PlannedRender setup;
  setup.eye = transport::Vec3f(0, 0, 0.1F);
  return setup;
}

struct Case {
  const char* name;
  std::string text;
  PlannedRender setup;
  int depth;
  std::vector<std::string> needed;
};

const std::string Sphere = test::sphere("brdf diffuse kd=0.5", 5, false);
const std::string Smooth = test::sphere("brdf diffuse kd=0.5", 5, true);

std::vector<Case> cases() {
  const std::string diffuse = "brdf diffuse kd=0.5";
  const std::string interreflects = "diffuse_interreflection";
  return {
      {"a flat wall under a lamp", wall(diffuse) + Lamp, {}, 1, {"area_lights"}},
      {"a lamp that shines away", wall(diffuse) + LampBehindWall, under_background(), 1, {"background"}},
      {"under a background", wall(diffuse), under_background(), 1, {"background"}},
      {"under an environment", wall(diffuse), under_environment(), 1, {"environment"}},
      {"wall and floor",
       wall(diffuse) + test::quad(diffuse, Floor) + Lamp,
       {},
       5,
       {"area_lights", interreflects}},
      {"glossy wall and floor",
       wall("brdf ward") + test::quad("brdf ward", Floor) + Lamp,
       {},
       5,
       {"area_lights", "glossy_interreflection"}},
      {"a wall that sees another out of view",
       wall(diffuse) + test::quad(diffuse, OutOfView) + Lamp,
       {},
       5,
       {"area_lights", interreflects}},
      {"direct light alone", wall(diffuse) + test::quad(diffuse, Floor) + Lamp, depth(1), 1, {"area_lights"}},
      {"emission alone", wall("brdf ward texture \"a.png\"") + Lamp, depth(0), 0, {}},
      {"black walls",
       wall("brdf diffuse kd=0") + test::quad("rgb (0,0,0) brdf ward", Floor) + Lamp,
       {},
       0,
       {}},
      {"a mirror", wall("brdf specular") + Lamp, {}, 1, {"area_lights", "mirror_reflection"}},
      {"anisotropy", wall("brdf ward sx=0.1 sy=0.4") + Lamp, {}, 1, {"area_lights", "anisotropy"}},
      {"no anisotropy", wall("brdf ward sx=0.2 sy=0.2") + Lamp, {}, 1, {"area_lights"}},
      {"a texture", wall(diffuse + " texture \"a.png\"") + Lamp, {}, 1, {"area_lights", "textures"}},
      {"a texture out of view",
       wall(diffuse) + test::quad(diffuse + " texture \"a.png\"", OutOfView) + Lamp,
       depth(1),
       1,
       {"area_lights"}},
      {"a texture out of view that paths meet",
       wall(diffuse) + test::quad(diffuse + " texture \"a.png\"", OutOfView) + Lamp,
       {},
       5,
       {"area_lights", interreflects, "textures"}},
      {"a texture on black", wall("rgb (0,0,0) texture \"a.png\"") + Lamp, {}, 0, {}},
      {"coloured vertices", upright("rgb (1,0,0) ") + Lamp, {}, 1, {"area_lights", "vertex_colours"}},
      {"white vertices", upright("rgb (1,1,1) ") + Lamp, {}, 1, {"area_lights"}},
      {"normals that bend",
       upright("normal (0.1,0,1) ") + Lamp,
       {},
       5,
       {"area_lights", interreflects, "interpolated_normals"}},
      {"normals that do not bend", upright("normal (0,0,2) ") + Lamp, {}, 1, {"area_lights"}},
      {"measured data", wall("brdf measured " + Data + "") + Lamp, {}, 1, {"area_lights", "measured_data"}},
      {"measured data out of view",
       wall(diffuse) + test::quad("brdf measured " + Data + "", OutOfView) + Lamp,
       depth(1),
       1,
       {"area_lights"}},
      {"irradiance", upright("irad (1,1,1) "), with_irradiance(), 1, {"irradiance"}},
      {"irradiance that is not there", wall(diffuse) + Lamp, with_irradiance(), 1, {"area_lights"}},
      {"irradiance that is not asked for", upright("irad (1,1,1) ") + Lamp, {}, 1, {"area_lights"}},
      {"instances",
       "def ball = " + Sphere + "begin use ball transform translation (0.3,0,0) begin use ball end end " +
           Lamp,
       with_instances(),
       5,
       {"area_lights", interreflects, "instances"}},
      {"a cube", cube(diffuse) + Lamp, {}, 1, {"area_lights"}},
      {"a cube that is turned", rotated(cube(diffuse)) + Lamp, {}, 1, {"area_lights"}},
      {"inside a cube", cube(diffuse), inside(), 5, {interreflects}},
      {"a sphere of flat faces", rotated(Sphere) + Lamp, {}, 1, {"area_lights"}},
      {"a cube on a floor",
       cube(diffuse) + test::quad(diffuse, Floor) + Lamp,
       {},
       5,
       {"area_lights", interreflects}},
      {"what is behind the wall and out of view",
       wall("brdf ward") + test::quad(diffuse, "(-1,-9,-1)(1,-9,-1)(1,-9,-3)(-1,-9,-3)") + Lamp,
       {},
       1,
       {"area_lights"}},
      {"nothing in view", test::quad(diffuse, BehindEye), under_background(), 0, {"background"}},
      {"a face that emits", wall("light rgb (1,1,1)"), {}, 0, {"area_lights"}},
      {"a face that emits to its other side",
       test::quad("light rgb (1,1,1)", "(-1,1,0)(1,1,0)(1,-1,0)(-1,-1,0)"),
       {},
       0,
       {}},
      {"a wall that lets light pass",
       wall(diffuse + " opacity 0.5") + Lamp,
       {},
       1,
       {"area_lights", "opacity"}},
      {"a wall that is opaque", wall(diffuse + " opacity 1") + Lamp, {}, 1, {"area_lights"}},
      {"emission through a wall", wall("opacity 0.5") + LampBehindWall, depth(0), 0, {"opacity"}},
      {"a sheet out of view that light passes",
       wall(diffuse) + test::quad("rgb (0,0,0) opacity 0.5", OutOfView) + Lamp,
       {},
       1,
       {"area_lights", "opacity"}},
      {"a sheet out of view that nobody needs",
       wall("rgb (0,0,0)") + test::quad("rgb (0,0,0) opacity 0.5", OutOfView) + Lamp,
       {},
       0,
       {}},
      {"a cube that light gets into",
       cube(diffuse + " opacity 0.5") + Lamp,
       {},
       5,
       {"area_lights", interreflects, "opacity"}},
      {"under a mesh light", wall(diffuse) + MeshLamp, {}, 1, {"area_lights"}},
  };
}

TEST(Plan, NeedsWhatCanMatter) {
  for (const Case& one : cases()) {
    const PlannedScene scene(one.text, one.setup);
    EXPECT_EQ(scene.plan().depth, one.depth) << one.name << ": " << scene.plan().why_depth;
    EXPECT_EQ(scene.needed(), one.needed) << one.name;
    for (const plan::PlannedEffect& effect : scene.plan().effects) {
      EXPECT_FALSE(effect.why.empty()) << one.name << " " << name_of(effect.effect);
    }
  }
}

// A reflected scene seen by a reflected eye needs the same effects.
TEST(Plan, IsTheSameForAMirroredScene) {
  for (const Case& one : cases()) {
    for (int axis = 0; axis < 3; ++axis) {
      transport::Vec3f scale(1);
      scale[axis] = -1;
      PlannedRender setup = one.setup;
      setup.eye[axis] *= -1;
      const PlannedScene scene(test::placed(one.text, scale, transport::Vec3f(0), transport::Vec3f(0)),
                               setup);
      EXPECT_EQ(scene.plan().depth, one.depth) << one.name << ", axis " << axis;
      EXPECT_EQ(scene.needed(), one.needed) << one.name << ", axis " << axis;
    }
  }
}

TEST(Plan, FramesTheSceneAsCompilingDoes) {
  for (const Case& one : cases()) {
    if (one.text.find(".png") != std::string::npos || one.text.find("CMakeLists") != std::string::npos)
      continue;
    PlannedScene scene(one.text, one.setup);
    EXPECT_EQ(scene.bounds(), scene.compiled().bounds()) << one.name;
  }
}

// A face that no path can hit may name a missing file.
TEST(Plan, LoadsNoFileThatNoPathNeeds) {
  for (const std::string& attributes : {std::string("texture \"missing.png\""), "brdf measured " + Data}) {
    const std::string text = wall("brdf diffuse") + test::quad(attributes, OutOfView) + Lamp;
    EXPECT_EQ(PlannedScene(text, depth(1)).compiled().texture_count(), 0U);
    EXPECT_THROW(PlannedScene(text, depth(2)).compiled(), std::runtime_error);
    EXPECT_THROW(PlannedScene(text, test::full(depth(1))).compiled(), std::runtime_error);
  }
  const std::string text = wall("brdf diffuse") + test::quad("texture \"missing.png\"", OutOfView) + Lamp;
  const PlannedScene scene(text, depth(1));
  ASSERT_EQ(scene.plan().textures.size(), 1U);
  EXPECT_FALSE(scene.plan().textures[0].is_needed);
  EXPECT_EQ(scene.plan().textures[0].why,
            "only on 1 face that no path hits: outside the view, and the depth of 1 allows no second bounce");
}

TEST(Plan, BuildsTablesOfPairsThatPathsMeetAlone) {
  const std::string text = "def unused = brdf ward sx=0.9 begin " + wall("brdf ward pdf cascadecdf") +
                           test::quad("brdf blinn pdf cascadecdf", OutOfView) + Lamp + " end";
  PlannedScene scene(text, depth(1));
  ASSERT_EQ(scene.plan().tables.size(), 2U);
  EXPECT_TRUE(scene.plan().tables[0].is_needed);
  EXPECT_FALSE(scene.plan().tables[1].is_needed);
  EXPECT_FALSE(scene.plan().tables[1].why.empty());
  const auto built = scene.compiled().tables();
  ASSERT_EQ(built.size(), 1U);
  EXPECT_EQ(built[0].brdf, scene.plan().tables[0].brdf);
  EXPECT_EQ(PlannedScene(text, test::full(depth(1))).compiled().tables().size(), 2U);
}

/// Walls and cubes around the centre, few enough that some do not see each other.
std::string random_scene(std::mt19937& random) {
  std::uniform_real_distribution<float> number(-1, 1);
  const std::array attributes = {"brdf diffuse kd=0.7",     "brdf ward",
                                 "brdf specular",           "rgb (0,0,0)",
                                 "brdf ward sx=0.1 sy=0.4", "brdf diffuse kd=0.5 light rgb (1,2,1)"};
  const auto vector = [&](float size) {
    return transport::Vec3f(number(random), number(random), number(random)) * size;
  };
  std::string text;
  const int count = 1 + static_cast<int>(random() % 4);
  for (int i = 0; i < count; ++i) {
    const transport::Vec3f centre = vector(random() % 4 == 0 ? 8 : 1.5F);
    const transport::Vec3f a = vector(1);
    const transport::Vec3f b = vector(1);
    std::string corners;
    for (const transport::Vec3f& p : {centre - a - b, centre + a - b, centre + a + b, centre - a + b}) {
      corners += fmt::format("({},{},{})", p.x, p.y, p.z);
    }
    text += test::quad(attributes[random() % attributes.size()], corners);
    if (random() % 3 != 0) continue;
    const transport::Vec3f turn = vector(3);
    const transport::Vec3f place = vector(2);
    text += fmt::format("transform rotation ({},{},{}) translation ({},{},{}) begin {} end ", turn.x, turn.y,
                        turn.z, place.x, place.y, place.z, cube(attributes[random() % attributes.size()]));
  }
  const transport::Vec3f corner = vector(3);
  return text + fmt::format("light begin rgb (2,3,4) ({},{},{}) (1,0,0) (0,0.3,1) end ", corner.x, corner.y,
                            corner.z);
}

// What a plan leaves out does not contribute: the image is the same, bit for bit. Paths that split would use
// other random numbers where the plan lowers the depth.
TEST(Plan, GivesTheImageOfTheFullRender) {
  int shorter = 0;
  int blacker = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    const std::string text = random_scene(random);
    PlannedRender setup;
    setup.width = setup.height = 12;
    setup.samples = 4;
    setup.split_count = 1;
    setup.depth = 1 + static_cast<int>(random() % 5);
    setup.background = seed % 2 == 0 ? 0.5F : 0.0F;
    setup.seed = seed;
    setup.threads = 1;
    if (seed % 3 == 0) {
      setup.lens_radius = seed % 2 == 0 ? 0.1F : 3.0F;
      setup.focus_distance = seed % 5 == 0 ? 1.0F : 6.0F;
    }
    PlannedScene planned(text, setup);
    PlannedScene whole(text, test::full(setup));
    shorter += planned.plan().depth < setup.depth ? 1 : 0;
    for (const auto& [mesh, surfaces] : *planned.plan().reflecting) blacker += surfaces[0] ? 0 : 1;
    ASSERT_EQ(planned.image().pixels, whole.image().pixels) << seed << "\n" << text;
  }
  EXPECT_GT(shorter, 50);
  EXPECT_GT(blacker, 50);
}

// The same scenes, some of which have a light that rays hit by chance.
TEST(Plan, GivesNaiveTheImageOfTheFullRender) {
  int lit = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    const std::string text = random_scene(random);
    PlannedRender setup;
    setup.integrator = transport::Integrator::Naive;
    setup.width = setup.height = 8;
    setup.samples = 2;
    setup.depth = 1 + static_cast<int>(random() % 3);
    setup.background = seed % 2 == 0 ? 0.5F : 0.0F;
    setup.seed = seed;
    setup.threads = 1;
    const Image planned = PlannedScene(text, setup).image();
    ASSERT_EQ(planned.pixels, PlannedScene(text, test::full(setup)).image().pixels) << seed << "\n" << text;
    lit += std::ranges::any_of(planned.pixels, [](const auto& pixel) { return pixel.y > 0; }) ? 1 : 0;
  }
  EXPECT_GT(lit, 50);
}

TEST(Plan, GivesTheFullImageOfItsCases) {
  for (const Case& one : cases()) {
    if (one.text.find(".png") != std::string::npos || one.text.find("CMakeLists") != std::string::npos)
      continue;
    PlannedRender setup = one.setup;
    setup.width = setup.height = 12;
    setup.samples = 8;
    setup.split_count = 1;
    const Image planned = PlannedScene(one.text, setup).image();
    const Image whole = PlannedScene(one.text, test::full(setup)).image();
    // Without vertex normals equal to the face's, and without invisible lights, random numbers or rounding
    // differ; white that is interpolated is rounded.
    const std::string name = one.name;
    const double most = name.starts_with("normals") ? 1e-4 : name == "white vertices" ? 1e-6 : 0;
    for (std::size_t i = 0; i < planned.pixels.size(); ++i) {
      ASSERT_LE((planned.pixels[i] - whole.pixels[i]).length(), most) << one.name << " " << i;
    }
  }
}

double largest_difference(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max<double>(largest, (a.pixels[i] - b.pixels[i]).length());
  }
  return largest;
}

std::string add_dark_texture(const test::TemporaryFolder& folder) {
  const std::array<float, 3> grey = {0.25F, 0.25F, 0.25F};
  std::string bytes(sizeof grey, '\0');
  std::memcpy(bytes.data(), grey.data(), sizeof grey);
  return folder.add("dark.pfm", "PF\n1 1\n-1.0\n" + bytes);
}

/// Adds measurements that are brighter than the diffuse BRDF in their place.
std::string add_measurements(const test::TemporaryFolder& folder) {
  const reflectance::MerlTable table(
      [](const transport::Vec3f&, const transport::Vec3f&) { return transport::Rgb(0.3F, 0.2F, 0.1F); });
  std::string path = folder.path("measured.binary");
  grf::Diagnostics diagnostics;
  if (!table.write(path, diagnostics)) throw std::runtime_error(diagnostics.to_text());
  return path;
}

struct Switch {
  Effect effect;
  std::string text;
  PlannedRender setup;
};

// Each name has an effect, and only removes: what is switched off is not needed.
TEST(Plan, LeavesOutWhatIsSwitchedOff) {
  const std::string diffuse = "brdf diffuse kd=0.8";
  const std::string room = wall(diffuse) + test::quad(diffuse, Floor) + Lamp;
  const test::TemporaryFolder folder;
  const std::string dark = "brdf diffuse kd=0.5 texture \"" + add_dark_texture(folder) + "\"";
  const std::string measured = "brdf measured \"" + add_measurements(folder) + "\"";
  const std::vector<Switch> switches = {
      {Effect::Textures, wall(dark) + Lamp, {}},
      {Effect::MeasuredData, wall(measured) + Lamp, {}},
      {Effect::AreaLights, wall(diffuse) + Lamp, {}},
      {Effect::Environment, wall(diffuse), under_environment()},
      {Effect::Background, wall(diffuse), under_background()},
      {Effect::DiffuseInterreflection, room, {}},
      {Effect::GlossyInterreflection, wall("brdf ward") + test::quad("brdf ward", Floor) + Lamp, {}},
      {Effect::MirrorReflection, wall("brdf specular"), under_background()},
      {Effect::Anisotropy, rotated(cube("brdf ward sx=0.05 sy=0.5 ks=0.9")) + Lamp, {}},
      {Effect::VertexColours, upright("rgb (1,0,0) ") + Lamp, {}},
      {Effect::InterpolatedNormals, Smooth + Lamp, {}},
      {Effect::Irradiance, upright("irad (1,1,1) ") + Lamp, with_irradiance()}};
  for (const Switch& one : switches) {
    PlannedRender setup = one.setup;
    setup.samples = 64;
    PlannedScene with(one.text, setup);
    PlannedScene without(one.text, test::without(setup, one.effect));
    EXPECT_TRUE(with.plan()[one.effect].is_needed) << name_of(one.effect);
    EXPECT_FALSE(without.plan()[one.effect].is_needed) << name_of(one.effect);
    EXPECT_GT(largest_difference(with.image(), without.image()), 0.02) << name_of(one.effect);
  }
}

TEST(Plan, HasCopiesInPlaceOfInstances) {
  const std::string text = "def ball = " + Sphere +
                           "begin use ball transform translation (0.3,0,0) begin use ball end end " + Lamp;
  PlannedScene with(text, with_instances());
  PlannedScene without(text, test::without(with_instances(), Effect::Instances));
  EXPECT_EQ(with.compiled().instance_count(), 2U);
  EXPECT_EQ(without.compiled().instance_count(), 0U);
  EXPECT_LT(largest_difference(with.image(), without.image()), 0.2);
}

TEST(Plan, TakesDirectLightAloneAsDepthOne) {
  const std::string room = wall("brdf diffuse kd=0.8") + test::quad("brdf ward", Floor) + Lamp;
  PlannedRender direct;
  direct.effects = transport::effects_named(std::vector<std::string_view>{"direct"});
  EXPECT_EQ(PlannedScene(room, direct).plan().depth, 1);
  EXPECT_EQ(PlannedScene(room, direct).image().pixels, PlannedScene(room, depth(1)).image().pixels);
}

}  // namespace
