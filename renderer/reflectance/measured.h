#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "renderer/reflectance/merl_table.h"
#include "renderer/reflectance/model.h"

namespace reflectance {

/// A table of measurements, and a distribution of h about the normal that follows it.
class MeasuredData {
 public:
  explicit MeasuredData(std::shared_ptr<const MerlTable> table);

  const MerlTable& table() const { return *table_; }
  float matte_albedo() const { return matte_albedo_; }  ///< estimates, of what the lobe stands on
  float lobe_albedo() const { return lobe_albedo_; }    ///< and of the lobe

  /// Of light that h reflects, which can be under the horizon.
  Vec3f lobe_direction(const Vec3f& u, const Vec2f& xi) const;
  float lobe_density(const Vec3f& u, const Vec3f& v) const;

 private:
  static constexpr std::size_t Edges = MerlTable::HalfCount + 1;

  std::shared_ptr<const MerlTable> table_;
  // 1 - cos of the rings' edges about the normal, from 0 to 1: near the normal a cosine has no digits for
  // them.
  std::array<float, Edges> versines_ = {};
  std::array<float, Edges> cumulative_ = {};  // the share of the rings up to each edge, from 0 to 1
  float matte_albedo_ = 0;
  float lobe_albedo_ = 0;
};

/// A BRDF that was measured: a file of the MERL data base, shared by all that name it. Without data it is
/// black.
struct Measured {
  bool linear = true;
  std::shared_ptr<const MeasuredData> data;

  static ModelTable<Measured> table() {
    return {
        .keyword = "measured",
        .title = "Measured data",
        .paper = "Matusik, Pfister, Brand and McMillan 2003; coordinates of Rusinkiewicz 1998",
        .parameters = {boolean_parameter(&Measured::linear, "linear",
                                         "between cells, and not the nearest cell's value")},
        .not_conserving = "as it was measured: cells at grazing angles were extrapolated",
        .takes = grf::ModelInfo::Takes::DataFile,
        .about =
            "A real material, as the gonioreflectometer of the MERL data base saw it: behind the keyword "
            "stands "
            "the name of a file of that format, `measured \"gold-paint.binary\"`. Cells without a "
            "measurement "
            "are left out between others. `bpt brdf export` makes such files of any isotropic model without "
            "a "
            "mirror part. It is sampled by the half vector, after the table itself.",
    };
  }

  template <class Real>
  Vec3<Real> evaluate(const Vec3<Real>& u, const Vec3<Real>& v) const {
    constexpr Real Horizon = Real(1e-12);
    if (!data || !(u.z > Horizon && v.z > Horizon)) return Vec3<Real>(0);
    const HalfAngles angles = half_angles(u, v);
    return Vec3<Real>(linear ? data->table().linear(angles) : data->table().nearest(angles));
  }

  bool has_diffuse_part() const { return data != nullptr; }
  bool has_glossy_part() const { return data != nullptr; }

  float albedo_estimate(const Vec3f&) const { return data ? data->matte_albedo() + data->lobe_albedo() : 0; }
  std::optional<DirectionSample> sample(const Vec3f& u, const Uniforms& xi) const;
  float density(const Vec3f& u, const Vec3f& v) const;

 private:
  float cosine_probability() const;
};

}  // namespace reflectance
