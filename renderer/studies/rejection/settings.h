#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/reflectance/model.h"
#include "renderer/studies/rejection/disc.h"
#include "renderer/studies/study.h"

namespace studies {

/// The settings of the study of rejection sampling.
struct RejectionToolSettings {
  enum BoundKind { Exact, Grid, Hand };

  float samples = 2000;
  int bound = Exact;
  float factor = 0.5F;
  float cells = 100;
  float tail = 0.1F;
  int region = 0;
  float nmax = 2;
  float seed = 1;

  static reflectance::ModelTable<RejectionToolSettings> table();

  int cell_count() const { return static_cast<int>(std::lround(cells)); }
  std::uint32_t seed_number() const { return static_cast<std::uint32_t>(std::lround(seed)); }
  Region region_of_tries() const { return region == 0 ? Region::Disc : Region::Square; }
  RunLimits limits(const StudyContext& context) const {
    return {static_cast<std::size_t>(std::lround(samples)), context.is_stopped};
  }
  /// Returns the bound that is chosen. The exact maximum may be infinite.
  double chosen_bound(double exact, double grid) const {
    return bound == Grid ? grid : bound == Hand ? factor * exact : exact;
  }
};

/// The view of the row `brdf` of the distributions.
struct BrdfView {
  float theta = 45;
  float phi = 0;

  static reflectance::ModelTable<BrdfView> table();
};

// Each returns nothing after an error.
std::optional<Study> interval_study(const ToolState& state, const RejectionToolSettings& settings,
                                    const StudyContext& context, grf::Diagnostics& diagnostics);
std::optional<Study> disc_study(const ToolState& state, const RejectionToolSettings& settings,
                                const StudyContext& context, grf::Diagnostics& diagnostics);

}  // namespace studies
