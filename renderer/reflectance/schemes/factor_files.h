#pragma once

#include <optional>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/reflectance/schemes/factors.h"

namespace reflectance {

/// The factors of a BRDF as two text files, NAME.txt with the weights of the lobes per view and NAME_cdf.txt
/// with the lobes' cdfs. Both begin with
///   granada factors 1              (or `granada factors cdf 1`: kind and version of the format)
///   brdf IDENTITY                  (see BrdfMaker::identity)
///   uTh 16 uPh 1 pTh 32 pPh 16 J 2 K 1 half false
/// where uPh is 1 for isotropic BRDFs. Then follow a line of numbers per view, theta_u running first, with
/// one number per lobe; or two lines per lobe, theta and phi, with one number per cell edge. The last line is
/// `end`. Numbers have all their digits, so that they read back exactly.
struct FactorFiles {
  std::string name;           ///< a path, without the suffix of each file
  std::string brdf_identity;  ///< the identity that the files must have
  FactorSize size;

  std::string weights_path() const { return name + ".txt"; }
  std::string curves_path() const { return name + "_cdf.txt"; }

  /// Returns true if at least one of the two files exists.
  bool exist() const;

  /// Loads the factors, or returns nothing after an error: a missing or broken file, another BRDF or size.
  std::optional<Factors> load(grf::Diagnostics& diagnostics) const;

  /// Writes both files, or reports an error.
  bool save(const Factors& factors, grf::Diagnostics& diagnostics) const;
};

}  // namespace reflectance
