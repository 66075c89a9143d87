#include "converters/renderers/written_material.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "renderer/image/image.h"
#include "renderer/reflectance/rgl_export.h"
#include "renderer/reflectance/scheme.h"

namespace convert {
namespace {

using reflectance::Rgb;
using Base = WrittenMaterial::Base;

bool is_grey(const grf::Colour& colour) { return colour.x == colour.y && colour.x == colour.z; }

/// A view direction at this cosine of the angle from the normal.
reflectance::Vec3f view_at(float cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

/// Returns the facets of a `ggx` that is a pbrt `conductor`, whatever its colours are.
std::optional<ConductorFacets> conductor_of(const reflectance::Brdf& brdf, const grf::Colour& colour) {
  constexpr int SingleScattering = 2;
  const auto* ggx = std::get_if<reflectance::Ggx>(&brdf);
  if (ggx == nullptr || ggx->scattering != SingleScattering || ggx->ks * colour != Rgb(1)) return {};
  if (ggx->alpha != ggx->ay || ggx->anisotropy != 0 || ggx->f0 != Rgb(0)) return {};
  if (!is_grey(ggx->nreal) || !is_grey(ggx->nimag)) return {};
  return ConductorFacets{double(ggx->alpha), double(ggx->nreal.x), double(ggx->nimag.x)};
}

/// Returns an image with each pixel multiplied by a colour; negative and non-finite channels count as 0.
void multiply(image::Image& image, const grf::Colour& colour) {
  for (grf::Colour& pixel : image.pixels) {
    for (int k = 0; k < 3; ++k) pixel[k] = std::isfinite(pixel[k]) ? std::max(0.0F, pixel[k]) * colour[k] : 0;
  }
}

/// Makes the colours those of what is opaque.
void divide_by_alpha(image::Image& image) {
  for (std::size_t i = 0; i < image.alpha.size(); ++i) {
    if (image.alpha[i] > 0) image.pixels[i] /= image.alpha[i];
  }
  image.alpha = {};
}

grf::Colour mean_of(const image::Image& image) {
  grf::Vec3d sum(0);
  for (const grf::Colour& pixel : image.pixels) sum += grf::Vec3d(pixel);
  return grf::Colour(sum / double(std::max<std::size_t>(1, image.pixels.size())));
}

/// Writes one material.
class MaterialWriter {
 public:
  MaterialWriter(const RenderMaterial& material, const MaterialTarget& target, SceneFolder& folder,
                 Losses& losses, grf::Diagnostics& diagnostics)
      : material_(material),
        target_(target),
        folder_(folder),
        losses_(losses),
        diagnostics_(diagnostics),
        colour_(material.colour) {}

  std::optional<WrittenMaterial> write();

 private:
  bool take_texture();
  std::optional<WrittenMaterial> write_glass(const reflectance::Glass& glass);
  bool write_diffuse(const grf::Colour& reflectance);
  bool write_table(const grf::Colour& colour);

  const RenderMaterial& material_;
  const MaterialTarget& target_;
  SceneFolder& folder_;
  Losses& losses_;
  grf::Diagnostics& diagnostics_;
  grf::Colour colour_;                 ///< factor of the BRDF
  std::optional<image::Image> image_;  ///< factor of a diffuse BRDF
  WrittenMaterial written_;
};

// The texture of a BRDF that is tabulated counts with its mean.
bool MaterialWriter::take_texture() {
  if (material_.texture.empty()) return true;
  const auto alpha = material_.reads_alpha ? image::Alpha::Kept : image::Alpha::OverBlack;
  image_ = image::read_image(material_.texture, diagnostics_, {}, alpha);
  if (!image_) return false;
  divide_by_alpha(*image_);
  if (std::holds_alternative<reflectance::Diffuse>(material_.brdf)) return true;
  multiply(*image_, grf::Colour(1));
  colour_ *= mean_of(*image_);
  image_.reset();
  losses_.add(Loss::BrdfTexture, material_.faces);
  return true;
}

bool MaterialWriter::write_diffuse(const grf::Colour& reflectance) {
  written_.base = Base::Diffuse;
  written_.reflectance = reflectance;
  written_.has_vertex_colours = material_.has_vertex_colours;
  if (!image_) return true;
  multiply(*image_, reflectance);
  written_.image = folder_.add_image("reflectance", *std::move(image_), diagnostics_);
  return !written_.image.empty();
}

// Tables of anisotropic BRDFs have two dimensions of views, so that finer ones would be too large.
bool MaterialWriter::write_table(const grf::Colour& colour) {
  written_.base = Base::Measured;
  written_.is_anisotropic = reflectance::is_anisotropic(material_.brdf);
  reflectance::RglExportSettings settings;
  settings.colours = target_.colours;
  settings.largest_error = 0.01;
  settings.finest = written_.is_anisotropic ? 1 : 2.25;
  settings.colour = colour;
  settings.description = fmt::format("made by Granada of {}", material_.name);
  const reflectance::Reflector reflector(material_.brdf, reflectance::OwnScheme());
  const reflectance::RglExport table = reflectance::export_rgl(reflector, settings);
  const SceneFolder::Name name = folder_.next("material", "bsdf", diagnostics_);
  if (name.path.empty() || !grf::replace_file(name.path, table.bytes, diagnostics_)) return false;
  written_.table = name.in_scene;
  written_.table_error = table.error.relative;
  losses_.add(Loss::BrdfFormula, material_.faces);
  return true;
}

std::optional<WrittenMaterial> MaterialWriter::write_glass(const reflectance::Glass& glass) {
  written_.base = Base::Glass;
  written_.index = double(glass.ior);
  written_.is_pane = glass.thin;
  if (glass.thin) written_.pane_colour = glass.colour * colour_;
  const bool keeps_colour = glass.thin && target_.has_pane_colour;
  const bool is_clear = glass.colour * colour_ == grf::Colour(1) && material_.texture.empty();
  if (!keeps_colour && !is_clear) losses_.add(Loss::GlassColour, material_.faces);
  return written_;
}

std::optional<WrittenMaterial> MaterialWriter::write() {
  if (colour_ == grf::Colour(0)) return written_;
  if (const auto* glass = std::get_if<reflectance::Glass>(&material_.brdf)) return write_glass(*glass);
  if (!take_texture()) return std::nullopt;
  const MirrorPart mirror = mirror_of(material_.brdf, colour_);
  if (mirror.varies) losses_.add(Loss::MirrorFresnel, material_.faces);
  written_.mirror_share = mirror.share;
  written_.mirror = mirror.reflectance;
  if (!reflectance::has_nonspecular_part(material_.brdf) || mirror.share >= 1) return written_;
  const auto* diffuse = std::get_if<reflectance::Diffuse>(&material_.brdf);
  if (diffuse != nullptr && reflectance::largest(diffuse->kd * colour_) <= 1) {
    return write_diffuse(diffuse->kd * colour_) ? std::optional(written_) : std::nullopt;
  }
  if (const auto facets = conductor_of(material_.brdf, colour_); facets && target_.has_ggx_conductor) {
    written_.base = Base::Conductor;
    written_.facets = *facets;
    return written_;
  }
  const auto rest = static_cast<float>(1 - mirror.share);
  return write_table(colour_ / rest) ? std::optional(written_) : std::nullopt;
}

}  // namespace

MirrorPart mirror_of(const reflectance::Brdf& brdf, const grf::Colour& colour) {
  if (!reflectance::has_specular_part(brdf)) return {};
  constexpr int Count = 64;
  const Rgb at_normal = reflectance::specular_weight(brdf, view_at(1));
  MirrorPart mirror;
  grf::Vec3d sum(0);
  for (int i = 0; i < Count; ++i) {
    const float squared_cosine = (static_cast<float>(i) + 0.5F) / Count;
    const Rgb weight = reflectance::specular_weight(brdf, view_at(std::sqrt(squared_cosine)));
    mirror.varies = mirror.varies || (weight - at_normal).length() > 1e-4F;
    sum += grf::Vec3d(weight);
  }
  const Rgb mean = colour * (mirror.varies ? Rgb(sum / Count) : at_normal);
  // Something has to be left for the base, where there is one.
  const float most = reflectance::has_nonspecular_part(brdf) ? 0.95F : 1.0F;
  const float share = std::min(most, reflectance::largest(mean));
  if (!(share > 0)) return mirror;
  mirror.share = double(share);
  for (int k = 0; k < 3; ++k) mirror.reflectance[k] = std::min(1.0F, mean[k] / share);
  return mirror;
}

std::optional<WrittenMaterial> write_material(const RenderMaterial& material, const MaterialTarget& target,
                                              SceneFolder& folder, Losses& losses,
                                              grf::Diagnostics& diagnostics) {
  return MaterialWriter(material, target, folder, losses, diagnostics).write();
}

}  // namespace convert
