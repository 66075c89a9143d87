#include "editor/tools/scene_reading.h"

#include "converters/format.h"

namespace editor {

std::optional<grf::Scene> read_any_scene(const std::string& path, grf::Diagnostics& diagnostics) {
  const convert::Format* format = convert::recognise(path, diagnostics);
  if (format == nullptr) return std::nullopt;
  auto import = convert::read(*format, path, {}, diagnostics);
  return import ? std::optional(std::move(import->scene)) : std::nullopt;
}

}  // namespace editor
