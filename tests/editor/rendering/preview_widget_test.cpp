#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "editor/rendering/preview.h"
#include "tests/editor/programs/shell_program.h"
#include "tests/editor/rendering/rendering_helpers.h"

namespace {

using editor::Preview;
using job::PreviewState;

TEST(PreviewObject, ShowsImagesAndEnds) {
  Preview preview;
  QSignalSpy images(&preview, &Preview::image_changed);
  QSignalSpy states(&preview, &Preview::state_changed);
  preview.restart(test::request(test::scene_of_text(test::Corner)));
  EXPECT_TRUE(preview.is_on());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return !states.empty() && states.back()[0].value<PreviewState>() == PreviewState::Done; },
      test::Minute));
  ASSERT_FALSE(images.empty());
  ASSERT_TRUE(preview.image());
  EXPECT_EQ(preview.image()->width, 96);
  test::expect_lit_corner(*preview.image());
  EXPECT_EQ(images.back()[1].value<transport::RenderProgress>().done, 1);
}

TEST(PreviewObject, ShowsTheLastOfManyEdits) {
  Preview preview;
  QSignalSpy images(&preview, &Preview::image_changed);
  job::PreviewRequest request = test::request(test::scene_of_text(test::Corner), 96, 72, 100'000);
  for (int i = 1; i <= 50; ++i) {
    request.options.size = {96 + i, 72};
    preview.restart(request);
    QTest::qWait(1);
  }
  EXPECT_FALSE(images.empty()) << "images come while edits follow each other";
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return preview.image() && preview.image()->width == 96 + 50; }, test::Minute));
  preview.pause();
  ASSERT_TRUE(QTest::qWaitFor([&] { return preview.is_paused(); }, test::Minute));
  preview.resume();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !preview.is_paused(); }, test::Minute));
  preview.stop();
  images.clear();
  QTest::qWait(200);
  EXPECT_TRUE(images.empty()) << "nothing comes of a preview that was stopped";
}

TEST(PreviewObject, SaysWhyThereIsNoImage) {
  Preview preview;
  QSignalSpy images(&preview, &Preview::image_changed);
  std::string text;
  QObject::connect(&preview, &Preview::diagnosed,
                   [&](const grf::Diagnostics& diagnostics) { text = diagnostics.to_text(); });
  job::PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  test::first_mesh(request.scene).edit().surfaces[0].texture = grf::Texture{"lost.png", {}};
  preview.restart(request);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !preview.is_on(); }, test::Minute));
  EXPECT_THAT(text, testing::HasSubstr("lost.png"));
  EXPECT_TRUE(images.empty());
}

TEST(PreviewObject, OutlivesDecodersThatCrash) {
  const test::TemporaryFolder folder;
  Preview preview(nullptr, editor::ImageProcess(test::shell_program(folder, "kill -SEGV $$")));
  std::string text;
  QObject::connect(&preview, &Preview::diagnosed,
                   [&](const grf::Diagnostics& diagnostics) { text = diagnostics.to_text(); });
  job::PreviewRequest request = test::request(test::scene_of_text(test::Corner));
  test::first_mesh(request.scene).edit().surfaces[0].texture = grf::Texture{folder.path("evil.png"), {}};
  preview.restart(request);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !preview.is_on(); }, test::Minute));
  EXPECT_THAT(text, testing::HasSubstr(
                        "evil.png: error: cannot read the image: the file is corrupt (its decoder crashed)"));
  test::first_mesh(request.scene).edit().surfaces[0].texture.reset();
  request.options.environment = folder.path("evil.exr");
  preview.restart(request);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !preview.is_on(); }, test::Minute));
  EXPECT_THAT(text, testing::HasSubstr("evil.exr"));
  EXPECT_THAT(text, testing::HasSubstr("its decoder crashed"));
}

}  // namespace
