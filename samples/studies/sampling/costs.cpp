#include "samples/studies/sampling/costs.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "renderer/reflectance/schemes/rejection_trees.h"

namespace study {
namespace {

using reflectance::Brdf;
using reflectance::Uniforms;
using reflectance::Vec3f;

template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Request {
  Vec3f u;
  Uniforms xi;
};

// The requests fit the second-level cache, without a pattern that a branch predictor learns.
std::vector<Request> requests() {
  constexpr int Count = 8192;
  std::mt19937 random(1);
  const auto uniform = [&] { return static_cast<float>(random() >> 8U) * 0x1p-24F; };
  const auto pair = [&] {
    const float x = uniform();
    return reflectance::Vec2f(x, uniform());
  };
  std::vector<Request> all;
  for (int i = 0; i < Count; ++i) {
    const Vec3f u = reflectance::cosine_direction(pair());
    const reflectance::Vec2f xi = pair();
    all.push_back({u, {xi, uniform()}});
  }
  return all;
}

double nanoseconds(const Technique& technique, const Brdf& valued, int rounds) {
  const std::vector<Request> all = requests();
  double least = std::numeric_limits<double>::infinity();
  volatile float sink = 0;  // prevents dead-code elimination
  for (int round = 0; round < rounds; ++round) {
    const double seconds = seconds_of([&] {
      float sum = 0;
      for (const Request& one : all) {
        const auto drawn = technique.sample_alone(valued, one.u, one.xi);
        if (drawn) sum += drawn->pdf + drawn->weight.x + drawn->direction.z;
      }
      sink = sum;
    });
    least = std::min(least, seconds);
  }
  return least / static_cast<double>(all.size()) * 1e9;
}

}  // namespace

TableCost table_cost(const Brdf& brdf, const std::string& scheme, int builds) {
  TableCost cost{std::numeric_limits<double>::infinity(), 0};
  double total = 0;
  constexpr double MostSeconds = 5;  // seconds, after which one more build tells little
  for (int i = 0; i < builds && total < MostSeconds; ++i) {
    reflectance::Scheme made = scheme_of(scheme);
    cost.seconds = std::min(cost.seconds, seconds_of([&] { reflectance::build(made, brdf); }));
    cost.bytes = reflectance::bytes(made);
    total += cost.seconds;
  }
  return cost;
}

std::array<std::size_t, TriesOfTable.size()> tree_bytes(const Brdf& brdf, int resolution) {
  std::array<std::size_t, TriesOfTable.size()> bytes = {};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    reflectance::RejectionSettings settings;
    settings.thetas = 1;  // at 45 degrees
    settings.phis = 1;
    settings.most_tries = static_cast<float>(TriesOfTable[i]);
    settings.resolution = resolution;
    settings.keep_table = false;
    bytes[i] = reflectance::RejectionTrees(brdf, settings).bytes();
  }
  return bytes;
}

SampleCost sample_cost(const Technique& technique, int rounds) {
  // A diffuse BRDF replaces its own: its value costs nothing, and the tables are the same. For the model's
  // own sampler, the weight is part of the formula.
  const Brdf diffuse = reflectance::default_brdf();
  const double with_pdf = nanoseconds(technique, diffuse, rounds);
  if (technique.is_own()) return {with_pdf, with_pdf};
  return {with_pdf, nanoseconds(technique, technique.brdf(), rounds)};
}

}  // namespace study
