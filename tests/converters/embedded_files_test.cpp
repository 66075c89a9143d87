#include "converters/embedded_files.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grf/relocate.h"
#include "tests/support/temporary_folder.h"

namespace convert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

TEST(EmbeddedFiles, AreWrittenBesideTheOutput) {
  const test::TemporaryFolder folder;
  const std::vector<EmbeddedFile> files = {{"wood.png", "wood"}, {"stone.png", std::string("a\0b", 3)}};
  grf::Diagnostics diagnostics;
  const auto written = write_embedded_files(files, folder.path("out.grf"), diagnostics);
  ASSERT_TRUE(written.has_value()) << diagnostics.to_text();
  EXPECT_THAT(folder.names(), ElementsAre("stone.png", "wood.png"));
  EXPECT_EQ(test::bytes_of(folder.path("stone.png")), files[1].bytes);
  EXPECT_THAT(written->paths, ElementsAre(folder.path("wood.png"), folder.path("stone.png")));
  EXPECT_EQ(written->created, written->paths);
  EXPECT_THAT(diagnostics.entries(), IsEmpty());
}

TEST(EmbeddedFiles, TakeAFreeNameBesideADifferentFile) {
  const test::TemporaryFolder folder;
  folder.add("wood.png", "another");
  folder.add("wood_2.png", "one more");
  grf::Diagnostics diagnostics;
  const std::vector<EmbeddedFile> files = {{"wood.png", "wood"}};
  const auto written = write_embedded_files(files, folder.path("out.grf"), diagnostics);
  ASSERT_TRUE(written.has_value());
  EXPECT_THAT(written->names, ElementsAre(Pair("wood.png", "wood_3.png")));
  EXPECT_EQ(test::bytes_of(folder.path("wood.png")), "another");
  EXPECT_EQ(test::bytes_of(folder.path("wood_3.png")), "wood");
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("wood_3.png: note: 'wood.png' is written under this name"));
}

TEST(EmbeddedFiles, AreNotWrittenAgain) {
  const test::TemporaryFolder folder;
  folder.add("wood.png", "wood");
  grf::Diagnostics diagnostics;
  const std::vector<EmbeddedFile> files = {{"wood.png", "wood"}};
  const auto written = write_embedded_files(files, folder.path("out.grf"), diagnostics);
  ASSERT_TRUE(written.has_value());
  EXPECT_THAT(written->created, IsEmpty());
  EXPECT_THAT(folder.names(), ElementsAre("wood.png"));
  remove_created(*written);
  EXPECT_THAT(folder.names(), ElementsAre("wood.png")) << "it was there before";
}

TEST(EmbeddedFiles, LeaveNothingAfterAnError) {
  const test::TemporaryFolder folder;
  for (const std::string name : {"../wood.png", "a/b.png", "a\\b.png", "", ".", ".."}) {
    grf::Diagnostics diagnostics;
    const std::vector<EmbeddedFile> files = {{"first.png", "first"}, {name, "wood"}};
    EXPECT_FALSE(write_embedded_files(files, folder.path("out.grf"), diagnostics).has_value());
    EXPECT_EQ(diagnostics.error_count(), 1U) << name;
    EXPECT_THAT(folder.names(), IsEmpty());
  }
}

TEST(EmbeddedFiles, AreNamedFromTheOutputWhereOthersAreNamedFromTheInput) {
  const test::TemporaryFolder folder;
  grf::MeshDraft mesh;
  mesh.surfaces.resize(2);
  mesh.surfaces[0].texture = grf::Texture{"embedded.png", {}};
  mesh.surfaces[1].texture = grf::Texture{"beside.png", {}};
  for (const std::string to : {"out/scene.grf", "in/scene.grf"}) {
    grf::Scene scene;
    scene.contents.blocks.emplace_back();
    scene.contents.blocks[0].content = grf::Shared<grf::Mesh>(grf::MeshDraft(mesh));
    grf::relocate(scene, folder.path("in/model.glb"), folder.path(to), {{"embedded.png", "free.png"}});
    const auto& moved = *std::get<grf::Shared<grf::Mesh>>(scene.contents.blocks[0].content);
    EXPECT_EQ(std::get<grf::Texture>(*moved.surfaces[0].texture).file, "free.png");
    EXPECT_EQ(std::get<grf::Texture>(*moved.surfaces[1].texture).file,
              to == "in/scene.grf" ? "beside.png" : "../in/beside.png");
  }
}

}  // namespace
}  // namespace convert
