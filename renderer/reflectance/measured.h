#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "renderer/reflectance/merl_table.h"
#include "renderer/reflectance/model.h"

namespace reflectance {

/// A table of measured values, with a distribution of h about the normal for importance sampling.
class MeasuredData {
 public:
  explicit MeasuredData(std::shared_ptr<const MerlTable> table);

  const MerlTable& table() const { return *table_; }
  float diffuse_albedo() const { return diffuse_albedo_; }  ///< estimated albedo of the diffuse floor
  float lobe_albedo() const { return lobe_albedo_; }        ///< estimated albedo of the lobe above it

  /// Samples a direction by reflecting u at a sampled h; it can be below the horizon.
  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const;
  float lobe_pdf(const Vec3f& u, const Vec3f& v) const;

 private:
  static constexpr std::size_t Edges = MerlTable::HalfCount + 1;

  std::shared_ptr<const MerlTable> table_;
  // 1 - cos of the rings' edges about the normal, from 0 to 1: near the normal a cosine lacks the digits.
  std::array<float, Edges> versines_ = {};
  std::array<float, Edges> cumulative_ = {};  // cdf at the rings' edges, from 0 to 1
  float diffuse_albedo_ = 0;
  float lobe_albedo_ = 0;
};

/// A measured BRDF: a file of the MERL data base, shared by all that name it. Without data it is black.
struct Measured {
  using Data = MeasuredData;

  bool linear = true;
  std::shared_ptr<const MeasuredData> data;

  static ModelTable<Measured> table() {
    return {
        .keyword = "measured",
        .title = "Measured data",
        .paper = "Matusik, Pfister, Brand and McMillan 2003; coordinates of Rusinkiewicz 1998",
        .parameters = {boolean_parameter(&Measured::linear, "linear",
                                         "interpolate between cells instead of taking the nearest")},
        .not_conserving = "as measured: cells at grazing angles were extrapolated",
        .argument_kind = grf::ModelInfo::ArgumentKind::DataFile,
        .description =
            "A measured material in the format of the MERL data base: the keyword is followed by the name of "
            "a file, `measured \"gold-paint.binary\"`. Interpolation skips cells without a measurement. `bpt "
            "brdf export` writes such files for any isotropic model without a delta part. Its half vectors "
            "are importance-sampled from the table.",
    };
  }

  /// Loads a file, or returns nothing after an error.
  static std::shared_ptr<const MeasuredData> load(const std::string& path, grf::Diagnostics& diagnostics,
                                                  const grf::SourceLocation& asked_for_at);

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    constexpr Real Horizon = Real(1e-12);
    if (!data || !(u.z > Horizon && v.z > Horizon)) return Vec3<Real>(0);
    const HalfAngles angles = half_angles(u, v);
    return Vec3<Real>(linear ? data->table().linear(angles) : data->table().nearest(angles));
  }

  DataState data_state(const Vec3f& u, const Vec3f& v) const {
    return data && data->table().is_missing(half_angles(u, v)) ? DataState::Missing : DataState::Sound;
  }

  bool has_diffuse_part() const { return data != nullptr; }
  bool has_glossy_part() const { return data != nullptr; }

  float albedo_estimate(const Vec3f&) const {
    return data ? data->diffuse_albedo() + data->lobe_albedo() : 0;
  }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const;
  float pdf(const Vec3f& u, const Vec3f& v) const;

 private:
  float cosine_probability() const;
};

}  // namespace reflectance
