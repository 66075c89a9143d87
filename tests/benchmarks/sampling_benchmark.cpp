// What sampling schemes take: seconds to build the tables of a BRDF, nanoseconds to draw a sample with its
// density and weight (so with the BRDF's value, which reflectance_benchmark times alone), and to know a
// density. Each scheme, as it is and without a cosine part, on each BRDF.
#include <random>

#include <benchmark/benchmark.h>

#include "renderer/reflectance/scheme.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"

namespace {

using reflectance::Brdf;
using reflectance::Scheme;
using reflectance::Uniforms;
using reflectance::Vec3f;

const std::vector<std::string> Schemes = {
    "auto",       "diffuse",
    "factored",   "factored pTh=100 pPh=32 J=2 K=2 half=true",
    "cascadeCDF", "cascadeCDF compress=true",
};

const std::vector<std::string> Brdfs = {
    "oren s=0 r=1",
    "lewis n=100 ks=1 kd=0",
    "ward sx=0.2 ks=0.5 kd=0.5",
    "ward sx=0.15 sy=0.4 ks=0.6 kd=0.3",
    "table of torrance rough=0.3",
};

constexpr std::size_t Count =
    4096;  // fits the second-level cache, and is no pattern that a branch predictor learns

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

void build(benchmark::State& state, const std::string& scheme_text, const std::string& brdf_text) {
  const Brdf brdf = test::brdf_of(brdf_text);
  Scheme scheme = test::scheme_of(scheme_text);
  for (auto _ : state) reflectance::build(scheme, brdf);
  state.counters["KB"] = static_cast<double>(reflectance::bytes(scheme)) / 1024;
}

void sample(benchmark::State& state, const std::string& scheme_text, const std::string& brdf_text) {
  const Brdf brdf = test::brdf_of(brdf_text);
  Scheme scheme = test::scheme_of(scheme_text);
  reflectance::build(scheme, brdf);
  const Inputs inputs = random_inputs();
  double sum = 0;
  double squares = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    const auto drawn = reflectance::sample(scheme, brdf, inputs.u[i % Count], inputs.xi[i % Count]);
    benchmark::DoNotOptimize(drawn);
    const double weight = drawn ? reflectance::mean(drawn->weight) : 0;
    sum += weight;
    squares += weight * weight;
    ++i;
  }
  // The weights' standard deviation over their mean: what a sample is worth.
  state.counters["deviation"] = std::sqrt(std::max(0.0, squares * static_cast<double>(i) / (sum * sum) - 1));
}

void density(benchmark::State& state, const std::string& scheme_text, const std::string& brdf_text) {
  const Brdf brdf = test::brdf_of(brdf_text);
  Scheme scheme = test::scheme_of(scheme_text);
  reflectance::build(scheme, brdf);
  const Inputs inputs = random_inputs();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reflectance::density(scheme, brdf, inputs.u[i], inputs.v[i]));
    i = (i + 1) % Count;
  }
}

const bool Registered = [] {
  for (const std::string& scheme : Schemes) {
    for (const std::string& brdf : Brdfs) {
      const auto name = [&](const char* what) { return std::string(what) + '/' + scheme + '/' + brdf; };
      benchmark::RegisterBenchmark(name("build").c_str(), build, scheme, brdf)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
      benchmark::RegisterBenchmark(name("sample").c_str(), sample, scheme, brdf);
      benchmark::RegisterBenchmark(name("density").c_str(), density, scheme, brdf);
    }
  }
  return true;
}();

}  // namespace
