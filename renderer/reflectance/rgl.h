#pragma once

#include <memory>
#include <optional>
#include <string>

#include "renderer/reflectance/model.h"
#include "renderer/reflectance/rgl_data.h"

namespace reflectance {

/// A measured BRDF: a file of the RGL data base, shared by all that name it. Without data it is black.
struct Rgl {
  using Data = RglData;

  std::shared_ptr<const RglData> data;

  static ModelTable<Rgl> table() {
    return {
        .keyword = "rgl",
        .title = "Measured data, adaptive and spectral",
        .paper = "Dupuy and Jakob 2018; observer of Wyman, Sloan and Shirley 2013",
        .not_isotropic = "isotropic if the file is",
        .not_reciprocal = "as measured: interpolated by the angles of u",
        .not_conserving = "as measured and interpolated",
        .argument_kind = grf::ModelInfo::ArgumentKind::DataFile,
        .description =
            "A measured material in the format of the RGL data base, isotropic or anisotropic, spectral or "
            "RGB: the keyword is followed by the name of a file, `rgl \"satin-purple.bsdf\"`. The view u is "
            "what its tables call the incident direction. Spectra become linear sRGB as the CIE 1931 "
            "observer sees them under light of equal energy, balanced to white: a reflectance of 1 at all "
            "wavelengths is (1, 1, 1). Negative channels, of colours beyond sRGB, are 0. Directions are "
            "importance-sampled from the file's own tables, and one in ten by the cosine.",
    };
  }

  /// Loads a file, or returns nothing after an error.
  static std::shared_ptr<const RglData> load(const std::string& path, grf::Diagnostics& diagnostics,
                                             const grf::SourceLocation& asked_for_at) {
    return RglData::load(path, diagnostics, asked_for_at);
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    return data ? Vec3<Real>(data->evaluate(Imath::V3d(u), Imath::V3d(v))) : Vec3<Real>(0);
  }

  DataState data_state(const Vec3f& u, const Vec3f& v) const {
    return data && data->is_negative(Imath::V3d(u), Imath::V3d(v)) ? DataState::Negative : DataState::Sound;
  }

  bool has_diffuse_part() const { return data != nullptr; }
  bool has_glossy_part() const { return data != nullptr; }
  bool is_anisotropic() const { return data && !data->is_isotropic(); }

  float albedo_estimate(const Vec3f& u) const { return data ? data->albedo(u) : 0; }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const;
  float pdf(const Vec3f& u, const Vec3f& v) const { return reflect(u, v).pdf; }

  /// Evaluates the BRDF and the pdf together, which share most of their work.
  Reflection reflect(const Vec3f& u, const Vec3f& v) const;
};

}  // namespace reflectance
