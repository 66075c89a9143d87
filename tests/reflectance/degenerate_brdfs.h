#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "renderer/reflectance/halton.h"
#include "renderer/reflectance/reflector.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"

namespace test {

/// Samples BRDFs that are black, a mirror, or a lobe narrower than any cell, and expects finite weights >= 0.
inline void expect_defined_for_degenerate_brdfs(const std::string& scheme) {
  for (const std::string brdf : {"diffuse kd=0", "specular", "lewis n=100000", "lafortune n=1000000"}) {
    const reflectance::Reflector subject(brdf_of(brdf), scheme_of(scheme));
    for (std::uint32_t i = 0; i < 1000; ++i) {
      const auto drawn =
          subject.sample(direction(i % 3 == 0 ? 89.99 : 30.0 * (i % 3), i), reflectance::halton_point(i));
      if (!drawn) continue;
      for (int k = 0; k < 3; ++k) {
        ASSERT_TRUE(std::isfinite(drawn->weight[k]) && drawn->weight[k] >= 0) << scheme << " / " << brdf;
      }
    }
  }
}

}  // namespace test
