#include "editor/document/model_import.h"

#include <QDir>
#include <QElapsedTimer>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/document.h"
#include "tests/support/sanitizers.h"
#include "tests/support/temporary_folder.h"

namespace editor {
namespace {

using testing::HasSubstr;

class ModelImports : public testing::Test {
 protected:
  ModelImports()
      : import_(QString::fromStdString(folder_.path("imports"))),
        done_(&import_, &ModelImport::done),
        failed_(&import_, &ModelImport::failed) {}

  std::shared_ptr<const ImportedModel> imported(const QString& file) {
    import_.start(file);
    if (done_.count() == 0 && failed_.count() == 0) done_.wait(20000);
    if (done_.count() != 1) return nullptr;
    return done_.takeFirst().at(0).value<std::shared_ptr<const ImportedModel>>();
  }
  std::string failure_of(const QString& file) {
    import_.start(file);
    if (failed_.count() == 0) failed_.wait(20000);
    return failed_.count() == 1 ? failed_.takeFirst().at(0).toString().toStdString() : "no failure";
  }
  QStringList left() const { return QDir(import_folder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot); }
  QString import_folder() const { return QString::fromStdString(folder_.path("imports")); }

  test::TemporaryFolder folder_;
  ModelImport import_;
  QSignalSpy done_;
  QSignalSpy failed_;
};

TEST_F(ModelImports, GiveTheSceneOfARealModel) {
  const auto model = imported("/usr/share/glmark2/models/bunny.obj");
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(objects_of(model->scene, model->path.toStdString()).faces, 69666U);
  EXPECT_THAT(model->diagnostics.to_text(), HasSubstr("faces without a BRDF"));
}

TEST_F(ModelImports, HaveTheCamerasOfTheModel) {
  const auto model =
      imported("/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb");
  ASSERT_NE(model, nullptr);
  ASSERT_EQ(model->cameras.size(), 1U);
  EXPECT_FALSE(model->diagnostics.to_text().find("camera") != std::string::npos);
  Document document;
  document.take_import(*model);
  const options::RenderOptions& view = document.options().valid_options();
  EXPECT_EQ(view.cameras, model->cameras);
  EXPECT_EQ(view.camera, model->cameras.front().name) << "it renders";
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(document.save(QString::fromStdString(folder_.path("engine.grf")), diagnostics));
  EXPECT_THAT(test::bytes_of(folder_.path("engine.op")), HasSubstr("BPT_Cameras"));
}

TEST_F(ModelImports, CarryWhatStoodInsideTheModelToWhereTheSceneIsSaved) {
  const auto model = imported("/usr/share/assimp/models/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb");
  ASSERT_NE(model, nullptr);
  Document document;
  document.take_import(*model);
  EXPECT_TRUE(document.is_modified());
  EXPECT_TRUE(document.path().isEmpty());
  const std::string before = document.objects().meshes[0].flat_surfaces.front().texture;
  EXPECT_THAT(before, HasSubstr("/imports/"));
  grf::Diagnostics diagnostics;
  folder_.add("saved/other", "");
  ASSERT_TRUE(document.save(QString::fromStdString(folder_.path("saved/box.grf")), diagnostics));
  const std::string after = document.objects().meshes[0].flat_surfaces.front().texture;
  EXPECT_EQ(after, folder_.path("saved/" + before.substr(before.rfind('/') + 1)));
  EXPECT_EQ(test::bytes_of(after), test::bytes_of(before));
}

TEST_F(ModelImports, LeaveNothingOnceNobodyNeedsIt) {
  const QString box = "/usr/share/assimp/models/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb";
  ASSERT_NE(imported("/usr/share/glmark2/models/bunny.obj"), nullptr);
  EXPECT_TRUE(left().isEmpty()) << "a model without images";
  Document document;
  document.take_import(*imported(box));
  EXPECT_EQ(left().size(), 1);
  const QDir folder(import_folder() + "/" + left().front());
  EXPECT_EQ(folder.entryList(QDir::Files).size(), 1) << "the image, and not the scene";
  document.merge_imports("Append", {*imported(box)});
  EXPECT_EQ(left().size(), 2);
  document.undo_stack().undo();
  grf::Diagnostics diagnostics;
  folder_.add("saved/other", "");
  ASSERT_TRUE(document.save(QString::fromStdString(folder_.path("saved/box.grf")), diagnostics));
  ASSERT_EQ(left().size(), 1) << "what redo brings back needs its image";
  document.undo_stack().redo();
  ASSERT_TRUE(document.save(document.path(), diagnostics));
  EXPECT_TRUE(left().isEmpty());
  document.take_import(*imported(box));
  EXPECT_EQ(left().size(), 1);
  document.clear();
  EXPECT_TRUE(left().isEmpty()) << "of a scene that was replaced";
}

TEST_F(ModelImports, SayWhatIsWrong) {
  const std::string broken = folder_.add("broken.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_THAT(failure_of(QString::fromStdString(broken)), HasSubstr("broken.obj:2:7: error: no vertex"));
  EXPECT_THAT(failure_of("/nowhere/at-all.obj"), HasSubstr("No such file"));
  EXPECT_TRUE(left().isEmpty());
}

TEST_F(ModelImports, KeepToALimitOfMemoryThatCanBeRaised) {
  if (test::HasSanitizers) GTEST_SKIP() << "sanitizers reserve more address space than any limit";
  EXPECT_EQ(ModelImport::memory_limit(), 4);
  ModelImport::set_memory_limit(0.025);
  const std::string failure = failure_of("/usr/share/glmark2/models/bunny.obj");
  EXPECT_THAT(failure, HasSubstr("exceeded the memory limit of 26 MB"));
  EXPECT_THAT(failure, testing::Not(HasSubstr("--")));
  ModelImport::set_memory_limit(2);
  EXPECT_NE(imported("/usr/share/glmark2/models/bunny.obj"), nullptr);
  QSettings().remove("import/memory_limit");
}

TEST_F(ModelImports, TakeNoLongerThanTheSizeOfTheFileCalls) {
  EXPECT_EQ(ModelImport::time_limit(147), 60);
  EXPECT_GE(ModelImport::time_limit(1'000'000'000), 3600);
}

TEST_F(ModelImports, CanBeCancelled) {
  import_.start("/usr/share/glmark2/models/bunny.obj");
  EXPECT_TRUE(import_.is_running());
  import_.cancel();
  EXPECT_FALSE(import_.is_running());
  EXPECT_FALSE(done_.wait(300));
  EXPECT_EQ(failed_.count(), 0);
  EXPECT_TRUE(QTest::qWaitFor([this] { return left().isEmpty(); }, 20000)) << "nothing is left";
  EXPECT_NE(imported("/usr/share/glmark2/models/horse.3ds"), nullptr) << "and another one can begin";
}

}  // namespace
}  // namespace editor
