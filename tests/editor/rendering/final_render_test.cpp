#include <QDir>
#include <QFileInfo>
#include <QLockFile>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/document/op_files.h"
#include "editor/rendering/render_files.h"
#include "renderer/options/op_file.h"
#include "tests/editor/rendering/rendering_helpers.h"

namespace {

using editor::FinalRender;
using editor::FinalRenderRequest;
using editor::FinalRenderResult;
using testing::HasSubstr;

class FinalRenderTest : public testing::Test {
 protected:
  FinalRenderTest() {
    QObject::connect(&render_, &FinalRender::finished,
                     [this](const FinalRenderResult& result) { result_ = result; });
    QObject::connect(&render_, &FinalRender::failed,
                     [this](const QString& why) { why_ = why.toStdString(); });
    QObject::connect(&render_, &FinalRender::image_changed, [this](const auto& image) { image_ = image; });
  }

  QString path(const char* name) const { return QString::fromStdString(folder_.path(name)); }
  bool ends() {
    return QTest::qWaitFor([this] { return !render_.is_running(); }, test::Minute);
  }
  bool comes_to_render() {
    QSignalSpy reports(&render_, &FinalRender::progressed);
    return QTest::qWaitFor([&] { return !reports.empty(); }, test::Minute);
  }

  test::TemporaryFolder folder_;
  FinalRender render_;
  std::optional<FinalRenderResult> result_;
  std::string why_;
  std::shared_ptr<const image::Image> image_;
};

TEST_F(FinalRenderTest, RendersWhatIsInMemoryBesideTheScene) {
  FinalRenderRequest request = test::final_request(path("my scene.grf"), 8);  // no such file
  render_.start(request);
  ASSERT_TRUE(ends());
  ASSERT_TRUE(result_) << why_;
  EXPECT_EQ(result_->image, path("my scene.exr"));
  EXPECT_FALSE(result_->is_stopped);
  EXPECT_EQ(result_->summary.samples, 8);
  EXPECT_EQ(result_->summary.width, 96);
  EXPECT_GT(*result_->summary.estimated_error, 0);
  ASSERT_TRUE(image_);
  EXPECT_EQ(image_->width, 96);
  test::expect_lit_corner(*image_);
  EXPECT_THAT(folder_.names(), testing::ElementsAre("my scene.exr")) << "and leaves nothing else there";
  EXPECT_TRUE(QFileInfo::exists(result_->copy));
  EXPECT_NE(result_->copy, result_->image);
}

TEST_F(FinalRenderTest, KeepsTheImageThatItReplaces) {
  FinalRenderRequest request = test::final_request(path("scene.grf"), 2);
  const std::string before = "the image of an earlier session";
  folder_.add("scene.exr", before);
  request.may_overwrite = true;
  render_.start(request);
  ASSERT_TRUE(ends());
  ASSERT_TRUE(result_) << why_;
  EXPECT_EQ(test::bytes_of(result_->former.toStdString()), before);
  EXPECT_NE(test::bytes_of(folder_.path("scene.exr")), before);
  request.options.output = folder_.path("other.exr");
  render_.start(request);
  ASSERT_TRUE(ends());
  EXPECT_EQ(result_->former, "") << "there was no such image";
}

TEST_F(FinalRenderTest, FindsFilesBesideTheSceneAndNotBesideItsSnapshot) {
  FinalRenderRequest request = test::final_request(path("scene.grf"), 4);
  folder_.add("paper.pfm", std::string("PF\n1 1\n-1.0\n") + std::string(12, '\0'));
  test::first_mesh(request.scene).edit().surfaces[0].texture = grf::Texture{"paper.pfm", {}};
  request.options.environment = "paper.pfm";
  render_.start(request);
  ASSERT_TRUE(ends());
  EXPECT_TRUE(result_) << why_;
}

TEST_F(FinalRenderTest, KeepsTheImageOfARenderThatIsStopped) {
  render_.start(test::final_request(path("scene.grf"), 1'000'000));
  ASSERT_TRUE(comes_to_render());
  render_.stop();
  ASSERT_TRUE(ends());
  ASSERT_TRUE(result_) << why_;
  EXPECT_TRUE(result_->is_stopped);
  EXPECT_TRUE(QFileInfo::exists(path("scene.exr")));
  EXPECT_LT(result_->summary.samples, 1'000'000);
}

TEST_F(FinalRenderTest, GoesToATemporaryFolderWhereTheSceneHasNoFile) {
  render_.start(test::final_request({}, 2));
  ASSERT_TRUE(ends());
  ASSERT_TRUE(result_) << why_;
  EXPECT_TRUE(result_->image.startsWith(QDir::tempPath())) << result_->image.toStdString();
  EXPECT_TRUE(QFileInfo::exists(result_->image));
}

TEST_F(FinalRenderTest, SaysWhatTheRendererSays) {
  FinalRenderRequest request = test::final_request(path("scene.grf"), 2);
  test::first_mesh(request.scene).edit().surfaces[0].texture = grf::Texture{"lost.png", {}};
  QSignalSpy log(&render_, &FinalRender::logged);
  render_.start(request);
  ASSERT_TRUE(ends());
  EXPECT_FALSE(result_);
  EXPECT_THAT(why_, HasSubstr("lost.png"));
  EXPECT_FALSE(log.empty());
  render_.start(test::final_request(path("scene.grf"), 2));
  ASSERT_TRUE(ends());
  EXPECT_TRUE(result_) << "and renders again: " << why_;
}

TEST_F(FinalRenderTest, SaysThatTheRendererIsMissing) {
  for (const char* program : {"", "/nowhere/bpt"}) {
    FinalRender render{QString(program)};
    QSignalSpy failed(&render, &FinalRender::failed);
    render.start(test::final_request(path("scene.grf"), 2));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.empty(); }, test::Minute));
    EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("bpt"));
    EXPECT_FALSE(render.is_running());
  }
}

TEST_F(FinalRenderTest, TwoNeverWriteOneFile) {
  render_.start(test::final_request(path("scene.grf"), 1'000'000));
  FinalRender other;
  QSignalSpy failed(&other, &FinalRender::failed);
  other.start(test::final_request(path("scene.grf"), 2));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_THAT(failed[0][0].toString().toStdString(), HasSubstr("another render"));
  render_.start(test::final_request(path("other.grf"), 2));
  EXPECT_THAT(why_, HasSubstr("already running"));
  render_.stop();
  ASSERT_TRUE(ends());
}

TEST_F(FinalRenderTest, EndsWithTheEditorAndKeepsItsImage) {
  auto render = std::make_unique<FinalRender>();
  QSignalSpy reports(render.get(), &FinalRender::progressed);
  render->start(test::final_request(path("quit.grf"), 1'000'000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !reports.empty(); }, test::Minute));
  render.reset();
  EXPECT_THAT(folder_.names(), testing::ElementsAre("quit.exr"));
}

TEST_F(FinalRenderTest, ShowsItsOwnImagesAlone) {
  render_.start(test::final_request(path("scene.grf"), 1'000'000));
  const auto image = std::make_shared<const image::Image>();
  render_.show("another.exr", image);
  EXPECT_FALSE(image_);
  render_.show(render_.output(), image);
  EXPECT_EQ(image_, image);
  render_.stop();
  ASSERT_TRUE(ends());
}

TEST(OpFile, HasWhatIsNotAsByDefault) {
  const test::TemporaryFolder folder;
  options::RenderOptions render_options;
  render_options.scene = folder.path("my scene.grf");
  render_options.environment = "/maps/sky # 1.exr";
  render_options.size = {640, 480};
  render_options.eye = grf::Vec3f(0.1F, 2, -3);
  render_options.scheme = "Hemisphere";
  render_options.target_error = 0.02F;
  render_options.without = {"textures", "indirect"};
  render_options.samples = 64;
  const QString path = QString::fromStdString(folder.path("my scene.op"));
  grf::Diagnostics diagnostics;
  ASSERT_TRUE(editor::write_op_file(render_options, path, diagnostics)) << diagnostics.to_text();
  const auto read = options::read_op_file(path.toStdString(), diagnostics);
  ASSERT_TRUE(read) << diagnostics.to_text();
  EXPECT_EQ(*read, render_options);
  EXPECT_THAT(test::bytes_of(path.toStdString()), HasSubstr("BPT_Scene             \"my scene.grf\"\n"));
  EXPECT_THAT(test::bytes_of(path.toStdString()), testing::Not(HasSubstr("BPT_Depth")));
}

TEST(OpFile, KeepsWhatItsAuthorWrote) {
  const test::TemporaryFolder folder;
  const std::string before =
      "# the garden, at noon\r\n"
      "Depth 7\t# deep\r\n"
      "BPT_EM_Background maps/../sky.exr // of June\r\n"
      "a line of another program\r\n"
      "BPT_Samples many\r\n"
      "BPT_Scene garden.grf\r\n"
      "BPT_Seed 0\r\n";
  const std::string path = folder.add("garden.op", before);
  const QString op_path = QString::fromStdString(path);
  options::RenderOptions render_options;
  render_options.depth = 7;
  render_options.environment = "maps/../sky.exr";
  render_options.scene = "garden.grf";
  render_options = editor::with_absolute_paths(render_options, op_path);
  render_options.samples = 64;
  const auto written = [&](const options::RenderOptions& wanted) {
    grf::Diagnostics diagnostics;
    EXPECT_TRUE(editor::write_op_file(wanted, op_path, diagnostics)) << diagnostics.to_text();
    return test::bytes_of(path);
  };
  std::string expected = before;
  expected.replace(expected.find("many"), 4, "64");
  EXPECT_EQ(written(render_options), expected);
  render_options.depth = 9;
  expected.replace(expected.find("Depth 7"), 7, "Depth 9");
  EXPECT_EQ(written(render_options), expected);
  render_options.environment.clear();
  EXPECT_THAT(written(render_options),
              HasSubstr("Depth 9\t# deep\r\n// of June\r\na line of another program\r\n"));
}

TEST(OpFile, IsLeftAsItWasWhereANameCannotBeWritten) {
  const test::TemporaryFolder folder;
  const std::string path = folder.add("a.op", "Depth 7\n");
  options::RenderOptions render_options;
  render_options.scene = "two\nlines.grf";
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(editor::write_op_file(render_options, QString::fromStdString(path), diagnostics));
  EXPECT_THAT(diagnostics.to_text(), HasSubstr("BPT_Scene"));
  EXPECT_EQ(test::bytes_of(path), "Depth 7\n");
}

}  // namespace
