#include "editor/programs/image_process.h"

#include <QElapsedTimer>
#include <filesystem>
#include <thread>

#include <gmock/gmock.h>

#include "tests/editor/programs/shell_program.h"

namespace editor {
namespace {

using testing::HasSubstr;

/// A shell script in place of `bpt`, and the result of reading an image with it.
class ImageProcesses : public testing::Test {
 protected:
  std::string read_by(const std::string& script, const ImageProcess::Limits& limits = {}) {
    return read(ImageProcess(test::shell_program(folder_, script), limits));
  }
  std::string read(const ImageProcess& images, const std::string& name = "image.pfm") {
    diagnostics_ = {};
    image_ = images.read(folder_.path(name), diagnostics_);
    EXPECT_EQ(image_.has_value(), diagnostics_.entries().empty());
    return image_ ? "read" : diagnostics_.entries().front().message;
  }
  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;
  std::optional<image::Image> image_;
};

TEST_F(ImageProcesses, ReadWhatAFileHolds) {
  folder_.add("image.pfm", std::string("Pf\n2 1\n-1.0\n\0\0\x80\x3f\0\0\0\xc0", 20));  // 1 and -2
  ASSERT_EQ(read(ImageProcess()), "read");
  ASSERT_EQ(image_->width, 2);
  ASSERT_EQ(image_->height, 1);
  EXPECT_EQ(image_->pixels[0], grf::Colour(1));
  EXPECT_EQ(image_->pixels[1], grf::Colour(-2));
}

TEST_F(ImageProcesses, ReadTheLayersOfAFile) {
  image::ImageFile written{{2, 1, {grf::Colour(1), grf::Colour(2)}}};
  written.layers = {{"depth", "Z", {3, 4}}, {"normal", "XYZ", {0, 0, 1, 0, 1, 0}}};
  ASSERT_TRUE(image::write_image(written, folder_.path("image.exr"), diagnostics_));
  const auto file = ImageProcess().read_file(folder_.path("image.exr"), diagnostics_);
  ASSERT_TRUE(file) << diagnostics_.to_text();
  EXPECT_EQ(file->image.pixels, written.image.pixels);
  ASSERT_EQ(file->layers.size(), 2U);
  EXPECT_EQ(file->layers[0].name, "depth");
  EXPECT_EQ(file->layers[0].channels, "Z");
  EXPECT_EQ(file->layers[0].values, written.layers[0].values);
  EXPECT_EQ(file->layers[1].values, written.layers[1].values);
}

TEST_F(ImageProcesses, KeepTheAlphaOfAFile) {
  const std::string path = folder_.add("leaf.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\x08"
                                                               "\0\0\xff\x33",
                                                               22));
  const auto image = ImageProcess().read(path, diagnostics_, {}, {}, image::Alpha::Kept);
  ASSERT_TRUE(image) << diagnostics_.to_text();
  EXPECT_THAT(image->alpha, testing::ElementsAre(testing::FloatEq(0.2F)));
  EXPECT_TRUE(ImageProcess().read(path, diagnostics_)->alpha.empty());
}

// The decoder may have been taken over by the file that it read.
TEST_F(ImageProcesses, BelieveNoDecoderThatWritesBrokenLayers) {
  const std::string image = "\\001\\0\\0\\0\\001\\0\\0\\0............";
  for (const std::string layers : {"\\001", "\\377\\377\\377\\377\\0\\0\\0\\0z....",
                                   "\\001\\0\\0\\0\\0\\0\\0\\0z..", "\\001\\0\\0\\0\\003\\0\\0\\0zXYZ...."}) {
    diagnostics_ = {};
    const ImageProcess images(test::shell_program(folder_, "printf '" + image + layers + "'"));
    EXPECT_FALSE(images.read_file(folder_.path("image.exr"), diagnostics_)) << layers;
    EXPECT_THAT(diagnostics_.to_text(), HasSubstr("its decoder wrote no image"));
  }
  const ImageProcess whole(
      test::shell_program(folder_, "printf '" + image + "\\001\\0\\0\\0\\0\\0\\0\\0z....'"));
  EXPECT_TRUE(whole.read_file(folder_.path("image.exr"), diagnostics_ = {})) << "so far these are right";
}

TEST_F(ImageProcesses, TellWhatTheDecoderSaysOfABrokenFile) {
  folder_.add("image.pfm", "PF\n2 1\n-1.0\n");
  EXPECT_EQ(read(ImageProcess()), "cannot read the image: it is damaged (unexpected end of file)");
  EXPECT_EQ(diagnostics_.entries().front().location.file->path, folder_.path("image.pfm"));
  EXPECT_THAT(read(ImageProcess(), "--help"), HasSubstr("No such file"));
}

TEST_F(ImageProcesses, SayAtThePlaceThatNamesTheFileWhatIsWrong) {
  grf::SourceLocation place = grf::whole_file("scene.grf");
  place.line = 3;
  place.column = 20;
  EXPECT_FALSE(ImageProcess().read("none.png", diagnostics_, place));
  EXPECT_THAT(diagnostics_.to_text(), HasSubstr("scene.grf:3:20: error: 'none.png': "));
}

TEST_F(ImageProcesses, OutliveADecoderThatCrashes) {
  EXPECT_EQ(read_by("kill -SEGV $$"), "cannot read the image: the file is corrupt (its decoder crashed)");
}

TEST_F(ImageProcesses, EndADecoderThatHangs) {
  QElapsedTimer clock;
  clock.start();
  EXPECT_EQ(read_by("trap '' TERM INT; while :; do :; done", {0.3}),
            "cannot read the image: decoding takes longer than 0.3 s");
  EXPECT_LT(clock.elapsed(), 5000);
}

TEST_F(ImageProcesses, EndAtOnceWhenTheyAreAskedToStop) {
  const QString program = test::shell_program(folder_, "exec sleep 100");
  std::stop_source stop;
  QElapsedTimer clock;
  clock.start();
  std::thread reading(
      [&] { EXPECT_FALSE(ImageProcess(program).read("image.png", diagnostics_, {}, stop.get_token())); });
  stop.request_stop();
  reading.join();
  EXPECT_LT(clock.elapsed(), 10'000);
  EXPECT_TRUE(diagnostics_.entries().empty());
}

#ifndef GRANADA_HAS_SANITIZERS
TEST_F(ImageProcesses, KeepADecoderFromTakingAllMemory) {
  const ImageProcess::Limits limits = {60, std::uint64_t(300) << 20U};
  const std::string size("\x70\x17\0\0\x70\x17\0\0", 8);  // 6000 x 6000, 432 MB
  std::filesystem::resize_file(folder_.add("image.raw", size), size.size() + 12ULL * 6000 * 6000);
  EXPECT_THAT(read(ImageProcess(bundled_program("bpt"), limits), "image.raw"), HasSubstr("memory"));
}
#endif

TEST_F(ImageProcesses, BelieveNothingThatADecoderWrites) {
  const std::string refused = "cannot read the image: the file is corrupt (its decoder wrote no image)";
  EXPECT_EQ(read_by("exit 0"), refused);
  EXPECT_EQ(read_by("printf '\\002\\0\\0\\0'"), refused) << "half a size";
  EXPECT_EQ(read_by("printf '\\002\\0\\0\\0\\001\\0\\0\\0'; printf '%20s' x"), refused) << "too few pixels";
  EXPECT_EQ(read_by("printf '\\002\\0\\0\\0\\001\\0\\0\\0'; printf '%25s' x"), refused) << "too many bytes";
  EXPECT_EQ(read_by("printf '\\0\\0\\0\\0\\001\\0\\0\\0'"), refused) << "no pixels";
  EXPECT_EQ(read_by("printf '\\377\\377\\377\\377\\377\\377\\377\\377'; printf '%12s' x"), refused)
      << "negative";
  EXPECT_EQ(read_by("printf '\\377\\377\\377\\177\\377\\377\\377\\177'; printf '%12s' x"), refused) << "huge";
  EXPECT_EQ(read_by("printf '\\002\\0\\0\\0\\001\\0\\0\\0'; printf '%24s' x"), "read");
  EXPECT_EQ(read_by("head -c 3000000 /dev/zero | tr '\\0' 'e' >&2; exit 1").size(), 999U)
      << "an endless message";
}

TEST_F(ImageProcesses, SayThatTheProgramIsMissing) {
  EXPECT_EQ(read(ImageProcess(QString())), "cannot read the image: cannot find the program bpt");
  EXPECT_THAT(read(ImageProcess("/no/such/program")), HasSubstr("cannot start"));
}

}  // namespace
}  // namespace editor
