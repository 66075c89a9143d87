// Tests of the memory usage of large scenes. The speed of reading is in tests/benchmarks/grf_benchmark.cpp.
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "grf/read.h"
#include "grf/summary.h"
#include "grf/write.h"
#include "tests/grf/allocation_meter.h"
#include "tests/grf/height_field.h"

namespace grf {
namespace {

TEST(LargeMesh, IsReadInThreeTimesItsOwnMemory) {
  for (const std::uint32_t side :
       {300, 363, 420}) {  // sizes at which doubling arrays would waste most, or least
    std::string text = to_text(scene_of_mesh(height_field(side)));
    text.shrink_to_fit();
    const std::size_t before = allocated_bytes() - text.size();
    restart_peak();
    Diagnostics diagnostics;
    const auto scene = read_text(std::move(text), "mesh.grf", diagnostics);
    ASSERT_TRUE(scene) << diagnostics.to_text();
    const std::size_t own = bytes_of(*std::get<Shared<Mesh>>(scene->contents.blocks.front().content));
    EXPECT_LT(peak_bytes() - before, 3 * own) << side;
    EXPECT_LT(allocated_bytes() - before, own + own / 8) << "and that much is kept";
  }
}

std::string text_of_instances(int count) {
  std::string text = to_text(scene_of_mesh(height_field(225)));
  text = "def bumps = " + text + "begin\n";
  for (int i = 0; i < count; ++i) {
    text +=
        "transform rotation (0, 0.1, 0) translation (" + std::to_string(i) + ", 0, 0) begin use bumps end\n";
  }
  return text + "end\n";
}

TEST(Instances, ShareTheMeshAndCostLessThanAKilobyteEach) {
  const auto bytes_of_instances = [](int count) {
    const std::string text = text_of_instances(count);
    const std::size_t before = allocated_bytes();
    Diagnostics diagnostics;
    const auto scene = read_text(text, "instances.grf", diagnostics);
    EXPECT_TRUE(scene) << diagnostics.to_text();
    const std::size_t bytes = allocated_bytes() - before;
    const Summary summary = summarize(*scene);
    EXPECT_EQ(summary.instances, static_cast<std::size_t>(count));
    EXPECT_EQ(summary.triangles, static_cast<std::size_t>(count) * 100'352);
    return bytes;
  };
  const std::size_t one = bytes_of_instances(1);
  const std::size_t many = bytes_of_instances(10'001);
  EXPECT_LT(many - one, 10'000 * 1024U);
}

}  // namespace
}  // namespace grf
