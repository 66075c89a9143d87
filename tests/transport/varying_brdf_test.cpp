// Images that vary parameters of BRDFs. What they make of a point must be what the numbers make of a whole
// face.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/reflectance/brdf_instance.h"
#include "renderer/transport/integrators/feature_layers.h"
#include "tests/transport/scene_helpers.h"

namespace {

using image::Alpha;
using image::Image;
using test::RenderSetup;
using transport::CompiledScene;
using transport::CompileSettings;
using transport::Effect;
using transport::Integrator;
using transport::Rgb;

/// The linear value of a byte in sRGB (IEC 61966-2-1).
float decoded(int byte) { return static_cast<float>(std::pow((byte / 255.0 + 0.055) / 1.055, 2.4)); }

/// `bytes.png` has one texel of 102, 153, 204, half transparent as files of 8 bits are read; `floats.exr` has
/// the same numbers as fractions; `halves.png` is 0 in its left half, and 255 in its right one; `grid.png`
/// has as many of both, side by side.
std::optional<Image> test_image(const std::string& path, grf::Diagnostics&, const grf::SourceLocation&,
                                Alpha alpha) {
  constexpr int Side = 64;
  const int width = path.ends_with("halves.png") ? Side / 2 : path.ends_with("grid.png") ? 1 : 0;
  if (width > 0) {
    Image image{Side, Side, {}};
    for (int i = 0; i < Side * Side; ++i) image.pixels.emplace_back(i % Side / width % 2 == 0 ? 0.0F : 1.0F);
    return image;
  }
  if (path.ends_with("glassy.exr")) {  // the same numbers, multiplied by an alpha of a half
    Image image{2, 1, {Rgb(0.2F, 0.3F, 0.4F), Rgb(0.2F, 0.3F, 0.4F)}};
    if (alpha == Alpha::Kept) image.alpha = {0.5F, 0.5F};
    return image;
  }
  if (path.ends_with("floats.exr")) return Image{1, 1, {Rgb(0.4F, 0.6F, 0.8F)}};
  constexpr float Opaque = 51 / 255.0F;
  Image image{1, 1, {Rgb(decoded(102), decoded(153), decoded(204)) * Opaque}};
  if (alpha == Alpha::Kept) image.alpha = {Opaque};
  return image;
}

CompileSettings with_images() {
  CompileSettings settings;
  settings.image_reader = test_image;
  return settings;
}

/// A floor with uv from 0 to 1, and a lamp over it.
std::string floor_of(const std::string& attributes) {
  return "begin mesh " + attributes +
         " begin vertexs uv (0,0) (-2,0,2) uv (1,0) (2,0,2) uv (1,1) (2,0,-2) uv (0,1) (-2,0,-2) end vertexs "
         "begin faces (0,1,2,3) end faces end mesh\n" +
         test::FloorLight;
}

Image rendered(const std::string& text, const RenderSetup& setup, Integrator integrator = Integrator::Path,
               CompileSettings compile_settings = with_images()) {
  const CompiledScene scene = test::scene_of(text, compile_settings);
  transport::RenderSettings settings = test::settings_of(setup);
  settings.integrator.integrator = integrator;
  settings.integrator.secondary_rays = 4;
  transport::Render render(scene, settings);
  render.run();
  EXPECT_EQ(render.rejected_samples(), 0U);
  return render.film().mean();
}

/// The largest difference of pixels relative to the mean.
double difference(const Image& image, const Image& other) {
  double largest = 0;
  double sum = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    largest = std::max(largest, static_cast<double>((image.pixels[i] - other.pixels[i]).length()));
    sum += image.pixels[i].length();
  }
  EXPECT_GT(sum, 0);
  return largest * static_cast<double>(image.pixels.size()) / sum;
}

/// Interpolation rounds, and texels that are no bytes are stored as halves.
constexpr double Rounding = 3e-3;

/// The first two must give the same image with each integrator, and the third another one.
void expect_same(const std::string& varied, const std::string& constant, const std::string& other) {
  RenderSetup setup = test::floor_setup(24, 16, 4);
  setup.background = 0.5F;
  for (const Integrator integrator : {Integrator::Path, Integrator::Naive}) {
    const Image expected = rendered(floor_of(constant), setup, integrator);
    EXPECT_LT(difference(expected, rendered(floor_of(varied), setup, integrator)), Rounding) << varied;
    EXPECT_GT(difference(expected, rendered(floor_of(other), setup, integrator)), 3 * Rounding) << other;
  }
}

TEST(VaryingBrdf, ReadsASingleChannelAsStored) {
  for (const std::string file : {"bytes.png", "floats.exr", "glassy.exr"}) {
    const std::string map = "texture \"" + file + "\" ";
    expect_same("brdf ward sx=" + map + "r sy=0.3", "brdf ward sx=0.4 sy=0.3 pdf own",
                "brdf ward sx=0.41 sy=0.3");
    expect_same("brdf ward sx=" + map + "g * 0.5", "brdf ward sx=0.3 pdf own", "brdf ward sx=0.6");
    expect_same("brdf gltf metallic=" + map + "b roughness=" + map + "g",
                "brdf gltf metallic=0.8 roughness=0.6 pdf own", "brdf gltf metallic=0.8 roughness=0.8");
  }
  expect_same("brdf oren s=texture \"bytes.png\" a", "brdf oren s=0.2 pdf own", "brdf oren s=0.3");
  expect_same("brdf oren s=texture \"floats.exr\" a * 0.2", "brdf oren s=0.2 pdf own", "brdf oren s=0.3");
}

TEST(VaryingBrdf, DecodesColours) {
  const std::string colour = fmt::format("({}, {}, {})", decoded(102), decoded(153), decoded(204));
  expect_same("brdf diffuse kd=texture \"floats.exr\" rgb", "brdf diffuse kd=(0.4, 0.6, 0.8) pdf own",
              "brdf diffuse kd=0.6");
  expect_same("brdf diffuse kd=texture \"bytes.png\" rgb", "brdf diffuse kd=" + colour,
              "brdf diffuse kd=(0.4, 0.6, 0.8)");
  expect_same("brdf diffuse kd=texture \"floats.exr\" rgb * (1, 0.5, 0.25)",
              "brdf diffuse kd=(0.4, 0.3, 0.2) pdf own", "brdf diffuse kd=(0.4, 0.6, 0.8)");
  expect_same("brdf diffuse kd=texture \"floats.exr\" g", "brdf diffuse kd=0.6 pdf own",
              "brdf diffuse kd=0.4");
}

TEST(VaryingBrdf, GivesDefaultsThatFollowAndStaysInRanges) {
  expect_same("brdf ggx alpha=texture \"floats.exr\" r", "brdf ggx alpha=0.4 ay=0.4 pdf own",
              "brdf ggx alpha=0.4 ay=1");
  const std::string film = "brdf gltf roughness=0.4 iridescence=1 iridescenceIor=";
  expect_same(film + "texture \"floats.exr\" r * 2", film + "1 pdf own", film + "1.8");
}

// The left half is rough as 0.2, and the right one as 1: each is what a whole floor is that is so rough.
TEST(VaryingBrdf, VariesOverAFace) {
  RenderSetup setup = test::floor_setup(32, 16, 4);
  setup.eye = transport::Vec3f(0, 3, 0.01F);
  const auto of = [&](const std::string& roughness) {
    return rendered(floor_of("brdf oren r=0.5 s=" + roughness + " pdf own"), setup);
  };
  const Image varied = of("texture \"halves.png\" r");
  const Image smooth = of("0");
  const Image rough = of("1");
  for (const auto& [column, expected] : {std::pair(10, &smooth), std::pair(21, &rough)}) {
    for (int row = 6; row < 10; ++row) {
      const Rgb pixel = expected->at(column, row);
      EXPECT_NEAR((varied.at(column, row) - pixel).length(), 0, Rounding * pixel.length()) << column;
      EXPECT_GT((smooth.at(column, row) - rough.at(column, row)).length(), 0.02F * pixel.length());
    }
  }
}

// From so far that a pixel sees all texels, the parameter is their mean.
TEST(VaryingBrdf, FiltersByTheFootprint) {
  RenderSetup setup = test::floor_setup(4, 4, 16);
  setup.eye = transport::Vec3f(0, 3000, 0.01F);
  setup.field_of_view = 0.05F;
  const auto of = [&](const std::string& rough) {
    double sum = 0;
    for (const Rgb& pixel : rendered(floor_of("brdf oren r=0.5 s=" + rough + " pdf own"), setup).pixels) {
      sum += reflectance::mean(pixel);
    }
    return sum;
  };
  const double varied = of("texture \"grid.png\" r");
  EXPECT_NEAR(varied, of("0.5"), 2e-3 * varied);
  EXPECT_GT(std::abs(varied - of("0")), 1e-2 * varied);
}

// Unbiased for a texture with all roughnesses between: light sampling, scattering and MIS know the same pdf.
TEST(VaryingBrdf, IsTheSameForBothIntegrators) {
  const std::string text = floor_of(
      "brdf gltf baseColor=(0.9, 0.5, 0.2) metallic=texture \"halves.png\" r roughness=texture "
      "\"halves.png\" g "
      "clearcoat=texture \"halves.png\" b");
  RenderSetup setup = test::floor_setup(8, 8, 1024);
  setup.depth = 2;
  const CompiledScene scene = test::scene_of(text, with_images());
  std::vector<test::Estimate> estimates;
  for (const Integrator integrator : {Integrator::Path, Integrator::Naive}) {
    transport::RenderSettings settings = test::settings_of(setup);
    settings.integrator.integrator = integrator;
    settings.integrator.secondary_rays = 8;
    transport::Render render(scene, settings);
    render.run();
    estimates.push_back(test::mean_radiance(render.film()));
  }
  const double deviation = std::hypot(estimates[0].deviation, estimates[1].deviation);
  EXPECT_NEAR(estimates[0].mean, estimates[1].mean, 4 * deviation);
  EXPECT_LT(deviation, 0.01 * estimates[0].mean);
}

TEST(VaryingBrdf, ShowsInTheAlbedo) {
  const CompiledScene scene =
      test::scene_of(floor_of("brdf diffuse kd=texture \"floats.exr\" rgb"), with_images());
  const auto layers =
      transport::feature_layers(scene, test::settings_of(test::floor_setup(4, 4, 1)).view, 4, 4, 4, 0);
  EXPECT_NEAR((layers.albedo.at(2, 2) - Rgb(0.4F, 0.6F, 0.8F)).length(), 0, 1e-3);
}

TEST(VaryingBrdf, HasItsFactorsWithoutTheEffectOfTextures) {
  CompileSettings settings = with_images();
  settings.effects.remove(Effect::Textures);
  const RenderSetup setup = test::floor_setup(8, 8, 2);
  EXPECT_EQ(
      rendered(floor_of("brdf oren s=texture \"floats.exr\" r * 0.7"), setup, Integrator::Path, settings)
          .pixels,
      rendered(floor_of("brdf oren s=0.7 pdf own"), setup).pixels);
}

TEST(VaryingBrdf, RefusesSchemesWithTables) {
  const auto error_of = [](const std::string& scheme) -> std::string {
    try {
      test::scene_of(floor_of("brdf oren s=texture \"floats.exr\" r pdf " + scheme), with_images());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  };
  for (const std::string scheme : {"adaptive", "cascadeCDF", "factored", "reject"}) {
    EXPECT_NE(error_of(scheme).find("the scheme '" + scheme + "' has tables for one BRDF"), std::string::npos)
        << error_of(scheme);
  }
  for (const std::string scheme : {"own", "auto", "diffuse", "hemisphere", "sphere"})
    EXPECT_EQ(error_of(scheme), "") << scheme;
}

// Commands and tools that have no faces.
TEST(VaryingBrdf, HasItsFactorsWithoutFaces) {
  grf::Diagnostics diagnostics;
  const auto reflector = reflectance::read_instance("ward sx=texture \"a.png\" r * 0.3", diagnostics);
  ASSERT_TRUE(reflector);
  EXPECT_EQ(std::get<reflectance::Ward>(reflector->brdf()).sx, 0.3F);
  EXPECT_NE(diagnostics.to_text().find("images vary parameters of 'ward'"), std::string::npos);
}

// A mirror that an image takes away: the delta part is there where the image says so.
TEST(VaryingBrdf, VariesSpecularReflection) {
  expect_same("brdf specular ks=texture \"floats.exr\" r", "brdf specular ks=0.4 pdf own",
              "brdf specular ks=0.6");
}

}  // namespace
