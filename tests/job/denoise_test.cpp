#include "renderer/job/denoise.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/job/preview_helpers.h"

namespace {

using image::Image;
using reflectance::Rgb;
using transport::FeatureLayers;

constexpr int Side = 96;

Image filled(const Rgb& value) { return {Side, Side, std::vector<Rgb>(Side * Side, value)}; }

/// The guides of one plane.
FeatureLayers plane_guides() {
  return {filled(Rgb(0.5F)), filled(Rgb(0, 0, 1)), std::vector<float>(Side * Side, 2.0F)};
}

/// Adds independent normal noise to an image.
Image with_noise(Image image, float deviation) {
  std::mt19937 bits(5);
  std::normal_distribution<float> noise(0, deviation);
  for (Rgb& pixel : image.pixels) pixel += Rgb(noise(bits), noise(bits), noise(bits));
  return image;
}

/// The root of the mean squared difference of the columns from `begin` to `end`.
double error_of(const Image& image, const Image& truth, int begin = 0, int end = Side) {
  double sum = 0;
  for (int y = 0; y < Side; ++y) {
    for (int x = begin; x < end; ++x) sum += static_cast<double>((image.at(x, y) - truth.at(x, y)).length2());
  }
  return std::sqrt(sum / (3.0 * Side * (end - begin)));
}

/// Fills the right half.
void fill_right(Image& image, const Rgb& value) {
  for (int y = 0; y < Side; ++y) {
    for (int x = Side / 2; x < Side; ++x) image.pixels[static_cast<std::size_t>(y * Side + x)] = value;
  }
}

TEST(Denoise, ReducesNoiseOnASurface) {
  const Image truth = filled(Rgb(1));
  const Image noisy = with_noise(truth, 0.2F);
  const Image result = job::denoised(noisy, filled(Rgb(0.04F)), true, plane_guides());
  EXPECT_NEAR(error_of(noisy, truth), 0.2, 0.01);
  EXPECT_LT(error_of(result, truth), 0.2 / 5);
}

// Without stops, the five levels are a convolution by a fixed, separable kernel: (1 4 6 4 1)/16 spread by 1,
// 2, 4, 8 and 16.
TEST(Denoise, IsTheSplinesConvolutionWhereNothingStopsIt) {
  const Image truth = filled(Rgb(1));
  const Image noisy = with_noise(truth, 0.2F);
  Image impulse = filled(Rgb(0));
  impulse.pixels[static_cast<std::size_t>(Side / 2 * Side + Side / 2)] = Rgb(1);
  const Image result = job::denoised(impulse, filled(Rgb(0)), false, plane_guides());
  std::vector<double> row(2 * Side + 1, 0.0);
  row[Side] = 1;
  for (int step = 1; step <= 16; step *= 2) {
    std::vector<double> next(row.size(), 0.0);
    for (int i = 0; i < static_cast<int>(row.size()); ++i) {
      for (int k = -2; k <= 2; ++k) {
        const int from = i + k * step;
        if (from < 0 || from >= static_cast<int>(row.size())) continue;
        constexpr double Binomial[] = {1, 4, 6, 4, 1};
        next[static_cast<std::size_t>(i)] += Binomial[k + 2] / 16 * row[static_cast<std::size_t>(from)];
      }
    }
    row = next;
  }
  // Near the border, what is cut off changes the weights; at the centre it does not yet.
  EXPECT_NEAR(result.at(Side / 2, Side / 2).x, row[Side] * row[Side], 2e-3 * row[Side] * row[Side]);
  EXPECT_LT(error_of(job::denoised(noisy, filled(Rgb(0)), false, plane_guides()), truth), 0.2 / 8);
}

TEST(Denoise, KeepsEdgesOfNormalsAlbedoAndDepth) {
  Image truth = filled(Rgb(0.2F));
  fill_right(truth, Rgb(0.8F));
  const Image noisy = with_noise(truth, 0.1F);
  for (const char* edge : {"normal", "albedo", "depth", "background"}) {
    FeatureLayers guides = plane_guides();
    if (*edge == 'n') fill_right(guides.normal, Rgb(1, 0, 0));
    if (*edge == 'a') fill_right(guides.albedo, Rgb(0.9F));
    for (std::size_t i = 0; i < guides.depth.size(); ++i) {
      if (i % Side < Side / 2) continue;
      if (*edge == 'd') guides.depth[i] = 200;
      if (*edge == 'b') guides.depth[i] = INFINITY;
    }
    // Colours are said to be unknown, so that only the guide keeps the edge.
    const Image result = job::denoised(noisy, filled(Rgb(0)), false, guides);
    EXPECT_LT(error_of(result, truth, Side / 2 - 4, Side / 2 + 4), 0.04) << edge;
  }
  const Image blurred = job::denoised(noisy, filled(Rgb(0)), false, plane_guides());
  EXPECT_GT(error_of(blurred, truth, Side / 2 - 4, Side / 2 + 4), 0.2) << "without a guide it is lost";
}

TEST(Denoise, LeavesWhatHasNoVariance) {
  Image truth = filled(Rgb(0.2F));
  fill_right(truth, Rgb(0.25F));  // a shadow, of which the guides know nothing
  const Image result = job::denoised(truth, filled(Rgb(0)), true, plane_guides());
  EXPECT_LT(error_of(result, truth), 1e-5);
}

TEST(Denoise, OfAPreviewIsNearerToTheConvergedImage) {
  const auto last_image = [](int samples, bool denoises) {
    test::PreviewRecorder recorder;
    job::PreviewRender preview(recorder.listener());
    job::PreviewRequest request = test::request(test::scene_of_text(test::Corner), Side, Side, samples);
    request.denoises = denoises;
    const int number = preview.start(request);
    EXPECT_TRUE(recorder.reaches(number, job::PreviewState::Done));
    Image image = *recorder.images(number).back().image;
    // The light above is so bright that the antialiasing of its edge would outweigh all noise.
    std::fill_n(image.pixels.begin(), 16 * Side, Rgb(0));
    return image;
  };
  const Image converged = last_image(1024, false);
  const double noisy = error_of(last_image(4, false), converged);
  const double smooth = error_of(last_image(4, true), converged);
  EXPECT_LT(smooth, 0.5 * noisy);
}

}  // namespace
