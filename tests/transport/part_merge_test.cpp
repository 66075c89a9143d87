#include "renderer/transport/part_merge.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/transport/scene_helpers.h"

namespace {

using testing::HasSubstr;
using transport::Fingerprint;
using transport::ImagePart;
using transport::PartMerge;
using transport::Render;
using transport::RenderSettings;

constexpr Fingerprint OfImage = {{1}, {2}, {3}};

class Parts : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  transport::CompiledScene scene_ =
      test::scene_of("light begin rgb (9,9,9) (-1,3,-1) (2,0,0) (0,0,2) end\n" +
                     test::quad("brdf diffuse kd=0.7", "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)"));

  static RenderSettings settings(int samples) {
    test::RenderSetup setup;
    setup.eye = transport::Vec3f(0, 2, 5);
    setup.width = 37;
    setup.height = 33;
    setup.samples = samples;
    return test::settings_of(setup);
  }

  /// Renders a part and writes it to a file, which may be given several times.
  std::string rendered(RenderSettings settings, const ImagePart& part,
                       const Fingerprint& fingerprint = OfImage) const {
    settings.part = part;
    Render render(scene_, settings);
    render.run();
    transport::SamplePart written = part_of(render, fingerprint, settings.samples);
    written.description = "of sample 0";
    if (!written.tiles.front().has_first_sample()) written.description = "of none";
    static int number = 0;
    const std::string path = folder_.path("part" + std::to_string(number++));
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(write_part(path, written, diagnostics)) << diagnostics.to_text();
    return path;
  }

  /// Merges files; errors are expected to be these.
  static PartMerge merged(const std::vector<std::string>& paths, const std::string& expected_error = "") {
    PartMerge merge;
    grf::Diagnostics diagnostics;
    for (const std::string& path : paths) {
      auto part = transport::read_part(path, diagnostics);
      if (part) merge.add(std::move(*part), path, diagnostics);
    }
    if (expected_error.empty()) {
      EXPECT_EQ(diagnostics.to_text(), "");
    } else {
      EXPECT_THAT(diagnostics.to_text(), HasSubstr(expected_error));
    }
    return merge;
  }

  void expect_whole(const PartMerge& merge, const RenderSettings& settings) const {
    Render render(scene_, settings);
    render.run();
    const transport::Film film = merge.film();
    EXPECT_EQ(film.mean().pixels, render.film().mean().pixels);
    EXPECT_EQ(film.variance().pixels, render.film().variance().pixels);
    EXPECT_EQ(film.error_estimate().value_or(transport::ErrorEstimate()).high,
              render.film().error_estimate().value_or(transport::ErrorEstimate()).high);
    EXPECT_EQ(merge.sum().totals.paths, render.path_count());
    EXPECT_EQ(merge.sum().totals.rays, render.ray_count());
    EXPECT_EQ(merge.sum().description, "of sample 0");
    EXPECT_THAT(merge.missing(), testing::IsEmpty());
  }
};

TEST_F(Parts, AddUpToTheImageOfOneProcess) {
  for (const int samples : {1, 7, 16}) {
    for (const int count : {1, 2, 3, 7, 40}) {
      SCOPED_TRACE(std::to_string(samples) + " samples in parts " + std::to_string(count));
      std::vector<std::string> paths;
      for (int index = 0; index < count; ++index) {
        paths.push_back(rendered(settings(samples), {.index = index, .count = count}));
      }
      std::shuffle(paths.begin(), paths.end(), std::mt19937(static_cast<unsigned>(count)));
      expect_whole(merged(paths), settings(samples));
    }
  }
}

// Each division cuts samples and tiles at random; the parts are merged in random groups, and these in random
// order.
TEST_F(Parts, AddUpOverAnyPartitionAndOrder) {
  constexpr int Samples = 5;
  constexpr int Tiles = 9;
  Render whole(scene_, settings(Samples));
  whole.run();
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::string> paths;
    const int tile_cut = static_cast<int>(1 + random() % (Tiles - 1));
    for (const auto& [first_tile, end_tile] : {std::pair(0, tile_cut), std::pair(tile_cut, Tiles)}) {
      const int cut = static_cast<int>(random() % Samples);
      const int count = static_cast<int>(1 + random() % 4);
      if (cut > 0) paths.push_back(rendered(settings(Samples), {0, cut, first_tile, end_tile}));
      for (int index = 0; index < count; ++index) {
        paths.push_back(rendered(settings(Samples), {cut, Samples, first_tile, end_tile, index, count}));
      }
    }
    std::shuffle(paths.begin(), paths.end(), random);
    const auto middle = paths.begin() + static_cast<std::ptrdiff_t>(1 + random() % (paths.size() - 1));
    const std::string group = folder_.path("group" + std::to_string(seed));
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(write_part(group, merged({paths.begin(), middle}).sum(), diagnostics));
    paths.erase(paths.begin(), middle);
    paths.insert(paths.begin() + static_cast<std::ptrdiff_t>(random() % (paths.size() + 1)), group);
    const PartMerge all = merged(paths);
    ASSERT_EQ(all.film().mean().pixels, whole.film().mean().pixels) << seed;
    ASSERT_TRUE(all.missing().empty()) << seed;
  }
}

TEST_F(Parts, OfAdaptiveImagesFollowTheirPilot) {
  RenderSettings adaptive = settings(64);
  adaptive.adaptive = true;
  std::vector<std::string> paths;
  for (int index = 0; index < 3; ++index) paths.push_back(rendered(adaptive, {.index = index, .count = 3}));
  EXPECT_EQ(merged({paths[0], paths[2]}).missing(), (std::vector<ImagePart>{{.index = 1, .count = 3}}));
  const PartMerge pilot = merged(paths);
  ASSERT_TRUE(pilot.has_whole_pilot());
  EXPECT_EQ(pilot.missing(), std::vector<ImagePart>{ImagePart()}) << "all that follows the pilot";
  const auto counts = transport::AdaptiveSampling(pilot.film()).counts(adaptive.samples);
  for (int index = 0; index < 4; ++index) {
    const ImagePart part = {.index = index, .count = 4};
    adaptive.part_samples = transport::samples_of(
        part, counts, transport::uniform_counts(transport::AdaptiveSampling::PilotSamples));
    paths.push_back(rendered(adaptive, part));
  }
  std::shuffle(paths.begin(), paths.end(), std::mt19937(7));
  RenderSettings whole = settings(64);
  whole.adaptive = true;
  expect_whole(merged(paths), whole);
}

TEST_F(Parts, ThatLackAreThoseOfTheSameDivision) {
  const std::vector<std::string> paths = {rendered(settings(16), {.index = 0, .count = 5}),
                                          rendered(settings(16), {.index = 3, .count = 5})};
  const std::vector<ImagePart> missing = merged(paths).missing();
  EXPECT_EQ(missing, (std::vector<ImagePart>{
                         {.index = 1, .count = 5}, {.index = 2, .count = 5}, {.index = 4, .count = 5}}));
}

// Whatever there is, rendering what lacks makes the image whole.
TEST_F(Parts, ThatLackMakeTheImageWhole) {
  std::vector<std::string> paths = {rendered(settings(16), {0, 6, 0, 4, 1, 3}),
                                    rendered(settings(16), {9, 12, 3, 7}), rendered(settings(16), {7, 8})};
  for (const ImagePart& part : merged(paths).missing()) paths.push_back(rendered(settings(16), part));
  expect_whole(merged(paths), settings(16));
}

TEST_F(Parts, AreTakenOnce) {
  std::vector<std::string> paths;
  for (int index = 0; index < 3; ++index)
    paths.push_back(rendered(settings(4), {.index = index, .count = 3}));
  for (int index = 0; index < 3; ++index)
    paths.push_back(rendered(settings(4), {.index = index, .count = 3}));
  expect_whole(merged(paths), settings(4));
}

TEST_F(Parts, WithOtherValuesAreRefused) {
  const std::string right = rendered(settings(4), {.index = 0, .count = 3});
  grf::Diagnostics diagnostics;
  auto altered = transport::read_part(right, diagnostics);
  ASSERT_TRUE(altered);
  altered->tiles[3].pixels[5][0].add(transport::Rgb(0, 0x1p-60F, 0));
  const std::string wrong = folder_.path("wrong");
  ASSERT_TRUE(write_part(wrong, *altered, diagnostics));
  merged({right, wrong},
         "wrong: error: it has samples of '" + right + "', with other values: one of them is wrong");
}

TEST_F(Parts, OfOtherImagesAreRefused) {
  const std::string first = rendered(settings(4), {.index = 0, .count = 3});
  const auto other = [&](const Fingerprint& fingerprint) {
    return rendered(settings(4), {.index = 1, .count = 3}, fingerprint);
  };
  const std::string of = "it is no part of the image that '" + first + "' is of: ";
  merged({first, other({{9}, {2}, {3}})}, of + "it has other options");
  merged({first, other({{1}, {9}, {3}})}, of + "the scene has other contents");
  merged({first, other({{1}, {2}, {9}})}, of + "it is by another build of bpt");
  merged({first, rendered(settings(5), {.index = 1, .count = 3})},
         of + "it has 5 samples per pixel, and that one 4");
  RenderSettings larger = settings(4);
  larger.width = 50;
  merged({first, rendered(larger, {.index = 1, .count = 3})}, of + "it has other options");
  merged({first, rendered(settings(4), {0, 2})},
         "it has samples of '" + first + "', but not all, or others besides");
}

TEST_F(Parts, ThatWereCutOffOrAlteredAreRefused) {
  const std::string path = rendered(settings(4), {.index = 1, .count = 3});
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto expect_refused = [&](const std::string& damaged, const std::string& why) {
    const std::string name = folder_.add("damaged", damaged);
    merged({name}, "damaged: error: cannot use the part file: " + why);
  };
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{7}, std::size_t{20}, std::size_t{100}, bytes.size() - 1}) {
    expect_refused(bytes.substr(0, size), "it is ");
  }
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    std::string altered = bytes;
    altered[random() % altered.size()] ^= static_cast<char>(1U << random() % 8);
    expect_refused(altered, "it is ");
  }
}

// The check sum is made anew, so that contents are read that no program has written.
TEST_F(Parts, OfNonsenseAreRefusedWithoutHarm) {
  const std::string path = rendered(settings(2), {.index = 1, .count = 40});
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  std::mt19937 random(2);
  int read = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string altered = bytes.substr(0, bytes.size() - 4);
    const std::size_t most = i % 2 == 0 ? std::min<std::size_t>(altered.size(), 300) : altered.size();
    for (unsigned k = 0; k <= random() % 3; ++k) altered[random() % most] = static_cast<char>(random());
    if (i % 5 == 0) altered.resize(random() % altered.size());
    const std::uint32_t sum = transport::check_sum(0, altered);
    const std::string name = folder_.add("nonsense", altered.append(reinterpret_cast<const char*>(&sum), 4));
    grf::Diagnostics diagnostics;
    auto part = transport::read_part(name, diagnostics);
    EXPECT_NE(part.has_value(), diagnostics.has_errors());
    if (!part) continue;
    ++read;
    PartMerge merge;
    EXPECT_TRUE(merge.add(std::move(*part), name, diagnostics));
    merge.film();
  }
  EXPECT_GT(read, 30) << "some values have no wrong ones";
}

}  // namespace
