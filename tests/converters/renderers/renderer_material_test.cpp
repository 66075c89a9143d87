// The materials of exported scenes.
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/renderers/written_material.h"
#include "grf/read.h"
#include "renderer/image/image_file.h"
#include "renderer/reflectance/rgl_data.h"
#include "tests/converters/reading.h"
#include "tests/converters/renderers/exported_scene.h"

namespace convert {
namespace {

using grf::Vec3d;
using testing::HasSubstr;

/// Evaluates f of a table as an independent reader of the file.
Vec3d evaluate(const std::string& path, const Vec3d& u, const Vec3d& v) {
  grf::Diagnostics diagnostics;
  const auto data = reflectance::RglData::load(path, diagnostics, {});
  EXPECT_NE(data, nullptr) << diagnostics.to_text();
  return data ? Vec3d(data->evaluate(u, v)) : Vec3d(0);
}

const test::PbrtEntity& only_pbrt_material(const ExportedScene& scene) {
  return scene.pbrt().materials.at(scene.pbrt().shapes.at(0).material);
}

const test::MitsubaElement& only_mitsuba_material(const ExportedScene& scene) {
  return scene.mitsuba().child("bsdf").child("bsdf");
}

TEST(RendererMaterials, AreTabulatedWithTheirColour) {
  const ExportedScene scene(cube("rgb (0.75, 0.5, 0.25) brdf oren s=0.5 r=0.8"));
  const std::string spectral = scene.path(only_pbrt_material(scene).string("filename"));
  const std::string rgb = scene.path(only_mitsuba_material(scene).values.at("filename"));
  EXPECT_THAT(test::bytes_of(spectral), HasSubstr("wavelengths"));
  EXPECT_THAT(test::bytes_of(rgb), testing::Not(HasSubstr("wavelengths")));
  const auto brdf = reflectance::make_brdf([] {
    grf::Diagnostics diagnostics;
    return *grf::read_brdf("oren s=0.5 r=0.8", "test", diagnostics);
  }());
  for (const double angle : {0.1, 0.5, 1.0}) {
    const Vec3d u(std::sin(angle), 0, std::cos(angle));
    const Vec3d v(-0.3, 0.4, std::sqrt(0.75));
    const Vec3d value(reflectance::evaluate(*brdf, grf::Vec3f(u), grf::Vec3f(v)));
    const Vec3d expected = value * Vec3d(0.75, 0.5, 0.25);
    EXPECT_LT((evaluate(rgb, u, v) - expected).length(), 0.02 * expected.length()) << angle;
    EXPECT_LT((evaluate(spectral, u, v) - expected).length(), 0.02 * expected.length()) << angle;
  }
  EXPECT_THAT(scene.pbrt_warnings(), HasSubstr("6 faces have tables in place of their BRDF's formula"));
  EXPECT_THAT(scene.pbrt_warnings(), HasSubstr("1 BRDF is tabulated with a mean error of up to"));
}

TEST(RendererMaterials, OfPbrtAreConductorsOnlyWhereTheFormulaIsTheSame) {
  const ExportedScene scene(cube("brdf ggx alpha=0.25 nreal=1.5 nimag=2 scattering=single"));
  const test::PbrtEntity& material = only_pbrt_material(scene);
  EXPECT_EQ(material.plugin, "conductor");
  EXPECT_EQ(material.number("roughness"), 0.25);
  EXPECT_EQ(material.string("remaproughness"), "false");
  EXPECT_EQ(material.parameters.at("eta").numbers[1], 1.5);
  EXPECT_EQ(material.parameters.at("eta").numbers[3], 1.5);
  EXPECT_EQ(material.parameters.at("k").numbers[1], 2);
  EXPECT_EQ(only_mitsuba_material(scene).type, "measured");
  for (const char* other :
       {"ggx alpha=0.25 nreal=1.5 nimag=2", "ggx alpha=0.25 ay=0.5 scattering=single",
        "ggx alpha=0.25 F0=0.5 scattering=single", "ggx alpha=0.25 nreal=(1, 2, 3) scattering=single"}) {
    EXPECT_EQ(only_pbrt_material(ExportedScene(cube(fmt::format("brdf {}", other)))).plugin, "measured")
        << other;
  }
  EXPECT_EQ(only_pbrt_material(ExportedScene(cube("rgb (1, 1, 0.5) brdf ggx scattering=single"))).plugin,
            "measured");
}

TEST(RendererMaterials, OfMirrorsHaveTheirReflectance) {
  const ExportedScene scene(cube("rgb (0.5, 1, 1) brdf specular ks=0.75"));
  const test::PbrtEntity& mix = only_pbrt_material(scene);
  EXPECT_EQ(mix.plugin, "mix");
  EXPECT_EQ(mix.number("amount"), 0.75);
  const auto& names = mix.parameters.at("materials").strings;
  // The amount is the probability of the second.
  EXPECT_EQ(scene.pbrt().materials.at(names[0]).rgb("reflectance"), Vec3d(0));
  EXPECT_EQ(scene.pbrt().materials.at(names[1]).plugin, "conductor");
  EXPECT_EQ(scene.pbrt().materials.at(names[1]).rgb("reflectance"), Vec3d(0.5, 1, 1));
  EXPECT_EQ(scene.pbrt().materials.at(names[1]).number("roughness"), 0);
  const test::MitsubaElement& mirror = only_mitsuba_material(scene);
  EXPECT_EQ(mirror.type, "conductor");
  EXPECT_EQ(mirror.values.at("material"), "none");
  EXPECT_EQ(mirror.lists.at("specular_reflectance"), (std::vector<double>{0.375, 0.75, 0.75}));
}

TEST(RendererMaterials, OfGlassAreDielectrics) {
  const ExportedScene pane(cube("rgb (0.5, 1, 1) brdf glass ior=1.25 colour=0.5 thin=true"));
  EXPECT_EQ(only_pbrt_material(pane).plugin, "thindielectric");
  EXPECT_EQ(only_pbrt_material(pane).number("eta"), 1.25);
  const test::MitsubaElement& mitsuba = pane.mitsuba().child("bsdf");
  EXPECT_EQ(mitsuba.type, "thindielectric") << "twosided takes nothing that transmits";
  EXPECT_EQ(mitsuba.number("int_ior"), 1.25);
  EXPECT_EQ(mitsuba.number("ext_ior"), 1) << "its default is that of air";
  EXPECT_EQ(mitsuba.lists.at("specular_transmittance"), (std::vector<double>{0.25, 0.5, 0.5}));
  EXPECT_THAT(pane.pbrt_warnings(), HasSubstr("6 faces lost the colour of their glass"));
  EXPECT_THAT(pane.mitsuba_warnings(), testing::Not(HasSubstr("glass")));
  const ExportedScene solid(cube("brdf glass"));
  EXPECT_EQ(only_pbrt_material(solid).plugin, "dielectric");
  EXPECT_EQ(solid.mitsuba().child("bsdf").type, "dielectric");
  EXPECT_THAT(solid.mitsuba_warnings(), testing::Not(HasSubstr("glass")));
}

TEST(RendererMaterials, OfSumsWithAMirrorAreBlended) {
  const ExportedScene scene(
      "def clay = brdf diffuse kd=0.8 shine = brdf specular ks=1 "
      "both = brdf combine 0.5 clay, 0.25 shine begin " +
      cube("brdf both") + " end");
  const test::PbrtEntity& mix = only_pbrt_material(scene);
  EXPECT_EQ(mix.number("amount"), 0.25);
  const auto& names = mix.parameters.at("materials").strings;
  const std::string table = scene.path(scene.pbrt().materials.at(names[0]).string("filename"));
  // Three quarters of the table are the diffuse part of the sum.
  const Vec3d value = 0.75 * evaluate(table, {0, 0, 1}, {0.6, 0, 0.8});
  EXPECT_LT((value - Vec3d(0.4 / M_PI)).length(), 0.01);
  const test::MitsubaElement& blend = only_mitsuba_material(scene);
  EXPECT_EQ(blend.type, "blendbsdf");
  EXPECT_EQ(blend.number("weight"), 0.25);
  EXPECT_EQ(blend.all("bsdf").at(0).type, "measured");
  EXPECT_EQ(blend.all("bsdf").at(1).type, "conductor");
}

// The mean of Schlick's R0 + (1 - R0) (1 - c)^5 by the cosine is R0 + (1 - R0)/21.
TEST(RendererMaterials, OfMirrorsThatVaryHaveTheMean) {
  const ExportedScene scene(cube("brdf coupled Rm=0.5 R0=0.16"));
  EXPECT_NEAR(only_pbrt_material(scene).number("amount"), 0.16 + 0.84 / 21, 1e-3);
  EXPECT_NEAR(only_mitsuba_material(scene).number("weight"), 0.2, 1e-3);
  EXPECT_THAT(scene.mitsuba_warnings(),
              HasSubstr("6 faces lost the dependence of their specular (delta) part"));
}

TEST(RendererTextures, OfDiffuseFacesIncludeTheColour) {
  const test::TemporaryFolder files;
  grf::Diagnostics diagnostics;
  image::Image image{2, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5F, 0.5F, 0.5F}}};
  ASSERT_TRUE(image::write_image({image}, files.path("wood.exr"), diagnostics));
  const std::string quad =
      "begin mesh rgb (0.5, 1, 1) brdf {} texture \"wood.exr\" begin vertexs uv (0, 0) (0,0,0) uv (1, 0) "
      "(1,0,0) uv (0, 1) (0,1,0) end begin faces (0,1,2) end end";
  const ExportedScene scene(fmt::format(fmt::runtime(quad), "diffuse kd=0.5"), {}, files);
  const std::string texture = only_pbrt_material(scene).string("reflectance");
  const std::vector<std::string> names = {
      scene.pbrt().textures.at(texture).string("filename"),
      only_mitsuba_material(scene).child("texture").values.at("filename")};
  for (const std::string& name : names) {
    EXPECT_EQ(scene.image(name).at(0, 0), grf::Colour(0.25F, 0, 0));
    EXPECT_EQ(scene.image(name).at(1, 1), grf::Colour(0.125F, 0.25F, 0.25F));
  }
  const grf::Mesh mesh = scene.pbrt_meshes().at(0);
  EXPECT_EQ(mesh.geometry->uvs[mesh.face(0)[2]], grf::Vec2f(0, 1));
  // (0,0) is the lower left corner in pbrt, and the upper left one in Mitsuba.
  EXPECT_EQ(scene.mitsuba().child("shape").values.at("flip_tex_coords"), "true");

  const ExportedScene glossy(fmt::format(fmt::runtime(quad), "oren s=0 r=0.5"), {}, files);
  const std::string table = glossy.path(only_mitsuba_material(glossy).values.at("filename"));
  const Vec3d expected = 0.5 / M_PI * Vec3d(0.5, 1, 1) * Vec3d(1.5 / 4);
  EXPECT_LT((evaluate(table, {0, 0, 1}, {0.6, 0, 0.8}) - expected).length(), 0.002);
  EXPECT_THAT(glossy.pbrt_warnings(), HasSubstr("has the mean colour of its texture"));
}

TEST(RendererOpacity, IsThatOfShapes) {
  const ExportedScene scene(cube("brdf diffuse", {"opacity 0.25", "", "", "", "", ""}));
  std::vector<double> of_pbrt;
  for (const test::PbrtShape& shape : scene.pbrt().shapes) {
    const auto alpha = shape.shape.parameters.find("alpha");
    of_pbrt.push_back(alpha == shape.shape.parameters.end() ? 1 : alpha->second.numbers.at(0));
  }
  EXPECT_THAT(of_pbrt, testing::Contains(0.25));
  for (const test::MitsubaElement& shape : scene.mitsuba().all("shape")) {
    const auto masks = shape.all("bsdf");
    if (masks.empty()) continue;
    EXPECT_EQ(masks[0].number("opacity"), 0.25);
    EXPECT_EQ(masks[0].references.size(), 1U);
  }
  EXPECT_THAT(scene.pbrt_warnings(), testing::Not(HasSubstr("opacity")));
}

// A mask keeps the light of Mitsuba's emitters, and pbrt's area lights with `alpha` 0 are there and unseen.
TEST(RendererOpacity, OfZeroLeavesFacesOutWithTheirLight) {
  const ExportedScene scene(
      cube("brdf diffuse", {"light rgb (4, 2, 1) opacity 0", "light none opacity none", "", "", "", ""}));
  ASSERT_EQ(scene.pbrt().shapes.size(), 1U);
  EXPECT_FALSE(scene.pbrt().shapes[0].emission);
  ASSERT_EQ(scene.mitsuba().all("shape").size(), 1U);
  EXPECT_TRUE(scene.mitsuba().all("shape")[0].all("emitter").empty());
  EXPECT_EQ(scene.pbrt_meshes().at(0).face_count(), 10U) << "triangles of the five other faces";
  EXPECT_EQ(scene.mitsuba_meshes().at(0).face_count(), 10U);
}

TEST(RendererOpacity, IsAnImageWhereAlphaDecides) {
  const test::TemporaryFolder files;
  // Two pixels of red with an alpha of 0.2 and 1, bottom up, blue first.
  files.add("leaf.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x20\x08", 18) +
                            std::string("\0\0\xff\x33\0\0\xff\xff", 8));
  const auto exported = [&](const std::string& opacity) {
    return ExportedScene("begin mesh brdf diffuse kd=0.5 texture \"leaf.tga\" opacity " + opacity +
                             " begin vertexs uv (0, 0) (0,0,0) uv (1, 0) (1,0,0) uv (0, 1) (0,1,0) end begin "
                             "faces (0,1,2) end end",
                         {}, files);
  };
  for (const auto& [opacity, left, right] :
       {std::tuple("mask 0.5", 0.0F, 1.0F), {"mask 0.125", 1.0F, 1.0F}, {"blend 0.5", 0.1F, 0.5F}}) {
    const ExportedScene scene = exported(opacity);
    const std::string texture = scene.pbrt().shapes.at(0).shape.string("alpha");
    const test::MitsubaElement mask = scene.mitsuba().child("shape").child("bsdf");
    const test::MitsubaElement& bitmap = mask.child("texture");
    EXPECT_EQ(bitmap.values.at("raw"), "true");
    for (const std::string& name :
         {scene.pbrt().textures.at(texture).string("filename"), bitmap.values.at("filename")}) {
      EXPECT_NEAR(scene.image(name).at(0, 0).x, left, 1e-3) << opacity;
      EXPECT_NEAR(scene.image(name).at(1, 0).x, right, 1e-3) << opacity;
    }
    const std::string reflectance = only_pbrt_material(scene).string("reflectance");
    const image::Image colours = scene.image(scene.pbrt().textures.at(reflectance).string("filename"));
    EXPECT_NEAR(colours.at(0, 0).x, 0.5, 1e-3) << "of its opaque part";
  }
}

TEST(RendererFormats, AreOnlyWritten) {
  const test::TemporaryFolder folder;
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"a.pbrt", "WorldBegin\n"}, {"a.xml", "<!-- a -->\n<scene version=\"3.0.0\"></scene>"}}) {
    grf::Diagnostics diagnostics;
    const std::string path = folder.add(name, text);
    const Format* format = recognise(path, diagnostics);
    ASSERT_NE(format, nullptr);
    EXPECT_FALSE(read(*format, path, {}, diagnostics).has_value());
    EXPECT_THAT(diagnostics.to_text(), HasSubstr("files are only written, and cannot be read"));
  }
}

TEST(RendererFormats, RefuseAnEmptySceneAndABadOpFile) {
  const test::TemporaryFolder folder;
  folder.add("scene.grf", cube());
  for (const char* name : {"pbrt", "mitsuba"}) {
    grf::Diagnostics diagnostics;
    EXPECT_FALSE(find_format(name)->write({}, folder.path("out"), diagnostics));
    EXPECT_THAT(diagnostics.to_text(), HasSubstr("the scene has no faces"));
    const WriteOptions options{
        folder.add("bad.op", "BPT_Viewer 0 0 0\nBPT_VLook 0 0 0\nBPT_Scene scene.grf\n")};
    grf::Diagnostics of_view;
    EXPECT_FALSE(find_format(name)->write_view(scene_of_grf(cube()), folder.path("out"), options, of_view));
    EXPECT_THAT(of_view.to_text(), HasSubstr("the eye is at the point it looks at"));
  }
}

}  // namespace
}  // namespace convert
