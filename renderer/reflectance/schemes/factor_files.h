#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/reflectance/schemes/factors.h"

namespace reflectance {

/// The factors of a BRDF as two text files, NAME.txt with the weights of the lobes for each view and
/// NAME_cdf.txt with the lobes' cumulative distributions. Both begin with
///   granada factors 1              (or `granada factors cdf 1`: what it is, and the format's version)
///   brdf IDENTITY                  (see BrdfMaker::identity)
///   uTh 16 uPh 1 pTh 32 pPh 16 J 2 K 1 half false
/// uPh being 1 for isotropic BRDFs. Then a line of numbers for each view, theta_u running first, with one
/// for each lobe; or for each lobe a line for theta and one for phi, with one for each edge of a cell. The
/// last line is `end`. Numbers have all their digits, so that what is read is what was written.
struct FactorFiles {
  std::string name;           ///< a path, without what is added for each file
  std::string brdf_identity;  ///< what must stand in the files
  FactorSize size;

  std::string weights_path() const { return name + ".txt"; }
  std::string curves_path() const { return name + "_cdf.txt"; }

  /// Whether there is one of the two.
  bool exist() const;

  /// The factors, or nothing after an error: a file is missing or broken, or its BRDF or sizes are others.
  std::optional<Factors> load(grf::Diagnostics& diagnostics) const;

  /// Writes both files, or says why not.
  bool save(const Factors& factors, grf::Diagnostics& diagnostics) const;
};

}  // namespace reflectance
