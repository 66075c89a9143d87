#include "editor/document/save.h"

#include <QSignalSpy>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "grf/read.h"
#include "renderer/options/op_file.h"
#include "tests/editor/scene_of.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

const std::string LoneTriangle =
    "begin mesh begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs begin faces (0,1,2) end faces end mesh\n";

/// Saves a document in parts, and edits it between them.
class Saving : public testing::Test {
 protected:
  Saving() {
    document_.take(scene_of(LoneTriangle), path("scene.grf"), {});
    FaceSelection all(document_.objects());
    all.select_all();
    document_.select(all);
  }

  QString path(const char* name) const { return QString::fromStdString(folder_.path(name)); }
  void colour(float value) {
    SurfaceEdit edit;
    edit.colour = AttributeEdit<grf::ColourAttribute>::set(grf::Colour(value));
    document_.edit_surfaces("Colour", edit, "colour");
  }
  float saved_colour(const char* name) const {
    grf::Diagnostics diagnostics;
    const grf::Scene scene = *grf::read(folder_.path(name), diagnostics);
    const SceneObjects objects = objects_of(scene, folder_.path(name));
    return std::get<grf::Colour>(*objects.meshes[0].mesh->surface(0).colour).x;
  }

  test::TemporaryFolder folder_;
  Document document_;
};

TEST_F(Saving, LeavesModifiedWhatWasEditedMeanwhile) {
  colour(0.25F);
  const SaveRequest request = document_.save_request(path("scene.grf"));
  colour(0.5F);  // of the same gesture
  document_.take_saved(write(request));
  EXPECT_EQ(saved_colour("scene.grf"), 0.25F);
  EXPECT_TRUE(document_.is_modified());
  document_.undo_stack().undo();
  EXPECT_FALSE(document_.is_modified()) << "the state that was saved";
  document_.undo_stack().undo();
  EXPECT_TRUE(document_.is_modified());
}

TEST_F(Saving, TellsStatesApartThatHaveTheSameIndexOfUndo) {
  colour(0.25F);
  const std::uint64_t saved = document_.revision();
  document_.take_saved(write(document_.save_request(path("scene.grf"))));
  document_.undo_stack().undo();
  document_.finish_gesture();
  colour(0.5F);
  EXPECT_EQ(document_.undo_stack().index(), 1);
  EXPECT_NE(document_.revision(), saved);
  EXPECT_TRUE(document_.is_modified());
}

TEST_F(Saving, KeepsEditsWhereTheSceneGoesToAnotherFolder) {
  colour(0.25F);
  const SaveRequest request = document_.save_request(path("other/scene.grf"));
  folder_.add("other/file", "");
  colour(0.5F);
  document_.take_saved(write(request));
  EXPECT_EQ(document_.path(), path("other/scene.grf"));
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document_.save(document_.path(), diagnostics));
  EXPECT_EQ(saved_colour("other/scene.grf"), 0.5F);
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(Saving, KeepsOptionsThatWereEditedMeanwhile) {
  const auto set_depth = [this](int depth) {
    options::RenderOptions now = document_.options().valid_options();
    now.depth = depth;
    document_.options().set_options("Depth", now);
  };
  const auto depth_of_file = [this] {
    grf::Diagnostics diagnostics;
    return options::read_op_file(folder_.path("scene.op"), diagnostics)->depth;
  };
  set_depth(3);
  const SaveRequest request = document_.save_request(path("scene.grf"));
  set_depth(5);
  document_.take_saved(write(request));
  EXPECT_EQ(depth_of_file(), 3);
  EXPECT_EQ(document_.options().valid_options().depth, 5);
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document_.save(path("scene.grf"), diagnostics));
  EXPECT_EQ(depth_of_file(), 5);
}

TEST_F(Saving, IsNothingToASceneThatWasOpenedMeanwhile) {
  colour(0.25F);
  const SaveRequest request = document_.save_request(path("scene.grf"));
  document_.take(scene_of(LoneTriangle), path("next.grf"), {}, {}, true);
  const QSignalSpy saved(&document_, &Document::saved);
  document_.take_saved(write(request));
  EXPECT_TRUE(saved.empty());
  EXPECT_EQ(document_.path(), path("next.grf"));
  EXPECT_TRUE(document_.is_modified());
}

TEST_F(Saving, NamesTheFilesThatItReplacesBesideTheScene) {
  folder_.add("parts/inner.grf", LoneTriangle);
  folder_.add("parts/outer.grf", "include \"inner.grf\"\n" + LoneTriangle);
  folder_.add("scene.grf", "include \"parts/outer.grf\"\n");
  folder_.add("scene.op", "BPT_Samples 7\n");
  grf::Diagnostics diagnostics;
  document_.take(*grf::read(folder_.path("scene.grf"), diagnostics), path("scene.grf"), {});
  EXPECT_TRUE(files_beside(document_.save_request(path("scene.grf"))).empty());
  FaceSelection inner(document_.objects());
  inner.set({0, 0});
  document_.select(inner);
  colour(0.5F);
  EXPECT_EQ(files_beside(document_.save_request(path("other.grf"))),
            QStringList({path("other.op"), path("parts/outer.grf"), path("parts/inner.grf")}));
}

}  // namespace
}  // namespace editor
