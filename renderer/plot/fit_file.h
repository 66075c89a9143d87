// FIT files: a cloud of directions over a BRDF, for one view (the thesis' section 6.2.4).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/math.h"
#include "grf/model.h"

namespace plot {

/// A direction, as long as it may be, with some magnitude of interest: the BRDF there, or a density.
struct FitPoint {
  grf::Vec3f direction;
  float value = 0;

  bool operator==(const FitPoint&) const = default;
};

/// As text it is an instance in GRF, `viewer (theta, phi)`, and between the words `begin` and `end` the
/// points, `(x, y, z) value` each:
///
///   ward sx=0.1
///   viewer (1.2, 0)
///   begin
///   (0.34, -0.33, 0.88) 1
///   end
///
/// White space is free, keywords have any case, and `//` starts a comment, as in GRF.
struct FitFile {
  grf::BrdfModel brdf;  ///< no `combine`; a file of data is relative to the FIT file's folder
  float theta = 0;      ///< of the view, radians from the normal
  float phi = 0;        ///< radians from the x axis
  std::vector<FitPoint> points;

  bool operator==(const FitFile&) const = default;
};

/// Numbers have the fewest digits that read back, and must be finite.
std::string to_text(const FitFile& file);

/// Reads the text of a FIT file; the path stands for it in messages. After an error, nothing. A phi over a
/// full turn is kept as it is, with a warning: it may be in degrees, as it seems to be in the thesis'
/// example, whose theta is in radians.
std::optional<FitFile> read_fit(const std::string& text, const std::string& path,
                                grf::Diagnostics& diagnostics);

}  // namespace plot
