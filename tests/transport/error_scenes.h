#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/support/paths.h"
#include "tests/transport/sample_scenes.h"

namespace test {

/// A specular ball over a diffuse floor, under a small light: paths find its caustic only by chance. The
/// noise is uneven and heavy-tailed.
inline SampleScene caustic_scene() {
  const std::string text = "light begin rgb (60,60,60) (-0.3,3,-0.3) (0.6,0,0) (0,0,0.6) end\n" +
                           quad("brdf diffuse kd=0.6", "(-4,-1,4) (4,-1,4) (4,-1,-4) (-4,-1,-4)") +
                           sphere("brdf specular ks=0.9", 16, true);
  RenderSetup setup;
  setup.eye = transport::Vec3f(0, 2, 5);
  setup.width = 48;
  return {"caustic", scene_of(text), settings_of(setup)};
}

/// A glossy ball on a diffuse floor under a dim sky with a sun.
inline SampleScene sun_scene() {
  image::Image image{64, 32, std::vector<transport::Rgb>(64 * 32, transport::Rgb(0.3F, 0.4F, 0.5F))};
  image.pixels[8 * 64 + 42] = transport::Rgb(300, 300, 200);
  const std::string text = quad("brdf diffuse kd=0.6", "(-4,-1,4) (4,-1,4) (4,-1,-4) (-4,-1,-4)") +
                           sphere("brdf ward sx=0.1 sy=0.3 ks=0.5 kd=0.3", 16, true);
  RenderSetup setup;
  setup.eye = transport::Vec3f(0, 2, 5);
  setup.width = 48;
  transport::RenderSettings settings = settings_of(setup);
  settings.integrator.environment = environment_of(std::move(image));
  return {"sun", scene_of(text), settings};
}

/// Four scenes with different kinds of noise, of 48x32 pixels.
inline std::vector<SampleScene> error_scenes() {
  const std::string samples = std::string(GRANADA_SOURCE_DIR) + "/samples/";
  std::vector<SampleScene> scenes;
  scenes.push_back(sample_scene(samples + "cornell_box/cornell_box.op"));
  scenes.push_back(caustic_scene());
  scenes.push_back(sun_scene());
  scenes.push_back(sample_scene(samples + "garden/garden.op"));
  for (SampleScene& scene : scenes) {
    scene.settings.width = 48;
    scene.settings.height = 32;
  }
  return scenes;
}

}  // namespace test
