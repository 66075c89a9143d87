// The geometry, lamps, instances and views of USD files.
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/image/image_file.h"
#include "tests/converters/usd/exchanged_scene.h"

namespace convert {
namespace {

using grf::Vec3d;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(UsdMeshes, HaveEachFaceInTheSubsetOfItsMaterial) {
  const ExchangedScene scene(exchange_cube(
      "brdf diffuse kd=0.5", {"", "brdf eon kd=0.25", "brdf diffuse kd=0.5", "", "brdf eon kd=0.25"}));
  const test::UsdaPrim& mesh = scene.usd().root.child("cube");
  EXPECT_EQ(mesh.type, "Mesh");
  EXPECT_EQ(mesh.custom.at("name"), "cube");
  EXPECT_THAT(mesh.attribute("faceVertexCounts").numbers, ElementsAre(4, 4, 4, 4, 4, 4));
  EXPECT_EQ(mesh.attribute("points").elements, 8U);
  EXPECT_EQ(mesh.string("subdivisionScheme"), "none");
  EXPECT_EQ(mesh.number("doubleSided"), 1);
  EXPECT_FALSE(mesh.attributes.contains("normals")) << "faces without normals are flat";
  EXPECT_THAT(mesh.child("diffuse").attribute("indices").numbers, ElementsAre(0, 2, 3));
  EXPECT_THAT(mesh.child("eon").attribute("indices").numbers, ElementsAre(1, 4, 5));
  EXPECT_EQ(mesh.child("eon").string("material:binding"), "/World/Looks/eon");
  EXPECT_THAT(mesh.attribute("primvars:displayColor").numbers, testing::SizeIs(18));
  EXPECT_EQ(scene.usd().find("/World/Looks/eon")->custom.at("surface"), "brdf eon kd=0.25");
  EXPECT_THAT(scene.usd_warnings(), testing::IsEmpty());
}

TEST(UsdMeshes, HaveNamesThatAreIdentifiersAndUnique) {
  std::string text;
  for (const char* name : {"a b", "a_b", "1", "\xC3\xA9", "Looks"})
    text += fmt::format(
        "begin mesh \"{}\" begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end end\n", name);
  const ExchangedScene scene(text);
  const test::UsdaPrim& world = scene.usd().root;
  EXPECT_EQ(world.child("a_b").custom.at("name"), "a b");
  EXPECT_EQ(world.child("a_b_2").custom.at("name"), "a_b");
  EXPECT_EQ(world.child("_1").custom.at("name"), "1");
  EXPECT_EQ(world.child("mesh").custom.at("name"), "\xC3\xA9");
  EXPECT_EQ(world.child("Looks_2").custom.at("name"), "Looks");
}

TEST(UsdMeshes, HaveAttributesOfVerticesAndFlatFacesWhereANormalIsAbsent) {
  const ExchangedScene scene(
      "begin mesh brdf diffuse kd=0.5 begin vertexs\n"
      "normal (0, 0, 2) uv (0, 0.25) (0,0,0) normal (0, 0.6, 0.8) uv (1, 0) rgb (0.5, 1, 1) (1,0,0)\n"
      "normal (0, 0, 1) (1,1,0) (0,1,0)\n"
      "end vertexs begin faces (0,1,2) (0,2,3) end faces end mesh");
  const test::UsdaPrim& mesh = scene.usd().root.child("mesh");
  const test::UsdaValue& normals = mesh.attribute("normals");
  EXPECT_EQ(normals.interpolation, "faceVarying");
  ASSERT_EQ(normals.elements, 6U);
  EXPECT_NEAR(normals.numbers[4], 0.6, 1e-6) << "of the second corner";
  EXPECT_NEAR(normals.numbers[2], 1, 1e-6) << "of unit length";
  EXPECT_EQ(normals.numbers[17], 1) << "of the flat face";
  EXPECT_EQ(mesh.attribute("primvars:st").interpolation, "vertex");
  EXPECT_EQ(mesh.attribute("primvars:st").numbers[1], 0.25);
  EXPECT_THAT(mesh.attribute("primvars:vertexColor").numbers,
              ElementsAre(1, 1, 1, 0.5, 1, 1, 1, 1, 1, 1, 1, 1));
  const test::UsdaValue& display = mesh.attribute("primvars:displayColor");
  EXPECT_EQ(display.interpolation, "faceVarying");
  EXPECT_EQ(display.numbers[3], 0.25) << "base times colour";
  EXPECT_EQ(
      scene.usd().find("/World/Looks/diffuse/PreviewSurface")->attribute("inputs:diffuseColor").connection,
      "/World/Looks/diffuse/PreviewColor.outputs:result");
}

TEST(UsdMeshes, HaveTheCornersOfTheirFacesInOrder) {
  const ExchangedScene scene(
      "begin mesh begin vertexs (0,0,0) (2,0,0) (2,3,0) (0,3,0) (0,0,5) end begin faces (0,1,2,3) (0,1,4) "
      "end end");
  const test::UsdaPrim& mesh = scene.usd().root.child("mesh");
  EXPECT_THAT(mesh.attribute("faceVertexCounts").numbers, ElementsAre(4, 3));
  EXPECT_THAT(mesh.attribute("faceVertexIndices").numbers, ElementsAre(0, 1, 2, 3, 0, 1, 4));
  EXPECT_THAT(mesh.attribute("extent").numbers, ElementsAre(0, 0, 0, 2, 3, 5));
  EXPECT_EQ(mesh.string("orientation"), "rightHanded");
  EXPECT_EQ(mesh.string("subsetFamily:materialBind:familyType"), "partition") << "each face is in one subset";
  EXPECT_EQ(mesh.attribute("primvars:displayColor").interpolation, "uniform") << "one per face";
}

TEST(UsdMeshes, HaveNormalsOfUnitLength) {
  const ExchangedScene scene(
      "begin mesh begin vertexs normal (0, 0, 2) (0,0,0) normal (0, 3, 4) (1,0,0) normal (0.5, 0, 0) (1,1,0) "
      "end "
      "begin faces (0,1,2) end end");
  const test::UsdaValue& normals = scene.usd().root.child("mesh").attribute("normals");
  EXPECT_EQ(normals.interpolation, "vertex");
  const std::vector<double> expected = {0, 0, 1, 0, 0.6, 0.8, 1, 0, 0};
  EXPECT_THAT(normals.numbers, testing::Pointwise(testing::DoubleNear(1e-6), expected));
}

TEST(UsdStages, AreInMetresWithTheYAxisUp) {
  const ExchangedScene scene(exchange_cube({}, {}));
  EXPECT_THAT(scene.usd_text(), HasSubstr("\n    metersPerUnit = 1\n    upAxis = \"Y\"\n"));
}

TEST(UsdInstances, ReferToAPrototypeUnderTheTransforms) {
  const ExchangedScene scene("def chair = " + exchange_cube("brdf diffuse kd=0.25", {}) +
                             " begin transform scale (-1, 2, 3) translation (10, 0, 0) begin use chair "
                             "transform translation (0, 1, 0) begin use chair end end use chair end");
  const test::UsdaPrim& outer = scene.usd().root.child("transform");
  const grf::Matrix44d mirror = outer.to_parent();
  EXPECT_EQ(Vec3d(1, 1, 1) * mirror, Vec3d(9, 2, 3));
  EXPECT_LT(mirror.determinant(), 0);
  const test::UsdaPrim& inner = outer.child("transform");
  EXPECT_EQ(Vec3d(1, 1, 1) * (inner.to_parent() * mirror), Vec3d(9, 4, 3));
  for (const test::UsdaPrim* instance :
       {&outer.child("chair"), &inner.child("chair"), &scene.usd().root.child("chair")}) {
    EXPECT_TRUE(instance->is_instanceable);
    EXPECT_EQ(instance->reference, "/World/Prototypes/cube");
  }
  const test::UsdaPrim& prototype = *scene.usd().find("/World/Prototypes/cube");
  EXPECT_EQ(scene.usd().root.child("Prototypes").specifier, "class") << "it is not rendered itself";
  EXPECT_EQ(prototype.child("mesh").string("orientation"), "rightHanded") << "mirrors keep fronts in USD";
  EXPECT_EQ(prototype.child("mesh").child("diffuse").string("material:binding"),
            "/World/Prototypes/cube/Looks/diffuse")
      << "a reference must not lead out of the prototype";
  EXPECT_THAT(scene.mtlx().geometry.at("diffuse"),
              ElementsAre("/World/transform/chair/mesh/diffuse",
                          "/World/transform/transform/chair/mesh/diffuse", "/World/chair/mesh/diffuse"));
}

TEST(UsdLamps, HaveTheRadianceOfTheirFaces) {
  const ExchangedScene scene(
      "light begin (0, 2, 0) (1, 0, 0) (0, 0, 2) rgb (4, 2, 1) end\n"
      "light begin (0, 2, 0) (1, 0, 0) (1, 0, 2) rgb (5, 6, 7) end\n"
      "mesh light begin rgb (7, 8, 9) begin vertexs (0,0,0) (1,0,0) (0,1,0) end begin faces (0,1,2) end "
      "end\n" +
      exchange_cube("brdf diffuse kd=0.25", {"light rgb (0.5, 0.25, 0.125)", "light none"}));
  const test::UsdaPrim& light = scene.usd().root.child("light");
  EXPECT_EQ(light.type, "RectLight");
  EXPECT_EQ(light.number("inputs:intensity"), 4);
  EXPECT_THAT(light.attribute("inputs:color").numbers, ElementsAre(1, 0.5, 0.25));
  EXPECT_EQ(light.number("inputs:width"), 1);
  EXPECT_EQ(light.number("inputs:height"), 2);
  EXPECT_EQ(light.number("inputs:normalize"), 0);
  EXPECT_EQ(Vec3d(0) * light.to_parent(), Vec3d(0.5, 2, 1));
  Vec3d front;
  light.to_parent().multDirMatrix(Vec3d(0, 0, -1), front);
  EXPECT_LT((front - Vec3d(0, -1, 0)).length(), 1e-9) << "towards edge1 x edge2";
  Vec3d corner;
  light.to_parent().multVecMatrix(Vec3d(-0.5, 1, 0), corner);
  EXPECT_NEAR(std::abs(corner.z - 1), 1, 1e-9);
  EXPECT_NEAR(light.to_parent().determinant(), 1, 1e-9) << "a rotation, and no reflection";
  const auto emission = [&](const std::string& material) {
    return scene.usd()
        .find("/World/Looks/" + material + "/PreviewSurface")
        ->attribute("inputs:emissiveColor")
        .numbers;
  };
  EXPECT_EQ(scene.usd().root.child("light_2").type, "Mesh") << "no rectangle";
  EXPECT_EQ(scene.usd().root.child("light_3").number("doubleSided"), 0) << "it emits from its front only";
  EXPECT_THAT(emission("light"), ElementsAre(5, 6, 7));
  EXPECT_THAT(emission("light_2"), ElementsAre(7, 8, 9));
  EXPECT_THAT(scene.usd_warnings(), HasSubstr("1 face that emits lost its dark back"));
}

TEST(UsdCameras, HaveTheFieldOfViewLensAndPlace) {
  const ExchangedScene scene(
      exchange_cube({}, {}),
      "BPT_Scene scene.grf\nBPT_Image_Resolution 80 60\nBPT_Viewer 1 2 10\nBPT_VLook 1 2 0\n"
      "BPT_FieldOfView 40\nBPT_LensRadius 0.05\nBPT_FocusDistance 8\n");
  const test::UsdaPrim& camera = scene.usd().root.child("Camera");
  const double vertical = camera.number("verticalAperture");
  const double angle = 2 * std::atan(vertical / 2 / camera.number("focalLength"));
  EXPECT_NEAR(angle * 180 / std::numbers::pi, 40, 1e-4);
  EXPECT_NEAR(camera.number("horizontalAperture") / vertical, 80.0 / 60, 1e-6);
  EXPECT_EQ(camera.number("focusDistance"), 8);
  // The diameter of the lens is the focal length, in units of the scene, over the f-number.
  EXPECT_NEAR(camera.number("focalLength") / 10 / camera.number("fStop"), 0.1, 1e-6);
  EXPECT_LT((Vec3d(0, 0, -9) * camera.to_parent() - Vec3d(1, 2, 1)).length(), 1e-9);
  EXPECT_LT((Vec3d(1, 1, 0) * camera.to_parent() - Vec3d(2, 3, 10)).length(), 1e-9);
  // The cube is 9 to 11 away.
  EXPECT_LT(camera.attribute("clippingRange").numbers.at(0), 0.1);
  EXPECT_GT(camera.attribute("clippingRange").numbers.at(1), 15);
  const test::UsdaPrim& settings = scene.usd().root.child("Render");
  EXPECT_THAT(settings.attribute("resolution").numbers, ElementsAre(80, 60));
  EXPECT_EQ(settings.string("camera"), "/World/Camera");
}

TEST(UsdCameras, AreAllThatHaveNames) {
  const ExchangedScene scene(exchange_cube({}, {}),
                             "BPT_Scene scene.grf\nBPT_Cameras side 5 0 0 0 0 0 0 1 0 90 0 0\n"
                             "BPT_Cameras top 0 7 0 0 0 0 0 0 -1 30 0 0\nBPT_Camera top\n");
  const auto place = [](const test::UsdaPrim& camera) { return Vec3d(0) * camera.to_parent(); };
  const auto angle = [](const test::UsdaPrim& camera) {
    return 360 / std::numbers::pi *
           std::atan(camera.number("verticalAperture") / 2 / camera.number("focalLength"));
  };
  const test::UsdaPrim& all = scene.usd().root.child("Cameras");
  EXPECT_LT((place(all.child("side")) - Vec3d(5, 0, 0)).length(), 1e-6);
  EXPECT_NEAR(angle(all.child("side")), 90, 1e-4);
  EXPECT_LT((place(all.child("top")) - Vec3d(0, 7, 0)).length(), 1e-6);
  EXPECT_NEAR(angle(all.child("top")), 30, 1e-4);
  EXPECT_LT((place(scene.usd().root.child("Camera")) - Vec3d(0, 7, 0)).length(), 1e-6)
      << "the one that renders";
}

TEST(UsdSurroundings, AreTheBackgroundWithoutAnImage) {
  const ExchangedScene scene(exchange_cube({}, {}), "BPT_Scene scene.grf\nBPT_Background 0.25 0.5 1\n");
  const test::UsdaPrim& dome = scene.usd().root.child("Surroundings");
  EXPECT_THAT(dome.attribute("inputs:color").numbers, ElementsAre(0.25, 0.5, 1));
  EXPECT_EQ(dome.number("inputs:intensity"), 1);
}

TEST(UsdSurroundings, AreADomeThatIsTurned) {
  const test::TemporaryFolder files;
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(image::write_image({{2, 1, {{1, 2, 3}, {4, 5, 6}}}}, files.path("sky.exr"), diagnostics));
  const ExchangedScene scene(
      exchange_cube({}, {}),
      "BPT_Scene scene.grf\nBPT_EM_Background sky.exr\nBPT_EM_Rotation 30\nBPT_EM_Scale 0.5\n", files);
  const test::UsdaPrim& dome = scene.usd().root.child("Surroundings");
  EXPECT_EQ(dome.number("inputs:intensity"), 0.5);
  // The centre of the image is at +z in USD, and at -z in ours.
  EXPECT_EQ(dome.number("xformOp:rotateY"), 210);
  EXPECT_EQ(dome.string("inputs:texture:file"), "./out_usd/environment_1.exr");
}

}  // namespace
}  // namespace convert
