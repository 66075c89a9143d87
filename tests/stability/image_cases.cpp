// Pixels of a million samples, and values that must not reach an image.
#include <limits>

#include <half.h>

#include "renderer/image/image_file.h"
#include "renderer/transport/film.h"
#include "renderer/transport/scene/texture.h"
#include "tests/stability/hard_case.h"
#include "tests/support/temporary_folder.h"

namespace test {
namespace {

using image::Image;
using transport::FilmTile;
using transport::Rgb;

constexpr int MillionSamples = 1'000'000;

/// Makes a tile of one pixel.
FilmTile one_pixel() {
  FilmTile tile;
  tile.bounds = {0, 0, 1, 1};
  tile.pixels.resize(1);
  return tile;
}

/// Adds a sample to each of the scramblings in turn; true if it was accepted.
bool add(FilmTile& tile, int sample, const Rgb& radiance) {
  const int scrambling = sample % FilmTile::Scramblings;
  ++tile.counts[static_cast<std::size_t>(scrambling)];
  return tile.add(0, 0, scrambling, radiance);
}

/// Calls `use` with samples within `spread` of the mean.
template <class Use>
void for_each_sample(float mean, float spread, Use use) {
  Random random;
  for (int i = 0; i < MillionSamples; ++i) use(i, mean + spread * random.uniform(-1, 1));
}

Errors mean_of_a_million() {
  FilmTile tile = one_pixel();
  long double exact = 0;
  float naive = 0;
  for_each_sample(0.1F, 0.1F, [&](int i, float value) {
    add(tile, i, Rgb(value));
    exact += value;
    naive += value;
  });
  exact /= MillionSamples;
  return {relative_error(tile.mean(0).x, double(exact)),
          relative_error(naive / MillionSamples, double(exact))};
}

/// Tests the variance of a pixel of 1000 whose samples are within 1 of that.
Errors variance_of_a_million() {
  FilmTile tile = one_pixel();
  std::array<long double, 2> halves = {};
  double about_1000 = 0;
  double squares_about_1000 = 0;
  float sum = 0;
  float squares = 0;
  for_each_sample(1000, 1, [&](int i, float value) {
    add(tile, i, Rgb(value));
    halves[static_cast<std::size_t>(i % 2)] += value;
    about_1000 += double(value) - 1000;
    squares_about_1000 += (double(value) - 1000) * (double(value) - 1000);
    sum += value;
    squares += value * value;
  });
  const long double difference = (halves[0] - halves[1]) / (MillionSamples / 2);
  const double between_halves = static_cast<double>(difference * difference / 4);
  const double shift = about_1000 / MillionSamples;
  const double of_samples = squares_about_1000 / MillionSamples - shift * shift;
  const float mean = sum / MillionSamples;
  return {relative_error(tile.variance(0).x, between_halves),
          relative_error(squares / MillionSamples - mean * mean, of_samples)};
}

/// Tests that invalid samples, one in a thousand, are counted and kept out of the image.
Errors samples_that_are_no_numbers() {
  const std::array<Rgb, 3> wrong = {Rgb(NAN), Rgb(0, std::numeric_limits<float>::infinity(), 0),
                                    Rgb(0, 0, -std::numeric_limits<float>::infinity())};
  FilmTile tile = one_pixel();
  int rejected = 0;
  double naive = 0;
  for (int i = 0; i < MillionSamples; ++i) {
    const Rgb sample = i % 1000 == 7 ? wrong[static_cast<std::size_t>(i / 1000 % 3)] : Rgb(1);
    if (!add(tile, i, sample)) ++rejected;
    naive += double(sample.x + sample.y + sample.z) / (3.0 * MillionSamples);
  }
  if (rejected != MillionSamples / 1000) return {INFINITY, naive};
  const Rgb mean = tile.mean(0);
  return {std::max({relative_error(mean.x, 1), relative_error(mean.y, 1), relative_error(mean.z, 1)}),
          relative_error(naive, 1)};
}

/// Writes a sun of 1e6 and a dark texel of 1e-9 into one file.
Errors range_of_a_file() {
  Image image{64, 1, {}};
  for (const float value : numbers(1e-9F, 1e6F, 64)) image.pixels.emplace_back(value);
  const TemporaryFolder folder;
  grf::Diagnostics diagnostics;
  if (!image::write_image({image}, folder.path("range.exr"), diagnostics)) return {INFINITY, 0};
  const auto read = image::read_image(folder.path("range.exr"), diagnostics);
  if (!read) return {INFINITY, 0};
  Errors errors;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double exact = image.pixels[i].x;
    errors.include(
        {relative_error(read->pixels[i].x, exact), relative_error(half(image.pixels[i].x), exact)});
  }
  return errors;
}

/// Tests a texture of 15000 texels, black and white in turn, repeated 64 times: the value is the distance
/// from the last black texel. Naive code multiplies by the width before it wraps.
Errors wide_texture() {
  constexpr int Width = 15'000;  // no power of two, whose products are exact
  Image image{Width, 1, std::vector<Rgb>(Width)};
  for (int i = 0; i < Width; ++i) image.pixels[static_cast<std::size_t>(i)] = Rgb(static_cast<float>(i % 2));
  const transport::Texture texture(image);
  const auto wave = [](double x) {
    const double place = x - 2 * std::floor(x / 2);
    return place < 1 ? place : 2 - place;
  };
  Random random;
  Errors errors;
  for (int i = 0; i < 10'000; ++i) {
    const float u = random.uniform(0, 64);
    const double exact = wave((double(u) - std::floor(double(u))) * Width - 0.5);
    const float naive = u * float(Width) - 0.5F;
    errors.include(
        {std::abs(double(texture.lookup({u, 0.5F}, 0).x) - exact), std::abs(wave(double(naive)) - exact)});
  }
  return errors;
}

/// Tests a texture of one texel. Naive code stretches it between texels 0 and width - 1, which are 0 apart.
Errors single_texel() {
  const transport::Texture texture(Image{1, 1, {Rgb(0.5F)}});
  Random random;
  Errors errors;
  for (int i = 0; i < 1000; ++i) {
    const grf::Vec2f uv(random.uniform(-9, 9), random.uniform(-9, 9));
    const float footprint = random.log_uniform(1e-9F, 1e9F);
    const float apart = 1.0F / static_cast<float>(texture.width() - 1);
    const float naive = 0.5F * (uv.x * apart) / (uv.x * apart);
    errors.include(
        {relative_error(double(texture.lookup(uv, footprint).x), 0.5), relative_error(double(naive), 0.5)});
  }
  return errors;
}

}  // namespace

std::vector<HardCase> image_cases() {
  return {
      {"Mean of 1e6 samples of a pixel", "a sum in float", "a sum in double", 9e-5, 1e-6, 7e-10,
       mean_of_a_million},
      {"Variance of 1e6 samples of a pixel that is 1000", "the mean square minus the squared mean, in float",
       "the squared difference of two halves, with sums in double", 7e4, 1e-6, 8e-9, variance_of_a_million},
      {"One sample in 1000 is NaN or infinite", "it is accumulated", "it counts as black, and is counted",
       INFINITY, 2e-3, 1e-3, samples_that_are_no_numbers},
      {"Radiance from 1e-9 to 1e6 in an EXR file", "half floats, of 16 bits", "floats, of 32", INFINITY, 0, 0,
       range_of_a_file},
      {"Texture 15000 texels wide, repeated 64 times", "u times the width, then wrapped",
       "wrapped, then times the width", 0.06, 2e-3, 5e-4, wide_texture, "distance in texels"},
      {"Texture of one texel, footprints from 1e-9 to 1e9", "texels 1/(width - 1) apart",
       "texels 1/width apart, which wrap", INFINITY, 0, 0, single_texel},
  };
}

}  // namespace test
