// The cost of light sampling in nanoseconds: a direction on a shape with its pdf, compared with a point on
// its area; the choice among many emitters; and an environment map. Counter "deviation": the relative
// standard deviation of a sample's irradiance estimate, which the time has to be weighed against.
#include <cmath>
#include <random>

#include <benchmark/benchmark.h>

#include "renderer/transport/lights/environment_map.h"
#include "renderer/transport/lights/lights.h"

namespace {

using grf::Vec2f;
using grf::Vec3f;
using transport::Emitter;
using transport::Lights;
using transport::Rgb;

const Emitter Rectangle{Vec3f(-0.5F, -0.5F, 1), Vec3f(0, 1, 0), Vec3f(1, 0, 0), false, Rgb(1)};
const Emitter Parallelogram{Vec3f(-0.5F, -0.5F, 1), Vec3f(0.2F, 1, 0), Vec3f(1, 0, 0), false, Rgb(1)};
const Emitter Triangle{Vec3f(-0.5F, -0.5F, 1), Vec3f(0, 1, 0), Vec3f(1, 0, 0), true, Rgb(1)};

/// Points under lights at a height of 1, and random numbers to sample with.
struct Inputs {
  struct Input {
    Vec3f from;
    float choice;
    Vec2f xi;
  };
  std::vector<Input> inputs;
  std::size_t next = 0;

  explicit Inputs(float spread) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> number(0, 1 - 0x1p-24F);
    for (int i = 0; i < 4096; ++i) {
      Input input;
      input.from = Vec3f((number(random) - 0.5F) * spread, (number(random) - 0.5F) * spread, 0);
      input.choice = number(random);
      input.xi = {number(random), 0};
      input.xi.y = number(random);
      inputs.push_back(input);
    }
  }

  const Input& operator()() { return inputs[next++ % inputs.size()]; }
};

const Vec3f Up(0, 0, 1);

/// The relative standard deviation of estimates at one point.
template <class Estimate>
double deviation(const Estimate& estimate) {
  Inputs inputs(0);
  double sum = 0;
  double squares = 0;
  for (const auto& input : inputs.inputs) {
    const double value = estimate(input);
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(inputs.inputs.size());
  return std::sqrt(std::max(0.0, squares * count / (sum * sum) - 1));
}

void area(benchmark::State& state, const Emitter& emitter) {
  const auto sample = [&emitter](const Inputs::Input& input) {
    Vec2f at = input.xi;
    if (emitter.is_triangle) {
      const float root = std::sqrt(at.x);
      at = {1 - root, root * at.y};
    }
    const Vec3f to_light = emitter.corner + emitter.edge1 * at.x + emitter.edge2 * at.y - input.from;
    const Vec3f normal = emitter.doubled_area_normal().normalized();
    const float distance2 = to_light.length2();
    const Vec3f direction = to_light / std::sqrt(distance2);
    const float pdf = distance2 / (-direction.dot(normal) * emitter.area());
    return std::pair(direction, pdf);
  };
  Inputs inputs(2);
  for (auto _ : state) benchmark::DoNotOptimize(sample(inputs()));
  state.counters["deviation"] = deviation([&](const auto& input) {
    const auto [direction, pdf] = sample(input);
    return double(direction.z) / double(pdf);
  });
}

double estimate(const Lights& lights, const Inputs::Input& input) {
  const auto light = lights.sample(input.from, Up, input.choice, input.xi);
  return light ? double(light->radiance.x) * double(light->direction.z) / double(light->pdf) : 0;
}

void solid_angle(benchmark::State& state, const Emitter& emitter) {
  const Lights lights({emitter});
  Inputs inputs(2);
  for (auto _ : state) {
    const auto& input = inputs();
    benchmark::DoNotOptimize(lights.sample(input.from, Up, input.choice, input.xi));
  }
  state.counters["deviation"] = deviation([&](const auto& input) { return estimate(lights, input); });
}

void pdf(benchmark::State& state, const Emitter& emitter) {
  const Lights lights({emitter});
  Inputs inputs(2);
  for (auto _ : state) benchmark::DoNotOptimize(lights.pdf(inputs().from, Up, 0, Up));
}

BENCHMARK_CAPTURE(area, rectangle, Rectangle);
BENCHMARK_CAPTURE(area, triangle, Triangle);
BENCHMARK_CAPTURE(solid_angle, rectangle, Rectangle);
BENCHMARK_CAPTURE(solid_angle, parallelogram, Parallelogram);
BENCHMARK_CAPTURE(solid_angle, triangle, Triangle);
BENCHMARK_CAPTURE(pdf, rectangle, Rectangle);
BENCHMARK_CAPTURE(pdf, parallelogram, Parallelogram);
BENCHMARK_CAPTURE(pdf, triangle, Triangle);

/// Lights of many sizes and orientations over a floor of 10 x 10, up to a height of 5.
std::vector<Emitter> many(std::size_t count) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> number(-1, 1);
  const auto vector = [&] { return Vec3f(number(random), number(random), number(random)); };
  const float size = 3 / std::cbrt(static_cast<float>(count));
  std::vector<Emitter> emitters;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3f corner = vector() * Vec3f(5, 5, 2.4F) + Vec3f(0, 0, 2.5F);
    emitters.push_back({corner, vector() * size, vector() * size, i % 2 == 0, Rgb(1 + number(random))});
  }
  return emitters;
}

void tree_sample(benchmark::State& state) {
  const Lights lights(many(static_cast<std::size_t>(state.range(0))));
  Inputs inputs(8);
  for (auto _ : state) {
    const auto& input = inputs();
    benchmark::DoNotOptimize(lights.sample(input.from, Up, input.choice, input.xi));
  }
  state.counters["deviation"] = deviation([&](const auto& input) { return estimate(lights, input); });
  state.counters["bytes"] = static_cast<double>(lights.bytes()) / static_cast<double>(lights.size());
}

void tree_pdf(benchmark::State& state) {
  const Lights lights(many(static_cast<std::size_t>(state.range(0))));
  Inputs inputs(8);
  for (auto _ : state) {
    const auto& input = inputs();
    const auto emitter = static_cast<std::size_t>(input.choice * static_cast<float>(lights.size()));
    benchmark::DoNotOptimize(lights.pdf(input.from, Up, emitter, Up));
  }
}

void tree_build(benchmark::State& state) {
  const auto emitters = many(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(Lights(emitters).size());
}

BENCHMARK(tree_sample)->Arg(1)->Arg(2)->Arg(100)->Arg(100'000);
BENCHMARK(tree_pdf)->Arg(1)->Arg(2)->Arg(100)->Arg(100'000);
BENCHMARK(tree_build)->Arg(1000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// A noisy sky with a sun.
transport::EnvironmentMap sky(int height) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(0, 1);
  image::Image image{2 * height, height, {}};
  for (int i = 0; i < 2 * height * height; ++i) image.pixels.emplace_back(number(random));
  image.pixels[static_cast<std::size_t>(height * height / 2)] = Rgb(1000);
  return transport::EnvironmentMap(std::move(image));
}

void map_sample(benchmark::State& state) {
  const auto map = sky(static_cast<int>(state.range(0)));
  Inputs inputs(1);
  for (auto _ : state) benchmark::DoNotOptimize(map.sample(inputs().xi));
}

void map_pdf(benchmark::State& state) {
  const auto map = sky(static_cast<int>(state.range(0)));
  Inputs inputs(8);
  for (auto _ : state) {
    const auto& input = inputs();
    benchmark::DoNotOptimize(map.pdf({input.from.x, input.choice, input.from.y}));
  }
}

BENCHMARK(map_sample)->Arg(64)->Arg(2048);
BENCHMARK(map_pdf)->Arg(64)->Arg(2048);

}  // namespace
