#include "renderer/transport/error_map.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "renderer/image/image_error.h"
#include "tests/transport/scene_helpers.h"

namespace {

using image::Image;
using transport::FilmTile;
using transport::Render;
using transport::Rgb;
using transport::TileBounds;

constexpr int Width = 48;
constexpr int Height = 32;
constexpr int Middle = Width / 2;

test::RenderSetup setup_of() {
  test::RenderSetup setup;
  setup.width = Width;
  setup.height = Height;
  return setup;
}

/// Gives the pixels of a tile two samples, one in each half: 1 with this deviation above and below.
template <class Deviation>
void fill(Render& render, int tile, const Deviation& deviation_at) {
  FilmTile sums;
  render.copy_tile(tile, sums);
  for (int y = 0; y < sums.bounds.height; ++y) {
    for (int x = 0; x < sums.bounds.width; ++x) {
      const float deviation = deviation_at(sums.bounds.x + x);
      sums.add(x, y, 0, Rgb(1 + deviation));
      sums.add(x, y, 1, Rgb(1 - deviation));
    }
  }
  sums.counts = {1, 1};
  render.restore_tile(tile, sums);
}

// The halves 1 + s and 1 - s have a mean whose standard error is s, so that its relative one is s / sqrt(1 +
// 0.01). Beside the line where s changes, three columns of five are on one side of it.
TEST(ErrorMap, IsTheRelativeStandardErrorAroundEachPixel) {
  const auto scene = test::scene_of(test::LitFloor);
  Render render(scene, settings_of(setup_of()));
  for (int tile = 0; tile < render.film().tile_count(); ++tile) {
    fill(render, tile, [](int x) { return x < Middle ? 0.1F : 0.3F; });
  }
  const std::vector<float> map = error_map(render);
  ASSERT_EQ(map.size(), std::size_t{Width * Height});
  const auto expected = [](int columns_of_less) {
    return std::sqrt((columns_of_less * 0.01 + (5 - columns_of_less) * 0.09) / 5 / 1.01);
  };
  for (int y = 0; y < Height; ++y) {
    const auto at = [&](int x) { return map[static_cast<std::size_t>(y * Width + x)]; };
    EXPECT_NEAR(at(0), expected(5), 1e-6) << y;
    EXPECT_NEAR(at(Middle - 3), expected(5), 1e-6);
    EXPECT_NEAR(at(Middle - 2), expected(4), 1e-6);
    EXPECT_NEAR(at(Middle - 1), expected(3), 1e-6);
    EXPECT_NEAR(at(Middle), expected(2), 1e-6);
    EXPECT_NEAR(at(Width - 1), expected(0), 1e-6);
  }
}

TEST(ErrorMap, IsInfiniteWhereThereAreNoTwoHalves) {
  const auto scene = test::scene_of(test::LitFloor);
  Render render(scene, settings_of(setup_of()));
  fill(render, 0, [](int) { return 0.1F; });
  const std::vector<float> map = error_map(render);
  const int side = transport::Film::TileSize;
  EXPECT_NEAR(map[0], 0.1 / std::sqrt(1.01), 1e-6);
  EXPECT_TRUE(std::isfinite(map[static_cast<std::size_t>(side - 1)])) << "what is known around it counts";
  EXPECT_EQ(map[static_cast<std::size_t>(side)], std::numeric_limits<float>::infinity());
  EXPECT_EQ(map.back(), std::numeric_limits<float>::infinity());
}

TEST(ErrorMap, IsStopped) {
  const auto scene = test::scene_of(test::LitFloor);
  const Render render(scene, settings_of(setup_of()));
  EXPECT_TRUE(error_map(render, [] { return true; }).empty());
}

/// The root mean square of a map over a rectangle.
double root_mean_square(const std::vector<float>& map, const TileBounds& part) {
  double sum = 0;
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      const double error = map[static_cast<std::size_t>(y * Width + x)];
      sum += error * error / static_cast<double>(part.pixel_count());
    }
  }
  return std::sqrt(sum);
}

Image part_of(const Image& image, const TileBounds& part) {
  Image result{part.width, part.height, {}};
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) result.pixels.push_back(image.at(part.x + x, part.y + y));
  }
  return result;
}

// The truth is an image of far more samples, of a floor that fills it: at a silhouette, pixels that no sample
// has hit would have an error that nothing shows.
TEST(ErrorMap, ShowsTheTrueErrorOfEachPart) {
  const auto scene = test::scene_of(test::LitFloor);
  test::RenderSetup setup = test::floor_setup(Width, Height, 8192);
  setup.depth = 1;
  setup.field_of_view = 14;
  const Image truth = render(scene, setup).mean();
  setup.samples = 8;
  setup.seed = 5;
  Render render(scene, settings_of(setup));
  render.run();
  const std::vector<float> map = error_map(render);
  const Image image = render.film().mean();
  for (const TileBounds& part :
       {TileBounds{0, 0, Middle, Height / 2}, TileBounds{Middle, 0, Middle, Height / 2},
        TileBounds{0, Height / 2, Middle, Height / 2}, TileBounds{Middle, Height / 2, Middle, Height / 2}}) {
    const double error = std::sqrt(error_of(part_of(image, part), part_of(truth, part)).relmse);
    EXPECT_NEAR(root_mean_square(map, part) / error, 1, 0.25) << part.x << " " << part.y;
  }
  const double whole = root_mean_square(map, {0, 0, Width, Height});
  EXPECT_NEAR(whole / *render.film().estimated_error(), 1, 0.1);
}

}  // namespace
