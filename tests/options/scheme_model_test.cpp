#include "renderer/options/scheme_model.h"

#include <gtest/gtest.h>

#include "grf/write.h"
#include "renderer/options/op_file.h"
#include "tests/support/temporary_folder.h"

namespace {

using options::RenderOptions;

class SchemeModel : public testing::Test {
 protected:
  RenderOptions read(const std::string& text) {
    const auto read_options =
        options::read_op_file(folder_.add("test.op", "Scene a.grf\n" + text), diagnostics_);
    EXPECT_TRUE(read_options) << diagnostics_.to_text();
    return read_options.value_or(RenderOptions());
  }

  /// Returns the scheme as a PDF of a scene; all its options must be used.
  std::string scheme_of(const std::string& text) {
    diagnostics_ = {};
    const RenderOptions read_options = read(text);
    options::warn_of_unused_options(read_options, diagnostics_);
    EXPECT_EQ(diagnostics_.to_text(), "") << text;
    const auto model = options::scheme_model(read_options);
    return model ? grf::to_text(*model) : "";
  }

  std::string warnings_of(const std::string& text) {
    diagnostics_ = {};
    options::warn_of_unused_options(read(text), diagnostics_);
    std::string all;
    for (const grf::Diagnostic& entry : diagnostics_.entries()) {
      all += std::to_string(entry.location.line) + ": " + entry.message + "\n";
    }
    return all;
  }

  test::TemporaryFolder folder_;
  grf::Diagnostics diagnostics_;
};

TEST_F(SchemeModel, HasTheSchemesOfOpFiles) {
  EXPECT_EQ(scheme_of("Depth 3\n"), "");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Diffuse\n"), "diffuse");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name specular\n"), "specular");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name REJECT\n"), "reject");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Auto\n"), "auto");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Disk\n"), "adaptive");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Adaptive\n"), "adaptive");
}

TEST_F(SchemeModel, HasTheParametersThatWereGiven) {
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Hemisphere\nBPT_Pdf_LobeExponent 30\n"), "hemisphere exp=30");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Sphere\nBPT_Pdf_LobeExponent 2.5\n"), "sphere exp=2.5");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Anisotropic\nBPT_Pdf_AnisoNu 25\nBPT_Pdf_AnisoNv 5\n"),
            "anisotropic nu=25 nv=5");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Disk\nBPT_QT_Precomputed 60\nBPT_QT_Anisotropic 4\nBPT_QT_avgnmax 1.7\n"
                      "BPT_QT_ImgRes 400\nBPT_QT_release true\n"),
            "adaptive nQT=60 nAnisoQT=4 nmax=1.7 res=400 release=true");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name Factored\nBPT_Pdf_Factors_ResU 16 8\nBPT_Pdf_Factors_ResP 100 32\n"
                      "BPT_Pdf_Factors_JK 2 3\nBPT_Pdf_Factors_Half false\nBPT_Pdf_Factors_File none\n"),
            "factored uTh=16 uPh=8 pTh=100 pPh=32 J=2 K=3 half=false");
  EXPECT_EQ(scheme_of("BPT_Pdf_Name CascadeCDF\nBPT_Pdf_CDF_Res 128 16\nBPT_Pdf_CDF_Compress TRUE\n"),
            "cascadeCDF nTh=128 nPh=16 compress=true");
}

TEST_F(SchemeModel, KeepsPathsAndPlaces) {
  const RenderOptions read_options =
      read("BPT_Pdf_Name Factored\nBPT_Pdf_Factors_File plastic\nBPT_Pdf_Factors_JK 2 3\n");
  EXPECT_EQ(read_options.factors_file, folder_.path("plastic"));
  const auto model = options::scheme_model(read_options);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->location.line, 2U);
  EXPECT_EQ(model->location.column, 14U);
  EXPECT_EQ(model->arguments.at(0).location.line, 4U);
}

TEST_F(SchemeModel, WarnsOfWhatHasNoEffect) {
  EXPECT_EQ(warnings_of("BPT_Pdf_Name Disk\nBPT_Pdf_LobeExponent 30\nBPT_Pdf_Factors_JK 2 3\n"
                        "BPT_Pdf_Factors_File plastic\n"),
            "3: BPT_Pdf_LobeExponent has no effect: the scheme 'adaptive' does not use it\n"
            "4: BPT_Pdf_Factors_JK has no effect: the scheme 'adaptive' does not use it\n"
            "5: BPT_Pdf_Factors_File has no effect: the scheme 'adaptive' does not use it\n");
  EXPECT_EQ(warnings_of("BPT_QT_avgnmax 2\n"),
            "2: BPT_QT_avgnmax has no effect: no BPT_Pdf_Name is given, so the parameters of the scene's "
            "schemes apply\n");
  EXPECT_EQ(warnings_of("BPT_RIS 8 2\nBPT_EM_Projection backplate\n"),
            "3: BPT_EM_Projection has no effect: no BPT_EM_Background is given\n"
            "2: BPT_RIS has no effect: a backplate lights nothing\n");
  EXPECT_EQ(warnings_of("BPT_Pixel_Radial true\nBPT_Pixel_Random false\n"),
            "3: BPT_Pixel_Random has no effect: the integrator 'path' places its samples itself\n"
            "2: BPT_Pixel_Radial has no effect: the integrator 'path' places its samples itself\n");
  EXPECT_EQ(warnings_of("BPT_Integrator naive\nBPT_Pixel_Radial true\nBPT_Samples 4\n"),
            "4: BPT_Samples has no effect: the integrator 'naive' takes Pixel_SampleRes x NSecRaysRoot^2\n");
  EXPECT_EQ(warnings_of("BPT_Integrator naive\nBPT_Irradiance true\n"),
            "3: BPT_Irradiance has no effect: the integrator 'naive' does not use baked irradiance\n");
  EXPECT_EQ(warnings_of("BPT_Integrator naive\nBPT_RIS 8 2\nBPT_EM_Background sky.exr\n"),
            "3: BPT_RIS has no effect: the integrator 'naive' does not sample lights\n");
  EXPECT_EQ(warnings_of("BPT_Integrator naive\nBPT_Branches 3\n"),
            "3: BPT_Branches has no effect: the integrator 'naive' takes NSecRaysRoot^2\n");
  EXPECT_EQ(warnings_of("BPT_RayCasting true\nBPT_Depth 3\n"),
            "3: BPT_Depth has no effect: BPT_RayCasting traces one ray per pixel\n");
  EXPECT_EQ(warnings_of("BPT_RIS 8 2\n"), "2: BPT_RIS has no effect: no BPT_EM_Background is given\n");
}

// Forms disable options that have no effect, whether or not they are given.
TEST_F(SchemeModel, KnowsWhatIsUnusedBeforeItIsGiven) {
  const auto why = [](const RenderOptions& given, std::string_view key) {
    return options::why_unused(given, *options::find_option(key)).value_or("");
  };
  RenderOptions given;
  given.scheme = "CascadeCDF";
  EXPECT_EQ(why(given, "BPT_QT_avgnmax"), "the scheme 'cascadeCDF' does not use it");
  EXPECT_EQ(why(given, "BPT_Pdf_CDF_Res"), "");
  EXPECT_EQ(why(given, "BPT_EM_Projection"), "no BPT_EM_Background is given");
  EXPECT_EQ(why(given, "BPT_Depth"), "");
  EXPECT_EQ(why(given, "BPT_Pixel_Radial"), "the integrator 'path' places its samples itself");
}

}  // namespace
