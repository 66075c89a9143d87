// Tests that no operation grows faster than n log n with the size of a file: a megabyte would take hours.
#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "converters/format.h"
#include "converters/risks/risk.h"
#include "grf/check.h"
#include "grf/read.h"
#include "grf/triangulation.h"
#include "grf/write.h"
#include "renderer/plan/coarse_scene.h"
#include "renderer/plan/plan.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/transport/scene/compiled_scene.h"
#include "tests/grf/allocation_meter.h"
#include "tests/scaling/editing.h"
#include "tests/scaling/growth.h"
#include "tests/scaling/inputs.h"
#include "tests/support/polygon_shapes.h"
#include "tests/support/temporary_folder.h"

namespace scaling {
namespace {

/// An operation on a file, or on its scene.
struct Station {
  std::string name;
  bool needs_scene = true;
  std::function<void(const convert::Format&, const std::string& path, const grf::Scene&)> run;
};

std::vector<Station> all_stations() {
  return {
      {"read", false,
       [](const convert::Format& format, const std::string& path, const grf::Scene&) {
         grf::Diagnostics diagnostics;
         convert::read(format, path, {}, diagnostics);
         EXPECT_FALSE(diagnostics.to_text().size() > 10'000'000);
       }},
      {"check", true,
       [](const convert::Format&, const std::string&, const grf::Scene& scene) {
         grf::Diagnostics diagnostics;
         grf::check(scene, reflectance::catalogue(), diagnostics);
       }},
      {"find risks", true,
       [](const convert::Format&, const std::string&, const grf::Scene& scene) {
         convert::risks_of(scene, reflectance::catalogue());
       }},
      {"write", true,
       [](const convert::Format& format, const std::string& path, const grf::Scene& scene) {
         grf::Diagnostics diagnostics;
         if (format.write != nullptr)
           format.write(scene, path + ".written." + std::string(format.extensions[0]), diagnostics);
       }},
      {"plan", true,
       [](const convert::Format&, const std::string&, const grf::Scene& scene) {
         plan::plan_of(plan::CoarseScene(scene, 10'000), {});
       }},
      {"compile", true,
       [](const convert::Format&, const std::string&, const grf::Scene& scene) {
         grf::Diagnostics diagnostics;
         transport::compile(scene, diagnostics);
       }},
#ifdef WITH_EDITOR
      {"edit", true,
       [](const convert::Format&, const std::string& path, const grf::Scene& scene) { edit(scene, path); }},
#endif
      {"copy, compare and destroy", true,
       [](const convert::Format&, const std::string&, const grf::Scene& scene) {
         // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): how long it takes is the question
         const grf::Scene copy = scene;
         EXPECT_TRUE(copy == scene);
       }},
  };
}

TEST(Memory, IsNotTakenForVerticesThatNoFaceUses) {
  std::string text = "def m = begin mesh begin vertexs\n";
  for (int i = 0; i < 20'000; ++i) text += fmt::format("({},{},0)\n", i % 100, i % 3);
  text += "end vertexs begin faces (0,1,2) end faces end mesh begin\n";
  for (int i = 0; i < 1000; ++i) text += "use m\n";
  grf::Diagnostics diagnostics;
  const auto scene = grf::read_text(text + "end\n", "scene.grf", diagnostics);
  ASSERT_TRUE(scene) << diagnostics.to_text();
  const std::size_t before = grf::allocated_bytes();
  grf::restart_peak();
  const auto compiled = transport::compile(*scene, diagnostics);
  ASSERT_TRUE(compiled) << diagnostics.to_text();
  EXPECT_EQ(compiled->triangle_count(), 1000U);
  EXPECT_EQ(compiled->geometry().meshes.front().positions.size(), 3U * 1000 + 1);
  EXPECT_LT(grf::peak_bytes() - before, 4U << 20U);
}

/// For a build that is not optimised.
#ifdef NDEBUG
constexpr double Allowance = 1;
#else
constexpr double Allowance = 20;
#endif

TEST(Triangulation, Of20000CornersTakes50Milliseconds) {
  for (const shapes::Shape& shape : shapes::hard_shapes(20'000)) {
    double least = 1e9;
    for (int i = 0; i < 5; ++i) {
      std::vector<std::array<std::uint32_t, 3>> triangles;
      const std::clock_t before = std::clock();
      grf::triangulate(shape.polygon, triangles);
      least = std::min(least, double(std::clock() - before) / CLOCKS_PER_SEC);
    }
    EXPECT_LT(least, 0.05 * Allowance) << shape.name;
  }
}

TEST(Triangulation, OfAMillionCornersTakes5Seconds) {
  for (const shapes::Shape& shape : shapes::hard_shapes(1'000'000)) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    const std::clock_t before = std::clock();
    grf::triangulate(shape.polygon, triangles);
    EXPECT_LT(double(std::clock() - before) / CLOCKS_PER_SEC, 5 * Allowance) << shape.name;
    EXPECT_EQ(triangles.size(), shape.polygon.size() - 2) << shape.name;
  }
}

class Scaling : public testing::TestWithParam<Input> {};

TEST_P(Scaling, GrowsNoFasterThanTheFile) {
  const Input& input = GetParam();
  const test::TemporaryFolder folder;
  const convert::Format* format = convert::format_of_name("scene." + input.extension);
  ASSERT_NE(format, nullptr);
  for (const Station& station : all_stations()) {
    bool has_scene = true;
    const Prepare prepare = [&](std::size_t count) -> Measured {
      const std::string path = folder.path(std::to_string(count) + "." + input.extension);
      std::ofstream(path, std::ios::binary) << input.text(count);
      if (input.companions) {
        for (const CompanionFile& file : input.companions(count)) folder.add(file.name, file.text);
      }
      if (!station.needs_scene) return [&station, format, path] { station.run(*format, path, {}); };
      grf::Diagnostics diagnostics;
      const auto import = convert::read(*format, path, {}, diagnostics);
      has_scene = import.has_value();
      EXPECT_EQ(has_scene, !input.is_refused) << diagnostics.to_text().substr(0, 1000);
      if (!import) return [] {};
      const auto scene = std::make_shared<const grf::Scene>(import->scene);
      return [&station, format, path, scene] { station.run(*format, path, *scene); };
    };
    const Growth growth = growth_of(prepare, std::min<std::size_t>(input.largest, 250), input.largest);
    if (!has_scene) continue;
    EXPECT_FALSE(growth.is_too_fast()) << station.name << ": " << growth.to_text();
  }
}

std::string test_name(const testing::TestParamInfo<Input>& info) {
  std::string name = info.param.extension + "_" + info.param.name;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Grf, Scaling, testing::ValuesIn(grf_inputs()), test_name);
INSTANTIATE_TEST_SUITE_P(Models, Scaling, testing::ValuesIn(model_inputs()), test_name);
INSTANTIATE_TEST_SUITE_P(Assimp, Scaling, testing::ValuesIn(assimp_inputs()), test_name);

}  // namespace
}  // namespace scaling
