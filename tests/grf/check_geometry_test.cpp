// Tests of `check` on geometry: faces, lights, irradiance, and textures.
#include <string>

#include <gtest/gtest.h>

#include "grf/check.h"
#include "tests/grf/check_helpers.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

TEST(CheckOfFaces, WarnsOfThoseWithoutArea) {
  const std::string vertices = "(0, 0, 0) (1, 0, 0) (2, 0, 0) (0, 1, 0)";
  EXPECT_EQ(said_of(mesh(vertices, "(0, 1, 3) (0, 1, 2)")), "warning: face 1 has no area\n");
  EXPECT_EQ(said_of(mesh(vertices, "(0, 1, 2) (0, 1, 3) (1, 1, 3)")),
            "warning: 2 faces, the first is 0, have no area\n");
  EXPECT_EQ(said_of(mesh("(0, 0, 0) (1e-6, 0, 0) (0, 1e-6, 0)", "(0, 1, 2)")), "") << "small is not flat";
  EXPECT_EQ(said_of(mesh("(0, 0, 0) (1, 0, 0) (1, 1e-4, 0)", "(0, 1, 2)")), "") << "nor is narrow";
}

TEST(CheckOfFaces, WarnsOfNormalsBehindThem) {
  const std::string vertices =
      "normal (0, 0, -1) (0, 0, 0) normal (1, 0, -1) (1, 0, 0) normal (0, 0, -2) (1, 1, 0) normal (0, 0, 1) "
      "(0, 1, 0) "
      "(2, 2, 0)";
  EXPECT_EQ(said_of(mesh(vertices, "(0, 1, 2)")),
            "warning: face 0 has normals that point away from the front\n");
  EXPECT_EQ(said_of(mesh(vertices, "(2, 1, 0) (0, 1, 2) (0, 1, 2)")),
            "warning: 2 faces, the first is 1, have normals that point away from the front\n");
  EXPECT_EQ(said_of(mesh(vertices, "(2, 1, 0)")), "") << "turned over";
  EXPECT_EQ(said_of(mesh(vertices, "(0, 1, 2, 3)")), "") << "one normal is in front";
  EXPECT_EQ(said_of(mesh(vertices, "(0, 1, 4)")), "") << "one corner has no normal";
}

const std::string Nothing = "nothing is in front of this light, on the side that emits";

/// Returns whether a light is reported to face nothing, with a triangle in the plane z = 0.
bool faces_nothing(const std::string& light) {
  const std::string said = said_of(triangle("brdf flat") + light);
  EXPECT_TRUE(said.empty() || said == "warning: " + Nothing + "\n") << said;
  return !said.empty();
}

TEST(CheckOfLights, WarnsOfThoseThatFaceNothing) {
  EXPECT_TRUE(faces_nothing("light begin (0, 0, 1) (1, 0, 0) (0, 1, 0) end"));
  EXPECT_FALSE(faces_nothing("light begin (0, 0, 1) (0, 1, 0) (1, 0, 0) end"));
  EXPECT_FALSE(faces_nothing("light begin (0, 0, -1) (1, 0, 0) (0, 1, 0) end"));
  EXPECT_TRUE(faces_nothing("light begin (0, 0, 0) (1, 0, 0) (0, 1, 0) end")) << "in its plane";
  EXPECT_TRUE(faces_nothing(
      "transform translation (0, 0, 9) begin light begin (0, 0, -1) (1, 0, 0) (0, 1, 0) end end"));
  EXPECT_FALSE(
      faces_nothing("transform scale (1, 1, -1) begin light begin (0, 0, -1) (1, 0, 0) (0, 1, 0) end end"))
      << "a mirror image emits from the mirrored side";
  EXPECT_TRUE(
      faces_nothing("transform scale (1, 1, -1) begin light begin (0, 0, -1) (0, 1, 0) (1, 0, 0) end end"));
}

TEST(CheckOfLights, LooksAtEachFaceOfAMeshLight) {
  const auto light = [](const std::string& height, const std::string& list) {
    return "mesh light begin begin vertexs (0, 0, " + height + ") (1, 0, " + height + ") (0, 1, " + height +
           ") end vertexs " + faces(list) + "end ";
  };
  EXPECT_TRUE(faces_nothing(light("1", "(0, 1, 2)")));
  EXPECT_FALSE(faces_nothing(light("1", "(0, 2, 1)")));
  EXPECT_FALSE(faces_nothing(light("1", "(0, 1, 2) (0, 2, 1)"))) << "one of them is enough";
  EXPECT_FALSE(faces_nothing(light("-1", "(0, 1, 2)")));
  EXPECT_FALSE(faces_nothing("transform scale (1, 1, -1) begin " + light("-1", "(0, 1, 2)") + "end"));
  EXPECT_TRUE(faces_nothing("transform scale (1, 1, -1) begin " + light("-1", "(0, 2, 1)") + "end"));
}

TEST(CheckOfLights, SeesMeshesWhereTheyArePlaced) {
  const std::string light = "light begin (0, 0, 1) (1, 0, 0) (0, 1, 0) end ";
  EXPECT_EQ(said_of("transform translation (0, 0, 2) begin " + triangle("brdf flat") + "end " + light), "");
  EXPECT_EQ(said_of("def m = " + triangle("brdf flat") +
                    " begin use m transform translation (0, 0, 2) begin use m end end " + light),
            "");
  EXPECT_EQ(said_of("def m = " + triangle("brdf flat") + " begin use m end " + light),
            "warning: " + Nothing + "\n");
}

TEST(CheckOfLights, WarnsOfThoseWithoutArea) {
  EXPECT_EQ(said_of("light begin (0, 0, 1) (1, 0, 0) (2, 0, 0) end " + triangle("brdf flat")),
            "warning: a light without area\n");
  EXPECT_EQ(said_of("mesh light begin " + Square + faces("") + "end"), "warning: a light without area\n");
}

TEST(CheckOfMeshLights, LetsRadianceBeLargeButNotNegative) {
  const auto light = [](const std::string& attribute, const std::string& list) {
    return "mesh light begin " + attribute + Square + faces(list) + "end " +
           mesh("(0, 0, 1) (1, 0, 1) (0, 1, 1)", "(0, 1, 2)");
  };
  const std::string error = "a radiance of (0, -1, 0), expected components of 0 or more\n";
  EXPECT_EQ(said_of(light("rgb (100, 0, 0) ", "(0, 1, 2) rgb none (0, 1, 2)")), "");
  EXPECT_EQ(said_of(light("rgb (0, -1, 0) ", "(0, 1, 2)")), error);
  EXPECT_EQ(said_of(light("", "rgb (0, -1, 0) (0, 1, 2)")), error);
  EXPECT_EQ(said_of("def c = rgb (9, 9, 9) begin " + light("rgb c ", "(0, 1, 2)") + "end"), "")
      << "a colour over 1 is no mistake there";
}

TEST(CheckOfMeshLights, LooksAtTheirFacesToo) {
  EXPECT_EQ(
      said_of(triangle("brdf flat") + "mesh light begin begin vertexs (0, 0, 1) (1, 0, 1) (0, 1, 1) end " +
              faces("(0, 2, 1) (0, 1, 1)") + "end"),
      "warning: face 1 has no area\n");
}

/// Returns the diagnostics of a text as a file of that name.
std::string said_of_file(const std::string& name, const std::string& text) {
  Diagnostics diagnostics;
  const auto scene = read_text(text, name, diagnostics);
  EXPECT_TRUE(scene && check(*scene, catalogue(), diagnostics));
  std::string messages;
  for (const Diagnostic& entry : diagnostics.entries()) messages += entry.message + "\n";
  return messages;
}

TEST(CheckOfIrradiance, WarnsWhereTheNameOfTheFileOrTheObserverIsMissing) {
  const std::string lit = mesh("irad (1, 1, 1) (0, 0, 0)", "");
  const std::string name = "irradiance makes this an IGRF file: its name should end in '.igrf'\n";
  const std::string observer =
      "irradiance without 'params begin dependent view (..) end', the observer that it is for\n";
  const std::string params = "params begin dependent view (0, 0, 5) end";
  EXPECT_EQ(said_of_file("scene.grf", lit + lit), name + observer);
  EXPECT_EQ(said_of_file("scene.igrf", lit), observer);
  EXPECT_EQ(said_of_file("scene.igrf", lit + "params begin end"), observer) << "nobody observes";
  EXPECT_EQ(said_of_file("scene.grf", lit + params), name);
  EXPECT_EQ(said_of_file("scene.IGRF", params + " " + lit), "");
  EXPECT_EQ(said_of_file("scene.grf", mesh("(0, 0, 0)", "")), "");
  EXPECT_EQ(said_of_file("scene.igrf", mesh("(0, 0, 0)", "")), "") << "an IGRF file may have none";
}

TEST(CheckOfIrradiance, RefusesWhatIsNegative) {
  const std::string message = "an irradiance of (1, -1, 1), expected components of 0 or more\n";
  const auto errors = [](const std::string& vertex) {
    Diagnostics diagnostics;
    const auto scene =
        read_text(mesh(vertex, "") + "params begin dependent view (0, 0, 5) end", "scene.igrf", diagnostics);
    EXPECT_TRUE(scene);
    check(*scene, catalogue(), diagnostics);
    std::string messages;
    for (const Diagnostic& entry : diagnostics.entries()) messages += entry.message + "\n";
    return messages;
  };
  EXPECT_EQ(errors("irad (1, -1, 1) (0, 0, 0)"), message);
  EXPECT_EQ(
      errors("begin list ray (-1, 0, 0) irad (1, 1, 1) ray (1, 0, 0) irad (1, -1, 1) end list (0, 0, 0)"),
      message);
  EXPECT_EQ(errors("begin list ray (-1, 0, 0) irad (1000, 1, 0) end list (0, 0, 0)"), "");
}

TEST(CheckOfTextures, SaysNothingWhereAllIsThere) {
  const test::TemporaryFolder folder;
  folder.add("images/there.png", "an image");
  folder.add("parts/part.grf",
             "begin mesh brdf flat texture \"../images/there.png\" begin vertexs uv (0, 0) (0, 0, 0) "
             "uv (1, 0) (1, 0, 0) uv (1, 1) (1, 1, 0) (0, 1, 0) end " +
                 faces("(0, 1, 2) texture none (0, 2, 3)") + "end");
  const std::string path = folder.add("scene.grf", "include \"parts/part.grf\"");
  Diagnostics diagnostics;
  const auto scene = read(path, diagnostics);
  EXPECT_TRUE(scene && check(*scene, catalogue(), diagnostics));
  EXPECT_EQ(diagnostics.to_text(), "");
}

}  // namespace
}  // namespace grf
