// Tests of the option table, from which OP files, the command line and documents follow.
#include <iterator>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "grf/write.h"
#include "renderer/options/scheme_model.h"
#include "renderer/reflectance/scheme.h"

namespace {

using options::RenderOptions;

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(OptionTable, KeysAndFlagsAreDistinctAndExplained) {
  for (const options::OptionInfo& option : options::option_table()) {
    EXPECT_EQ(options::find_option(option.key), &option);
    EXPECT_FALSE(option.meaning.empty());
    for (const options::OptionInfo& other : options::option_table()) {
      EXPECT_TRUE(&other == &option || option.flag.empty() || other.flag != option.flag) << option.flag;
    }
  }
}

// The defaults in the table are those of the struct.
TEST(OptionTable, DefaultsAreThoseOfTheStruct) {
  for (const char* key : {"BPT_Image_Resolution",
                          "BPT_Up",
                          "BPT_FieldOfView",
                          "BPT_Background",
                          "BPT_Depth",
                          "BPT_Exposure",
                          "BPT_Layers",
                          "BPT_Irradiance",
                          "BPT_Integrator",
                          "BPT_Pixel_SampleRes",
                          "BPT_Pixel_Random",
                          "BPT_Pixel_Radial",
                          "BPT_RE_NSecRaysRoot",
                          "BPT_RayCasting",
                          "BPT_Checkpoint",
                          "BPT_DisplayWindow",
                          "BPT_DisplayServer",
                          "BPT_Seed",
                          "BPT_Threads",
                          "BPT_EM_Background",
                          "BPT_EM_Projection",
                          "BPT_EM_Rotation",
                          "BPT_EM_Scale",
                          "BPT_LensRadius",
                          "BPT_Camera",
                          "BPT_Frames",
                          "BPT_Frame",
                          "BPT_CameraPath",
                          "BPT_Pdf_memstat",
                          "BPT_Pdf_Factors_File",
                          "BPT_Chrono_Sampling",
                          "BPT_Chrono_Rendering",
                          "BPT_Chrono_Prebuild"}) {
    const options::OptionInfo& option = *options::find_option(key);
    std::istringstream stream{std::string(option.default_value)};
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    RenderOptions render_options;
    EXPECT_EQ(options::set_option(render_options, option, words), std::nullopt) << key;
    EXPECT_EQ(render_options, RenderOptions()) << key;
  }
}

// A line starts with a key, and the words after it are its values.
TEST(OptionTable, NoKeyStartsAnother) {
  for (const options::OptionInfo& option : options::option_table()) {
    for (const options::OptionInfo& other : options::option_table()) {
      EXPECT_FALSE(other.key.starts_with(std::string(option.key) + "_")) << option.key << " " << other.key;
    }
  }
}

TEST(OptionTable, FindsKeysHoweverTheyAreWritten) {
  const options::OptionInfo* option = options::find_option("BPT_Pixel_SampleRes");
  ASSERT_NE(option, nullptr);
  for (const char* key :
       {"bpt_pixel_sampleres", "BPT Pixel SampleRes", "Pixel_SampleRes", "PIXEL SAMPLERES"}) {
    EXPECT_EQ(options::find_option(key), option) << key;
  }
  EXPECT_EQ(options::find_option("PixelSampleRes"), nullptr);
}

// A value for each key, other than its default.
TEST(OptionTable, WordsOfAnOptionSetItAgain) {
  const std::map<std::string_view, std::string> values = {
      {"float", "0.1"},
      {"int", "7"},
      {"int int", "5 3"},
      {"x y z", "0.1 1e-20 3"},
      {"r g b", "1 2 3"},
      {"path", "a/b c"},
      {"HOST:PORT", "[::1]:80"},
      {"name", "side"},
      {"name x y z x y z x y z float float float", "side 1 2 3 4 5 6 0 1 0 45 0 0.5"}};
  for (const options::OptionInfo& option : options::option_table()) {
    RenderOptions first;
    std::vector<std::string> words;
    if (option.values == "bool") {
      words = {option.default_value == "true" ? "false" : "true"};
    } else if (const auto* word = std::get_if<options::WordOption>(&option.value)) {
      words = {std::string(word->words.front() == option.default_value ? word->words.back()
                                                                       : word->words.front())};
    } else if (const auto* list = std::get_if<options::ListOption>(&option.value)) {
      words = {std::string(list->words[1]) + "," + std::string(list->words[2])};
    } else if (option.values == "path") {
      words = {"a/b c"};
    } else if (option.key == "BPT_QT_avgnmax") {
      words = {"1.7"};
    } else {
      words = words_of(values.at(option.values));
    }
    ASSERT_EQ(options::set_option(first, option, words), std::nullopt) << option.key;
    EXPECT_FALSE(first == RenderOptions()) << option.key << " changes nothing";
    EXPECT_EQ(options::option_words(first, option), words) << option.key;
  }
}

TEST(OptionTable, SamplesFollowFromThoseOfTheThesis) {
  RenderOptions render_options;
  EXPECT_EQ(render_options.samples_per_pixel(), 100);
  render_options.pixel_samples = {2, 3};
  render_options.secondary_rays_root = 4;
  EXPECT_EQ(render_options.samples_per_pixel(), 96);
  render_options.samples = 7;
  EXPECT_EQ(render_options.samples_per_pixel(), 7);
  render_options = {};
  render_options.pixel_samples = {4096, 4096};
  render_options.secondary_rays_root = 10000;
  EXPECT_EQ(render_options.samples_per_pixel(), std::numeric_limits<int>::max());
}

/// Returns the default of a parameter of a scheme.
float default_of_scheme(std::string_view scheme, std::string_view parameter) {
  for (const grf::ModelInfo& info : reflectance::scheme_infos()) {
    if (info.keyword != scheme) continue;
    for (const grf::ParameterInfo& entry : info.parameters) {
      if (entry.is_called(parameter)) return entry.default_value;
    }
  }
  ADD_FAILURE() << scheme << " has no " << parameter;
  return -1;
}

// An option set to the default in the table has the same effect as the scheme without it.
TEST(OptionTable, DefaultsOfSchemesAreTheirOwn) {
  for (const options::OptionInfo& option : options::option_table()) {
    if (!option.key.starts_with("BPT_QT_") && !option.key.starts_with("BPT_Pdf_Factors_") &&
        !option.key.starts_with("BPT_Pdf_CDF_")) {
      continue;
    }
    if (option.values == "path") continue;
    RenderOptions render_options;
    render_options.scheme = option.key.starts_with("BPT_QT_")     ? "Disk"
                            : option.key.starts_with("BPT_Pdf_C") ? "CascadeCDF"
                                                                  : "Factored";
    ASSERT_EQ(options::set_option(render_options, option, words_of(option.default_value)), std::nullopt)
        << option.key;
    const auto model = options::scheme_model(render_options);
    ASSERT_TRUE(model && !model->arguments.empty()) << option.key;
    for (const grf::Argument& argument : model->arguments) {
      const float expected = default_of_scheme(model->keyword, argument.name);
      const auto* number = std::get_if<float>(&argument.value);
      const auto* truth = std::get_if<bool>(&argument.value);
      ASSERT_TRUE(number != nullptr || truth != nullptr);
      EXPECT_EQ(number != nullptr ? *number : static_cast<float>(*truth), expected) << option.key;
    }
  }
}

}  // namespace
