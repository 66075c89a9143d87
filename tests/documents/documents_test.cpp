// Tests that the tables in documents are those of the code. To rewrite them after a change:
//   GRANADA_UPDATE_DOCUMENTS=1 build/release/bin/documents_test
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "grf/read.h"
#include "renderer/options/render_options.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/scheme.h"
#include "tests/support/generated_document.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"

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

std::string effect_rows() {
  std::string rows = "| effect | where it is switched off |\n|---|---|\n";
  for (const transport::EffectInfo& effect : transport::EffectInfos) {
    rows += fmt::format("| {} | {} |\n", effect.name, effect.without);
  }
  return rows;
}

/// Returns the anchor of a heading in links.
std::string anchor_of(std::string_view words) {
  std::string anchor;
  for (const char c : words) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-') {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return anchor;
}

std::string names_of(const grf::ParameterInfo& parameter) {
  std::string names(parameter.name);
  for (const std::string_view alias : parameter.aliases) names += fmt::format(" or {}", alias);
  return names;
}

std::string default_of(const grf::ParameterInfo& parameter) {
  if (!parameter.default_from.empty()) return fmt::format("that of {}", parameter.default_from);
  if (parameter.kind == grf::ParameterKind::Boolean) return parameter.default_value != 0 ? "true" : "false";
  if (parameter.kind == grf::ParameterKind::Word) {
    return std::string(parameter.choices.at(static_cast<std::size_t>(parameter.default_value)));
  }
  if (!parameter.default_rgb) return fmt::format("{}", parameter.default_value);
  const grf::Colour& rgb = *parameter.default_rgb;
  return fmt::format("({}, {}, {})", rgb.x, rgb.y, rgb.z);
}

std::string range_of(const grf::ParameterInfo& parameter) {
  if (parameter.kind == grf::ParameterKind::Boolean) return "true or false";
  if (parameter.kind == grf::ParameterKind::Word)
    return fmt::format("{}", fmt::join(parameter.choices, " or "));
  const bool is_rgb = parameter.kind == grf::ParameterKind::Reflectance;
  return fmt::format("{} to {}{}{}{}", parameter.minimum, parameter.maximum,
                     parameter.unit.empty() ? "" : " ", parameter.unit, is_rgb ? ", RGB" : "");
}

std::string parameter_rows(const grf::ModelInfo& model) {
  if (model.parameters.empty()) return "No parameters.\n";
  std::string rows = "| parameter | range | default | meaning |\n|---|---|---|---|\n";
  for (const grf::ParameterInfo& parameter : model.parameters) {
    rows += fmt::format("| {} | {} | {} | {} |\n", names_of(parameter), range_of(parameter),
                        default_of(parameter), parameter.help);
  }
  return rows;
}

std::string property(std::string_view name, std::string_view reason) {
  return reason.empty() ? fmt::format("- {}: yes.\n", name)
                        : fmt::format("- {}: not always; {}.\n", name, reason);
}

/// Returns cells with the directional albedo of an instance at 0, 45 and 80 degrees, specular part included.
std::string albedo_cells(const std::string& instance) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf(instance, "example", diagnostics);
  if (!model || !grf::check(*model, reflectance::brdf_infos(), "BRDF", diagnostics)) {
    ADD_FAILURE() << diagnostics.to_text();
    return " | |";
  }
  const reflectance::Reflector reflector(*reflectance::make_brdf(*model), reflectance::OwnScheme());
  std::string cells;
  for (const double degrees : {0, 45, 80}) {
    const double theta = degrees * std::numbers::pi / 180;
    const reflectance::Vec3f u(static_cast<float>(std::sin(theta)), 0, static_cast<float>(std::cos(theta)));
    const reflectance::Rgb albedo = reflectance::albedo(reflector, u);
    cells += albedo.x == albedo.y && albedo.y == albedo.z
                 ? fmt::format(" {:.3f} |", albedo.x)
                 : fmt::format(" {:.3f}, {:.3f}, {:.3f} |", albedo.x, albedo.y, albedo.z);
  }
  return cells;
}

std::string contents() {
  std::string text;
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    text += fmt::format("{}[{}](#{}-{})", text.empty() ? "" : ",\n", model.keyword, model.keyword,
                        anchor_of(model.title));
  }
  return text + ".\n\n";
}

std::string summary() {
  std::string text =
      "| model | isotropic | reciprocal | conserves energy | albedo of its example at 0 | 45 | 80 degrees "
      "|\n|---|---|---|---|---|---|---|\n";
  const auto answer = [](std::string_view reason) { return reason.empty() ? "yes" : "not always"; };
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    text += fmt::format("| {} | {} | {} | {} |{}\n", model.keyword, answer(model.not_isotropic),
                        answer(model.not_reciprocal), answer(model.not_conserving),
                        model.example.empty() ? " | | |" : albedo_cells(std::string(model.example)));
  }
  return text + "\n";
}

/// Returns the instances of table 5.5 of the thesis.
std::string thesis_instances() {
  std::string text =
      "The parameter sets of the thesis' sampling measurements (its table 5.5):\n\n| instance | albedo at 0 "
      "| 45 | 80 degrees |\n|---|---|---|---|\n";
  for (const char* instance :
       {"ashikhmin nu=25 nv=25 ks=0.39 kd=0.6",
        "beardmaxwell omega=1 tau=0 nreal=0.37 nimag=2.82 Rs=0.4 Rd=0.75 Rv=0.5", "blinn n=100 ks=1 kd=0.67",
        "coupled Rm=1 Ro=0.05", "he sigma=0.5 tau=3 lambda=800", "lafortune Cx=-1 Cy=-1 Cz=1 n=100 kp=0.96",
        "lewis n=100 ks=1 kd=0", "minnaert k=0.8 kd=1", "oren s=0 r=1", "phong n=100 ks=0.4 kd=0.6",
        "poulin d=2 h=0.01 n=100 ks=0.8 kd=0.2", "schlick SC=0.7 Sr=0.31 Sp=1 Ly=true DC=1 Dr=0 Dp=1",
        "schlick SC=0.7 Sr=0.31 Sp=1 Ly=false", "strauss s=0.76 m=0.91 ks=0.64 kd=0.5",
        "torrance m=0.35 nreal=0.617 nimag=2.63 ks=0.7 kd=0.3", "ward sx=0.2 sy=0.2 ks=0.5 kd=0.5"}) {
    text += fmt::format("| `{}` |{}\n", instance, albedo_cells(instance));
  }
  return text + "\n";
}

std::string picture_of(const grf::ModelInfo& model) {
  return fmt::format("![{0}](../samples/models/{0}.svg)\n", model.keyword);
}

std::string code_block(std::string_view text) {
  std::string block = "    ";
  for (const char c : text) {
    block += c;
    if (c == '\n') block += "    ";
  }
  return block + "\n\n";
}

std::string model_section(const grf::ModelInfo& model) {
  std::string text = fmt::format("### {}: {}\n\n", model.keyword, model.title);
  if (!model.description.empty()) text += fmt::format("{}\n\n", model.description);
  if (!model.example.empty()) text += picture_of(model) + "\n";
  if (!model.formula.empty()) text += code_block(model.formula);
  if (!model.parameters.empty()) text += parameter_rows(model) + "\n";
  text += property("Isotropic", model.not_isotropic);
  text += property("Reciprocal", model.not_reciprocal);
  text += property("Conserves energy if its parts sum to at most 1", model.not_conserving);
  if (!model.not_continuous.empty()) {
    text += property("Equal within 1e-3 in float, double and GLSL", model.not_continuous);
  }
  if (!model.paper.empty()) text += fmt::format("- Paper: {}.\n", model.paper);
  if (!grf::layer_names(model.keyword).empty()) {
    text += "- Code: [layers.cpp](reflectance/layers.cpp), [layers.h](reflectance/layers.h).\n";
  } else if (!model.formula.empty()) {
    text +=
        fmt::format("- Code: [{0}.glsl](reflectance/{0}.glsl), [{0}.h](reflectance/{0}.h).\n", model.keyword);
  }
  return text + "\n";
}

std::string models() {
  std::string text = contents() + summary() + thesis_instances();
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) text += model_section(model);
  return text;
}

/// Lists the BRDF models whose examples a scheme does not support, by reason.
std::string refusals_of(const grf::ModelInfo& scheme_info) {
  grf::Model named;
  named.keyword = scheme_info.keyword;
  const auto scheme = reflectance::make_scheme(named);
  std::vector<std::pair<std::string, std::vector<std::string>>> refused;
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    if (model.example.empty()) continue;
    grf::Diagnostics diagnostics;
    const auto brdf =
        reflectance::make_brdf(grf::read_brdf(std::string(model.example), "example", diagnostics).value());
    const std::string reason = reflectance::unsupported_reason(scheme.value(), brdf.value());
    if (reason.empty()) continue;
    auto known = std::find_if(refused.begin(), refused.end(),
                              [&](const auto& entry) { return entry.first == reason; });
    if (known == refused.end()) known = refused.insert(refused.end(), {reason, {}});
    known->second.emplace_back(model.keyword);
  }
  if (refused.empty()) return "- Supports all BRDFs.\n";
  std::string text;
  for (const auto& [reason, keywords] : refused) {
    text += fmt::format("- Does not support {}: {}.\n", fmt::join(keywords, ", "), reason);
  }
  return text;
}

std::string scheme_section(const grf::ModelInfo& info) {
  grf::Model named;
  named.keyword = info.keyword;
  std::string text = fmt::format("\n## {}: {}\n\n{}\n\n{}\n", info.keyword, info.title, info.description,
                                 parameter_rows(info));
  text += refusals_of(info);
  text += reflectance::is_incomplete(reflectance::make_scheme(named).value())
              ? "- Its pdf may be 0 where a BRDF reflects light: such BRDFs are sampled by a mixture with "
                "the cosine.\n"
              : "- Its pdf is above 0 wherever a BRDF reflects light.\n";
  if (!info.paper.empty()) text += fmt::format("- Paper: {}.\n", info.paper);
  return text;
}

std::string schemes() {
  std::string text;
  for (const grf::ModelInfo& info : reflectance::scheme_infos()) {
    text += fmt::format("{}[{}](#{}-{})", text.empty() ? "" : ",\n", info.keyword, anchor_of(info.keyword),
                        anchor_of(info.title));
  }
  text += ".\n";
  for (const grf::ModelInfo& info : reflectance::scheme_infos()) text += scheme_section(info);
  return text;
}

TEST(Documents, OptionsAreThoseOfTheTable) { expect_generated("renderer/OPTIONS.md", option_rows()); }

TEST(Documents, EffectsAreThoseOfTheTable) { expect_generated("renderer/EFFECTS.md", effect_rows()); }

TEST(Documents, ModelsAreThoseOfTheCatalogue) { expect_generated("renderer/MODELS.md", models()); }

TEST(Documents, SchemesAreThoseOfTheCatalogue) { expect_generated("renderer/SAMPLING.md", schemes()); }

TEST(Documents, EverySchemeIsExplained) {
  for (const grf::ModelInfo& info : reflectance::scheme_infos()) {
    EXPECT_FALSE(info.description.empty()) << info.keyword;
    for (const grf::ParameterInfo& parameter : info.parameters) {
      EXPECT_FALSE(parameter.help.empty()) << info.keyword << " " << parameter.name;
    }
  }
}

// MODELS.md shows these pictures because it is generated. scripts/plot_models makes them.
TEST(Documents, EveryModelIsExplainedAndHasItsPicture) {
  const std::string scene = test::bytes_of(GRANADA_SOURCE_DIR "/samples/models/models.grf");
  std::ptrdiff_t pictures = 0;
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    EXPECT_FALSE(model.description.empty()) << model.keyword;
    if (model.example.empty()) continue;
    EXPECT_TRUE(model.example.starts_with(model.keyword)) << model.example;
    EXPECT_FALSE(model.formula.empty()) << model.keyword;
    const std::string path = fmt::format("{}/samples/models/{}.svg", GRANADA_SOURCE_DIR, model.keyword);
    EXPECT_TRUE(std::filesystem::exists(path)) << "scripts/plot_models makes it: " << path;
    EXPECT_NE(test::bytes_of(path).find(fmt::format(">{}</text>", model.example)), std::string::npos)
        << path << " is not of the example: run scripts/plot_models";
    EXPECT_NE(scene.find(fmt::format("brdf {}", model.keyword)), std::string::npos)
        << "samples/models/models.grf has no sphere of " << model.keyword;
    ++pictures;
  }
  const std::filesystem::directory_iterator files(GRANADA_SOURCE_DIR "/samples/models");
  const auto is_plot = [](const auto& entry) { return entry.path().extension() == ".svg"; };
  EXPECT_EQ(std::count_if(begin(files), end(files), is_plot), pictures) << "one has no model";
}

}  // namespace
