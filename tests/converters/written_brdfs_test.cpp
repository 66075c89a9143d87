// What is written of each BRDF for programs that know none of GRF's: the numbers in the MTL and glTF files,
// against numbers worked out by hand from the table "Lobes of BRDFs" of FORMATS.md.
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "grf/read.h"
#include "grf/write.h"
#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/scheme.h"
#include "tests/converters/reading.h"

namespace convert {
namespace {

using nlohmann::json;

constexpr double MirrorExponent = std::numeric_limits<double>::infinity();

/// A BRDF with its diffuse lobe, its glossy lobe and the Blinn-Phong exponent.
struct WrittenBrdf {
  std::string brdf;
  grf::Vec3d diffuse;
  grf::Vec3d glossy;
  double exponent = 0;
};

// The numbers are of tests/converters/written_brdfs.py, which has the formulas of the table a second time.
const std::vector<WrittenBrdf>& written_brdfs() {
  static const std::vector<WrittenBrdf> rows = {
      {"diffuse kd=(0.1, 0.2, 0.3)", {0.1, 0.2, 0.3}, {0, 0, 0}, 0},
      {"minnaert kd=0.3", {0.3, 0.3, 0.3}, {0, 0, 0}, 0},
      {"oren s=0.4 r=0.25", {0.25, 0.25, 0.25}, {0, 0, 0}, 0},
      {"specular ks=(0.5, 0.25, 0.75)", {0, 0, 0}, {0.5, 0.25, 0.75}, MirrorExponent},
      {"coupled Rm=0.5 R0=0.2", {0.4, 0.4, 0.4}, {0.2, 0.2, 0.2}, MirrorExponent},
      {"glass ior=3", {0, 0, 0}, {0.25, 0.25, 0.25}, MirrorExponent},
      {"lewis n=20 ks=0.25 kd=0.5", {0.5, 0.5, 0.5}, {0.25, 0.25, 0.25}, 80},
      {"phong n=10 ks=0.3 kd=0.2", {0.2, 0.2, 0.2}, {0.15707963, 0.15707963, 0.15707963}, 40},
      {"blinn n=10 ks=0.3 kd=0.2", {0.2, 0.2, 0.2}, {0.45020145, 0.45020145, 0.45020145}, 10},
      {"lafortune Cz=0.9 n=8 kp=0.2", {0.2, 0.2, 0.2}, {0.27047052, 0.27047052, 0.27047052}, 32},
      {"ward sx=0.1 sy=0.4 ks=0.3 kd=0.2", {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}, 48},
      {"torrance rough=0.25 nreal=1.5 nimag=0.5 ks=0.8 kd=0.1",
       {0.1, 0.1, 0.1},
       {0.061538462, 0.061538462, 0.061538462},
       30},
      {"ashikhmin ex=16 ey=100 Rs=0.25 Rd=0.5", {0.375, 0.375, 0.375}, {0.25, 0.25, 0.25}, 40},
      {"schlick Ly=true DC=0.5 SC=0.4 Sr=0.1", {0.3, 0.3, 0.3}, {0.4, 0.4, 0.4}, 18},
      {"strauss kd=(0.6, 0.3, 0.15) s=0.5 m=0.4 ks=0.5", {0.42, 0.21, 0.105}, {0.0625, 0.05, 0.04375}, 24},
      {"neumann r=0.2 ry=0.5 ks=0.6 kd=0.1", {0.1, 0.1, 0.1}, {0.6, 0.6, 0.6}, 152},
      {"beardmaxwell Rd=0.2 Rv=0.1 Rs=0.5 nreal=2 nimag=0 sigma=0.25",
       {0.3, 0.3, 0.3},
       {0.055555556, 0.055555556, 0.055555556},
       30},
      {"kajiya taux=1 tauy=4 sigma=0.1 ks=0.5 kd=0.1 nreal=2",
       {0.1, 0.1, 0.1},
       {0.055555556, 0.055555556, 0.055555556},
       198},
      {"hanrahan kd=0.1 albedo=0.5 depth=0.2 g=0.3 nreal=1.5 rough=0.25 ks=0.5",
       {0.095886843, 0.095886843, 0.095886843},
       {0.02, 0.02, 0.02},
       30},
      {"westin tau=4 sigma=0.5 ks=0.75 kd=0.1 nreal=1.5 nimag=2",
       {0.1, 0.1, 0.1},
       {0.31097561, 0.31097561, 0.31097561},
       30},
      {"he tau=4 sigma=0.5 ks=0.75 kd=0.1 nreal=1.5 nimag=2",
       {0.1, 0.1, 0.1},
       {0.31097561, 0.31097561, 0.31097561},
       30},
      {"granier kd=0.1 ks=0.8 kt=0.5 nreal=1.5 m=45 n=30", {0.1, 0.1, 0.1}, {0.4928, 0.4928, 0.4928}, 20},
      {"granier kd=0.1 ks=0.8 kt=0.02 nreal=1.5 m=45 n=30",
       {0.1, 0.1, 0.1},
       {0.050432, 0.050432, 0.050432},
       30},
      {"poulin kd=0.2 ks=0.3 n=30", {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}, 30},
      {"ggx alpha=0.25 ay=0.5 nreal=1.5 ks=0.5", {0, 0, 0}, {0.02, 0.02, 0.02}, 14},
      {"ggx ax=0.5 F0=(0.9, 0.6, 0.3)", {0, 0, 0}, {0.9, 0.6, 0.3}, 6},
      {"gltf baseColor=(0.8, 0.4, 0.2) metallic=0.25 roughness=0.5 ior=1.5 specular=0.5 anisotropy=0.5",
       {0.6, 0.3, 0.15},
       {0.215, 0.115, 0.065},
       16.285714},
      {"openpbr baseWeight=0.5 baseColor=(0.8, 0.4, 0.2) metalness=0.25 specularWeight=0.5 "
       "specularColor=(1, 0.5, 0.25) roughness=0.5 anisotropy=0.25",
       {0.3, 0.15, 0.075},
       {0.065, 0.0325, 0.01625},
       31.333333},
      {"thinfilm alpha=0.25 ay=0.5 thickness=250 film=1.5 nreal=2 nimag=3 ks=0.8",
       {0, 0, 0},
       {0.30456704, 0.22698684, 0.35483166},
       14},
      {"sheen rough=0.5 ks=0.8", {0.093845017, 0.093845017, 0.093845017}, {0, 0, 0}, 0},
      {"eon rough=0.75 kd=0.5", {0.46443527, 0.46443527, 0.46443527}, {0, 0, 0}, 0},
  };
  return rows;
}

std::string keyword_of(const WrittenBrdf& row) { return row.brdf.substr(0, row.brdf.find(' ')); }

grf::Scene scene_with(const std::string& brdf) {
  return scene_of_grf(
      "begin mesh brdf " + brdf +
      " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end vertexs begin faces (0, 1, 2) end faces "
      "end mesh");
}

/// The numbers behind each keyword of an MTL file of one material.
std::map<std::string, std::vector<double>> written_mtl(const std::string& brdf) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(find_format("obj")->write(scene_with(brdf), folder.path("a.obj"), diagnostics))
      << diagnostics.to_text();
  std::map<std::string, std::vector<double>> values;
  std::istringstream lines(test::bytes_of(folder.path("a.mtl")));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    for (double value = 0; words >> value;) values[keyword].push_back(value);
  }
  return values;
}

void expect_colour(const std::vector<double>& written, const grf::Vec3d& expected, const std::string& of) {
  ASSERT_GE(written.size(), 3U) << of;
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(written[static_cast<std::size_t>(i)], expected[i], 1e-5) << of;
}

TEST(WrittenBrdfs, OfMtlAreTheNumbersOfTheTable) {
  for (const WrittenBrdf& row : written_brdfs()) {
    auto mtl = written_mtl(row.brdf);
    expect_colour(mtl["Kd"], row.diffuse, row.brdf + " Kd");
    expect_colour(mtl["Ks"], row.glossy, row.brdf + " Ks");
    const bool is_mirror = std::isinf(row.exponent);
    const bool is_diffuse = row.glossy == grf::Vec3d(0);
    ASSERT_EQ(mtl["illum"].size(), 1U) << row.brdf;
    EXPECT_EQ(mtl["illum"][0], is_diffuse ? 1 : is_mirror ? 3 : 2) << row.brdf;
    if (is_diffuse) continue;
    ASSERT_EQ(mtl["Ns"].size(), 1U) << row.brdf;
    EXPECT_NEAR(mtl["Ns"][0], is_mirror ? 1000 : row.exponent / 4, 1e-5 * row.exponent) << row.brdf;
  }
}

/// The material of a glTF file that has one.
json written_gltf(const std::string& brdf) {
  const test::TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(find_format("gltf")->write(scene_with(brdf), folder.path("a.gltf"), diagnostics))
      << diagnostics.to_text();
  return json::parse(test::bytes_of(folder.path("a.gltf")))["materials"].at(0);
}

// glTF 2.0, appendix B: what metallic-roughness reflects is 0.04 (1 - metallic) + base colour * metallic at
// its facets, and base colour * (1 - metallic) under those of its dielectric, which let 0.96 through. A
// channel of a coloured highlight can be out of its reach, and the brightest one decides then.
TEST(WrittenBrdfs, OfGltfReflectWhatTheTableHas) {
  for (const WrittenBrdf& row : written_brdfs()) {
    if (keyword_of(row) == "gltf" || keyword_of(row) == "glass")
      continue;  // written exactly, with extensions
    const json material = written_gltf(row.brdf);
    const json& values = material["pbrMetallicRoughness"];
    const double metallic = values["metallicFactor"];
    const bool is_diffuse = row.glossy == grf::Vec3d(0);
    const double roughness = is_diffuse                 ? 1
                             : std::isinf(row.exponent) ? 0
                                                        : std::pow(2 / (row.exponent + 2), 0.25);
    EXPECT_NEAR(values["roughnessFactor"].get<double>(), roughness, 1e-5) << row.brdf;
    const bool has_no_highlight =
        material.contains("extensions") &&
        material["extensions"]["KHR_materials_specular"]["specularFactor"] == json(0);
    EXPECT_EQ(has_no_highlight, is_diffuse) << row.brdf;
    const int brightest = row.glossy.x >= row.glossy.y && row.glossy.x >= row.glossy.z ? 0
                          : row.glossy.y >= row.glossy.z                               ? 1
                                                                                       : 2;
    for (int i = 0; i < 3; ++i) {
      const double base = values["baseColorFactor"].at(static_cast<std::size_t>(i));
      const double facet = 0.04 * (1 - metallic) + base * metallic;
      const double under = base * (1 - metallic);
      const double expected_under = row.diffuse[i] / 0.96;
      // The sum of both is exact in each channel.
      if (!is_diffuse && metallic > 0) {
        const double expected = expected_under + row.glossy[i] - 0.04 * (1 - metallic);
        EXPECT_NEAR(base, expected, 2e-4) << row.brdf << ' ' << i;
      }
      if (i != brightest && !is_diffuse) continue;
      EXPECT_NEAR(under, is_diffuse ? row.diffuse[i] : expected_under, 2e-4) << row.brdf << ' ' << i;
      if (is_diffuse || row.glossy[i] <= 0.04) continue;
      EXPECT_NEAR(facet, row.glossy[i], 2e-4) << row.brdf << ' ' << i;
    }
  }
}

/// The only BRDF of the faces of a scene.
reflectance::Reflector reflector_of(const grf::BrdfModel& model) {
  const auto brdf = reflectance::make_brdf(model);
  if (!brdf) throw std::runtime_error("no BRDF: " + grf::to_text(model));
  return {*brdf, reflectance::OwnScheme()};
}

reflectance::Reflector reflector_of_text(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf(text, "test", diagnostics);
  if (!model) throw std::runtime_error(diagnostics.to_text());
  return reflector_of(*model);
}

void erase_extras(json& values) {
  if (values.is_object()) values.erase("extras");
  for (json& part : values) {
    if (part.is_structured()) erase_extras(part);
  }
}

std::string without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with('#')) kept += line + '\n';
  }
  return kept;
}

/// What our reader makes of the written BRDF, of which no program but ours would know the original.
reflectance::Reflector read_without_original(const std::string& brdf, const char* format) {
  const test::TemporaryFolder folder;
  const std::string path = folder.path(fmt::format("a.{}", format));
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(find_format(format)->write(scene_with(brdf), path, diagnostics)) << diagnostics.to_text();
  if (std::string_view(format) == "obj") {
    folder.add("a.mtl", without_comments(test::bytes_of(folder.path("a.mtl"))));
  } else {
    json values = json::parse(test::bytes_of(path));
    erase_extras(values);
    folder.add("a.gltf", values.dump());
  }
  const Reading reading = read_path(path);
  EXPECT_TRUE(reading.scene.has_value()) << reading.text();
  return reflector_of(std::get<grf::BrdfModel>(definitions_of(*reading.scene).at(0).body));
}

/// A sphere under an even sky of radiance 1, with a round lamp of radiance 4, whose radius is 37 degrees,
/// above the viewer: the mean of the picture, and its part that is of the lamp.
struct SpherePicture {
  std::vector<grf::Vec3d> sky;
  std::vector<grf::Vec3d> lamp;
};

SpherePicture picture_of(const reflectance::Reflector& reflector) {
  constexpr int Width = 6;
  constexpr int Samples = 512;
  const Imath::V3f to_lamp = Imath::V3f(0, 0.6F, 0.8F);
  SpherePicture picture;
  for (int pixel = 0; pixel < Width * Width; ++pixel) {
    const float x = 2 * (static_cast<float>(pixel % Width) + 0.5F) / Width - 1;
    const float y = 2 * (static_cast<float>(pixel / Width) + 0.5F) / Width - 1;
    if (x * x + y * y > 0.95F) continue;
    const Imath::V3f normal(x, y, std::sqrt(1 - x * x - y * y));
    const Imath::V3f side = Imath::V3f(normal.z, 0, -normal.x).normalized();
    const Imath::V3f up = normal.cross(side);
    const Imath::V3f view(side.z, up.z, normal.z);  // (0, 0, 1) in the frame of the sphere
    grf::Vec3d sky(0);
    grf::Vec3d lamp(0);
    for (int i = 0; i < Samples; ++i) {
      const auto drawn = reflector.sample(view, reflectance::halton_point(static_cast<std::uint32_t>(i)));
      if (!drawn) continue;
      const Imath::V3f& d = drawn->direction;
      const grf::Vec3d weight(drawn->weight);
      sky += weight / Samples;
      if ((side * d.x + up * d.y + normal * d.z).dot(to_lamp) > 0.8F) lamp += weight * 4 / Samples;
    }
    picture.sky.push_back(sky);
    picture.lamp.push_back(lamp);
  }
  return picture;
}

/// The root of the mean square of what two pictures differ by, and the difference of their means.
std::pair<double, double> difference_of(const std::vector<grf::Vec3d>& a, const std::vector<grf::Vec3d>& b) {
  double squares = 0;
  grf::Vec3d sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += (a[i] - b[i]).length2() / 3;
    sum += a[i] - b[i];
  }
  const auto count = static_cast<double>(a.size());
  return {std::sqrt(squares / count), (sum.x + sum.y + sum.z) / (3 * count)};
}

/// How far the picture of what was written may be off: the root of the mean square, and the mean.
struct PictureBounds {
  double sky = 0.1;
  double mean_of_sky = 0.08;
  double lamp = 0.15;
  double mean_of_lamp = 0.08;
};

/// MTL has a glossy lobe over a diffuse one. Other effects of models at grazing angles are lost.
const std::map<std::string, PictureBounds> MtlBounds = {
    {"coupled", {0.15, 0.115, 0.15, 0.08}},  // Fresnel's reflectance grows, MTL's mirror does not
    {"glass", {0.15, 0.115, 0.15, 0.08}},    // likewise
    {"neumann", {0.13, 0.12, 0.15, 0.08}},   // the lobe loses what would leave below the surface
    {"beardmaxwell", {0.16, 0.13, 0.15, 0.08}}, {"granier", {0.12, 0.08, 0.15, 0.08}},
    {"eon", {0.1, 0.08, 0.15, 0.085}},        // rough surfaces are flatter than Lambert
    {"ggx", {0.22, 0.14, 0.21, 0.11}},        // light between facets is lost
    {"sheen", {0.12, 0.08, 0.15, 0.08}},      // it shines towards grazing
    {"thinfilm", {0.165, 0.12, 0.15, 0.08}},  // its colour changes with the angle
    {"gltf", {0.135, 0.095, 0.15, 0.08}},     // light between facets is lost
    {"poulin", {0.14, 0.135, 0.21, 0.08}},    // cylinders shadow each other
    {"schlick", {0.48, 0.27, 0.33, 0.1}},     // as published, it reflects up to twice the light
};

/// glTF's facets keep all light, and reflect all of it at grazing. Models that do not are darker there.
const std::map<std::string, PictureBounds> GltfBounds = {
    {"gltf", {1e-3, 1e-3, 1e-3, 1e-3}},
    {"diffuse", {1e-3, 1e-3, 1e-3, 1e-3}},
    {"glass", {1e-3, 1e-3, 1e-3, 1e-3}},
    {"coupled", {0.01, 0.01, 0.01, 0.01}},
    {"ggx", {0.03, 0.03, 0.02, 0.01}},
    {"lewis", {0.14, 0.11, 0.15, 0.08}},  // the lobe loses what would leave below the surface
    {"blinn", {0.22, 0.18, 0.15, 0.08}},
    {"ward", {0.18, 0.16, 0.15, 0.08}},
    {"ashikhmin", {0.165, 0.14, 0.15, 0.08}},
    {"neumann", {0.2, 0.135, 0.15, 0.08}},
    {"granier", {0.25, 0.21, 0.15, 0.08}},
    {"poulin", {0.24, 0.23, 0.18, 0.08}},   // cylinders shadow each other
    {"sheen", {0.125, 0.08, 0.15, 0.08}},   // it shines towards grazing
    {"eon", {0.1, 0.08, 0.15, 0.085}},      // rough surfaces are flatter than Lambert
    {"schlick", {0.34, 0.11, 0.26, 0.08}},  // as published, it reflects up to twice the light
};

PictureBounds bounds_of(const std::string& keyword, const std::string& format) {
  const auto& bounds = format == "obj" ? MtlBounds : GltfBounds;
  const auto known = bounds.find(keyword);
  return known == bounds.end() ? PictureBounds() : known->second;
}

// The images are not equal, since MTL and glTF have one glossy lobe over a diffuse one; but their brightness
// and the width of the highlight are.
TEST(WrittenBrdfs, LookLikeTheirOriginals) {
  for (const WrittenBrdf& row : written_brdfs()) {
    const SpherePicture original = picture_of(reflector_of_text(row.brdf));
    for (const char* format : {"obj", "gltf"}) {
      const PictureBounds bounds = bounds_of(keyword_of(row), format);
      const SpherePicture written = picture_of(read_without_original(row.brdf, format));
      const auto [sky, mean_of_sky] = difference_of(written.sky, original.sky);
      const auto [lamp, mean_of_lamp] = difference_of(written.lamp, original.lamp);
      EXPECT_LT(sky, bounds.sky) << row.brdf << ' ' << format;
      EXPECT_LT(std::abs(mean_of_sky), bounds.mean_of_sky) << row.brdf << ' ' << format;
      EXPECT_LT(lamp, bounds.lamp) << row.brdf << ' ' << format;
      EXPECT_LT(std::abs(mean_of_lamp), bounds.mean_of_lamp) << row.brdf << ' ' << format;
    }
  }
}

TEST(WrittenBrdfs, AreThoseOfEachModel) {
  std::set<std::string> models;
  for (const WrittenBrdf& row : written_brdfs()) models.insert(keyword_of(row));
  for (const grf::ModelInfo& model : reflectance::catalogue().brdfs) {
    if (model.argument_kind != grf::ModelInfo::ArgumentKind::Parameters) continue;
    EXPECT_EQ(models.erase(std::string(model.keyword)), 1U) << model.keyword << " has no row";
  }
  EXPECT_TRUE(models.empty());
}

}  // namespace
}  // namespace convert
