#pragma once

#include <cstdint>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "renderer/transport/checkpoint.h"
#include "tests/transport/scene_helpers.h"

namespace test {

/// Goes on with the render of a checkpoint, or begins it without a file, for about this many paths, which end
/// within a pass, and writes the checkpoint again.
inline void render_part(const transport::CompiledScene& scene, const transport::RenderSettings& settings,
                        std::uint64_t paths, const std::string& checkpoint,
                        const transport::Fingerprint& fingerprint) {
  transport::Render render(scene, settings);
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(resume_from_checkpoint(checkpoint, fingerprint, render, diagnostics)) << diagnostics.to_text();
  const std::uint64_t before = render.path_count();
  std::thread stopper([&] {
    while (render.path_count() < before + paths && render.end() == transport::RenderEnd::NotYet) {
      std::this_thread::yield();
    }
    render.stop();
  });
  render.run();
  stopper.join();
  ASSERT_TRUE(write_checkpoint(checkpoint, fingerprint, render, diagnostics)) << diagnostics.to_text();
}

/// Renders what a checkpoint leaves to do, and returns the image.
inline image::Image resumed(const transport::CompiledScene& scene, const transport::RenderSettings& settings,
                            const std::string& checkpoint, const transport::Fingerprint& fingerprint) {
  transport::Render render(scene, settings);
  grf::Diagnostics diagnostics;
  EXPECT_TRUE(resume_from_checkpoint(checkpoint, fingerprint, render, diagnostics)) << diagnostics.to_text();
  render.run();
  const double pixels = static_cast<double>(settings.width) * settings.height;
  EXPECT_EQ(static_cast<double>(render.path_count()), settings.samples * pixels);
  return render.film().mean();
}

}  // namespace test
