// A FIT file is a point cloud of directions over a BRDF, for one view (the thesis' section 6.2.4).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/model.h"

namespace plot {

/// A direction of any length with a value, such as the BRDF or a pdf.
struct FitPoint {
  grf::Vec3f direction;
  float value = 0;

  bool operator==(const FitPoint&) const = default;
};

/// A FIT file. As text it is a BRDF instance in GRF, `viewer (theta, phi)`, and the points, `(x, y, z) value`
/// each, between the words `begin` and `end`:
///
///   ward sx=0.1
///   viewer (1.2, 0)
///   begin
///   (0.34, -0.33, 0.88) 1
///   end
///
/// White space is free, keywords have any case, and `//` starts a comment, as in GRF.
struct FitFile {
  grf::BrdfModel brdf;  ///< no `combine`; data files are relative to the FIT file's folder
  float theta = 0;      ///< view angle to the normal, radians
  float phi = 0;        ///< view azimuth from the x axis, radians
  std::vector<FitPoint> points;

  bool operator==(const FitFile&) const = default;
};

/// Formats a FIT file. Numbers have the fewest digits that read back, and must be finite.
std::string to_text(const FitFile& file);

/// Parses a FIT file; messages use the path. Returns nothing after an error. A phi beyond a full turn is kept
/// with a warning: it may be in degrees, as it seems to be in the thesis' example, whose theta is in radians.
std::optional<FitFile> read_fit(const std::string& text, const std::string& path,
                                grf::Diagnostics& diagnostics);

}  // namespace plot
