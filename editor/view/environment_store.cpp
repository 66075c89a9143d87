#include "editor/view/environment_store.h"

#include <QtConcurrent>
#include <cmath>
#include <utility>

#include "renderer/studies/angles.h"

namespace editor {

using studies::Environment;

std::vector<reflectance::DistantLight> SceneEnvironment::world_lights() const {
  std::vector<reflectance::DistantLight> world = lights.lights;
  for (reflectance::DistantLight& light : world) {
    light.direction = sky.in_world(light.direction);
    light.irradiance *= sky.scale;
  }
  return world;
}

EnvironmentStore::EnvironmentStore(ImageProcess images) : images_(std::move(images)) {
  connect(&watch_, &FileWatch::changed, this, &EnvironmentStore::start_reading);
}

void EnvironmentStore::set_options(const options::RenderOptions& render_options) {
  const bool is_backplate = render_options.projection == "backplate";
  const bool is_other = render_options.environment != path_ || is_backplate != is_backplate_;
  const bool is_moved =
      render_options.environment_rotation != rotation_ || render_options.environment_scale != scale_;
  path_ = render_options.environment;
  is_backplate_ = is_backplate;
  rotation_ = render_options.environment_rotation;
  scale_ = render_options.environment_scale;
  if (is_other) {
    watch_.follow(path_.empty() ? QStringList() : QStringList(QString::fromStdString(path_)));
    start_reading();
  } else if (is_moved) {
    show_loaded();
  }
}

void EnvironmentStore::start_reading() {
  stop_.request_stop();
  is_reading_ = false;
  if (path_.empty()) {
    loaded_.reset();
    return show_loaded();
  }
  stop_ = std::stop_source();
  is_reading_ = true;
  const auto take = [this, reading = ++reading_, path = path_](const Loaded& loaded) {
    if (reading != reading_ || path != path_) return;
    is_reading_ = false;
    loaded_ = loaded.environment;
    if (!loaded.problem.empty()) emit failed(QString::fromStdString(loaded.problem));
    show_loaded();
  };
  QtConcurrent::run(&threads_, read, images_, path_, is_backplate_, stop_.get_token()).then(this, take);
}

void EnvironmentStore::show_loaded() {
  std::shared_ptr<SceneEnvironment> shown;
  if (loaded_) {
    shown = std::make_shared<SceneEnvironment>(*loaded_);
    shown->sky.turned = static_cast<float>(double(rotation_) * studies::Degree);
    shown->sky.scale = reflectance::Rgb(scale_);
    shown->backplate_scale = scale_;
  }
  environment_ = std::move(shown);
  emit changed();
}

EnvironmentStore::Loaded EnvironmentStore::read(const ImageProcess& images, const std::string& path,
                                                bool is_backplate, const std::stop_token& stop) {
  grf::Diagnostics diagnostics;
  auto image = images.read(path, diagnostics, {}, stop);
  const bool has_error = diagnostics.error_count() > 0;  // no message if it was stopped
  if (!image) return {nullptr, has_error ? path + ": " + diagnostics.entries().front().message : ""};
  auto environment = std::make_shared<SceneEnvironment>();
  image::Image reduced = studies::reduced_map(std::move(*image));
  if (is_backplate) {
    environment->backplate = std::make_shared<const image::Image>(std::move(reduced));
    return {environment, {}};
  }
  environment->lights = studies::map_lights(reduced);
  environment->sky.kind = Environment::Kind::Map;
  environment->sky.set_map(std::make_shared<const transport::EnvironmentMap>(std::move(reduced)));
  return {environment, {}};
}

}  // namespace editor
