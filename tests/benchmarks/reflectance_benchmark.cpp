// The time in nanoseconds of evaluating and sampling each BRDF model with its default parameters.
#include <benchmark/benchmark.h>

#include "renderer/reflectance/reflector.h"
#include "tests/benchmarks/random_inputs.h"
#include "tests/reflectance/brdf_cases.h"

namespace {

using reflectance::Reflector;
using reflectance::Rgb;

/// A model with its default parameters, or an example if it is made from data or other models.
std::string instance_of(const grf::ModelInfo& model) {
  switch (model.argument_kind) {
    case grf::ModelInfo::ArgumentKind::DataFile:
      return model.keyword == "rgl" ? "rgl brushed" : "table of torrance rough=0.3";
    case grf::ModelInfo::ArgumentKind::Layers:
      return model.keyword == "coat" ? "coat over diffuse" : "torrance over diffuse";
    case grf::ModelInfo::ArgumentKind::Terms:
      return "0.5 diffuse + 0.3 ward sx=0.1 + 0.2 phong";
    case grf::ModelInfo::ArgumentKind::Parameters:
      break;
  }
  return std::string(model.keyword);
}

void evaluate(benchmark::State& state, const std::string& instance) {
  const Reflector reflector(test::brdf_of(instance), reflectance::OwnScheme());
  const test::RandomInputs inputs;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reflector.evaluate(inputs.u[i], inputs.v[i]));
    i = (i + 1) % inputs.u.size();
  }
}

void sample(benchmark::State& state, const std::string& instance) {
  const Reflector reflector(test::brdf_of(instance), reflectance::OwnScheme());
  const test::RandomInputs inputs;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reflector.sample(inputs.u[i], inputs.xi[i]));
    i = (i + 1) % inputs.u.size();
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
