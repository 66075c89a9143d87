#include "converters/renderers/scene_folder.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "grf/text_file.h"
#include "renderer/image/image_file.h"

namespace convert {

SceneFolder::SceneFolder(const std::string& scene_path, std::string_view suffix) {
  const std::filesystem::path path(scene_path);
  name_ = fmt::format("{}_{}", path.stem().string(), suffix);
  folder_ = (path.parent_path() / name_).string();
}

SceneFolder::Name SceneFolder::next(std::string_view kind, std::string_view extension,
                                    grf::Diagnostics& diagnostics) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) {
    diagnostics.error(grf::whole_file(folder_), fmt::format("cannot create the folder: {}", error.message()));
    return {};
  }
  const std::size_t number = ++count_of_kind_[std::string(kind)];
  const std::string file = fmt::format("{}_{}.{}", kind, number, extension);
  return {fmt::format("{}/{}", name_, file), (std::filesystem::path(folder_) / file).string()};
}

std::string SceneFolder::add_image(std::string_view kind, image::Image image, grf::Diagnostics& diagnostics) {
  const Name name = next(kind, "exr", diagnostics);
  if (name.path.empty()) return {};
  const image::ImageFile file{std::move(image)};
  return image::write_image(file, name.path, diagnostics) ? name.in_scene : std::string();
}

}  // namespace convert
