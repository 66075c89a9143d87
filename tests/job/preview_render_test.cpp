#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/job/preview_stages.h"
#include "renderer/job/render_job.h"
#include "tests/job/preview_helpers.h"
#include "tests/support/camera_image.h"
#include "tests/support/samples.h"
#include "tests/support/temporary_folder.h"

namespace {

using job::PreviewRender;
using job::PreviewRequest;
using job::PreviewState;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;

double milliseconds_between(Clock::time_point start, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - start).count();
}

image::Image rendered(const options::RenderOptions& render_options) {
  grf::Diagnostics diagnostics;
  const auto render_job = job::render_job(render_options, diagnostics);
  if (!render_job) throw std::runtime_error(diagnostics.to_text());
  transport::Render render(render_job->scene, render_job->settings);
  render.run();
  return render.film().mean();
}

PreviewRequest sample_request(const std::string& path) {
  PreviewRequest request = test::request({});
  grf::Diagnostics diagnostics;
  request.path = (test::samples_folder() / path).string();
  request.options.scene = request.path;
  auto scene = job::read_scene(request.options, diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  request.scene = std::move(*scene);
  request.options.eye = grf::Vec3f(278, 273, -800);
  request.options.target = grf::Vec3f(278, 273, 0);
  request.options.field_of_view = 39.3076F;
  return request;
}

TEST(Preview, BeginsCoarseAndEndsWithTheImageOfTheRender) {
  const PreviewRequest request = sample_request("cornell_box/cornell_box.grf");
  test::PreviewRecorder recorder;
  PreviewRender preview(recorder.listener());
  const int number = preview.start(request);
  ASSERT_TRUE(recorder.reaches(number, PreviewState::Done)) << recorder.text(number);
  const auto images = recorder.images(number);
  ASSERT_GE(images.size(), 3U);
  EXPECT_EQ(images.front().image->width, 12 * 2) << "an eighth would be too small";
  EXPECT_EQ(images.front().progress.done, 0);
  EXPECT_EQ(images.back().image->pixels, rendered(request.options).pixels);
  EXPECT_EQ(images.back().progress.done, 1);
  for (const test::PreviewRecorder::Event& shown : images) test::expect_cornell_box(*shown.image);
}

/// Nothing else is traced: the pixels are those of the whole render, and the others are black.
TEST(Preview, RendersOnlyItsRegion) {
  PreviewRequest request = sample_request("cornell_box/cornell_box.grf");
  const image::Image whole = rendered(request.options);
  for (const bool denoises : {false, true}) {
    request.region = job::PreviewRegion{0.3, 0.25, 0.7, 0.9};
    request.denoises = denoises;
    test::PreviewRecorder recorder;
    PreviewRender preview(recorder.listener());
    const int number = preview.start(request);
    ASSERT_TRUE(recorder.reaches(number, PreviewState::Done)) << recorder.text(number);
    const auto images = recorder.images(number);
    const image::Image& last = *images.back().image;
    ASSERT_EQ(last.width, whole.width);
    ASSERT_EQ(last.height, whole.height);
    double lit = 0;
    for (int y = 0; y < whole.height; ++y) {
      for (int x = 0; x < whole.width; ++x) {
        const bool is_inside = x + 1 > 0.3 * whole.width && x < 0.7 * whole.width &&
                               y + 1 > 0.25 * whole.height && y < 0.9 * whole.height;
        if (!is_inside) {
          ASSERT_EQ(last.at(x, y), reflectance::Rgb(0)) << x << ' ' << y;
        } else if (!denoises) {
          ASSERT_EQ(last.at(x, y), whole.at(x, y)) << x << ' ' << y;
        }
        lit += double(last.at(x, y).y);
      }
    }
    EXPECT_GT(lit, 0);
    EXPECT_EQ(images.back().progress.done, 1);
  }
}

// A lit floor: where it is seen the error is that of the render, and where nothing is there is none.
TEST(Preview, MeasuresTheErrorOfItsPixels) {
  PreviewRequest request = test::request(test::scene_of_text(test::Corner), 96, 72, 16);
  for (const auto& region :
       {std::optional<job::PreviewRegion>(), {job::PreviewRegion{0.25, 0.25, 0.75, 1}}}) {
    request.region = region;
    test::PreviewRecorder recorder;
    PreviewRender preview(recorder.listener());
    const int number = preview.start(request);
    ASSERT_TRUE(recorder.reaches(number, PreviewState::Done)) << recorder.text(number);
    ASSERT_FALSE(recorder.accuracies(number).empty());
    const image::Image& error = recorder.accuracies(number).back()->error;
    const image::Image& image = *recorder.images(number).back().image;
    ASSERT_EQ(error.width, 96);
    ASSERT_EQ(error.height, 72);
    double squares = 0;
    for (std::size_t i = 0; i < error.pixels.size(); ++i) {
      ASSERT_TRUE(std::isfinite(error.pixels[i].x));
      squares += double(error.pixels[i].x) * double(error.pixels[i].x);
    }
    const auto estimate = recorder.images(number).back().progress.estimated_error;
    ASSERT_TRUE(estimate);
    const double pixels = region ? 48 * 54 : 96 * 72;
    EXPECT_NEAR(std::sqrt(squares / pixels) / *estimate, 1, 0.3);
    EXPECT_EQ(image.at(0, 0), transport::Rgb(0)) << "nothing is there";
    EXPECT_EQ(error.at(0, 0), transport::Rgb(0));
    EXPECT_GT(error.at(48, 48).x, 0.001F) << "the floor";
  }
}

TEST(PreviewStages, HaveTheRegionInEachResolution) {
  transport::RenderSettings whole;
  whole.width = 804;
  whole.height = 600;
  const auto stages = job::preview_stages(whole, job::PreviewRegion{0.25, 0.5, 0.5, 1});
  ASSERT_EQ(stages.size(), 4U);
  EXPECT_EQ(stages[0].width, 101);
  EXPECT_EQ(*stages[0].crop, (transport::CropWindow{25, 37, 26, 38}));
  EXPECT_EQ(*stages[3].crop, (transport::CropWindow{201, 300, 201, 300}));
  for (const auto& stage : job::preview_stages(whole)) EXPECT_FALSE(stage.crop);
  EXPECT_EQ(job::pixels_of({0.999, 0.999, 0.9995, 2}, 10, 10), (transport::CropWindow{9, 9, 1, 1}));
}

TEST(Preview, GoesOnAfterAPauseAsThoughThereHadBeenNone) {
  const PreviewRequest request = test::request(test::scene_of_text(test::Corner), 96, 72, 150);
  test::PreviewRecorder recorder;
  PreviewRender preview(recorder.listener());
  const int number = preview.start(request);
  ASSERT_TRUE(recorder.shows(number, 3));
  preview.pause();
  ASSERT_TRUE(recorder.reaches(number, PreviewState::Paused));
  const std::size_t images = recorder.images(number).size();
  preview.resume();
  ASSERT_TRUE(recorder.reaches(number, PreviewState::Done));
  EXPECT_GT(recorder.images(number).size(), images);
  const int undisturbed = preview.start(request);
  ASSERT_TRUE(recorder.reaches(undisturbed, PreviewState::Done));
  EXPECT_EQ(recorder.images(number).back().image->pixels, recorder.images(undisturbed).back().image->pixels);
  test::expect_lit_corner(*recorder.images(number).back().image);
}

TEST(Preview, ShowsWhatWasStartedLast) {
  PreviewRequest request = test::request(test::scene_of_text(test::Corner), 96, 72, 100'000);
  test::PreviewRecorder recorder;
  PreviewRender preview(recorder.listener());
  int number = 0;
  for (int i = 0; i < 30; ++i) {
    const float red = static_cast<float>(i) / 58;
    test::first_mesh(request.scene).edit().surfaces[0].colour = grf::Colour(red, 1, 1);
    number = preview.start(request);
    if (i % 3 == 0) {
      ASSERT_TRUE(recorder.shows(number)) << recorder.text(number);
    }
    if (i % 7 == 0) preview.pause();
  }
  ASSERT_TRUE(recorder.shows(number, 5));
  // Each bounce halves red: the floor reflects direct light once, and indirect light more often.
  const transport::Rgb floor = test::floor_of_corner(*recorder.images(number).back().image);
  EXPECT_EQ(floor.y, floor.z);
  EXPECT_LE(floor.x, 0.5001F * floor.y);
  EXPECT_GT(floor.x, 0.4F * floor.y);
  preview.stop();
  request.options.samples = 1;
  ASSERT_TRUE(recorder.reaches(preview.start(request), PreviewState::Done));
}

TEST(Preview, EndsAtOnce) {
  test::PreviewRecorder recorder;
  double least = 1e9;
  for (int i = 0; i < 5; ++i) {
    auto preview = std::make_unique<PreviewRender>(recorder.listener());
    const int number = preview->start(test::request(test::waves(100), 800, 600, 100'000));
    ASSERT_TRUE(recorder.shows(number, 4 + 4 * static_cast<std::size_t>(i)));
    const auto start = Clock::now();
    preview.reset();
    least = std::min(least, milliseconds_between(start, Clock::now()));
  }
  RecordProperty("milliseconds", static_cast<int>(least));
#if !defined(GRANADA_HAS_SANITIZERS) && defined(NDEBUG)
  EXPECT_LT(least, 50);
#endif
}

TEST(Preview, SaysWhyThereIsNone) {
  PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  request.options.environment = "no_sky.exr";
  test::PreviewRecorder recorder;
  PreviewRender preview(recorder.listener());
  const int number = preview.start(request);
  ASSERT_TRUE(recorder.reaches(number, PreviewState::Failed));
  EXPECT_THAT(recorder.text(number), HasSubstr("no_sky.exr"));
  EXPECT_TRUE(recorder.images(number).empty());
}

/// Returns the minimum latency from an edit to the first new image, in ms; other programs run too.
template <class Edit>
double least_restart(PreviewRequest request, const Edit& edit) {
  test::PreviewRecorder recorder;
  PreviewRender preview(recorder.listener());
  recorder.shows(preview.start(request), 4);
  double least = 1e9;
  for (int i = 1; i <= 8; ++i) {
    edit(request, static_cast<float>(i) / 8);
    const auto start = Clock::now();
    const int number = preview.start(request);
    if (!recorder.shows(number)) throw std::runtime_error(recorder.text(number));
    least = std::min(least, milliseconds_between(start, recorder.images(number).front().time));
  }
  return least;
}

void edit_surface(PreviewRequest& request, float amount) {
  test::first_mesh(request.scene).edit().surfaces[0].colour = grf::Colour(amount, 1, 1);
}
void edit_view(PreviewRequest& request, float amount) { request.options.eye->x += amount; }
void edit_shape(PreviewRequest& request, float amount) {
  grf::Mesh& mesh = test::first_mesh(request.scene).edit();
  grf::Geometry geometry = *mesh.geometry;
  geometry.positions[0].y += amount;
  mesh.geometry = std::move(geometry);
}

TEST(Preview, ShowsAnEditWithinATenthOfASecond) {
  const std::vector<std::pair<std::string, PreviewRequest>> requests = {
      {"cornell box", sample_request("cornell_box/cornell_box.grf")},
      {"70,000 faces", test::request(test::waves(187))},
      {"100,000 triangles", test::request(test::waves(224))}};
  const std::vector<std::pair<std::string, void (*)(PreviewRequest&, float)>> edits = {
      {"surface", edit_surface}, {"view", edit_view}, {"shape", edit_shape}};
  for (auto [name, request] : requests) {
    request.options.size = {800, 600};
    request.options.samples = 100'000;
    for (const auto& [what, edit] : edits) {
      const double least = least_restart(request, edit);
      std::cout << name << ", " << what << ": " << least << " ms\n";
#if !defined(GRANADA_HAS_SANITIZERS) && defined(NDEBUG)
      EXPECT_LT(least, 100) << name << ", " << what;
#endif
    }
  }
}

}  // namespace
