// Nanoseconds that each BRDF model takes to be evaluated and sampled, with its default parameters.
#include <random>

#include <benchmark/benchmark.h>

#include "renderer/reflectance/reflector.h"
#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::Reflector;
using reflectance::Rgb;
using reflectance::Uniforms;
using reflectance::Vec3f;

constexpr std::size_t Count =
    4096;  // fits the first-level cache, and is no pattern that a branch predictor learns

struct Inputs {
  std::vector<Vec3f> u, v;
  std::vector<Uniforms> xi;
};

Inputs random_inputs() {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  Inputs inputs;
  for (std::size_t i = 0; i < Count; ++i) {
    inputs.u.push_back(reflectance::cosine_direction({uniform(random), uniform(random)}));
    inputs.v.push_back(reflectance::cosine_direction({uniform(random), uniform(random)}));
    inputs.xi.push_back({{uniform(random), uniform(random)}, uniform(random)});
  }
  return inputs;
}

/// A model with its default parameters; what is made of data or of others, of an example.
std::string instance_of(const grf::ModelInfo& model) {
  switch (model.takes) {
    case grf::ModelInfo::Takes::DataFile:
      return "table of torrance rough=0.3";
    case grf::ModelInfo::Takes::Terms:
      return "0.5 diffuse + 0.3 ward sx=0.1 + 0.2 phong";
    case grf::ModelInfo::Takes::Parameters:
      break;
  }
  return std::string(model.keyword);
}

void evaluate(benchmark::State& state, const std::string& instance) {
  const Reflector reflector(test::brdf_of(instance), reflectance::OwnScheme());
  const Inputs inputs = random_inputs();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reflector.evaluate(inputs.u[i], inputs.v[i]));
    i = (i + 1) % Count;
  }
}

void sample(benchmark::State& state, const std::string& instance) {
  const Reflector reflector(test::brdf_of(instance), reflectance::OwnScheme());
  const Inputs inputs = random_inputs();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reflector.sample(inputs.u[i], inputs.xi[i]));
    i = (i + 1) % Count;
  }
}

const bool Registered = [] {
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    const std::string keyword(model.keyword);
    benchmark::RegisterBenchmark(("evaluate/" + keyword).c_str(), evaluate, instance_of(model));
    benchmark::RegisterBenchmark(("sample/" + keyword).c_str(), sample, instance_of(model));
  }
  return true;
}();

}  // namespace
