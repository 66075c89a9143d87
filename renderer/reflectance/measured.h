#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "renderer/reflectance/measurements/measured_formats.h"
#include "renderer/reflectance/merl_table.h"
#include "renderer/reflectance/model.h"

namespace reflectance {

/// A table of measured values, with a distribution of h about the normal for importance sampling.
class MeasuredData {
 public:
  explicit MeasuredData(MeasuredTable table);

  /// Returns the table of a file of the MERL data base; null for other files.
  const MerlTable* merl() const { return merl_; }

  /// Evaluates f(u, v) in 1/sr of directions above the horizon, interpolated or at the nearest entry.
  /// Negative channels are 0.
  Rgb value(const Imath::V3d& u, const Imath::V3d& v, bool interpolates) const;
  DataState state(const Imath::V3d& u, const Imath::V3d& v) const;
  bool is_anisotropic() const;

  float diffuse_albedo() const { return diffuse_albedo_; }  ///< estimated albedo of the diffuse floor
  float lobe_albedo() const { return lobe_albedo_; }        ///< estimated albedo of the lobe above it

  /// Samples a direction by reflecting u at a sampled h; it can be below the horizon.
  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const;
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const;

 private:
  static constexpr std::size_t Edges = MerlTable::HalfCount + 1;

  float mean_of_ring(std::size_t ring) const;

  MeasuredTable table_;
  const MerlTable* merl_ = nullptr;
  // 1 - cos of the rings' edges about the normal, from 0 to 1: near the normal a cosine lacks the digits.
  std::array<float, Edges> versines_ = {};
  std::array<float, Edges> cumulative_ = {};  // cdf at the rings' edges, from 0 to 1
  float diffuse_albedo_ = 0;
  float lobe_albedo_ = 0;
};

/// A measured BRDF: a file of one of `measured_formats`, shared by all that name it. Without data it is
/// black.
struct Measured {
  using Data = MeasuredData;

  bool linear = true;
  std::shared_ptr<const MeasuredData> data;

  static ModelTable<Measured> table() {
    return {
        .keyword = "measured",
        .title = "Measured data",
        .paper =
            "Matusik, Pfister, Brand and McMillan 2003; Filip and Vavra 2014; ASTM E1392; coordinates "
            "of Rusinkiewicz 1998; interpolation of Franke and Nielson 1980",
        .parameters = {boolean_parameter(&Measured::linear, "linear",
                                         "interpolate between cells instead of taking the nearest")},
        .not_isotropic = "isotropic if the file is",
        .not_reciprocal = "reciprocal if the file is of MERL, ASTM or CSV; others as measured",
        .not_conserving = "as measured: cells at grazing angles were extrapolated",
        .argument_kind = grf::ModelInfo::ArgumentKind::DataFile,
        .description =
            "A measured material: the keyword is followed by the name of a file, `measured "
            "\"gold-paint.binary\"`, whose format is found by its content. MERL's table is isotropic; "
            "interpolation skips cells without a measurement, and `bpt brdf export` writes such files for "
            "any "
            "isotropic model without a delta part. UTIA's `.bin` is anisotropic, every 15 degrees from the "
            "normal and 7.5 around it; beyond 75 degrees it is extrapolated, as by its own reader. Text "
            "files `.bsdf` of Zemax (BSDF Data Interchange) and LightTools are tables over the angles about "
            "the mirror direction or the normal, linear between them and constant beyond. Texts of ASTM "
            "E1392 and CSV files list values at any directions: those are interpolated by the modified "
            "method of Shepard among the eight nearest in half-angle coordinates. The incident direction is "
            "that of the light v. Half vectors are importance-sampled by their angle from the normal. Files "
            "of the RGL data base are read by `rgl`.",
    };
  }

  /// Loads a file, or returns nothing after an error.
  static std::shared_ptr<const MeasuredData> load(const std::string& path, grf::Diagnostics& diagnostics,
                                                  const grf::SourceLocation& asked_for_at);

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    constexpr Real Horizon = Real(1e-12);
    if (!data || !(u.z > Horizon && v.z > Horizon)) return Vec3<Real>(0);
    if (data->merl() == nullptr) return Vec3<Real>(data->value(Imath::V3d(u), Imath::V3d(v), linear));
    const HalfAngles angles = half_angles(u, v);
    return Vec3<Real>(linear ? data->merl()->linear(angles) : data->merl()->nearest(angles));
  }

  DataState data_state(const Vec3f& u, const Vec3f& v) const {
    return data ? data->state(Imath::V3d(u), Imath::V3d(v)) : DataState::Sound;
  }

  bool has_diffuse_part() const { return data != nullptr; }
  bool has_glossy_part() const { return data != nullptr; }
  bool is_anisotropic() const { return data && data->is_anisotropic(); }

  float albedo_estimate(const Vec3f&) const {
    return data ? data->diffuse_albedo() + data->lobe_albedo() : 0;
  }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const;
  float pdf(const Vec3f& u, const Vec3f& v) const;

 private:
  float cosine_probability() const;
};

}  // namespace reflectance
