// The tables in documents are those of the code. To rewrite them after a change:
//   GRANADA_UPDATE_DOCUMENTS=1 build/release/bin/documents_test
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "renderer/options/render_options.h"
#include "renderer/reflectance/scheme.h"
#include "tests/support/generated_document.h"

namespace {

void expect_generated(const std::string& document, const std::string& expected) {
  test::expect_generated(document, "documents_test", expected);
}

std::string option_rows() {
  std::string rows = "| key | command line | value | default | meaning |\n|---|---|---|---|---|\n";
  for (const options::OptionInfo& option : options::option_table()) {
    rows += fmt::format("| {} | {} | {} | {} | {} |\n", option.key,
                        option.flag.empty() ? "" : fmt::format("`{}`", option.flag), option.values,
                        option.default_value, option.meaning);
  }
  return rows;
}

std::string names_of(const grf::ParameterInfo& parameter) {
  std::string names(parameter.name);
  for (const std::string_view alias : parameter.aliases) names += fmt::format(" or {}", alias);
  return names;
}

std::string default_of(const grf::ParameterInfo& parameter) {
  if (!parameter.default_from.empty()) return fmt::format("that of {}", parameter.default_from);
  if (parameter.kind == grf::ParameterKind::Boolean) return parameter.default_value != 0 ? "true" : "false";
  if (!parameter.default_rgb) return fmt::format("{}", parameter.default_value);
  const grf::Colour& rgb = *parameter.default_rgb;
  return fmt::format("({}, {}, {})", rgb.x, rgb.y, rgb.z);
}

std::string parameter_rows(const grf::ModelInfo& model) {
  if (model.parameters.empty()) return "No parameters.\n";
  std::string rows = "| parameter | range | default | meaning |\n|---|---|---|---|\n";
  for (const grf::ParameterInfo& parameter : model.parameters) {
    const bool is_rgb = parameter.kind == grf::ParameterKind::Reflectance;
    const std::string value = default_of(parameter);
    const std::string range = parameter.kind == grf::ParameterKind::Boolean
                                  ? "true or false"
                                  : fmt::format("{} to {}", parameter.minimum, parameter.maximum);
    rows += fmt::format("| {} | {}{} | {} | {} |\n", names_of(parameter), range, is_rgb ? ", RGB" : "", value,
                        parameter.help);
  }
  return rows;
}

std::string property(std::string_view name, std::string_view reason) {
  return reason.empty() ? fmt::format("{}: yes.\n", name)
                        : fmt::format("{}: not always; {}.\n", name, reason);
}

std::string model_sections() {
  std::string text;
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    text += fmt::format("### `{}`: {}\n\n", model.keyword, model.title);
    if (!model.paper.empty()) text += fmt::format("{}. ", model.paper);
    if (model.takes == grf::ModelInfo::Takes::Parameters) {
      text += fmt::format("Formula: [{0}.glsl](reflectance/{0}.glsl).", model.keyword);
    } else if (model.takes == grf::ModelInfo::Takes::DataFile) {
      text += "Behind the keyword stands the name of its file of data.";
    } else {
      text += "Behind the keyword stand weights and names of defined BRDFs: `0.3 a, 0.7 b`.";
    }
    text += "\n\n";
    if (!model.parameters.empty()) text += parameter_rows(model) + "\n";
    text += property("Isotropic", model.not_isotropic);
    text += property("Reciprocal", model.not_reciprocal);
    text += property("Conserves energy where its parts sum to at most 1", model.not_conserving);
    if (!model.not_continuous.empty())
      text += property("The same within 1e-3 in float, in double and in GLSL", model.not_continuous);
    text += "\n";
  }
  return text;
}

TEST(Documents, OptionsAreThoseOfTheTable) { expect_generated("renderer/OPTIONS.md", option_rows()); }

TEST(Documents, ModelsAreThoseOfTheCatalogue) { expect_generated("renderer/MODELS.md", model_sections()); }

}  // namespace
