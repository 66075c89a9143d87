// The sample scenes have no fireflies: no pixel that stands out against a reference with many more samples.
#include <gtest/gtest.h>

#include "renderer/image/image_error.h"
#include "tests/transport/sample_scenes.h"

namespace {

using image::Image;
using transport::RenderSettings;

Image image_of(const transport::CompiledScene& scene, const RenderSettings& settings) {
  transport::Render render(scene, settings);
  render.run();
  return render.film().mean();
}

class Fireflies : public testing::TestWithParam<std::string> {};

TEST_P(Fireflies, AreNotInTheSamples) {
  const test::SampleScene sample = test::sample_scene(GetParam());
  RenderSettings settings = sample.settings;
  settings.width = 111;
  settings.height = 87;
  settings.samples = 64;
  const Image image = image_of(sample.scene, settings);
  settings.samples = 1024;
  settings.seed = 99;
  const Image reference = image_of(sample.scene, settings);
  EXPECT_EQ(error_of(image, reference).fireflies, 0U);
  // A firefly is found.
  Image with_one = image;
  const std::size_t middle = with_one.pixels.size() / 2 + 55;
  for (int k = 0; k < 3; ++k) with_one.pixels[middle][k] = 1000;
  EXPECT_EQ(error_of(with_one, reference).fireflies, 1U);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Fireflies, testing::ValuesIn(test::sample_op_files()),
                         [](const auto& tested) { return test::name_of(tested.param); });

}  // namespace
