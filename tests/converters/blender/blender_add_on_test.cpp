// GRF -> Blender -> GRF by the add-on, compared face by face in world space; and what was changed in Blender.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/world_meshes.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/write.h"
#include "tests/support/paths.h"
#include "tests/support/run.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const std::string Blender = "/usr/bin/blender";
const std::string Cornell = "cornell_box/cornell_box.grf";

/// The largest difference of a number, in units of the largest of the scene.
constexpr double Precision = 1e-6;

std::optional<grf::Scene> read_flat(const std::string& path) {
  grf::Diagnostics diagnostics;
  auto scene = grf::read(path, diagnostics);
  EXPECT_TRUE(scene.has_value()) << diagnostics.to_text();
  if (!scene) return std::nullopt;
  return grf::flatten(*scene, path);
}

std::string colour_text(const std::optional<grf::Colour>& colour) {
  return colour ? fmt::format("{} {} {}", colour->x, colour->y, colour->z) : "none";
}

/// What a face is made of, without the names of definitions. An absent radiance of a light is 1.
std::string surface_text(const WorldSurface& surface, const fs::path& folder) {
  std::string text = "rgb " + colour_text(surface.colour) + " light " + colour_text(surface.emission);
  if (surface.brdf) text += " brdf " + grf::to_text(*surface.brdf);
  for (const grf::BrdfModel* term : surface.terms) text += " of " + (term ? grf::to_text(*term) : "none");
  if (surface.pdf) text += " pdf " + grf::to_text(*surface.pdf);
  if (surface.texture) text += " texture " + (folder / surface.texture->file).lexically_normal().string();
  return text + ' ' + grf::to_text(surface.opacity);
}

/// A scene, and the folder that names of its files are relative to.
struct Located {
  explicit Located(const std::string& path)
      : scene(read_flat(path).value_or(grf::Scene())),
        meshes(scene),
        folder(fs::absolute(path).parent_path()) {}

  grf::Scene scene;
  WorldMeshes meshes;
  fs::path folder;
};

double extent_of(const Located& located) {
  double extent = 0;
  for (const WorldMesh& mesh : located.meshes.meshes()) {
    for (std::size_t i = 0; i < mesh.mesh().geometry->positions.size(); ++i) {
      const grf::Vec3f p = mesh.position(i);
      extent = std::max({extent, std::abs(double{p.x}), std::abs(double{p.y}), std::abs(double{p.z})});
    }
  }
  return extent;
}

template <class Vector>
bool are_near(const Vector& a, const Vector& b, double tolerance) {
  for (unsigned i = 0; i < Vector::dimensions(); ++i) {
    const auto place = static_cast<int>(i);
    if (!(std::abs(double{a[place]} - double{b[place]}) <= tolerance)) return false;
  }
  return true;
}

template <class Values>
std::string difference_of(const char* name, const Values& a, std::size_t i, const Values& b, std::size_t j) {
  if (a.has(i) != b.has(j)) return fmt::format("one vertex has no {}", name);
  return !a.has(i) || are_near(a[i], b[j], Precision) ? "" : fmt::format("the {} differs", name);
}

/// The first difference of two corners of faces; empty if there is none.
std::string corner_difference(const WorldMesh& a, std::uint32_t i, const WorldMesh& b, std::uint32_t j,
                              double extent) {
  const grf::Geometry& one = *a.mesh().geometry;
  const grf::Geometry& other = *b.mesh().geometry;
  if (!are_near(a.position(i), b.position(j), Precision * extent)) return "the position differs";
  if (one.normals.has(i) != other.normals.has(j)) return "one vertex has no normal";
  if (one.normals.has(i)) {
    const grf::Vec3f n = a.normal(i).normalized();
    if (!are_near(n, b.normal(j).normalized(), Precision)) return "the normal differs";
  }
  const std::string uv = difference_of("texture coordinate", one.uvs, i, other.uvs, j);
  return uv.empty() ? difference_of("colour", one.colours, i, other.colours, j) : uv;
}

std::string mesh_difference(const Located& first, const WorldMesh& a, const Located& second,
                            const WorldMesh& b, double extent) {
  if (a.is_light() != b.is_light()) return "one is a light";
  if (a.mesh().face_count() != b.mesh().face_count()) return "the number of faces differs";
  if (a.mesh().geometry->positions.size() != b.mesh().geometry->positions.size())
    return "the number of vertices differs";
  if (a.mesh().name != b.mesh().name) return "the name differs";
  for (std::size_t i = 0; i < a.mesh().face_count(); ++i) {
    const std::string surface = surface_text(a.surface(i), first.folder);
    const std::string other = surface_text(b.surface(i), second.folder);
    if (surface != other) return fmt::format("face {} has the surface '{}', not '{}'", i, other, surface);
    const auto corners = a.face(i);
    const auto others = b.face(i);
    if (corners.size() != others.size()) return fmt::format("face {} has other corners", i);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::string text = corner_difference(a, corners[k], b, others[k], extent);
      if (!text.empty()) return fmt::format("corner {} of face {}: {}", k, i, text);
    }
  }
  return "";
}

std::size_t count_uses(const grf::BlockList& list) {
  std::size_t count = 0;
  for (const grf::Block& block : list.blocks) {
    if (std::holds_alternative<grf::Use>(block.content)) ++count;
    if (const auto* transform = std::get_if<grf::Transform>(&block.content))
      count += count_uses(transform->body);
    if (const auto* scope = std::get_if<grf::DefinitionScope>(&block.content))
      count += count_uses(scope->body);
  }
  return count;
}

/// The first difference of two scenes in world space: meshes, faces, surfaces and instances, in order.
std::string difference(const std::string& path, const std::string& other_path) {
  const Located a(path);
  const Located b(other_path);
  if (a.meshes.meshes().size() != b.meshes.meshes().size())
    return fmt::format("{} meshes, not {}", b.meshes.meshes().size(), a.meshes.meshes().size());
  if (count_uses(a.scene.contents) != count_uses(b.scene.contents)) return "the number of instances differs";
  const double extent = extent_of(a);
  for (std::size_t i = 0; i < a.meshes.meshes().size(); ++i) {
    const std::string text = mesh_difference(a, a.meshes.meshes()[i], b, b.meshes.meshes()[i], extent);
    if (!text.empty()) return fmt::format("mesh {} '{}': {}", i, a.meshes.meshes()[i].name(), text);
  }
  return "";
}

std::string contents(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

class BlenderAddOn : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(Blender)) GTEST_SKIP() << "Blender is not installed";
  }

  /// Opens a scene in Blender, makes changes, and writes it; returns what Blender says.
  test::Outcome run(const std::string& source, const std::string& target,
                    const std::vector<std::string>& changes = {},
                    const std::string& program = GRANADA_BIN_DIR "/grfconvert") const {
    std::vector<std::string> command = {Blender,
                                        "--background",
                                        "--factory-startup",
                                        "--python",
                                        GRANADA_SOURCE_DIR "/tests/converters/blender/run_add_on.py",
                                        "--",
                                        GRANADA_SOURCE_DIR "/converters/blender",
                                        program,
                                        source,
                                        target};
    command.insert(command.end(), changes.begin(), changes.end());
    return test::run(command);
  }

  std::string converted(const std::string& source, const std::vector<std::string>& changes = {},
                        const std::string& name = "out.grf") const {
    const test::Outcome outcome = run(source, folder_.path(name), changes);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("the add-on was run"));
    return folder_.path(name);
  }

  static std::string sample(const std::string& name) { return test::samples_folder() / name; }

  void expect_kept(const std::string& name) const {
    SCOPED_TRACE(name);
    EXPECT_EQ(difference(sample(name), converted(sample(name))), "");
  }

  /// Writes a scene for a test.
  std::string scene_file(const std::string& text) const {
    std::ofstream(folder_.path("scene.grf")) << text;
    return folder_.path("scene.grf");
  }

  test::TemporaryFolder folder_;
};

TEST_F(BlenderAddOn, KeepsTheCornellBox) {
  expect_kept(Cornell);
  EXPECT_THAT(contents(folder_.path("out.grf")),
              HasSubstr("def white = brdf diffuse kd=(0.71325, 0.724, 0.75325)"));
  EXPECT_THAT(contents(folder_.path("out.grf")), HasSubstr("(213, 548.8, 227)"));
}

TEST_F(BlenderAddOn, KeepsInstancesOpacityAndTextures) { expect_kept("leaves/leaves.grf"); }
TEST_F(BlenderAddOn, KeepsTexturesOfAGarden) { expect_kept("garden/garden.grf"); }
TEST_F(BlenderAddOn, KeepsMeshLightsAndNormals) { expect_kept("plaza/plaza.grf"); }
TEST_F(BlenderAddOn, KeepsLayers) { expect_kept("layers/layers.grf"); }
TEST_F(BlenderAddOn, KeepsAnEditedScene) { expect_kept("authored/still_life.grf"); }

const std::string Everything = R"(// All that a scene can have.
def tint = rgb (0.5, 0.75, 1)
def a = brdf phong n=20 ks=0.3 kd=0.2
def b = brdf ward sx=0.1 sy=0.3 ks=0.4
def mixture = brdf combine 0.3 a, 0.7 b
def coated = brdf coat base=mixture ior=1.4
def scheme = pdf adaptive mode=reject
def never = brdf oren s=0.2 r=0.1
def spare = begin mesh brdf a begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) end faces end mesh
def $31$st = begin mesh "first"
  begin vertexs (0, 0, 0) (1, 0, 0) (1, 1, 0) (0, 1, 0) (0.5, 2, 0) end vertexs
  begin faces
    brdf coated pdf scheme rgb tint (0, 1, 2, 4, 3)
    brdf a pdf none light rgb (3, 2, 1) (0, 1, 2)
    light none rgb none brdf b rgb (0.1, 0.2, 0.3) opacity 0.25 (0, 2, 3)
  end faces
end mesh
begin
  use $31$st
  transform rotation (0.3, 0.2, 0.1) scale (1, 2, 3) rotation (1, 2, 3) translation (5, 6, 7) begin
    use $31$st
    transform scale (-1, 1, 1) begin use $31$st use $31$st end
  end
  def a = brdf blinn n=30 ks=0.2
  begin
    begin mesh "hidden name"
      brdf a
      begin vertexs
        normal (0, 0, 1) uv (0.1, 0.7) rgb (0.5, 0.25, 0.125) (0, 0, 0)
        normal (0.6, 0, 0.8) uv (0.9, 0.3) (1, 0, 0)
        normal (0, 0.6, 0.8) rgb (1, 0, 0) (0, 1, 0)
        (1, 1, 0)
      end vertexs
      begin faces (0, 1, 2) (1, 3, 2) end faces
    end mesh
    begin mesh begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs
      begin faces brdf a (0, 1, 2) (2, 1, 0) brdf b (0, 1, 2) end faces end mesh
  end
  transform scale (2, 3, 4) rotation (0.1, 0.2, 0.3) translation (1, 2, 3) begin
    light begin (0, 4, 0) (1, 0.5, 0) (0, 0, 2) end
    mesh light begin rgb (4, 5, 6) begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) (1, 1, 1) end vertexs
      begin faces (0, 1, 2) rgb (1, 2, 3) (1, 3, 2) end faces end
  end
  params begin dependent view (1, 2, 3) end
end
)";

TEST_F(BlenderAddOn, KeepsAllThatASceneCanHave) {
  const std::string source = scene_file(Everything);
  const std::string out = converted(source);
  EXPECT_EQ(difference(source, out), "");
  const std::string text = contents(out);
  for (const char* kept :
       {"// All that a scene can have.", "def never = brdf oren", "def spare = begin mesh",
        "def coated = brdf coat base=mixture", "def a_2 = brdf", "dependent view (1, 2, 3)",
        "def $31$st = begin mesh \"first\"",
        "transform rotation (0.3, 0.2, 0.1) scale (1, 2, 3) rotation (1, 2, 3) translation (5, 6, 7) "
        "begin"}) {
    EXPECT_THAT(text, HasSubstr(kept));
  }
}

// What the comparison is worth: each fault is found.
TEST_F(BlenderAddOn, FaultsAreFound) {
  const std::string source = scene_file(Everything);
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"swap_axes", "position"},
      {"lose_material_index", "surface"},
      {"lose_texture_coordinates", "texture coordinate"},
      {"turn_normals", "normal"},
      {"move_instances", "position"}};
  for (const auto& [fault, expected] : faults) {
    SCOPED_TRACE(fault);
    EXPECT_THAT(difference(source, converted(source, {fault})), HasSubstr(expected));
  }
}

TEST_F(BlenderAddOn, WritesWhatWasChangedOfAMaterial) {
  const std::string text = contents(converted(sample(Cornell), {"change_material"}));
  EXPECT_THAT(text, HasSubstr("def white = brdf gltf baseColor=(0.25, 0.5, 0.75) roughness=0.25"));
  EXPECT_THAT(text, Not(HasSubstr("0.71325")));
  EXPECT_THAT(text, HasSubstr("def green = brdf diffuse kd=(0.1155, 0.47725, 0.0975)"));
}

TEST_F(BlenderAddOn, WritesTheRadianceOfAChangedLamp) {
  const std::string text = contents(converted(sample(Cornell), {"change_lamp"}));
  EXPECT_THAT(text, HasSubstr("rgb (2, 1.174"));
  EXPECT_THAT(text, HasSubstr("(213, 548.8, 227)"));
  EXPECT_THAT(text, HasSubstr("def white = brdf diffuse kd=(0.71325, 0.724, 0.75325)"));
}

TEST_F(BlenderAddOn, WritesAVertexThatIsBeingEdited) {
  const std::string out = converted(sample(Cornell), {"edit_vertex"});
  EXPECT_THAT(difference(sample(Cornell), out),
              HasSubstr("'floor': corner 1 of face 0: the position differs"));
  EXPECT_THAT(contents(out), HasSubstr("(0, 7, 0)"));
}

TEST_F(BlenderAddOn, WritesTransformsOfObjectsThatWereMoved) {
  EXPECT_THAT(contents(converted(sample(Cornell), {"move_object"})),
              HasSubstr("transform translation (0, 25, 0) begin"));
  EXPECT_EQ(difference(sample(Cornell), converted(sample(Cornell), {"move_back"})), "");
}

TEST_F(BlenderAddOn, WritesNewObjectsAndSharesTheirMeshes) {
  const std::string text = contents(converted(sample(Cornell), {"new_cube"}));
  EXPECT_THAT(text, HasSubstr("def paint = brdf gltf baseColor=(0.5, 0.25, 0.125) metallic=1"));
  EXPECT_THAT(text, HasSubstr("transform translation (1, 3, -2) begin"));
  EXPECT_THAT(text, HasSubstr("transform translation (9, 3, -2) begin"));
  EXPECT_THAT(text, HasSubstr("use Cube"));
  EXPECT_THAT(text, HasSubstr("(1, 1, 1)"));
}

// Cycles gives an area light of 100 W and 2 m2 the radiance 100/(4 2) times its colour; it shines downwards.
TEST_F(BlenderAddOn, WritesAreaLights) {
  const std::string out = converted(sample(Cornell), {"new_lamp"});
  const Located located(out);
  const auto& meshes = located.meshes.meshes();
  const auto lamp = std::find_if(meshes.begin(), meshes.end(), [](const WorldMesh& mesh) {
    return mesh.is_light() && mesh.surface(0).emission &&
           std::abs(mesh.surface(0).emission->x - 12.5F) < 1e-4F;
  });
  ASSERT_NE(lamp, meshes.end()) << contents(out);
  EXPECT_NEAR(lamp->surface(0).emission->z, 12.5 / 4, 1e-4);
  const auto corners = lamp->face(0);
  const grf::Vec3f edge = lamp->position(corners[1]) - lamp->position(corners[0]);
  const grf::Vec3f last = lamp->position(corners[3]) - lamp->position(corners[0]);
  EXPECT_NEAR(edge.cross(last).y, -2, 1e-5);
  EXPECT_NEAR(lamp->position(corners[0]).y, 5, 1e-5);
}

TEST_F(BlenderAddOn, WritesTextThatWasEdited) {
  for (const char* change : {"edit_text", "preview_text"}) {
    const std::string text = contents(converted(sample(Cornell), {change}));
    EXPECT_THAT(text, HasSubstr("def white = brdf oren s=0.3 r=0.5"));
    EXPECT_THAT(text, Not(HasSubstr("0.71325")));
  }
}

TEST_F(BlenderAddOn, KeepsOptionsAndCamera) {
  const std::string source = sample("cornell_box/cornell_box.op");
  converted(source, {}, "out.op");
  const std::string text = contents(folder_.path("out.op"));
  for (const char* line : {"BPT_Scene out.grf\n", "BPT_Viewer            278 273 -800\n",
                           "BPT_VLook             278 273 0\n", "BPT_FieldOfView       39.3076\n",
                           "BPT_Image_Resolution  512 512\n", "BPT_Samples           256\n"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
  EXPECT_EQ(difference(sample(Cornell), folder_.path("out.grf")), "");
  converted(source, {"move_camera"}, "moved.op");
  const std::string moved = contents(folder_.path("moved.op"));
  EXPECT_THAT(moved, HasSubstr("BPT_Viewer 278 373 -800\n"));
  EXPECT_THAT(moved, HasSubstr("BPT_FieldOfView       39.3076\n"));
}

TEST_F(BlenderAddOn, WritesImagesThatHaveNoFile) {
  const std::string text = contents(converted(sample(Cornell), {"textured_plane"}));
  EXPECT_THAT(text, HasSubstr("def poster = brdf gltf baseColor=(0.5, 0.75, 1)\n"));
  EXPECT_THAT(text, HasSubstr("texture \"drawn.png\""));
  EXPECT_THAT(text, HasSubstr("opacity mask 0.25"));
  EXPECT_THAT(text, HasSubstr("uv (1, 0) (1, 0, 1)"));
  EXPECT_TRUE(fs::exists(folder_.path("drawn.png")));
}

// Blender's own matrices say where the vertices are.
TEST_F(BlenderAddOn, WritesMatricesThatShear) {
  for (const char* change : {"sheared_cube", "loose_matrix"}) {
    SCOPED_TRACE(change);
    const std::string out = converted(sample(Cornell), {change});
    const Located located(out);
    const auto& meshes = located.meshes.meshes();
    const auto cube = std::find_if(meshes.begin(), meshes.end(),
                                   [](const WorldMesh& mesh) { return mesh.name() == "sheared cube"; });
    ASSERT_NE(cube, meshes.end());
    std::ifstream positions(out + ".positions");
    for (std::size_t i = 0; i < 8; ++i) {
      grf::Vec3f expected(0);
      positions >> expected.x >> expected.y >> expected.z;
      ASSERT_TRUE(positions);
      EXPECT_TRUE(are_near(cube->position(i), expected, 5e-5)) << i << ": " << cube->position(i) << expected;
    }
  }
}

TEST_F(BlenderAddOn, WritesModifiersAndTexts) {
  const Located located(converted(sample(Cornell), {"new_curve_and_modifier"}));
  std::size_t found = 0;
  for (const WorldMesh& mesh : located.meshes.meshes()) {
    if (mesh.name() == "doubled") found += mesh.mesh().face_count() == 2 ? 1 : 0;
    if (mesh.name() == "text") found += mesh.mesh().face_count() > 0 ? 1 : 0;
  }
  EXPECT_EQ(found, 2);
}

TEST_F(BlenderAddOn, SaysWhichLampsAreLost) {
  const test::Outcome outcome = run(sample(Cornell), folder_.path("out.grf"), {"new_lamps"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("2 lamps that are no area lights were not written"));
  const Located located(folder_.path("out.grf"));
  const WorldMesh& lamp = located.meshes.meshes().back();
  EXPECT_TRUE(lamp.is_light());
  EXPECT_EQ(lamp.face(0).size(), 64);
  EXPECT_NEAR(lamp.surface(0).emission->x, 10 / (4 * 1.5708), 1e-4);
}

TEST_F(BlenderAddOn, SaysThatIrradianceIsLost) {
  const std::string room = sample("baked_room/room.igrf");
  const test::Outcome outcome = run(room, folder_.path("out.grf"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("lost their irradiance"));
  EXPECT_EQ(difference(room, folder_.path("out.grf")), "");
}

TEST_F(BlenderAddOn, KeepsAllThroughABlendFileAndEditMode) {
  const std::string source = scene_file(Everything);
  EXPECT_EQ(difference(source, converted(source, {"save_and_load"})), "");
  EXPECT_EQ(difference(source, converted(source, {"stay_in_edit_mode"})), "");
}

TEST_F(BlenderAddOn, ComputesNormalsOnlyWhereAMeshWasEdited) {
  const std::string source = sample("plaza/plaza.grf");
  const Located before(source);
  const Located after(converted(source, {"pull_vertex_of_knot"}));
  const grf::Geometry& one = *before.meshes.meshes()[0].mesh().geometry;
  const grf::Geometry& other = *after.meshes.meshes()[0].mesh().geometry;
  ASSERT_GE(other.positions.size(), one.positions.size());
  EXPECT_NE(one.positions[0], other.positions[0]);
  EXPECT_NE(one.normals[0], other.normals[0]);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < one.positions.size(); ++i)
    changed += one.normals[i] == other.normals[i] ? 0 : 1;
  EXPECT_LT(changed, 20);
}

TEST_F(BlenderAddOn, DropsFacesThatHaveAVertexTwice) {
  const test::Outcome outcome =
      run(scene_file("begin mesh brdf diffuse begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs "
                     "begin faces (0, 1, 2) (0, 1, 0) end faces end mesh"),
          folder_.path("out.grf"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("1 faces that have a vertex twice were dropped"));
}

TEST_F(BlenderAddOn, SaysThatNoConverterWasFound) {
  const test::Outcome outcome =
      test::run({"/usr/bin/env", "PATH=/nowhere", Blender, "--background", "--factory-startup", "--python",
                 GRANADA_SOURCE_DIR "/tests/converters/blender/run_add_on.py", "--",
                 GRANADA_SOURCE_DIR "/converters/blender", "PATH", sample(Cornell), folder_.path("out.grf")});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("grfconvert was not found on PATH"));
}

TEST_F(BlenderAddOn, SaysThatThereIsNoConverter) {
  const test::Outcome outcome = run(sample(Cornell), folder_.path("out.grf"), {}, "/nowhere/grfconvert");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("grfconvert is not at '/nowhere/grfconvert'"));
  EXPECT_FALSE(fs::exists(folder_.path("out.grf")));
}

TEST_F(BlenderAddOn, ShowsMessagesOfTheConverter) {
  const test::Outcome outcome = run(scene_file("begin mesh brdf\n"), folder_.path("out.grf"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("scene.grf:1:16: error"));
}

}  // namespace
}  // namespace convert
