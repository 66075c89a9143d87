#include "samples/studies/thesis/pictures.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "renderer/image/image_file.h"
namespace study {
namespace {

using image::Image;

/// Makes a scene to be rendered from the group that measures a technique, with only that technique.
Group scene_of(const PictureRow& row, const std::string& technique, const std::vector<Group>& groups) {
  for (Group group : groups) {
    if (group.scene != row.scene || group.integrator != "naive") continue;
    for (const Line& line : group.lines) {
      if (line.technique != technique) continue;
      if (!line.pdf.empty()) group.schemes.assign(group.parts.size(), line.pdf);
      group.options += fmt::format("BPT_RE_NSecRaysRoot {}\nBPT_Integrator naive\n", row.samples_root);
      group.file = fmt::format("{}_{}_picture", row.scene, technique);
      return group;
    }
  }
  throw std::runtime_error(row.scene + " has no " + technique);
}

Image render(const Group& group, const Programs& programs, const std::string& work) {
  const std::string path = fmt::format("{}/{}.pfm", work, group.file);
  programs.run("bpt", {"render", write_scene(group, work), "--output", path, "--progress", "none", "--json"});
  grf::Diagnostics diagnostics;
  auto image = image::read_image(path, diagnostics);
  if (!image) throw std::runtime_error(diagnostics.to_text());
  return std::move(*image);
}

/// Appends an image at the right or below, with a white gap.
void append(const Image& part, bool is_stacked, Image& whole) {
  constexpr int Gap = 2;
  const grf::Colour white(1, 1, 1);
  const bool is_first = whole.pixels.empty();
  const int gap = is_first ? 0 : Gap;
  Image joined;
  joined.width = is_stacked ? part.width : whole.width + gap + part.width;
  joined.height = is_stacked ? whole.height + gap + part.height : part.height;
  joined.pixels.assign(static_cast<std::size_t>(joined.width) * static_cast<std::size_t>(joined.height),
                       white);
  const auto copy = [&](const Image& from, int left, int top) {
    for (int y = 0; y < from.height; ++y) {
      for (int x = 0; x < from.width; ++x) {
        joined.pixels[static_cast<std::size_t>(top + y) * static_cast<std::size_t>(joined.width) +
                      static_cast<std::size_t>(left + x)] = from.at(x, y);
      }
    }
  };
  if (!is_first) copy(whole, 0, 0);
  copy(part, is_stacked ? 0 : whole.width + gap, is_stacked ? whole.height + gap : 0);
  whole = std::move(joined);
}

}  // namespace

PictureRow dragon_pictures() {
  return {"dragon", {"uniform", "hemisphere-best", "factored-best", "reject", "warp"}, 10, false, 0.5F};
}

PictureRow pottery_pictures() {
  return {"pottery", {"uniform", "hemisphere-best", "factored-best", "reject", "warp"}, 14, true, 0};
}

void write_pictures(const PictureRow& row, const std::vector<Group>& groups, const Programs& programs,
                    const std::string& work, const std::string& path) {
  image::ImageFile file;
  file.exposure = row.exposure;
  for (const std::string& technique : row.techniques) {
    append(render(scene_of(row, technique, groups), programs, work), row.is_stacked, file.image);
  }
  grf::Diagnostics diagnostics;
  if (!image::write_image(file, path, diagnostics)) throw std::runtime_error(diagnostics.to_text());
}

}  // namespace study
