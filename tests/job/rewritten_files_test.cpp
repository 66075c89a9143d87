// Tests that images which are overwritten during a preview or render cannot crash the program.
#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/job/render_job.h"
#include "tests/job/preview_helpers.h"
#include "tests/support/temporary_folder.h"

namespace {

using testing::HasSubstr;

/// Makes a grey portable float map.
std::string grey_float_map(int side, float value) {
  std::string bytes = fmt::format("Pf\n{} {}\n-1\n", side, side);
  for (int i = 0; i < side * side; ++i) bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  return bytes;
}

/// Overwrites a file repeatedly during its lifetime, as image editors do: the file is truncated, then filled.
class Overwriting {
 public:
  Overwriting(const std::string& path, const std::string& bytes)
      : thread_([=](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            std::ofstream file(path, std::ios::binary | std::ios::trunc);
            file.write(bytes.data(), static_cast<std::streamsize>(bytes.size() / 2)).flush();
            std::this_thread::sleep_for(std::chrono::microseconds(500));
            file.write(bytes.data() + bytes.size() / 2,
                       static_cast<std::streamsize>(bytes.size() - bytes.size() / 2));
            file.close();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));  // whoever looks now sees a whole file
          }
        }) {}

 private:
  std::jthread thread_;
};

class RewrittenFiles : public testing::Test {
 protected:
  static constexpr int Side = 1024;

  /// A textured corner, in a file, under an environment map.
  RewrittenFiles() {
    std::string corner = test::Corner;
    corner.insert(corner.find("brdf ward"), "texture \"paper.pfm\" ");
    request_ = test::request(test::scene_of_text(corner, folder_.path("scene.grf")), 8, 8, 1);
    request_.path = folder_.add("scene.grf", corner);
    request_.options.scene = request_.path;
    request_.options.environment = sky_;
  }

  /// Repeats an action while both images are overwritten, at least `times` times and until reading fails
  /// once.
  template <class Work>
  void while_overwritten(int times, const Work& work) {
    const Overwriting paper(paper_, grey_);
    const Overwriting sky(sky_, grey_);
    for (int i = 0; i < 100 && (i < times || diagnostics_.error_count() == 0); ++i) work();
    EXPECT_THAT(diagnostics_.to_text(), testing::AnyOf(HasSubstr("paper.pfm"), HasSubstr("sky.pfm")));
  }

  /// Renders the present files.
  image::Image rendered() {
    grf::Diagnostics diagnostics;
    const auto job = job::render_job(request_.options, diagnostics);
    if (!job) throw std::runtime_error(diagnostics.to_text());
    transport::Render render(job->scene, job->settings);
    render.run();
    return render.film().mean();
  }

  const std::string grey_ = grey_float_map(Side, 0.5F);
  test::TemporaryFolder folder_;
  const std::string paper_ = folder_.add("paper.pfm", grey_);
  const std::string sky_ = folder_.add("sky.pfm", grey_);
  job::PreviewRequest request_;
  grf::Diagnostics diagnostics_;
};

TEST_F(RewrittenFiles, StopNoPreview) {
  job::PreviewScene scene;
  while_overwritten(10, [&] { scene.prepare(request_, {}, diagnostics_); });
  std::filesystem::last_write_time(paper_, std::filesystem::file_time_type::clock::now());
  ASSERT_TRUE(scene.prepare(request_, {}, diagnostics_)) << diagnostics_.to_text();
  EXPECT_NEAR(scene.compiled().textures().at(0).texture->lookup({0.5F, 0.5F}, 0).x, 0.5, 1e-3);
}

TEST_F(RewrittenFiles, StopNoRenderThatStarts) {
  const image::Image before = rendered();
  while_overwritten(10, [&] { job::render_job(request_.options, diagnostics_); });
  EXPECT_EQ(rendered().pixels, before.pixels);
}

TEST_F(RewrittenFiles, StopNoRenderThatIsRunning) {
  const image::Image before = rendered();
  const auto job = job::render_job(request_.options, diagnostics_);
  ASSERT_TRUE(job) << diagnostics_.to_text();
  for (const std::string& path : {paper_, sky_}) std::filesystem::resize_file(path, 20);
  transport::Render render(job->scene, job->settings);
  render.run();
  EXPECT_EQ(render.film().mean().pixels, before.pixels);
}

}  // namespace
