// Light sampling as integrators use it.
#include "renderer/transport/lights/lights.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "renderer/transport/lights/environment_probability.h"
#include "renderer/transport/sobol.h"
#include "tests/transport/solid_angles.h"

namespace {

using grf::Vec2f;
using grf::Vec3f;
using test::Vec3l;
using transport::Emitter;
using transport::Lights;
using transport::Rgb;

std::vector<Vec3l> corners_from(const Emitter& emitter, const Vec3f& from) {
  const Vec3l corner = Vec3l(emitter.corner) - Vec3l(from);
  const Vec3l a(emitter.edge1);
  const Vec3l b(emitter.edge2);
  if (emitter.is_triangle) return {corner, corner + a, corner + b};
  return {corner, corner + a, corner + a + b, corner + b};
}

/// Returns the irradiance; where a light is almost a point, Lambert's formula has no accuracy left.
double irradiance_of(const std::vector<Vec3l>& corners, const Vec3l& normal) {
  const Vec3l diagonal = corners[2] - corners[0];
  const Vec3l middle = corners[0] + diagonal / 2;
  const long double distance2 = middle.dot(middle);
  if (diagonal.dot(diagonal) > 1e-10L * distance2) return test::lambert_irradiance(corners, normal);
  Vec3l area = (corners[1] - corners[0]).cross(diagonal);
  if (corners.size() == 3) area /= 2;
  return static_cast<double>(std::max(0.0L, middle.dot(normal)) * -area.dot(middle) /
                             (distance2 * distance2));
}

double irradiance_of(const Lights& lights, const Vec3f& from, const Vec3f& normal) {
  double sum = 0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Emitter& emitter = lights[i];
    if (Vec3l(emitter.edge1).cross(Vec3l(emitter.edge2)).dot(Vec3l(emitter.corner) - Vec3l(from)) >= 0)
      continue;
    sum += double(emitter.radiance.x) * irradiance_of(corners_from(emitter, from), Vec3l(normal));
  }
  return sum;
}

/// An irradiance estimate from independent samples, with its standard deviation.
struct Irradiance {
  double mean = 0;
  double deviation = 0;

  Irradiance(const Lights& lights, const Vec3f& from, const Vec3f& normal, int samples, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(0, 1 - 0x1p-24F);
    double squares = 0;
    for (int i = 0; i < samples; ++i) {
      const float choice = number(random);
      const float x = number(random);
      const auto light = lights.sample(from, normal, choice, {x, number(random)});
      if (!light) continue;
      const double value =
          double(light->radiance.x) * std::max(0.0F, light->direction.dot(normal)) / double(light->pdf);
      mean += value / samples;
      squares += value * value / samples;
    }
    deviation = std::sqrt(std::max(0.0, squares - mean * mean) / samples);
  }
};

const Emitter Slanted{Vec3f(-1, -1, 2), Vec3f(0.5F, 2, 0), Vec3f(2, 0, 0), false, Rgb(3)};
const Emitter Square{Vec3f(-1, -1, 2), Vec3f(0, 2, 0), Vec3f(2, 0, 0), false, Rgb(3)};
const Emitter Wall{Vec3f(2, -1, -1), Vec3f(0, 0, 3), Vec3f(0, 2, 0), false, Rgb(1)};

Emitter half_of(Emitter emitter) {
  emitter.is_triangle = true;
  return emitter;
}

TEST(DirectLight, IsLambertsFormulaAtManyPlaces) {
  const std::vector<std::vector<Emitter>> scenes = {
      {Slanted}, {Square}, {half_of(Slanted)}, {Wall}, {Slanted, Square, Wall, half_of(Wall)}};
  std::uint32_t seed = 0;
  for (const auto& emitters : scenes) {
    const Lights lights(emitters);
    for (const float x : {-9.0F, -0.7F, 0.0F, 1.99F, 4.0F}) {
      for (const float z : {-0.5F, 0.0F, 1.5F, 1.999F}) {
        const Vec3f from(x, 0.3F, z);
        const Vec3f normal = Vec3f(0.1F * x, 0.2F, 1).normalized();
        const double expected = irradiance_of(lights, from, normal);
        const Irradiance estimate(lights, from, normal, 4096, ++seed);
        EXPECT_NEAR(estimate.mean, expected, 4.5 * estimate.deviation + 1e-5 * expected) << from;
        EXPECT_LE(estimate.deviation, 0.2 * expected) << from;
      }
    }
  }
}

// Edge-on, tiny, huge or touching lights: the weight of a sample stays bounded.
TEST(DirectLight, IsRightInHardCases) {
  const auto square = [](double size, const Vec3f& corner) {
    const auto s = static_cast<float>(size);
    return Emitter{corner, Vec3f(0, s, 0), Vec3f(s, 0, 0), false, Rgb(1)};
  };
  const std::vector<Emitter> emitters = {
      square(1e-6, {0.1F, 0.2F, 1}),      square(1e6, {-3e5F, -4e5F, 1}),
      square(1, {-0.5F, -0.5F, 1e-6F}),   square(1, {0, 0, 1e-6F}),
      square(1, {0.5F, 0.5F, 1e-6F}),     square(1, {1e6F, 1e6F, 1e6F}),
      square(1e6, {-5e5F, -5e5F, 1e-3F}), square(1e-6, {3, 2, 1e-6F}),
      square(1e-3, {0, 0, 1e-30F}),       square(1e-12, {1e-6F, 1e-6F, 1e-6F}),
  };
  std::uint32_t seed = 0;
  for (Emitter emitter : emitters) {
    for (int shape = 0; shape < 3; ++shape) {
      if (shape == 1) emitter.is_triangle = true;
      if (shape == 2) {
        emitter.is_triangle = false;
        emitter.edge1.x = emitter.edge1.y / 3;
      }
      const Lights lights({emitter});
      for (const Vec3f& normal : {Vec3f(0, 0, 1), Vec3f(0.6F, 0, 0.8F)}) {
        const double expected = irradiance_of(lights, Vec3f(0), normal);
        const Irradiance estimate(lights, Vec3f(0), normal, 4096, ++seed);
        EXPECT_NEAR(estimate.mean, expected, 4.5 * estimate.deviation + 2e-5 * expected)
            << emitter.corner << emitter.edge1 << shape;
        EXPECT_LE(estimate.deviation, 0.05 * expected) << emitter.corner << emitter.edge1 << shape;
      }
    }
  }
}

TEST(Lights, GiveNothingFromBehindFromTheirPlaneAndUnderTheHorizon) {
  const Lights lights({Square});
  const Vec3f up(0, 0, 1);
  EXPECT_TRUE(lights.sample(Vec3f(0), up, 0.5F, {0.5F, 0.5F}));
  EXPECT_FALSE(lights.sample(Vec3f(0), -up, 0.5F, {0.5F, 0.5F}));
  EXPECT_FALSE(lights.sample(Vec3f(0, 0, 3), -up, 0.5F, {0.5F, 0.5F}));
  EXPECT_FALSE(lights.sample(Vec3f(0.2F, 0.3F, 2), up, 0.5F, {0.5F, 0.5F}));
  EXPECT_FALSE(lights.sample(Square.corner, up, 0.5F, {0.5F, 0.5F}));
  EXPECT_FALSE(lights.sample(Square.corner + Square.edge1, up, 0.5F, {0.5F, 0.5F}));
  EXPECT_EQ(lights.pdf(Vec3f(0, 0, 3), -up, 0, {0, 0, -1}), 0);
}

rc::Gen<std::vector<Emitter>> any_emitters() {
  return rc::gen::exec([] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto number = [&](float least, float most) {
      return std::uniform_real_distribution<float>(least, most)(random);
    };
    const auto vector = [&] { return Vec3f(number(-1, 1), number(-1, 1), number(-1, 1)); };
    std::vector<Emitter> emitters(1 + random() % 9);
    for (Emitter& emitter : emitters) {
      const float size = std::pow(10.0F, number(-6, 6));
      emitter.corner = vector() * std::pow(10.0F, number(-6, 6));
      emitter.edge1 = vector() * size;
      emitter.edge2 = vector() * size * std::pow(10.0F, number(-6, 0));
      emitter.is_triangle = random() % 2 == 0;
      emitter.radiance = Rgb(std::pow(10.0F, number(-6, 6)));
    }
    return emitters;
  });
}

RC_GTEST_PROP(Lights, SayOfTheirSamplesWhatTheySayOfDirections, ()) {
  const Lights lights(*any_emitters());
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  for (std::uint32_t i = 0; i < 200; ++i) {
    const auto a = transport::sobol_point(i, seed);
    const auto b = transport::sobol_point(i, seed + 1);
    // From anywhere, and from close to a light.
    Vec3f from = Vec3f(b.x, b.y, b.z) * 2.0F - Vec3f(1);
    if (i % 2 == 0) from = lights[0].corner + lights[0].edge1 * b.x + from * 1e-4F;
    const Vec3f normal = (Vec3f(b.y, b.z, b.w) * 2.0F - Vec3f(1)).normalized();
    const auto light = lights.sample(from, normal, a.z, a.xy());
    if (!light) continue;
    RC_ASSERT(light->pdf > 0);
    RC_ASSERT(std::isfinite(1 / light->pdf));
    RC_ASSERT(std::abs(light->direction.length() - 1) < 1e-6F);
    const float pdf = lights.pdf(from, normal, light->emitter, light->direction);
    RC_ASSERT(std::abs(pdf - light->pdf) <= 1e-5F * pdf);
    // The position lies in the sampled direction, and on the light.
    const Emitter& emitter = lights[light->emitter];
    const Vec3f to_light = light->position - from;
    const float reach = from.length() + emitter.corner.length() + emitter.edge1.length();
    RC_ASSERT((to_light - light->direction * to_light.length()).length() <= 1e-5F * reach);
    const Vec3f on_light = light->position - emitter.corner;
    RC_ASSERT(std::abs(on_light.dot(light->normal)) <= 2e-6F * reach);
    RC_ASSERT(light->radiance == emitter.radiance);
  }
}

TEST(EnvironmentShare, FollowsThePowers) {
  const grf::Box3d bounds(grf::Vec3d(-1), grf::Vec3d(1));
  const Lights lights({Square});  // 3 on an area of 4
  const auto share = [&](float radiance, const Lights& others) {
    const transport::EnvironmentMap map(image::Image{2, 1, {Rgb(radiance), Rgb(radiance)}});
    return transport::environment_probability(&map, others, bounds);
  };
  // 12 pi, compared with a disc of radius sqrt(3) under 4 pi times the radiance.
  EXPECT_NEAR(share(1 / std::numbers::pi_v<float>, lights), 0.5, 1e-5);
  EXPECT_NEAR(share(2 / std::numbers::pi_v<float>, lights), 2.0 / 3, 1e-5);
  EXPECT_FLOAT_EQ(share(1e6F, lights), 0.8F);
  EXPECT_FLOAT_EQ(share(1e-6F, lights), 0.2F);
  EXPECT_EQ(share(1, Lights()), 1);
  EXPECT_EQ(share(0, lights), 0);
  EXPECT_EQ(transport::environment_probability(nullptr, lights, bounds), 0);
}

TEST(Lights, TakeLittleMemory) {
  std::vector<Emitter> emitters(1000, Square);
  emitters.shrink_to_fit();
  EXPECT_LE(Lights(std::move(emitters)).bytes(), 140U * 1000);
}

}  // namespace
