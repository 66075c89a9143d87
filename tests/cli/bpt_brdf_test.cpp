// Tests of the command line of `bpt brdf`.
#include "tests/cli/bpt_brdf.h"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <sstream>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <fmt/format.h>
#include <png.h>

namespace {

using test::BptBrdf;

TEST_F(BptBrdf, ListsAllModelsAsText) {
  const std::string text = out({"list"});
  EXPECT_NE(text.find("\nward           Ward. Ward 1992\n    Paint, plastic"), std::string::npos) << text;
  EXPECT_NE(text.find("\n    sy       0.0001 to 10, sx by default: RMS slope along y\n"), std::string::npos);
  EXPECT_NE(text.find("\n    not always isotropic: isotropic if sx = sy\n"), std::string::npos);
  EXPECT_NE(text.find("\n    energy: "), std::string::npos);
  EXPECT_NE(text.find("\n    not reciprocal: "), std::string::npos);
  EXPECT_NE(text.find("\n    example: ward sx=0.2 sy=0.2 ks=0.5 kd=0.5\n"), std::string::npos);
}

TEST_F(BptBrdf, ListsAllModelsAsJson) {
  const nlohmann::json models = json({"list"})["models"];
  EXPECT_GE(models.size(), 22U);
  for (const nlohmann::json& model : models) {
    for (const char* field : {"keyword", "title", "about"}) {
      EXPECT_FALSE(model[field].get<std::string>().empty()) << model;
    }
    for (const char* field : {"isotropic", "reciprocal", "conserves_energy"}) {
      EXPECT_TRUE(model[field].is_boolean()) << model;
    }
    EXPECT_EQ(model["conserves_energy"].get<bool>(), model["not_conserving"].get<std::string>().empty());
    for (const nlohmann::json& parameter : model["parameters"]) {
      for (const char* field : {"min", "max", "default"})
        EXPECT_TRUE(parameter[field].is_number()) << parameter;
      for (const char* field : {"name", "unit", "help"})
        EXPECT_TRUE(parameter[field].is_string()) << parameter;
    }
  }
  const auto named = [&](const char* keyword) {
    return *std::find_if(models.begin(), models.end(),
                         [&](const auto& model) { return model["keyword"] == keyword; });
  };
  EXPECT_EQ(named("ward")["parameters"][0]["default"], 0.2) << "and not the float's 0.200000003";
  EXPECT_EQ(named("ward")["isotropic"], false);
  EXPECT_EQ(named("strauss")["reciprocal"], false);
  EXPECT_EQ(named("minnaert")["conserves_energy"], false);
  EXPECT_EQ(named("oren")["parameters"][0]["unit"], "rad");
}

TEST_F(BptBrdf, DescribesTheKindsOfParametersAsJson) {
  for (const nlohmann::json& model : json({"list"})["models"]) {
    const nlohmann::json& parameters = model["parameters"];
    if (model["keyword"] == "ward") {
      EXPECT_EQ(parameters[0]["kind"], "number");
      EXPECT_EQ(parameters[0]["logarithmic"], true);
      EXPECT_EQ(parameters[1]["default_from"], "sx");
      EXPECT_EQ(parameters[2]["kind"], "reflectance");
    } else if (model["keyword"] == "schlick") {
      EXPECT_EQ(parameters[3]["name"], "Ly");
      EXPECT_EQ(parameters[3]["kind"], "boolean");
    }
  }
}

TEST_F(BptBrdf, PrintsTheShader) {
  const std::string text = out({"glsl", "diffuse kd=(0.1, 0.2, 0.3)"});
  EXPECT_NE(text.find("vec3 brdf_value(vec3 u, vec3 v)"), std::string::npos);
  EXPECT_NE(text.find("return bounded(kd / PI);"), std::string::npos) << text;
  const nlohmann::json shader = json({"glsl", "diffuse kd=(0.5, 0.25, 1)"});
  EXPECT_EQ(shader["text"], text) << "the same for all parameters";
  EXPECT_EQ(shader["parameters"], nlohmann::json::parse("[[0.5, 0.25, 1]]"));
  expect_failure({"glsl", "diffuse kd=2"}, 1, "kd");
}

TEST_F(BptBrdf, ChecksWhatIsPlausible) {
  const std::string text = out({"check", "diffuse kd=0.5"});
  EXPECT_EQ(text,
            "ok      reciprocity: |f(u,v) - f(v,u)| is 0 % of f on average\n"
            "ok      energy: at most 0.5 of the light is reflected, at 0 degrees\n"
            "ok      holes: 0 % of the pairs of directions have no value in the file\n"
            "ok      sign: 0 % of the pairs of directions have a negative channel in the file\n");
}

// As published, minnaert reflects more light than there is near grazing, and strauss is not reciprocal.
TEST_F(BptBrdf, ChecksWhatIsNotPlausible) {
  const nlohmann::json bright = json({"check", "minnaert k=0.5 kd=1"});
  EXPECT_EQ(bright["conserves_energy"], false);
  EXPECT_GT(bright["largest_albedo"], 1.01);
  EXPECT_EQ(bright["reciprocal"], true);
  const nlohmann::json found = json({"check", "strauss s=0.6 m=0 ks=1 kd=0"});
  EXPECT_EQ(found["conserves_energy"], true);
  EXPECT_EQ(found["reciprocal"], false);
  EXPECT_GT(found["mean_asymmetry"], 1e-3);
  EXPECT_NE(found["worst_pair"]["value"], found["worst_pair"]["swapped"]);
  const std::string text = out({"check", "strauss s=0.6 m=0 ks=1 kd=0"});
  EXPECT_TRUE(text.starts_with("warning reciprocity: ")) << text;
  EXPECT_NE(text.find("\n        most for u, v at (theta, phi) = ("), std::string::npos) << text;
}

TEST_F(BptBrdf, ReadsMeasuredDataByTheirFile) {
  const std::string path = GRANADA_SOURCE_DIR "/tests/reflectance/rgl/matte.bsdf";
  EXPECT_EQ(albedo(path, "0.5"), albedo("rgl \"" + path + "\"", "0.5"));
  EXPECT_LT(json({"check", path})["negative_fraction"], 1e-4);
  const std::string merl = folder_.path("half.binary");
  out({"export", "diffuse kd=0.5", "-o", merl});
  EXPECT_NEAR(albedo(merl, "0.3")[0], 0.5, 0.01);
  expect_failure({"eval", folder_.path("none.bsdf"), "--u", "0", "--v", "0"}, 1, "none.bsdf");
}

TEST_F(BptBrdf, DrawsWhereItIsNotPlausible) {
  const std::string path = folder_.path("check.svg");
  out({"check", "strauss", "-o", path});
  boost::property_tree::ptree svg;
  read_xml(path, svg);
  expect_failure({"check", "strauss", "-o", folder_.path("check.doc")}, 1, "check.doc");
  expect_failure({"check", "no-such-file.binary"}, 1, "no-such-file.binary");
}

TEST_F(BptBrdf, EvaluatesWavelengthsWhereDataHaveThem) {
  const std::string folder = GRANADA_SOURCE_DIR "/tests/reflectance/rgl/";
  const std::string copper = "rgl \"" + folder + "copper.bsdf\"";
  const std::string text = out({"eval", copper, "--u", "0.3", "--v", "0.4,3"});
  EXPECT_TRUE(text.starts_with("# R G B and 380 420 460 500 530 560 590 620 660 720 nm\n")) << text;
  const nlohmann::json values = json({"eval", copper, "--u", "0.3", "--v", "0.4,3"});
  EXPECT_EQ(values["wavelengths"].size(), 10U);
  EXPECT_EQ(values["spectra"][0].size(), 10U);
  EXPECT_GT(values["spectra"][0][9], values["spectra"][0][0]) << "copper is red";
  EXPECT_FALSE(
      json({"eval", "rgl \"" + folder + "matte.bsdf\"", "--u", "0.3", "--v", "0.4,3"}).contains("spectra"));
}

TEST_F(BptBrdf, EvaluatesTheWavelengthsThatAreAskedFor) {
  const std::string smooth = "westin ks=0 kd=(0.8, 0.4, 0.2) lambda=(650, 550, 450)";
  const auto values = json({"eval", smooth, "--u", "0.3", "--v", "0.4,3", "--wavelengths", "500,650"});
  EXPECT_EQ(values["wavelengths"], (std::vector<double>{500, 650}));
  EXPECT_NEAR(values["spectra"][0][0].get<double>() * std::numbers::pi, 0.3, 1e-6);
  EXPECT_NEAR(values["spectra"][0][1].get<double>() * std::numbers::pi, 0.8, 1e-6);
  EXPECT_EQ(json({"eval", smooth, "--u", "0.3", "--v", "0.4,3"})["wavelengths"],
            (std::vector<double>{450, 550, 650}));
  expect_failure({"eval", "ggx", "--u", "0", "--v", "0", "--wavelengths", "500"}, 2, "RGB alone");
  expect_failure({"eval", smooth, "--u", "0", "--v", "0", "--wavelengths", "0"}, 2, "--wavelengths");
}

TEST_F(BptBrdf, EvaluatesOnePair) {
  EXPECT_EQ(out({"eval", "diffuse kd=(1, 0.5, 0)", "--u", "0,0", "--v", "0.5,1"}),
            "0.31830987 0.15915494 0\n");
  const auto values = json({"eval", "diffuse kd=1", "--u", "0.3", "--v", "1.2,-4"})["values"];
  ASSERT_EQ(values.size(), 1U);
  EXPECT_NEAR(values[0][2].get<double>(), std::numbers::inv_pi, 1e-7);
  EXPECT_EQ(out({"eval", "diffuse", "--u", "2,0", "--v", "0,0"}), "0 0 0\n") << "under the horizon";
  const auto ward =
      json({"eval", "ward sx=0.1 sy=0.3 kd=0", "--u", "0.4,0", "--v", "0.3,3.14159265"})["values"];
  EXPECT_NEAR(ward[0][0].get<double>(), 1.1006815, 1e-5) << "by hand";
}

TEST_F(BptBrdf, EvaluatesABatchFromStandardInput) {
  EXPECT_EQ(out({"eval", "diffuse kd=1"}, "0 0 0 0\n\n0,0,2,0\r\n\t0.1, 0.2 0.3\t,0.4"),
            "0.31830987 0.31830987 0.31830987\n0 0 0\n0.31830987 0.31830987 0.31830987\n");
  EXPECT_EQ(json({"eval", "diffuse kd=0"}, "0 0 0 0\n1 1 1 1\n"),
            nlohmann::json::parse(R"({"values": [[0,0,0],[0,0,0]]})"));
  EXPECT_EQ(json({"eval", "diffuse"}, ""), nlohmann::json::parse(R"({"values": []})"));
  std::string pairs;
  for (int i = 0; i < 20000; ++i) pairs += fmt::format("{} 0 {} 1\n", i * 1e-4, i * 5e-5);
  EXPECT_EQ(json({"eval", "ward"}, pairs)["values"].size(), 20000U);
}

TEST_F(BptBrdf, NamesTheLineThatIsBad) {
  for (const char* bad : {"0 0 0", "0 0 0 0 0", "0 0 zero 0", "nan 0 0 0", "inf 0 0 0", "0 0 0 0x"}) {
    expect_failure(
        {"eval", "diffuse"}, 1,
        fmt::format("standard input:3: error: expected theta_u phi_u theta_v phi_v, in radians\n  {}\n", bad),
        fmt::format("0 0 0 0\n\n{}\n0 0 0 0\n", bad));
  }
}

TEST_F(BptBrdf, ReportsBadInstancesAtTheirPlace) {
  expect_failure({"eval", "wrad sx=0.1", "--u", "0", "--v", "0"}, 1,
                 "BRDF:1:1: error: unknown BRDF 'wrad': did you mean 'ward'?\n");
  expect_failure(
      {"albedo", "ward\n sx=20", "--u", "0"}, 1,
      "BRDF:2:2: error: 'sx' of 'ward': 20 is out of range, expected a number from 0.0001 to 10\n");
  expect_failure({"plot", "ward sx=", "-o", folder_.path("a.svg")}, 1, "BRDF:1:");
  expect_failure({"albedo", "lafortune n=1000 Cx=10", "--u", "0"}, 1, "the lobe's peak exceeds 1e30");
  expect_failure({"albedo", "", "--u", "0"}, 1, "error: ");
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(BptBrdf, TakesInstancesFromFiles) {
  const std::string file = folder_.add("paint.brdf", "// a comment\nminnaert k=1\n kd=0.25\n");
  EXPECT_NEAR(albedo(file, "0.5")[0], 0.25, 1e-3);
  const std::string bad = folder_.add("bad.brdf", "minnaert\n  q=1\n");
  expect_failure({"albedo", bad, "--u", "0"}, 1, bad + ":2:3: error: 'minnaert' has no parameter 'q'");
  expect_failure({"albedo", folder_.path("none.brdf"), "--u", "0"}, 1, "error: ");
}

TEST_F(BptBrdf, KnowsTheAlbedo) {
  for (const char* u : {"0", "1,2", "1.5"}) {
    EXPECT_NEAR(albedo("diffuse kd=0.7", u)[1], 0.7, 1e-3);
    EXPECT_NEAR(albedo("minnaert k=1 kd=(0.1, 0.2, 0.3)", u)[2], 0.3, 1e-3);
    EXPECT_NEAR(albedo("coupled Rm=1", u)[0], 1, 2e-3);
    EXPECT_NEAR(albedo("specular ks=0.4", u)[0], 0.4, 1e-6);
  }
  EXPECT_NEAR(albedo("minnaert k=0.8 kd=1", "0")[0], 2 / 1.8, 1e-3);
  EXPECT_NEAR(albedo("lewis n=1000000 ks=1 kd=0", fmt::format("{}", std::numbers::pi / 3))[0], 0.5, 1e-3);
  EXPECT_EQ(out({"albedo", "specular ks=(1, 0.5, 0.25)", "--u", "0.3,0"}), "1 0.5 0.25\n");
}

TEST_F(BptBrdf, SaysWhenTheCommandLineIsBad) {
  expect_failure({}, 2, "");
  expect_failure({"look"}, 2, "");
  expect_failure({"eval"}, 2, "INSTANCE");
  expect_failure({"albedo", "diffuse"}, 2, "--u");
  expect_failure({"plot", "diffuse"}, 2, "--output");
  expect_failure({"list", "more"}, 2, "");
  expect_failure({"eval", "diffuse", "--u", "0"}, 2, "--v");
  expect_failure({"eval", "diffuse", "--v", "0"}, 2, "--u");
  expect_failure({"eval", "diffuse", "--u", "0,0,0", "--v", "0"}, 2,
                 "error: --u: '0,0,0' is not a direction, expected theta,phi in radians\n");
  expect_failure({"albedo", "diffuse", "--u", "steep"}, 2, "'steep' is not a direction");
  EXPECT_EQ(brdf({"--help"}).exit_code, 0);
}

TEST_F(BptBrdf, PlotsSvg) {
  const std::string file = folder_.path("a<b&c.svg");
  const std::string instance = folder_.add("x<y&z.brdf", "coupled Rm=(0.9, 0.4, 0.2)");
  EXPECT_EQ(out({"plot", instance, "-o", file}), file + "\n");
  std::istringstream text(test::bytes_of(file));
  boost::property_tree::ptree document;
  ASSERT_NO_THROW(read_xml(text, document));
  std::vector<std::string> words;
  int images = 0;
  for (const auto& [name, element] : document.get_child("svg")) {
    if (name == "text") words.push_back(element.data());
    images += name == "image" ? 1 : 0;
  }
  EXPECT_EQ(images, 1);
  for (const std::string& expected :
       {instance, std::string("Albedo"), std::string("view 60\u00B0"), std::string("green")}) {
    EXPECT_NE(std::find(words.begin(), words.end(), expected), words.end()) << expected;
  }
  EXPECT_LT(std::filesystem::file_size(file), 100'000U);
}

TEST_F(BptBrdf, PlotsPng) {
  const std::string file = folder_.path("a.png");
  EXPECT_EQ(json({"plot", "minnaert k=0.5 kd=1", "-o", file})["file"], file);
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, file.c_str()), 0) << image.message;
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> pixels(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0) << image.message;
  EXPECT_GT(image.width, 1000U);
  EXPECT_EQ(pixels[0], 255) << "on white";
  EXPECT_LT(*std::min_element(pixels.begin(), pixels.end()), 50);
}

TEST_F(BptBrdf, PlotsFitFiles) {
  const std::string fit = folder_.path("a.fit");
  const std::string file = folder_.path("a.pdf");
  json({"sample", "ward sx=0.1", "--pdf", "auto", "--u", "0.6,0.2", "--count", "50", "--fit", fit});
  const nlohmann::json plotted = json({"plot", fit, "-o", file});
  EXPECT_EQ(plotted["file"], file);
  const auto summary = plotted["summary"].get<std::string>();
  EXPECT_TRUE(summary.starts_with("a.fit: 50 directions; all values agree with the BRDF")) << summary;
  EXPECT_TRUE(test::bytes_of(file).starts_with("%PDF-"));
  EXPECT_TRUE(test::bytes_of(file).find("%%EOF") != std::string::npos);
  expect_failure({"plot", folder_.path("gone.fit"), "-o", file}, 1, "gone.fit");
  folder_.add("cut.fit", "diffuse\nviewer (0.5, 0)\nbegin\n(0, 0");
  expect_failure({"plot", folder_.path("cut.fit"), "-o", file}, 1,
                 "cut.fit:4:6: error: found the end of the file");
}

TEST_F(BptBrdf, RefusesOtherPictures) {
  for (const char* name : {"a.gif", "a", "a.svg.txt"}) {
    expect_failure({"plot", "diffuse", "-o", folder_.path(name)}, 1,
                   "error: the picture's name must end in .svg, .png or .pdf");
  }
  const std::string nowhere = folder_.path("none/a.svg");
  expect_failure({"plot", "diffuse", "-o", nowhere}, 1, nowhere + ": error: ");
  EXPECT_TRUE(folder_.names().empty());
}

TEST_F(BptBrdf, ExportsATableThatIsReadAsMeasuredData) {
  const std::string table = folder_.path("blinn.binary");
  const std::string blinn = "blinn n=20 ks=(0.3, 0.2, 0.1) kd=0.3";
  const nlohmann::json result = json({"export", blinn, "-o", table});
  EXPECT_EQ(result["file"], table);
  EXPECT_LT(result["largest_interpolation_error"].get<double>(), 2e-4);
  EXPECT_EQ(std::filesystem::file_size(table), 34'992'012U);
  const std::string measured = "measured \"" + table + "\"";
  const std::string u = "0.5";
  EXPECT_NEAR(albedo(measured, u)[1], albedo(blinn, u)[1], 2e-3);
}

TEST_F(BptBrdf, ExportsOtherMeasuredFilesToMerlAndRgl) {
  const std::string zemax = GRANADA_SOURCE_DIR "/tests/reflectance/measured/zemax.bsdf";
  const std::string file = folder_.path("zemax.bsdf");
  const nlohmann::json result = json({"export", zemax, "-o", file, "--resolution", "1"});
  // Other than those of Zemax, data of ASTM are as reciprocal as the tables of MERL are.
  const std::string astm = GRANADA_SOURCE_DIR "/tests/reflectance/measured/degrees.astm";
  const std::string table = folder_.path("astm.binary");
  out({"export", astm, "-o", table});
  for (const char* u : {"0", "0.5", "1"}) {
    EXPECT_NEAR(albedo(file, u)[0], albedo(zemax, u)[0], 3 * result["relative_error"].get<double>()) << u;
    EXPECT_NEAR(albedo(table, u)[0], albedo(astm, u)[0], 1e-3) << u;
  }
  const std::string scattered = GRANADA_SOURCE_DIR "/tests/reflectance/measured/scattered.csv";
  expect_failure({"export", scattered, "-o", table}, 1,
                 "it is anisotropic, and the MERL format holds isotropic");
}

TEST_F(BptBrdf, ExportsAFileOfTheRglDataBase) {
  const std::string file = folder_.path("ward.bsdf");
  const std::string ward = "ward sx=0.2 sy=0.4 ks=0.4 kd=(0.3, 0.2, 0.1)";
  const nlohmann::json result = json({"export", ward, "-o", file, "--resolution", "0.5"});
  EXPECT_EQ(result["file"], file);
  EXPECT_LT(result["relative_error"].get<double>(), 0.1);
  EXPECT_LT(result["mean_interpolation_error"].get<double>(), result["largest_interpolation_error"]);
  ASSERT_EQ(result["albedos"].size(), 4U);
  const std::string measured = "rgl \"" + file + "\"";
  for (const nlohmann::json& pair : result["albedos"]) {
    const std::string u = std::to_string(pair["degrees"].get<double>() * std::numbers::pi / 180);
    EXPECT_NEAR(albedo(ward, u)[0], pair["albedo"][0], 1e-4);
    EXPECT_NEAR(albedo(measured, u)[0], pair["of_file"][0], 1e-4);
    EXPECT_NEAR(pair["albedo"][0].get<double>(), pair["of_file"][0], 0.05);
  }
}

TEST_F(BptBrdf, ExportsAsFineAsTheErrorNeeds) {
  const std::string file = folder_.path("a.bsdf");
  const auto exported = [&](const std::string& error) {
    return json({"export", "ggx alpha=0.4 ks=0.8", "-o", file, "--resolution", "auto", "--error", error});
  };
  const nlohmann::json coarse = exported("0.2");
  const nlohmann::json fine = exported("0.02");
  EXPECT_EQ(coarse["resolution"], 1);
  EXPECT_LE(fine["relative_error"].get<double>(), 0.02);
  std::filesystem::remove(file);
  expect_failure({"export", "ggx alpha=0.02", "-o", file, "--resolution", "auto", "--error", "0.00001"}, 1,
                 "--error 1e-05 is not reached");
  EXPECT_FALSE(std::filesystem::exists(file));
}

// pbrt reads spectra only, and Mitsuba's RGB variants read RGB only.
TEST_F(BptBrdf, ExportsForReaders) {
  const auto holds = [&](const std::vector<std::string>& more, const std::string& array) {
    std::vector<std::string> arguments = {
        "export", "diffuse kd=0.5", "-o", folder_.path("a.bsdf"), "--resolution", "0.25"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    json(arguments);
    return test::bytes_of(folder_.path("a.bsdf")).find(array) != std::string::npos;
  };
  EXPECT_TRUE(holds({"--for", "pbrt"}, "spectra"));
  EXPECT_TRUE(holds({"--for", "mitsuba-spectral"}, "spectra"));
  EXPECT_FALSE(holds({"--for", "mitsuba"}, "spectra"));
  EXPECT_FALSE(holds({}, "spectra"));
}

// Names of files are bytes, and JSON is text in UTF-8.
TEST_F(BptBrdf, ReplacesBytesOfFileNamesThatAreNotUtf8) {
  const std::string picture = folder_.path("a\xff.svg");
  const std::string file = json({"plot", "diffuse kd=0.5", "-o", picture})["file"];
  EXPECT_TRUE(file.ends_with("a\xef\xbf\xbd.svg")) << file;
  EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST_F(BptBrdf, RefusesToExportWhatTheFormatCannotHold) {
  const std::string table = folder_.path("a.binary");
  expect_failure({"export", "ward sx=0.1 sy=0.2", "-o", table}, 1, "it is anisotropic");
  expect_failure({"export", "specular", "-o", table}, 1, "its specular (delta) part has no finite value");
  EXPECT_TRUE(folder_.names().empty());
}

// A sum of diffuse BRDFs is the sum of their kd over pi; inner definitions hide outer ones.
TEST_F(BptBrdf, EvaluatesABrdfThatASceneDefines) {
  const std::string scene =
      folder_.add("scene.grf",
                  "def a = brdf diffuse kd=0.6 both = brdf combine 0.5 a, 0.25 a\n"
                  "begin\n"
                  "  def a = brdf diffuse kd=0.2 inner = brdf combine 0.5 a, 0.25 both\n"
                  "  begin\n"
                  "  end\n"
                  "end\n");
  const auto value = [&](const std::string& name) {
    return json({"eval", scene + ":" + name, "--u", "0.3,0", "--v", "0.5,2"})["values"][0][1].get<double>();
  };
  EXPECT_NEAR(value("a"), 0.6 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(value("both"), 0.75 * 0.6 / std::numbers::pi, 1e-6);
  EXPECT_NEAR(value("inner"), (0.5 * 0.2 + 0.25 * 0.75 * 0.6) / std::numbers::pi, 1e-6);
  expect_failure({"albedo", scene + ":none", "--u", "0.3"}, 1,
                 "error: " + scene + " defines no BRDF called 'none'");
}

}  // namespace
