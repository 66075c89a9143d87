#pragma once

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "grf/read.h"
#include "renderer/job/preview_render.h"
#include "tests/support/camera_image.h"

namespace test {

inline grf::Scene scene_of_text(const std::string& text, const std::string& path = "scene.grf") {
  grf::Diagnostics diagnostics;
  auto scene = grf::read_text(text, path, diagnostics);
  if (!scene) throw std::runtime_error(diagnostics.to_text());
  return *scene;
}

/// A corner of a floor and a wall, under an area light.
inline const std::string Corner = R"(
light begin rgb (5, 5, 5) (-1,3,-1) (2,0,0) (0,0,2) end
begin mesh
  brdf ward sx=0.2 ks=0.3 kd=0.4
  begin vertexs (-2,0,2) (2,0,2) (2,0,-2) (-2,0,-2) (-2,2,-2) (2,2,-2) end vertexs
  begin faces (0,1,2,3) (3,2,5,4) end faces
end mesh)";

/// Makes a wavy height field of `side` x `side` squares, two triangles each, under a light.
inline grf::Scene waves(std::uint32_t side) {
  grf::Scene scene = scene_of_text("light begin rgb (5, 5, 5) (-1,3,-1) (2,0,0) (0,0,2) end");
  grf::MeshDraft mesh;
  for (std::uint32_t y = 0; y <= side; ++y) {
    for (std::uint32_t x = 0; x <= side; ++x) {
      const float s = 4 * static_cast<float>(x) / static_cast<float>(side) - 2;
      const float t = 4 * static_cast<float>(y) / static_cast<float>(side) - 2;
      mesh.positions.emplace_back(s, 0.2F * std::sin(5 * s) * std::cos(4 * t), -t);
    }
  }
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t corner = y * (side + 1) + x;
      const std::uint32_t above = corner + side + 1;
      mesh.add_face(std::vector{corner, corner + 1, above + 1}, 0);
      mesh.add_face(std::vector{corner, above + 1, above}, 0);
    }
  }
  scene.contents.blocks.emplace_back().content = grf::Shared<grf::Mesh>(std::move(mesh));
  return scene;
}

inline grf::Shared<grf::Mesh>* find_mesh(grf::BlockList& list) {
  for (grf::Block& block : list.blocks) {
    if (auto* mesh = std::get_if<grf::Shared<grf::Mesh>>(&block.content)) return mesh;
    auto* scope = std::get_if<grf::DefinitionScope>(&block.content);
    auto* found = scope != nullptr ? find_mesh(scope->body) : nullptr;
    if (found != nullptr) return found;
  }
  return nullptr;
}

inline grf::Shared<grf::Mesh>& first_mesh(grf::Scene& scene) {
  auto* mesh = find_mesh(scene.contents);
  if (mesh == nullptr) throw std::runtime_error("the scene has no mesh");
  return *mesh;
}

inline job::PreviewRequest request(grf::Scene scene, int width = 96, int height = 72, int samples = 8) {
  job::PreviewRequest request;
  request.scene = std::move(scene);
  request.options.size = {width, height};
  request.options.samples = samples;
  request.options.eye = grf::Vec3f(0, 2, 6);
  request.options.target = grf::Vec3f(0, 0.5F, 0);
  return request;
}

/// Checks bounds of the radiance at the centre of the corner's floor, as `request` views it. The light is a
/// square of half side 1 at height 3, with a form factor of 4/pi s atan(s) = 0.123, s = sqrt(1/10): the
/// diffuse part reflects 0.4 times 5 times that, and the glossy part and the wall add less than 0.3 + 0.3 * 5
/// * 0.123.
inline transport::Rgb floor_of_corner(const image::Image& image) {
  return CameraImage(image, {0, 2, 6}, {0, 0.5, 0}, 45).at(grf::Vec3d(0));
}
inline void expect_lit_corner(const image::Image& image) {
  const transport::Rgb floor = floor_of_corner(image);
  EXPECT_GT(floor.x, 0.2F);
  EXPECT_LT(floor.x, 0.75F);
  EXPECT_TRUE(is_grey(floor));
  EXPECT_EQ(image.at(0, 0), transport::Rgb(0)) << "beside it is nothing";
}

/// Records the callbacks of a preview, and can wait for them.
class PreviewRecorder {
 public:
  struct Event {
    std::shared_ptr<const image::Image> image;
    transport::RenderProgress progress;
    std::chrono::steady_clock::time_point time = std::chrono::steady_clock::now();
  };

  job::PreviewListener listener() {
    job::PreviewListener listener;
    listener.image = [this](int number, auto image, const transport::RenderProgress& progress) {
      add([&] { images_[number].push_back({std::move(image), progress}); });
    };
    listener.accuracy = [this](int number, auto accuracy) {
      add([&] { accuracies_[number].push_back(std::move(accuracy)); });
    };
    listener.diagnostics = [this](int number, const grf::Diagnostics& diagnostics) {
      add([&] { texts_[number] += diagnostics.to_text(); });
    };
    listener.state = [this](int number, job::PreviewState state) {
      add([&] { states_[number].push_back(state); });
    };
    return listener;
  }

  /// Waits up to a minute for a request to reach a state; returns whether it did.
  bool reaches(int number, job::PreviewState state) {
    return wait([&] { return !states_[number].empty() && states_[number].back() == state; });
  }
  bool shows(int number, std::size_t images = 1) {
    return wait([&] { return images_[number].size() >= images; });
  }
  std::vector<Event> images(int number) {
    const std::lock_guard lock(lock_);
    return images_[number];
  }
  std::vector<std::shared_ptr<const job::PreviewAccuracy>> accuracies(int number) {
    const std::lock_guard lock(lock_);
    return accuracies_[number];
  }
  std::string text(int number) {
    const std::lock_guard lock(lock_);
    return texts_[number];
  }

 private:
  template <class Add>
  void add(const Add& add) {
    const std::lock_guard lock(lock_);
    add();
    changed_.notify_all();
  }
  template <class Condition>
  bool wait(const Condition& condition) {
    std::unique_lock lock(lock_);
    return changed_.wait_for(lock, std::chrono::minutes(1), condition);
  }

  std::mutex lock_;
  std::condition_variable changed_;
  std::map<int, std::vector<Event>> images_;
  std::map<int, std::vector<std::shared_ptr<const job::PreviewAccuracy>>> accuracies_;
  std::map<int, std::string> texts_;
  std::map<int, std::vector<job::PreviewState>> states_;
};

}  // namespace test
