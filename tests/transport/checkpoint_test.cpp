#include "renderer/transport/checkpoint.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/transport/interrupted_render.h"

namespace {

using image::Image;
using transport::Fingerprint;
using transport::Render;
using transport::RenderEnd;
using transport::RenderSettings;

constexpr Fingerprint Ours = {{1}, {2}, {3}};

class Checkpoint : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::string path_ = folder_.path("state");
  transport::CompiledScene scene_ =
      test::scene_of("light begin rgb (9,9,9) (-1,3,-1) (2,0,0) (0,0,2) end\n" +
                     test::quad("brdf diffuse kd=0.7", "(-3,0,3) (3,0,3) (3,0,-3) (-3,0,-3)"));

  static RenderSettings settings(int samples) {
    test::RenderSetup setup;
    setup.eye = transport::Vec3f(0, 2, 5);
    setup.width = 45;
    setup.height = 33;
    setup.samples = samples;
    return test::settings_of(setup);
  }

  Image whole(const RenderSettings& settings) const {
    Render render(scene_, settings);
    render.run();
    return render.film().mean();
  }

  void render_part(const RenderSettings& settings, std::uint64_t paths) const {
    test::render_part(scene_, settings, paths, path_, Ours);
  }

  Image resumed(const RenderSettings& settings) const { return test::resumed(scene_, settings, path_, Ours); }

  /// Rendering until a target error gives the same image, interrupted after this many paths or not.
  void expect_same_end(const RenderSettings& until, std::uint64_t paths) const {
    Render uninterrupted(scene_, until);
    uninterrupted.run();
    render_part(until, paths);
    Render render(scene_, until);
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(resume_from_checkpoint(path_, Ours, render, diagnostics));
    render.run();
    EXPECT_EQ(render.film().mean().pixels, uninterrupted.film().mean().pixels);
    EXPECT_EQ(render.path_count(), uninterrupted.path_count());
  }

  /// Returns the message that refuses the file, which stays unchanged.
  std::string refusal(const Fingerprint& fingerprint, const RenderSettings& settings) const {
    const std::string before = test::bytes_of(path_);
    Render render(scene_, settings);
    grf::Diagnostics diagnostics;
    EXPECT_FALSE(resume_from_checkpoint(path_, fingerprint, render, diagnostics));
    EXPECT_EQ(diagnostics.error_count(), 1U);
    EXPECT_EQ(render.path_count(), 0U);
    EXPECT_TRUE(test::bytes_of(path_) == before);
    return diagnostics.to_text();
  }
};

TEST_F(Checkpoint, IsWrittenWhileWorkersGoOn) {
  const Image expected = whole(settings(200));
  Render render(scene_, settings(200));
  std::thread worker([&] { render.run(); });
  int written = 0;
  grf::Diagnostics diagnostics;
  while (render.end() == RenderEnd::NotYet && written < 50) {
    ASSERT_TRUE(write_checkpoint(path_, Ours, render, diagnostics)) << diagnostics.to_text();
    ++written;
  }
  render.stop();
  worker.join();
  EXPECT_GT(written, 0);
  EXPECT_EQ(resumed(settings(200)).pixels, expected.pixels);
}

TEST_F(Checkpoint, OfAFinishedRenderGoesOnWithMoreSamples) {
  EXPECT_EQ(resumed(settings(7)).pixels, whole(settings(7)).pixels);  // no file: from the start
  render_part(settings(7), 7 * 45 * 33);
  EXPECT_EQ(resumed(settings(7)).pixels, whole(settings(7)).pixels);
  EXPECT_EQ(resumed(settings(20)).pixels, whole(settings(20)).pixels);
}

TEST_F(Checkpoint, LeadsToTheSameSampleAtATargetError) {
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.target_error = 0.03;
  expect_same_end(until, 45 * 33 * 18);  // between two error checks
}

// Interrupted within the pilot's halves and later, and resumed with more samples.
TEST_F(Checkpoint, OfAnAdaptiveRenderGoesOn) {
  RenderSettings adaptive = settings(100);
  adaptive.adaptive = true;
  const Image expected = whole(adaptive);
  EXPECT_NE(expected.pixels, whole(settings(100)).pixels);
  const auto finished = [&](const RenderSettings& asked) {
    Render render(scene_, asked);
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(resume_from_checkpoint(path_, Ours, render, diagnostics)) << diagnostics.to_text();
    render.run();
    EXPECT_TRUE(write_checkpoint(path_, Ours, render, diagnostics));
    return render.film().mean();
  };
  for (const int first : {8, 20, 27, 60}) {
    std::filesystem::remove(path_);
    for (const int samples : {first, 30}) {
      render_part(adaptive, static_cast<std::uint64_t>(samples) * 45 * 33);
    }
    EXPECT_EQ(finished(adaptive).pixels, expected.pixels) << first;
  }
  std::filesystem::remove(path_);
  for (const int samples : {20, 50, 77}) {
    RenderSettings fewer = adaptive;
    fewer.samples = samples;
    EXPECT_EQ(finished(fewer).pixels, whole(fewer).pixels) << samples;
  }
  EXPECT_EQ(finished(adaptive).pixels, expected.pixels);
}

TEST_F(Checkpoint, OfAnAdaptiveRenderLeadsToTheSameEndAtATargetError) {
  RenderSettings until = settings(RenderSettings::Unlimited);
  until.target_error = 0.02;
  until.adaptive = true;
  expect_same_end(until, 45 * 33 * 40);
}

TEST_F(Checkpoint, KeepsWhatWasDoneInAllRuns) {
  render_part(settings(100), 20000);
  Render render(scene_, settings(100));
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(resume_from_checkpoint(path_, Ours, render, diagnostics));
  const transport::RenderTotals before = render.totals();
  EXPECT_GE(before.paths, 20000U);
  EXPECT_GT(before.rays, before.paths);
  EXPECT_GT(before.seconds, 0);
  EXPECT_GT(render.progress().done, 0);
  EXPECT_NEAR(render.progress().done, static_cast<double>(before.paths) / (45 * 33 * 100), 1e-9);
}

TEST_F(Checkpoint, OfAnotherImageIsRefused) {
  render_part(settings(10), 3000);
  EXPECT_NE(refusal({{9}, {2}, {3}}, settings(10)).find("with other options"), std::string::npos);
  EXPECT_NE(refusal({{1}, {9}, {3}}, settings(10)).find("of a scene with other contents"), std::string::npos);
  EXPECT_NE(refusal({{1}, {2}, {9}}, settings(10)).find("by another build of bpt"), std::string::npos);
  RenderSettings other = settings(10);
  std::swap(other.width, other.height);
  EXPECT_NE(refusal(Ours, other).find("with other options"), std::string::npos);
  EXPECT_NE(refusal(Ours, settings(1)).find("more than the 1 requested"), std::string::npos);
}

TEST_F(Checkpoint, ThatIsBrokenIsRefused) {
  render_part(settings(10), 3000);
  const std::string bytes = test::bytes_of(path_);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 97) {
    folder_.add("state", bytes.substr(0, size));
    EXPECT_NE(refusal(Ours, settings(10)).find("cannot resume from the checkpoint: "), std::string::npos);
  }
  for (std::size_t place = 0; place < bytes.size(); place += 1 + bytes.size() / 97) {
    std::string changed = bytes;
    changed[place] = static_cast<char>(changed[place] ^ 0x10);
    folder_.add("state", changed);
    EXPECT_NE(refusal(Ours, settings(10)).find("cannot resume from the checkpoint: "), std::string::npos);
  }
  folder_.add("state", bytes + "more");
  EXPECT_NE(refusal(Ours, settings(10)).find("it is damaged"), std::string::npos);
  folder_.add("state", "BPT_Scene a.grf\n");
  EXPECT_NE(refusal(Ours, settings(10)).find("it is not a checkpoint"), std::string::npos);
}

TEST_F(Checkpoint, ThatCannotBeWrittenIsAnError) {
  Render render(scene_, settings(1));
  render.run();
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(write_checkpoint(folder_.path("no/such/folder"), Ours, render, diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 1U);
}

}  // namespace
