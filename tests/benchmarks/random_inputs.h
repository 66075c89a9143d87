#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include "renderer/reflectance/model.h"

namespace test {

/// Random directions and numbers for BRDFs and sampling schemes: few enough for the L2 cache, in no pattern
/// that a branch predictor learns.
struct RandomInputs {
  std::vector<reflectance::Vec3f> u, v;
  std::vector<reflectance::Uniforms> xi;

  RandomInputs() {
    constexpr std::size_t Count = 4096;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (std::size_t i = 0; i < Count; ++i) {
      u.push_back(reflectance::cosine_direction({uniform(random), uniform(random)}));
      v.push_back(reflectance::cosine_direction({uniform(random), uniform(random)}));
      xi.push_back({{uniform(random), uniform(random)}, uniform(random)});
    }
  }
};

}  // namespace test
