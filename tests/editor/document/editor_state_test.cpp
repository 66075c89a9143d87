#include "editor/document/editor_state.h"

#include <QFile>
#include <QJsonDocument>
#include <QSignalSpy>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "editor/document/save.h"
#include "grf/read.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::ElementsAre;

/// A mesh of four triangles, and in a transform one of a triangle.
const std::string TwoMeshes = R"(
  begin mesh "four"
    begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs
    begin faces (0,1,2) (1,2,0) (2,0,1) (0,1,2) end faces
  end mesh
  transform translation (1, 2, 3) begin
    begin mesh "one"
      begin vertexs (0,0,0) (1,0,0) (0,1,0) end vertexs
      begin faces (0,1,2) end faces
    end mesh
  end
)";

/// Written by hand: the first mesh's faces 0, 2 and 3 are hidden, the second mesh is locked, and the face 1
/// has a name.
const std::string HandMadeFile = R"({
  "hidden": [{"path": [0], "name": "four", "face_count": 4, "runs": [0, 1, 2, 2]}],
  "locked": [{"path": [1, 0], "name": "one", "face_count": 1, "runs": [0, 1]}],
  "face_sets": {"middle": [{"path": [0], "name": "four", "face_count": 4, "runs": [1, 1]}], "none": []}
})";

class KeepingEditorState : public testing::Test {
 protected:
  QString path() const { return QString::fromStdString(folder_.path("scene.grf")); }
  std::string file() const { return folder_.path("scene.grf.editor.json"); }
  void open(const std::string& editor_file) {
    folder_.add("scene.grf", TwoMeshes);
    if (!editor_file.empty()) folder_.add("scene.grf.editor.json", editor_file);
    reopen(document_);
  }
  void reopen(Document& document) const {
    grf::Diagnostics diagnostics;
    auto scene = grf::read(path().toStdString(), diagnostics);
    if (!scene) throw std::runtime_error(diagnostics.to_text());
    const SceneObjects objects = objects_of(*scene, path().toStdString());
    EditorState state = read_editor_state(path(), objects, diagnostics);
    document.take(std::move(*scene), path(), std::move(diagnostics), std::move(state));
  }
  void save() {
    grf::Diagnostics diagnostics;
    ASSERT_TRUE(document_.save(path(), diagnostics)) << diagnostics.to_text();
  }
  QJsonDocument saved_json() const {
    QFile saved(QString::fromStdString(file()));
    return saved.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(saved.readAll()) : QJsonDocument();
  }
  static std::vector<std::size_t> faces(const FaceSelection& selection, std::uint32_t mesh) {
    std::vector<std::size_t> result;
    selection.for_each_face(mesh, [&](std::size_t face) { result.push_back(face); });
    return result;
  }
  void hide(FaceId face) {
    EditorState state = document_.editor_state();
    state.hidden.set(face);
    document_.set_editor_state(std::move(state));
  }

  test::TemporaryFolder folder_;
  Document document_;
};

TEST_F(KeepingEditorState, ReadsTheFileBesideTheScene) {
  open(HandMadeFile);
  const EditorState& state = document_.editor_state();
  EXPECT_THAT(faces(state.hidden, 0), ElementsAre(0, 2, 3));
  EXPECT_EQ(state.hidden.count(), 3U);
  EXPECT_THAT(faces(state.locked, 1), ElementsAre(0));
  EXPECT_EQ(state.locked.count(), 1U);
  ASSERT_EQ(state.face_sets.size(), 2U);
  EXPECT_THAT(faces(state.face_sets.at("middle"), 0), ElementsAre(1));
  EXPECT_TRUE(state.face_sets.at("none").empty());
  EXPECT_TRUE(document_.diagnostics().entries().empty());
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(KeepingEditorState, WritesTheSameFile) {
  open(HandMadeFile);
  QFile::remove(QString::fromStdString(file()));
  save();
  EXPECT_EQ(saved_json(), QJsonDocument::fromJson(QByteArray::fromStdString(HandMadeFile)));
}

TEST_F(KeepingEditorState, WritesNoFileThatSaysNothing) {
  open({});
  save();
  EXPECT_FALSE(QFile::exists(QString::fromStdString(file())));
  hide({0, 1});
  save();
  EXPECT_TRUE(QFile::exists(QString::fromStdString(file())));
  document_.set_editor_state(EditorState(document_.objects()));
  save();
  EXPECT_FALSE(QFile::exists(QString::fromStdString(file())));
}

TEST_F(KeepingEditorState, IsModifiedUntilItIsSavedAndIsNoUndoStep) {
  open({});
  const QSignalSpy modified(&document_, &Document::modified_changed);
  const QSignalSpy changed(&document_, &Document::editor_state_changed);
  hide({0, 1});
  EXPECT_TRUE(document_.is_modified());
  EXPECT_EQ(document_.undo_stack().count(), 0);
  hide({0, 1});
  EXPECT_EQ(changed.size(), 1) << "the second one changed nothing";
  document_.set_editor_state(EditorState(document_.objects()));
  EXPECT_FALSE(document_.is_modified());
  hide({0, 1});
  save();
  EXPECT_FALSE(document_.is_modified());
  EXPECT_EQ(modified.size(), 4);
}

TEST_F(KeepingEditorState, StaysModifiedIfFacesAreHiddenDuringASave) {
  open({});
  hide({0, 1});
  const SaveRequest request = document_.save_request(path());
  hide({0, 2});
  document_.take_saved(write(request));
  EXPECT_TRUE(document_.is_modified());
  Document other;
  reopen(other);
  EXPECT_THAT(faces(other.editor_state().hidden, 0), ElementsAre(1));
}

TEST_F(KeepingEditorState, FollowsMeshesThatAnEditRenumbers) {
  open(HandMadeFile);
  grf::Scene scene = document_.scene();
  std::swap(scene.contents.blocks[0], scene.contents.blocks[1]);
  document_.replace("Swap", scene);
  ASSERT_EQ(document_.objects().meshes[1].name, "four");
  EXPECT_THAT(faces(document_.editor_state().hidden, 1), ElementsAre(0, 2, 3));
  EXPECT_THAT(faces(document_.editor_state().locked, 0), ElementsAre(0));
  EXPECT_THAT(faces(document_.editor_state().face_sets.at("middle"), 1), ElementsAre(1));
  save();
  Document other;
  reopen(other);
  EXPECT_EQ(other.editor_state(), document_.editor_state());
  EXPECT_TRUE(other.diagnostics().entries().empty());
  document_.undo_stack().undo();
  EXPECT_THAT(faces(document_.editor_state().hidden, 0), ElementsAre(0, 2, 3));
}

TEST_F(KeepingEditorState, ComesBackWithAMeshWhoseRemovalIsUndone) {
  open(HandMadeFile);
  const EditorState before = document_.editor_state();
  grf::Scene scene = document_.scene();
  scene.contents.blocks.erase(scene.contents.blocks.begin());
  document_.replace("Delete four", scene);
  ASSERT_EQ(document_.objects().meshes.size(), 1U);
  EXPECT_TRUE(document_.editor_state().hidden.empty());
  EXPECT_EQ(document_.editor_state().locked.count(), 1U) << "of the mesh that is left";
  document_.undo_stack().undo();
  EXPECT_EQ(document_.editor_state(), before);
  EXPECT_FALSE(document_.is_modified());
  document_.undo_stack().redo();
  document_.undo_stack().undo();
  EXPECT_EQ(document_.editor_state(), before) << "again";
  document_.undo_stack().redo();
  EditorState without = document_.editor_state();
  without.face_sets.erase("middle");
  document_.set_editor_state(without);
  document_.undo_stack().undo();
  EXPECT_EQ(document_.editor_state().hidden, before.hidden);
  EXPECT_FALSE(document_.editor_state().face_sets.contains("middle")) << "that set was removed meanwhile";
}

TEST_F(KeepingEditorState, ComesBackWithAMeshThatIsAddedAgain) {
  open({});
  const std::size_t meshes = document_.objects().meshes.size();
  grf::Scene scene = document_.scene();
  document_.merge("Append", scene, path());
  ASSERT_EQ(document_.objects().meshes.size(), 2 * meshes);
  // The appended meshes share the geometry of the first ones.
  hide({static_cast<std::uint32_t>(meshes), 2});
  document_.undo_stack().undo();
  EXPECT_TRUE(document_.editor_state().hidden.empty());
  document_.undo_stack().redo();
  EXPECT_TRUE(faces(document_.editor_state().hidden, 0).empty());
  EXPECT_THAT(faces(document_.editor_state().hidden, static_cast<std::uint32_t>(meshes)), ElementsAre(2));
}

TEST_F(KeepingEditorState, WarnsOnceOfAStaleFileAndKeepsWhatFits) {
  std::string stale = HandMadeFile;
  stale.replace(stale.find("\"face_count\": 4"), 15, "\"face_count\": 5");
  open(stale);
  const auto& entries = document_.diagnostics().entries();
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries.front().severity, grf::Severity::Warning);
  EXPECT_THAT(entries.front().message, testing::HasSubstr("meshes that the scene does not have"));
  EXPECT_TRUE(document_.editor_state().hidden.empty());
  EXPECT_EQ(document_.editor_state().locked.count(), 1U);
  EXPECT_THAT(faces(document_.editor_state().face_sets.at("middle"), 0), ElementsAre(1));
}

TEST_F(KeepingEditorState, WarnsOnceOfABrokenFile) {
  const std::string mesh = R"({"hidden": [{"path": [0], "name": "four", "face_count": 4, "runs": )";
  const std::string texts[] = {HandMadeFile.substr(0, 100), "[]",
                               "{\"hidden\": 1}",           mesh + "[0]}]}",
                               mesh + "[3, 2]}]}",          mesh + "[-1, 1]}]}",
                               mesh + "[0, 0]}]}",          mesh + "[0, 1e300]}]}",
                               mesh + "[\"0\", 1]}]}",      mesh + "{}}, 3]}"};
  for (const std::string& text : texts) {
    SCOPED_TRACE(text);
    open(text);
    EXPECT_EQ(document_.diagnostics().entries().size(), 1U);
    EXPECT_TRUE(document_.editor_state().empty());
    EXPECT_TRUE(document_.editor_state().hidden.fits(document_.objects()));
  }
}

TEST_F(KeepingEditorState, BelongsToItsScene) {
  open(HandMadeFile);
  hide({0, 1});
  document_.clear();
  EXPECT_TRUE(document_.editor_state().empty());
  EXPECT_FALSE(document_.is_modified());
}

TEST_F(KeepingEditorState, SelectsNoHiddenOrLockedFaces) {
  open(HandMadeFile);
  FaceSelection all(document_.objects());
  all.select_all();
  document_.select(all);
  EXPECT_THAT(faces(document_.selection(), 0), ElementsAre(1));
  EXPECT_EQ(document_.selection().count(), 1U);
  hide({0, 1});
  EXPECT_TRUE(document_.selection().empty());
}

TEST_F(KeepingEditorState, DeselectsObjectsOfWhichNothingIsVisible) {
  open({});
  document_.select_objects({{0}, {1}});
  for (const std::uint32_t face : {0U, 1U, 2U}) hide({0, face});
  EXPECT_EQ(document_.selected_objects().size(), 2U);
  hide({0, 3});
  EXPECT_THAT(document_.selected_objects(), ElementsAre(grf::ScenePath{1}));
}

}  // namespace
}  // namespace editor
