// Tests of the image files of `bpt render`, and where they are written.
#include <cstdlib>
#include <filesystem>
#include <thread>

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMatrixAttribute.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <sys/stat.h>

#include "renderer/image/image.h"
#include "tests/cli/bpt.h"
#include "tests/support/paths.h"

namespace {

using image::Image;
using test::Outcome;
using test::Quad;

class BptOutput : public test::Bpt {
 protected:
  Image read(const std::string& name) const {
    grf::Diagnostics diagnostics;
    const auto image = image::read_image(name, diagnostics);
    EXPECT_TRUE(image) << diagnostics.to_text();
    return image.value_or(Image());
  }

  std::string scene_ = write("scene.grf", Quad);
};

TEST_F(BptOutput, IsOfEachType) {
  std::vector<std::string> arguments = {"render", scene_, "--size", "20x10", "--samples", "4"};
  const std::vector<std::string> types = {"exr", "pfm", "raw", "hdr", "png", "jpg", "tga"};
  for (const std::string& type : types) {
    arguments.insert(arguments.end(), {"--output", path("image." + type)});
  }
  const Outcome outcome = bpt(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const Image exr = read(path("image.exr"));
  ASSERT_EQ(exr.width, 20);
  float brightest = 0;
  for (const std::string& type : types) {
    const Image image = read(path("image." + type));
    ASSERT_EQ(image.pixels.size(), exr.pixels.size()) << type;
    const bool is_exact = type == "exr" || type == "pfm" || type == "raw";
    const float tolerance = is_exact ? 0 : type == "jpg" ? 0.1F : 0.01F;
    for (std::size_t i = 0; i < exr.pixels.size(); ++i) {
      brightest = std::max(brightest, exr.pixels[i].x);
      EXPECT_NEAR(image.pixels[i].x, std::min(exr.pixels[i].x, 1.0F), tolerance) << type << " " << i;
    }
  }
  EXPECT_GT(brightest, 0.05F) << "it shows something";
  EXPECT_LT(brightest, 1);
}

TEST_F(BptOutput, IsBrightenedByTheExposure) {
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Image_Resolution 8 8\nBPT_Samples 4\n"
                               "BPT_Exposure 1\nBPT_Output_Image image.png\n");
  ASSERT_EQ(bpt({op}).exit_code, 0);
  const Image brighter = read(path("image.png"));
  ASSERT_EQ(bpt({"render", op, "--exposure", "0"}).exit_code, 0);
  const Image plain = read(path("image.png"));
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
    EXPECT_NEAR(brighter.pixels[i].x, std::min(1.0F, 2 * plain.pixels[i].x), 0.02F);
  }
}

std::string text_of(const Imf::Header& header, const char* name) {
  const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
  return attribute == nullptr ? "absent" : attribute->value();
}

TEST_F(BptOutput, SaysInExrHowItWasMade) {
  const std::string op = write("scene.op",
                               "BPT_Scene scene.grf\nBPT_Image_Resolution 16 8\nBPT_Pixel_SampleRes 2 1\n"
                               "BPT_RE_NSecRaysRoot 2\nBPT_Background 0.5 0 0.25\nBPT_VLook 0 0 0\n"
                               "BPT_Viewer 0 1 2\n");
  ASSERT_EQ(bpt({"render", op, "--seed", "7", "--pdf", "Diffuse"}).err, "");
  Imf::InputFile file(path("scene.exr").c_str());
  const Imf::Header& header = file.header();
  EXPECT_EQ(text_of(header, "BPT_Scene"), path("scene.grf"));
  EXPECT_EQ(text_of(header, "BPT_Image_Resolution"), "16 8");
  EXPECT_EQ(text_of(header, "BPT_Background"), "0.5 0 0.25");
  EXPECT_EQ(text_of(header, "BPT_Viewer"), "0 1 2");
  EXPECT_EQ(text_of(header, "BPT_Seed"), "7");
  EXPECT_EQ(text_of(header, "BPT_Samples"), "8") << "what it came to";
  EXPECT_EQ(text_of(header, "BPT_Pdf_Name"), "Diffuse");
  EXPECT_EQ(text_of(header, "BPT_QT_ImgRes"), "absent") << "it was not given";
  EXPECT_TRUE(text_of(header, "software").starts_with("Granada "));
  const auto number = [&](const char* name) {
    const auto* attribute = header.findTypedAttribute<Imf::FloatAttribute>(name);
    return attribute == nullptr ? -1.0F : attribute->value();
  };
  EXPECT_EQ(number("samplesPerPixel"), 8);
  EXPECT_GT(number("renderSeconds"), 0);
  EXPECT_GT(number("estimatedError"), 0);
  EXPECT_LT(number("estimatedErrorLow"), number("estimatedError"));
  EXPECT_GT(number("estimatedErrorHigh"), number("estimatedError"));
  ASSERT_TRUE(Imf::hasWorldToCamera(header) && Imf::hasWorldToNDC(header));
  const Imath::V3f origin = Imath::V3f(0) * Imf::worldToNDC(header);
  EXPECT_NEAR(origin.x, 0.5F, 1e-5F) << "it is looked at";
  EXPECT_NEAR(origin.y, 0.5F, 1e-5F);
}

TEST_F(BptOutput, HasLayersOnRequest) {
  const auto channels_of = [&](const std::string& layers) {
    const Outcome outcome = bpt({"render", scene_, "--size", "8x8", "--samples", "2", "--layers", layers});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    Imf::InputFile file(path("scene.exr").c_str());
    std::vector<std::string> names;
    const Imf::ChannelList& channels = file.header().channels();
    for (auto it = channels.begin(); it != channels.end(); ++it) names.emplace_back(it.name());
    return names;
  };
  EXPECT_EQ(channels_of("none"), (std::vector<std::string>{"B", "G", "R"}));
  EXPECT_EQ(channels_of("depth,samples"), (std::vector<std::string>{"B", "G", "R", "depth.Z", "samples"}));
  EXPECT_EQ(channels_of("all"),
            (std::vector<std::string>{"B", "G", "R", "albedo.B", "albedo.G", "albedo.R", "depth.Z", "error",
                                      "normal.X", "normal.Y", "normal.Z", "samples", "variance.B",
                                      "variance.G", "variance.R"}));
  const Outcome plain = bpt(
      {"render", scene_, "--size", "8x8", "--samples", "1", "--layers", "normal", "--output", path("a.png")});
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_EQ(plain.err, "warning: BPT_Layers has no effect: only exr images have layers\n");
}

TEST_F(BptOutput, IsRefusedBeforeTheRenderWhereItCannotBe) {
  const auto error_of = [&](const std::string& output, const std::string& size) {
    const Outcome outcome =
        bpt({"render", scene_, "--output", output, "--size", size, "--samples", "1000000"});
    EXPECT_EQ(outcome.exit_code, 1);
    return outcome.err;
  };
  EXPECT_EQ(error_of(path("a.jpg"), "65501x1"),
            path("a.jpg") + ": error: images of this type have at most 65500 pixels per side\n");
  const std::string pipe = path("pipe.png");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(error_of(pipe, "8x8"), pipe + ": error: cannot write the image: it is not a regular file\n");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

/// Returns the fallback path of the image that a message names.
std::string kept_in(const std::string& message) {
  const std::string start = "the image was saved as '";
  const std::size_t at = message.find(start);
  if (at == std::string::npos) return "";
  return message.substr(at + start.size(), message.find('\'', at + start.size()) - at - start.size());
}

TEST_F(BptOutput, IsKeptElsewhereIfItsFolderIsGone) {
  const std::string output = path("gone/image.pfm");
  std::filesystem::create_directory(path("gone"));
  std::filesystem::create_directory(path("fallback"));
  std::thread remover([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    std::filesystem::remove_all(path("gone"));
  });
  const Outcome outcome =
      test::run({"/usr/bin/env", "TMPDIR=" + path("fallback"), GRANADA_BIN_DIR "/bpt", "render", scene_,
                 "--output", output, "--samples", "100000000", "--size", "16x16"},
                {}, {{SIGINT, std::chrono::milliseconds(1500)}});
  remover.join();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find(output + ": error: cannot create the file: No such file"), std::string::npos)
      << outcome.err;
  const std::string kept = kept_in(outcome.err);
  EXPECT_TRUE(kept.starts_with(path("fallback/granada-"))) << outcome.err;
  EXPECT_EQ(read(kept).width, 16);
}

TEST_F(BptOutput, IsKeptElsewhereIfTheDiskIsFull) {
  // A separate file system that is too small, which needs no rights except in a private name space.
  const std::vector<std::string> alone = {"/usr/bin/unshare", "--user", "--map-root-user", "--mount"};
  std::vector<std::string> probe = alone;
  probe.emplace_back("/bin/true");
  if (test::run(probe).exit_code != 0) GTEST_SKIP() << "this system lets nobody have a name space";
  std::filesystem::create_directory(path("small"));
  std::filesystem::create_directory(path("home"));
  const std::string output = path("small/image.pfm");
  std::vector<std::string> command = alone;
  command.insert(command.end(),
                 {"/bin/sh", "-ec",
                  "mount -t tmpfs -o size=16k none '" + path("small") + "'\nTMPDIR='" + path("small") +
                      "' HOME='" + path("home") + "' '" GRANADA_BIN_DIR "/bpt' render '" + scene_ +
                      "' --output '" + output + "' --size 64x64 --samples 1"});
  const Outcome outcome = test::run(command);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find(output + ": error: cannot write the file: No space left on device"),
            std::string::npos)
      << outcome.err;
  const std::string kept = kept_in(outcome.err);
  EXPECT_TRUE(kept.starts_with(path("home/granada-"))) << outcome.err;
  EXPECT_EQ(read(kept).width, 64);
}

// The limit applies to all files of the program, so no image can be written; but `bpt` reports this, and the
// older file stays.
TEST_F(BptOutput, IsNotTheEndOfTheProgramOverAFileSizeLimit) {
  const std::string output = write("image.pfm", "the older one");
  const Outcome outcome = test::run({"/bin/sh", "-c",
                                     "ulimit -f 4; exec '" GRANADA_BIN_DIR "/bpt' render '" + scene_ +
                                         "' --output '" + output + "' --size 64x64 --samples 1"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("error: the image could not be saved in "), std::string::npos) << outcome.err;
  EXPECT_EQ(test::bytes_of(output), "the older one");
}

}  // namespace
