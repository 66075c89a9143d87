// The cost of sampling schemes: seconds to build a BRDF's tables, nanoseconds to draw a sample with its pdf
// and weight (so with the BRDF's value, which reflectance_benchmark times separately), and to compute a pdf.
// Each scheme, with and without its cosine part, on each BRDF.
#include <benchmark/benchmark.h>

#include "renderer/reflectance/scheme.h"
#include "tests/benchmarks/random_inputs.h"
#include "tests/reflectance/brdf_cases.h"
#include "tests/reflectance/scheme_cases.h"

namespace {

using reflectance::Brdf;
using reflectance::Scheme;

const std::vector<std::string> Schemes = {
    "own",
    "diffuse",
    "hemisphere",
    "sphere",
    "anisotropic",
    "adaptive",
    "adaptive mode=reject",
    "reject",
    "factored",
    "factored pTh=100 pPh=32 J=2 K=2 half=true",
    "cascadeCDF",
    "cascadeCDF compress=true",
};

const std::vector<std::string> Brdfs = {
    "oren s=0 r=1",
    "lewis n=100 ks=1 kd=0",
    "ward sx=0.2 ks=0.5 kd=0.5",
    "ward sx=0.15 sy=0.4 ks=0.6 kd=0.3",
    "table of torrance rough=0.3",
};

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
  const test::RandomInputs inputs;
  double sum = 0;
  double squares = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    const auto drawn =
        reflectance::sample(scheme, brdf, inputs.u[i % inputs.u.size()], inputs.xi[i % inputs.u.size()]);
    benchmark::DoNotOptimize(drawn);
    const double weight = drawn ? reflectance::mean(drawn->weight) : 0;
    sum += weight;
    squares += weight * weight;
    ++i;
  }
  // The relative standard deviation of the weights, which measures the quality of a sample.
  state.counters["deviation"] = std::sqrt(std::max(0.0, squares * static_cast<double>(i) / (sum * sum) - 1));
}

void pdf(benchmark::State& state, const std::string& scheme_text, const std::string& brdf_text) {
  const Brdf brdf = test::brdf_of(brdf_text);
  Scheme scheme = test::scheme_of(scheme_text);
  reflectance::build(scheme, brdf);
  const test::RandomInputs inputs;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reflectance::pdf(scheme, brdf, inputs.u[i], inputs.v[i]));
    i = (i + 1) % inputs.u.size();
  }
}

// Only direction and pdf, without the BRDF's value.
void draw_by_warp(benchmark::State& state, const std::string& brdf_text) {
  const reflectance::WarpTrees trees(test::brdf_of(brdf_text), reflectance::WarpTreesSettings());
  const test::RandomInputs inputs;
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(trees.sample(inputs.u[i], inputs.xi[i].direction));
    i = (i + 1) % inputs.u.size();
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
      benchmark::RegisterBenchmark(name("density").c_str(), pdf, scheme, brdf);
    }
  }
  for (const std::string& brdf : Brdfs) {
    benchmark::RegisterBenchmark(("draw/adaptive/" + brdf).c_str(), draw_by_warp, brdf);
  }
  for (const test::ThesisCase& one : test::thesis_cases()) {
    benchmark::RegisterBenchmark(("draw/adaptive/" + one.brdf).c_str(), draw_by_warp, one.brdf);
  }
  return true;
}();

}  // namespace
