#include "renderer/transport/scene/ray_caster.h"

#include <cmath>
#include <new>
#include <set>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "renderer/parallel/loops.h"

namespace {

using transport::Geometry;
using transport::RayCaster;
using transport::TriangleMesh;
using transport::Vec3f;

/// Waves of this many squares per side over the unit square, several coincident layers.
std::shared_ptr<Geometry> layers_of_waves(std::uint32_t side, std::uint32_t layers) {
  auto geometry = std::make_shared<Geometry>();
  geometry->instances.emplace_back(grf::Matrix44d());
  TriangleMesh& mesh = geometry->meshes.emplace_back();
  const std::uint32_t columns = side + 1;
  for (std::uint32_t i = 0; i < columns * columns; ++i) {
    const float x = static_cast<float>(i % columns) / static_cast<float>(side);
    const float y = static_cast<float>(i / columns) / static_cast<float>(side);
    mesh.positions.emplace_back(x, y, 0.1F * std::sin(20 * x) * std::cos(30 * y));
  }
  mesh.positions.emplace_back(0.0F);  // padding
  for (std::uint32_t i = 0; i < layers * side * side; ++i) {
    const std::uint32_t corner = i / side % side * columns + i % side;
    mesh.triangles.push_back({{corner, corner + 1, corner + columns + 1}});
    mesh.triangles.push_back({{corner, corner + columns + 1, corner + columns}});
  }
  return geometry;
}

/// Returns the triangles that rays down onto the unit square hit.
std::vector<std::uint32_t> triangles_below(const RayCaster& caster, int side) {
  std::vector<std::uint32_t> met;
  for (int i = 0; i < side * side; ++i) {
    const float x = (static_cast<float>(i % side) + 0.37F) / static_cast<float>(side);
    const float y = (static_cast<float>(i / side) + 0.61F) / static_cast<float>(side);
    const auto hit = caster.intersect({Vec3f(x, y, 1), Vec3f(0, 0, -1)});
    met.push_back(hit ? hit->id.triangle : transport::InvalidIndex);
  }
  return met;
}

// Of coincident faces, the one that is hit must not depend on the threads that build.
TEST(RayCaster, MeetsTheSameWhateverTheNumberOfThreadsThatBuildIt) {
  const auto geometry = layers_of_waves(100, 4);
  std::set<std::vector<std::uint32_t>> found;
  for (const int threads : {1, 2, 5, 7}) {
    parallel::run_with_threads(threads, [&] { found.insert(triangles_below(RayCaster(geometry), 200)); });
  }
  EXPECT_EQ(found.size(), 1U);
}

/// The message of the exception for a geometry.
std::string refusal_of(std::shared_ptr<const Geometry> geometry) {
  try {
    const RayCaster caster(std::move(geometry));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// An instance of a missing mesh stands for all that Embree may reject.
TEST(RayCaster, SaysWhatEmbreeRefuses) {
  const auto geometry = layers_of_waves(2, 1);
  geometry->instances.emplace_back(grf::Matrix44d());
  EXPECT_THAT(refusal_of(geometry), testing::MatchesRegex("Embree reports error 2: .*invalid argument.*"));
}

// Sanitizers need address space of their own.
#ifndef GRANADA_HAS_SANITIZERS
/// Builds a caster with too little memory for Embree.
void build_without_memory(std::shared_ptr<const Geometry> geometry) {
  parallel::run_with_threads(1, [&] {
    const RayCaster caster(layers_of_waves(2, 1));  // allocates what is needed only once
    const rlimit least = {std::size_t(1) << 20, std::size_t(1) << 20};
    ::setrlimit(RLIMIT_AS, &least);
    try {
      const RayCaster too_large(geometry);
    } catch (const std::bad_alloc&) {
      ::_exit(7);
    } catch (const std::exception&) {
      ::_exit(8);
    }
    ::_exit(9);
  });
}

TEST(RayCaster, RunsOutOfMemory) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(build_without_memory(layers_of_waves(400, 1)), testing::ExitedWithCode(7), "");
}
#endif

}  // namespace
