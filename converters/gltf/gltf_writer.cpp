#include "converters/gltf/gltf_writer.h"

#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "converters/gltf/gltf_cameras.h"
#include "converters/gltf/gltf_check.h"
#include "converters/gltf/gltf_document.h"
#include "converters/gltf/gltf_grf.h"
#include "converters/gltf/gltf_images.h"
#include "converters/gltf/gltf_material_writer.h"
#include "converters/gltf/gltf_node_writer.h"
#include "converters/scene_building.h"
#include "converters/text_encoding.h"
#include "grf/read.h"
#include "grf/relocate.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace convert {
namespace {

namespace fs = std::filesystem;

/// The maximum size of buffers and GLB files, which have 32-bit sizes.
constexpr std::size_t LargestFile = 0xFFFFFFFF;

class Writer {
 public:
  Writer(const grf::Scene& scene, const std::string& path, const WriteOptions& options, bool is_binary,
         grf::Diagnostics& diagnostics)
      : scene_(grf::flatten(scene, path)),
        path_(path),
        options_(options),
        is_binary_(is_binary),
        diagnostics_(diagnostics),
        materials_(document_, path_, is_binary, diagnostics) {}

  bool run() {
    GltfNodeWriter nodes(document_, materials_);
    std::vector<int> roots = nodes.write(scene_.contents);
    const bool has_cameras = !options_.op_file.empty();
    if (has_cameras && !write_cameras(options_.op_file, bounds_of(scene_), document_, roots, diagnostics_)) {
      return false;
    }
    nlohmann::json root = nlohmann::json::object();
    if (!roots.empty()) root["nodes"] = roots;
    document_.append("scenes", std::move(root));
    document_.json()["scene"] = 0;
    if (!add_extras(nodes.take_lists())) return false;
    materials_.report();
    return is_binary_ ? write_binary() : write_json();
  }

 private:
  bool add_extras(nlohmann::json lists) {
    grf::Scene stubs = scene_;
    for_each_mesh(stubs.contents, [](grf::Shared<grf::Mesh>& mesh) { mesh = without_lists(*mesh); });
    grf::relocate(stubs, path_, path_, materials_.embedded());
    const std::string text = to_utf8(grf::to_text(stubs));
    grf::Diagnostics problems;
    if (!grf::read_text(text, path_, problems)) {
      return fail(fmt::format("the scene cannot be written as GRF ({})", problems.entries().front().message));
    }
    document_.json()["extras"]["grf"] = {{"check", NoCheck}, {"scene", text}, {"meshes", std::move(lists)}};
    return true;
  }

  bool write_binary() {
    const std::string text = document_.text("");
    constexpr std::size_t Headers = 64;
    if (text.size() + document_.buffer().size() + Headers > LargestFile)
      return fail("it would be larger than 4 GB");
    return grf::replace_file(path_, glb_of(text, document_.buffer()), diagnostics_);
  }

  // The buffer is written first: if that fails, the old file still names the old buffer.
  bool write_json() {
    const fs::path buffer = fs::path(path_).replace_extension(".bin");
    const std::string text = document_.text(to_uri(buffer.filename().string()));
    if (document_.buffer().size() > LargestFile) return fail("its buffer would be larger than 4 GB");
    const bool has_buffer = !document_.buffer().empty();
    if (has_buffer && !grf::replace_file(buffer.string(), document_.buffer(), diagnostics_)) return false;
    return grf::replace_file(path_, text + "\n", diagnostics_);
  }

  bool fail(std::string_view why) {
    diagnostics_.error(grf::whole_file(path_), fmt::format("cannot write the file: {}", why));
    return false;
  }

  grf::Scene scene_;
  std::string path_;
  const WriteOptions& options_;
  bool is_binary_;
  grf::Diagnostics& diagnostics_;
  GltfDocument document_;
  GltfMaterialWriter materials_;
};

}  // namespace

bool write_gltf(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
                grf::Diagnostics& diagnostics) {
  return Writer(scene, path, options, false, diagnostics).run();
}

bool write_glb(const grf::Scene& scene, const std::string& path, const WriteOptions& options,
               grf::Diagnostics& diagnostics) {
  return Writer(scene, path, options, true, diagnostics).run();
}

}  // namespace convert
