// Tests of the command line of `bpt brdf fit`.
#include <filesystem>
#include <sstream>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <gmock/gmock.h>

#include "tests/cli/bpt_brdf.h"

namespace {

using test::BptBrdf;
using testing::HasSubstr;

class BptBrdfFit : public BptBrdf {
 protected:
  std::string csv(const std::string& text) const { return folder_.add("data.csv", text); }

  /// Values of the BRDF kd/pi with kd = 0.6, 0.3 and 0.15.
  static std::string diffuse_csv() {
    std::string text = "theta_u,phi_u,theta_v,phi_v,r,g,b\n";
    for (const char* angles : {"0.1,0,0.3,1", "0.4,0,0.2,2", "0.7,0,0.9,0.5", "1,0,1.1,3"})
      text += std::string(angles) + ",0.190985932,0.095492966,0.047746483\n";
    return text;
  }
};

TEST_F(BptBrdfFit, FindsADiffuseColourInACsvFile) {
  const nlohmann::json result = json({"fit", csv(diffuse_csv()), "--to", "diffuse"});
  EXPECT_EQ(result["data"]["values"], 4);
  EXPECT_EQ(result["data"]["isotropic"], true);
  EXPECT_EQ(result["metric"], "cuberoot");
  ASSERT_EQ(result["fits"].size(), 1U);
  const nlohmann::json& fit = result["fits"][0];
  EXPECT_EQ(fit["model"], "diffuse");
  ASSERT_EQ(fit["parameters"].size(), 3U);
  const double expected[] = {0.6, 0.3, 0.15};
  for (std::size_t c = 0; c < 3; ++c) {
    const nlohmann::json& parameter = fit["parameters"][c];
    EXPECT_EQ(parameter["name"], "kd");
    EXPECT_EQ(parameter["channel"], c);
    EXPECT_EQ(parameter["term"], 1);
    EXPECT_NEAR(parameter["value"].get<double>(), expected[c], 1e-6);
    EXPECT_EQ(parameter["determined"], true);
    EXPECT_EQ(parameter["interval"].size(), 2U);
  }
  EXPECT_LT(fit["errors"]["l2"]["relative"].get<double>(), 1e-6);
}

TEST_F(BptBrdfFit, RanksModelsAndWritesTheBestOne) {
  const std::string best = folder_.path("best.brdf");
  const test::Outcome outcome =
      brdf({"fit", "blinn n=40 ks=0.5 kd=0.2", "--to", "oren,blinn,diffuse", "--samples", "800", "-o", best});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("warning: oren: the residuals are "));
  const std::string& text = outcome.out;
  const auto first = text.find("\nblinn ");
  ASSERT_NE(first, std::string::npos) << text;
  EXPECT_LT(first, text.find("\noren ")) << text;
  EXPECT_EQ(test::bytes_of(best).substr(0, 8), "blinn n=");
  const auto values = json({"eval", best, "--u", "0.5,0", "--v", "0.5,3.14159265"})["values"][0];
  EXPECT_NEAR(values[0].get<double>(), 0.5 + 0.2 / 3.14159265, 1e-4);
}

TEST_F(BptBrdfFit, WritesASumAsADefinition) {
  const std::string best = folder_.path("sum.grf");
  out({"fit", "blinn n=40 ks=0.5 kd=0.2", "--to", "combine diffuse blinn", "--samples", "800", "-o", best});
  const auto values = json({"eval", best + ":fit", "--u", "0.5,0", "--v", "0.5,3.14159265"})["values"][0];
  EXPECT_NEAR(values[0].get<double>(), 0.5 + 0.2 / 3.14159265, 1e-3);
}

TEST_F(BptBrdfFit, WritesAReport) {
  const std::string folder = folder_.path("report/new");
  out({"fit", csv(diffuse_csv()), "--to", "diffuse,minnaert", "--report", folder});
  const std::string markdown = test::bytes_of(folder + "/report.md");
  EXPECT_THAT(markdown, HasSubstr("# Fit of "));
  EXPECT_THAT(markdown, HasSubstr("| model | cuberoot (rank) | log (rank) | l2 (rank) | seconds |"));
  EXPECT_THAT(markdown, HasSubstr("\n    diffuse kd=("));
  EXPECT_THAT(markdown, HasSubstr("![Lobes and residuals of "));
  EXPECT_THAT(test::bytes_of(folder + "/report.html"), HasSubstr("<pre>diffuse kd=("));
  for (const char* name : {"/fit-1.svg", "/fit-2.svg"}) {
    std::istringstream stream(test::bytes_of(folder + name));
    boost::property_tree::ptree tree;
    EXPECT_NO_THROW(boost::property_tree::read_xml(stream, tree)) << name;
    EXPECT_EQ(tree.count("svg"), 1U);
  }
}

TEST_F(BptBrdfFit, SaysWhatIsWrong) {
  expect_failure({"fit", csv("theta_u,phi_u\n"), "--to", "ward"}, 1, "data.csv:1:1: error: ");
  expect_failure({"fit", csv(""), "--to", "ward"}, 1, "the file is empty");
  expect_failure({"fit", folder_.path("none.csv"), "--to", "ward"}, 1, "none.csv");
  expect_failure({"fit", "diffuse", "--to", "wardd"}, 1, "did you mean 'ward'?");
  expect_failure({"fit", "diffuse", "--to", "ward,,ggx"}, 2, "--to ward,,ggx: expected models");
  expect_failure({"fit", "diffuse", "--to", "ward", "--metric", "best"}, 2, "--metric");
  expect_failure({"fit", "diffuse", "--to", "ward", "--fix", "kx=1"}, 1,
                 "no model to fit has a parameter 'kx'");
  expect_failure({"fit", "diffuse", "--to", "ward", "--fix", "kd=7"}, 1, "kd");
  expect_failure({"fit", "specular", "--to", "ward"}, 1, "all values are 0");
  expect_failure({"fit", csv(diffuse_csv()), "--to", "diffuse", "-o", folder_.path("no/folder.brdf")}, 1,
                 "folder.brdf");
}

}  // namespace
