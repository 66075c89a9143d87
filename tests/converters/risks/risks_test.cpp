#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "converters/risks/mesh_risks.h"
#include "converters/risks/risk.h"
#include "grf/read.h"
#include "renderer/reflectance/scheme.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Risk> risks_in(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text, "scene.grf", diagnostics);
  EXPECT_TRUE(scene) << diagnostics.to_text();
  return scene ? risks_of(*scene, reflectance::catalogue()) : std::vector<Risk>();
}

std::vector<RiskKind> kinds_in(const std::string& text) {
  std::vector<RiskKind> kinds;
  for (const Risk& risk : risks_in(text)) kinds.push_back(risk.kind);
  return kinds;
}

std::string vertices(double low, double high) {
  std::string text = "begin vertexs ";
  for (int i = 0; i < 8; ++i) {
    const auto at = [&](int bit) { return std::to_string((i >> bit & 1) != 0 ? high : low); };
    text += "(" + at(0) + ", " + at(1) + ", " + at(2) + ") ";
  }
  return text + "end vertexs ";
}

// The faces of a cube whose corner i is at (bit 0, bit 1, bit 2) of i, counter-clockwise from outside.
const std::string OutwardFaces =
    "(0, 4, 6, 2) (1, 3, 7, 5) (0, 1, 5, 4) (2, 6, 7, 3) (0, 2, 3, 1) (4, 5, 7, 6) ";
const std::string InwardFaces =
    "(2, 6, 4, 0) (5, 7, 3, 1) (4, 5, 1, 0) (3, 7, 6, 2) (1, 3, 2, 0) (6, 7, 5, 4) ";

std::string mesh(const std::string& name, const std::string& vertices, const std::string& faces,
                 const std::string& brdf = "brdf diffuse kd=0.5") {
  return "begin mesh " + (name.empty() ? "" : "\"" + name + "\" ") + brdf + " " + vertices + "begin faces " +
         faces + "end faces end mesh ";
}

std::string cube(const std::string& name = "cube", double low = -1, double high = 1,
                 const std::string& faces = OutwardFaces) {
  return mesh(name, vertices(low, high), faces);
}

// A light of side 0.2 about the origin, facing y.
const std::string Lamp = "light begin rgb (1, 1, 1) (-0.1, 0, -0.1) (0, 0, 0.2) (0.2, 0, 0) end ";

std::string scene(const std::string& blocks, const std::string& definitions = "") {
  return definitions.empty() ? blocks : definitions + " begin " + blocks + " end";
}

TEST(Risks, AreNotFoundInSoundScenes) {
  EXPECT_THAT(kinds_in(scene(cube())), IsEmpty());
  EXPECT_THAT(kinds_in(scene(cube("a", -1, 1) + cube("b", 2, 3))), IsEmpty());
}

TEST(Risks, FindLampsInSolids) {
  const auto risks = risks_in(scene(Lamp + cube()));
  ASSERT_EQ(risks.size(), 1U);
  EXPECT_EQ(risks[0].kind, RiskKind::LampInSolid);
  EXPECT_EQ(risks[0].message, "a lamp is inside the mesh 'cube': it illuminates nothing outside");
  EXPECT_THAT(risks[0].path, ElementsAre(0));
  const std::string far = "transform translation (0, 2, 0) begin " + Lamp + "end ";
  EXPECT_THAT(kinds_in(scene(far + cube())), IsEmpty());
  const std::string on_the_top = "transform translation (0, 1, 0) begin " + Lamp + "end ";
  EXPECT_THAT(kinds_in(scene(on_the_top + cube())), IsEmpty());
}

TEST(Risks, LeaveRoomsWithLampsAlone) {
  EXPECT_THAT(kinds_in(scene(Lamp + cube("room", -1, 1, InwardFaces))), IsEmpty());
  EXPECT_THAT(kinds_in(scene(cube() + cube("room", -9, 9, InwardFaces))), IsEmpty());
  const std::string defined = "def room = " + cube("", -9, 9, InwardFaces);
  EXPECT_THAT(kinds_in(scene(Lamp + "use room ", defined)), IsEmpty());
  EXPECT_THAT(kinds_in(scene("use room ", defined)), ElementsAre(RiskKind::InwardFaces));
}

TEST(Risks, FindEmittingFacesInSolids) {
  const std::string glow = mesh("glow", "begin vertexs (0, 0, 0) (0.1, 0, 0) (0, 0.1, 0) end vertexs ",
                                "light rgb (1, 1, 1) (0, 1, 2) ");
  const auto risks = risks_in(scene(glow + cube()));
  ASSERT_EQ(risks.size(), 1U);
  EXPECT_EQ(risks[0].kind, RiskKind::LampInSolid);
  EXPECT_THAT(risks[0].faces, ElementsAre(0));
}

TEST(Risks, FindInwardFronts) {
  const auto whole = risks_in(scene(cube("cube", -1, 1, InwardFaces)));
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(whole[0].message, "the fronts of the mesh 'cube' point inward");
  EXPECT_EQ(whole[0].share, 1);
  const std::string open_box = "(2, 6, 4, 0) (5, 7, 3, 1) (4, 5, 1, 0) (3, 7, 6, 2) (1, 3, 2, 0) ";
  EXPECT_THAT(kinds_in(scene(cube("box", -1, 1, open_box))), IsEmpty()) << "it may show its inside";
  const std::string one_turned =
      "(0, 4, 6, 2) (1, 3, 7, 5) (0, 1, 5, 4) (2, 6, 7, 3) (0, 2, 3, 1) (6, 7, 5, 4) ";
  const auto one = risks_in(scene(cube("cube", -1, 1, one_turned)));
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].kind, RiskKind::InwardFaces);
  EXPECT_THAT(one[0].faces, ElementsAre(5));
  EXPECT_DOUBLE_EQ(one[0].share, 1.0 / 6);
}

TEST(Risks, FindEnergyGain) {
  const std::string strong = mesh("m", "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs ",
                                  "(0, 1, 2) ", "brdf phong n=10 ks=0.9 kd=0.9");
  const auto risks = risks_in(scene(strong));
  ASSERT_EQ(risks.size(), 1U);
  EXPECT_EQ(risks[0].kind, RiskKind::EnergyGain);
  const std::string definitions = "def a = brdf diffuse kd=0.8 def b = brdf diffuse kd=0.7";
  const auto sum_with = [&](const std::string& colour) {
    return risks_in(scene(mesh("m", "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs ", "(0, 1, 2) ",
                               colour + "brdf combine 1 a 1 b"),
                          definitions));
  };
  ASSERT_EQ(sum_with("").size(), 1U);
  EXPECT_THAT(sum_with("").front().message, HasSubstr("up to 1.5 times"));
  EXPECT_THAT(sum_with("rgb (0.5, 0.5, 0.5) "), IsEmpty());
}

TEST(Risks, FindDuplicates) {
  EXPECT_THAT(kinds_in(scene(cube("a") + cube("b"))), ElementsAre(RiskKind::DuplicateMesh));
  const std::string twice = mesh("m", vertices(-1, 1), OutwardFaces + "(6, 2, 0, 4) ");
  const auto risks = risks_in(scene(twice));
  ASSERT_FALSE(risks.empty());
  EXPECT_EQ(risks.back().kind, RiskKind::DuplicateFaces);
  EXPECT_THAT(risks.back().faces, ElementsAre(6));
  const std::string sheet =
      mesh("m", "begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs ", "(0, 1, 2) (2, 1, 0) ");
  for (const RiskKind kind : kinds_in(scene(sheet))) EXPECT_NE(kind, RiskKind::DuplicateFaces);
}

TEST(Risks, FindNormalsAgainstFaces) {
  const std::string turned = mesh("m",
                                  "begin vertexs normal (0, 0, -1) (0, 0, 0) normal (0, 0, -1) (1, 0, 0) "
                                  "normal (0, 0, -1) (0, 1, 0) end vertexs ",
                                  "(0, 1, 2) ");
  EXPECT_THAT(kinds_in(scene(turned)), ElementsAre(RiskKind::NormalsAgainstFaces));
}

TEST(Risks, FindMeshesFarFromTheMiddle) {
  // A cube of 1 at 10,000 from the middle of a scene of 20,000: by the machine epsilon, 2^-23, its diagonal
  // has sqrt(3) / (10,000 * 2^-23) = 1,453 steps.
  const std::string ground = mesh("ground",
                                  "begin vertexs (-10000, -2, -9) (10000, -2, -9) (10000, -2, 9) "
                                  "(-10000, -2, 9) end vertexs ",
                                  "(0, 3, 2, 1) ");
  const auto at = [](const std::string& x) {
    return "transform translation (" + x + ", 0, 0) begin " + cube("small", 0, 1) + "end ";
  };
  const auto risks = risks_in(scene(ground + at("9999")));
  ASSERT_EQ(risks.size(), 1U);
  EXPECT_EQ(risks[0].kind, RiskKind::FarFromMiddle);
  EXPECT_THAT(risks[0].message, HasSubstr("resolves it to 1/1453"));
  EXPECT_THAT(risks[0].path, ElementsAre(1, 0));
  EXPECT_THAT(kinds_in(scene(ground + at("999"))), IsEmpty());
  EXPECT_THAT(kinds_in(scene(at("10000"))), IsEmpty()) << "the whole scene is moved to the origin";
}

TEST(Risks, FindTextureCoordinatesAndFacesWithoutArea) {
  const std::string flat_uv = mesh("m",
                                   "begin vertexs uv (0.5, 0.5) (0, 0, 0) uv (0.5, 0.5) (1, 0, 0) "
                                   "uv (0.5, 0.5) (0, 1, 0) end vertexs ",
                                   "(0, 1, 2) ", "texture \"wood.png\" brdf diffuse kd=0.5");
  EXPECT_THAT(kinds_in(scene(flat_uv)), ElementsAre(RiskKind::UvWithoutArea));
  const std::string needle =
      mesh("m", "begin vertexs (0, 0, 0) (1, 0, 0) (2, 0, 0) (0, 1, 0) end vertexs ", "(0, 2, 1) (0, 1, 3) ");
  EXPECT_THAT(kinds_in(scene(needle)), ElementsAre(RiskKind::FacesWithoutArea));
}

TEST(Risks, AreRankedByKindAndShare) {
  const std::string needle =
      mesh("m", "begin vertexs (5, 0, 0) (6, 0, 0) (7, 0, 0) (5, 1, 0) end vertexs ", "(0, 2, 1) (0, 1, 3) ");
  EXPECT_THAT(
      kinds_in(scene(needle + cube("turned", -1, 1, InwardFaces) + cube("a", 2, 3) + cube("b", 2, 3))),
      ElementsAre(RiskKind::DuplicateMesh, RiskKind::InwardFaces, RiskKind::FacesWithoutArea));
}

TEST(WindingNumber, IsOneInsideAndZeroOutside) {
  grf::Geometry geometry;
  for (int i = 0; i < 8; ++i) {
    geometry.positions.emplace_back(static_cast<float>(i & 1), static_cast<float>(i >> 1 & 1),
                                    static_cast<float>(i >> 2));
  }
  const std::uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& face : faces) geometry.add_face(face);
  const grf::SharedGeometry cube(geometry);
  EXPECT_NEAR(winding_number(cube, {0.5, 0.5, 0.5}), 1, 1e-12);
  EXPECT_NEAR(winding_number(cube, {0.01, 0.99, 0.5}), 1, 1e-12);
  EXPECT_NEAR(winding_number(cube, {1.5, 0.5, 0.5}), 0, 1e-12);
  grf::Geometry turned = geometry;
  for (std::size_t face = 0; face < 6; ++face) turned.reverse_face(face);
  EXPECT_NEAR(winding_number(turned, {0.5, 0.5, 0.5}), -1, 1e-12);
}

}  // namespace
}  // namespace convert
