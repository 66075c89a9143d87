#pragma once

#include <cstddef>
#include <vector>

#include "renderer/reflectance/geometry.h"

namespace reflectance {

/// The angles at which values are tabulated, in radians and ascending along each axis. The light v is the
/// incident direction, and the view u the scattered one.
struct GridAxes {
  /// What the angles of the scattered direction are about.
  enum class Pole {
    Normal,
    Mirror  ///< the mirror direction of the light; azimuth 0 leads from there to the normal
  };

  std::vector<double> incidence;  ///< of the light from the normal
  std::vector<double> rotation;   ///< azimuths of the light; one: the values are isotropic
  std::vector<double> polar;      ///< of the view from the pole
  /// Of the view around the pole, counter-clockwise seen from above. Around the normal they are counted from
  /// the light if the values are isotropic, and else from the x axis.
  std::vector<double> azimuth;
  Pole pole = Pole::Normal;
  bool is_mirrored = false;   ///< azimuths are 0 to pi, and the plane of incidence is one of symmetry
  bool extrapolates = false;  ///< values beyond the last angles from the normal are linear, else constant
};

/// A table of measured values over the angles of both directions, interpolated linearly along each of them.
class AngleGrid {
 public:
  /// The values are in 1/sr, with the last of incidence, rotation, azimuth and polar fastest. There must be
  /// one for each combination of angles, and at least one angle along each axis.
  AngleGrid(GridAxes axes, std::vector<Rgb> values);

  /// Interpolates between the nearest angles along each axis. Channels can be negative.
  Rgb linear(const Imath::V3d& u, const Imath::V3d& v) const;
  /// Returns the value at the nearest angle along each axis.
  Rgb nearest(const Imath::V3d& u, const Imath::V3d& v) const;

  bool is_anisotropic() const { return axes_.rotation.size() > 1; }

 private:
  /// An interpolation position between two indices of an axis.
  struct Place {
    std::size_t lower = 0;
    std::size_t upper = 0;
    double fraction = 0;  ///< of the way to the upper one; below 0 or over 1 if values are extrapolated
    std::size_t nearest() const { return fraction < 0.5 ? lower : upper; }
  };
  struct Places {
    Place incidence, rotation, azimuth, polar;
  };
  static Place place_between(const std::vector<double>& nodes, double angle, bool extrapolates);
  static Place place_around(const std::vector<double>& nodes, double angle);
  Places places_of(const Imath::V3d& u, const Imath::V3d& v) const;
  const Rgb& value(std::size_t incidence, std::size_t rotation, std::size_t azimuth,
                   std::size_t polar) const {
    return values_[polar +
                   axes_.polar.size() *
                       (azimuth + axes_.azimuth.size() * (rotation + axes_.rotation.size() * incidence))];
  }

  GridAxes axes_;
  std::vector<Rgb> values_;
};

}  // namespace reflectance
