#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf.h"

namespace reflectance {

/// Makes the BRDFs that a scene describes. Each file of measurements is loaded once.
class BrdfMaker {
 public:
  explicit BrdfMaker(grf::Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// The BRDF, whose names mean what they mean in that scope, or nothing after an error.
  std::optional<Brdf> make(const grf::BrdfModel& data, const grf::Scope& scope);

  /// What a sum adds up, without sums, or the model itself; those of weight 0 are left out. Reads no data.
  std::vector<const grf::BrdfModel*> models_of(const grf::BrdfModel& data, const grf::Scope& scope);

  /// The paths of the files that a BRDF is made of.
  std::vector<std::string> data_files_of(const grf::BrdfModel& data, const grf::Scope& scope);

  /// A text that is the same for the same BRDFs.
  std::string identity(const grf::BrdfModel& data, const grf::Scope& scope);

 private:
  std::optional<Brdf> make_summand(const grf::BrdfModel& data);
  std::shared_ptr<const MeasuredData> measured(const grf::BrdfModel& data);

  grf::Diagnostics& diagnostics_;
  std::map<std::string, std::shared_ptr<const MeasuredData>> measured_;  // by canonical path
};

}  // namespace reflectance
