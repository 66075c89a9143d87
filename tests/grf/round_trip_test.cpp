// Tests of lossless writing: a scene that is read back is equal, and is written as the same bytes.
#include <bit>
#include <cstdint>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grf/read.h"
#include "grf/write.h"
#include "tests/grf/scene_generator.h"
#include "tests/support/temporary_folder.h"

namespace grf {
namespace {

/// The scene of a text that has to be right.
Scene scene_again(const std::string& text) {
  Diagnostics diagnostics;
  const auto scene = read_text(text, "scene.grf", diagnostics);
  if (!scene || !diagnostics.entries().empty()) RC_FAIL(diagnostics.to_text() + text);
  return *scene;
}

RC_GTEST_PROP(RoundTrip, GivesTheSceneAndItsTextBack, ()) {
  const Scene scene = SceneGenerator(false).scene();
  const std::string text = to_text(scene);
  RC_LOG() << text;
  const Scene again = scene_again(text);
  RC_ASSERT(again == scene);
  RC_ASSERT(to_text(again) == text);
}

RC_GTEST_PROP(RoundTrip, KeepsEveryNumberToTheLastBit, ()) {
  const float number = SceneGenerator::number();
  Scene scene;
  Block block;
  block.content = AreaLight{Vec3f(number), Vec3f(1, 0, 0), Vec3f(0, 1, 0), {}};
  scene.contents.blocks.push_back(block);
  const Scene again = scene_again(to_text(scene));
  const float read_again = std::get<AreaLight>(again.contents.blocks[0].content).corner.y;
  RC_ASSERT(std::bit_cast<std::uint32_t>(read_again) == std::bit_cast<std::uint32_t>(number));
}

/// The bytes of all files in a folder and the folders inside, by their names.
std::map<std::string, std::string> files_of(const test::TemporaryFolder& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
    if (!entry.is_regular_file()) continue;
    const auto name = std::filesystem::relative(entry.path(), folder.path()).string();
    files[name] = test::bytes_of(entry.path().string());
  }
  return files;
}

void write_to(const test::TemporaryFolder& folder, const Scene& scene) {
  Diagnostics diagnostics;
  if (!write(scene, folder.path("scene.igrf"), diagnostics)) RC_FAIL(diagnostics.to_text());
}

void keeps_included_files_apart() {
  const Scene scene = SceneGenerator(true).scene();
  const test::TemporaryFolder folder;
  write_to(folder, scene);
  for (const auto& [name, bytes] : files_of(folder)) RC_LOG() << "--- " << name << "\n" << bytes;
  Diagnostics diagnostics;
  const auto again = read(folder.path("scene.igrf"), diagnostics);
  if (!again || !diagnostics.entries().empty()) RC_FAIL(diagnostics.to_text());
  RC_ASSERT(*again == scene);
  const test::TemporaryFolder copy;
  write_to(copy, *again);
  RC_ASSERT(files_of(copy) == files_of(folder));
}

TEST(RoundTrip, KeepsIncludedFilesApart) {
  rc::detail::TestMetadata metadata;
  metadata.id = "RoundTrip/KeepsIncludedFilesApart";
  rc::detail::TestParams params = rc::detail::configuration().testParams;
  params.maxSuccess /= 10;  // each case waits for the disk several times
  const auto result = rc::detail::checkTestable(&keeps_included_files_apart, metadata, params);
  std::ostringstream text;
  rc::detail::printResultMessage(result, text);
  EXPECT_TRUE(result.is<rc::detail::SuccessResult>()) << text.str();
}

}  // namespace
}  // namespace grf
