// Fuzz test of `grfconvert` with damaged files of all formats that it reads. Each gives a scene or an error,
// without crash, hang or excessive memory. Files that break it are kept in the folder `found_mutants` beside
// that of the programs.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "converters/format.h"
#include "grf/read.h"
#include "grf/write.h"
#include "tests/cli/grfconvert.h"
#include "tests/cli/mutation.h"
#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/thoroughness.h"

namespace {

namespace fs = std::filesystem;

constexpr std::size_t MutantsPerFormat = 20;
constexpr std::size_t MutantsOfALongRun = 320;
constexpr std::size_t LargestSeed = 200'000;
constexpr const char* MostSeconds = "10";
constexpr long MostMemory = 4L << 20;  // kilobytes

/// A valid file, and the files beside it that it names.
struct Seed {
  std::string path;
  std::vector<std::string> companions;
};

bool is_small_file(const fs::directory_entry& entry) {
  return entry.is_regular_file() && entry.file_size() > 0 && entry.file_size() <= LargestSeed;
}

std::vector<std::string> companions_of(const std::string& path, const std::string& bytes) {
  std::vector<std::string> companions;
  for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path())) {
    const std::string name = entry.path().filename().string();
    if (entry.path() != path && is_small_file(entry) && bytes.find(name) != std::string::npos) {
      companions.push_back(entry.path().string());
    }
  }
  std::sort(companions.begin(), companions.end());
  return companions;
}

/// Copies a file and its companions into a separate folder; returns the file's path. The one of this index is
/// damaged; the file itself comes after its companions.
std::string add_copy(const Seed& seed, const std::string& name, const test::TemporaryFolder& folder,
                     const std::function<std::string(std::size_t index, const std::string& bytes)>& damage) {
  for (std::size_t i = 0; i < seed.companions.size(); ++i) {
    const fs::path companion = seed.companions[i];
    folder.add(name + "/" + companion.filename().string(), damage(i, test::bytes_of(companion.string())));
  }
  const std::string extension = fs::path(seed.path).extension().string();
  return folder.add(name + "/" + name + extension, damage(seed.companions.size(), test::bytes_of(seed.path)));
}

/// A file is a seed if it converts with only its companions beside it: files that are refused anyway test no
/// damage.
bool is_sound(const Seed& seed, const convert::Format& format) {
  const test::TemporaryFolder folder;
  const auto keep_whole = [](std::size_t, const std::string& bytes) { return bytes; };
  grf::Diagnostics diagnostics;
  return format.read(add_copy(seed, "copy", folder, keep_whole), {}, diagnostics).has_value();
}

/// Writes files of each output format into the folder.
void write_seeds(const test::TemporaryFolder& folder) {
  grf::Diagnostics diagnostics;
  const auto import = convert::find_format("obj")->read(test::CubeWithMaterials, {}, diagnostics);
  ASSERT_TRUE(import.has_value()) << diagnostics.to_text();
  for (const convert::Format& format : convert::formats()) {
    if (format.write == nullptr) continue;
    const std::string path = folder.path(fmt::format("{}.{}", format.name, format.extensions.front()));
    EXPECT_TRUE(format.write(import->scene, path, diagnostics)) << diagnostics.to_text();
  }
}

std::vector<std::string> small_files(const test::TemporaryFolder& written) {
  const std::string sources = GRANADA_SOURCE_DIR;
  std::vector<std::string> paths;
  for (const std::string& folder :
       {std::string("/usr/share/assimp/models"), std::string("/usr/share/glmark2/models"), written.path(),
        sources + "/samples", sources + "/tests/grf/corpus/valid", sources + "/tests/fuzz/vrml_corpus"}) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (is_small_file(entry)) paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<Seed> find_seeds(const convert::Format& format, const test::TemporaryFolder& written) {
  std::vector<Seed> seeds;
  for (const std::string& path : small_files(written)) {
    grf::Diagnostics diagnostics;
    if (convert::recognise(path, diagnostics) != &format) continue;
    const Seed seed = {path, companions_of(path, test::bytes_of(path))};
    if (is_sound(seed, format)) seeds.push_back(seed);
  }
  return seeds;
}

/// Copies a seed into the folder, damaged or with a damaged companion.
std::string add_mutant(const Seed& seed, const std::string& name, const test::TemporaryFolder& folder,
                       std::mt19937& random) {
  const std::size_t count = seed.companions.size();
  const std::size_t damaged = count > 0 && random() % 4 == 0 ? random() % count : count;
  return add_copy(seed, name, folder, [&](std::size_t index, const std::string& bytes) {
    return index == damaged ? test::mutated(bytes, random) : bytes;
  });
}

/// The results of the mutants of one format.
struct Fates {
  std::vector<std::string> converted;  ///< the scenes that were made
  std::size_t refused = 0;
  std::vector<std::string> crashed;
  std::vector<std::string> late;
  std::vector<std::string> hungry;
};

/// Returns the last error of each mutant, by name: about the file, one beside it, or the output.
std::map<std::string, std::string> errors_of(const std::string& text, const test::TemporaryFolder& folder) {
  std::map<std::string, std::string> errors;
  std::istringstream lines(text);
  constexpr std::string_view Mark = ": error: ";
  for (std::string line; std::getline(lines, line);) {
    const std::size_t mark = line.find(Mark);
    if (mark == std::string::npos || !line.starts_with(folder.path() + "/")) continue;
    const std::string path = line.substr(folder.path().size() + 1, line.find(':') - folder.path().size() - 1);
    const std::string name =
        path.starts_with("out/") ? fs::path(path).stem().string() : path.substr(0, path.find('/'));
    errors[name] = line.substr(mark + Mark.size());
  }
  return errors;
}

void keep(const std::string& path) {
  const fs::path folder = fs::path(GRANADA_BIN_DIR).parent_path() / "found_mutants";
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  fs::copy(fs::path(path).parent_path(), folder / fs::path(path).stem(),
           fs::copy_options::recursive | fs::copy_options::overwrite_existing, ignored);
}

void add_failure(const std::string& path, const std::string& error, Fates& fates) {
  std::vector<std::string>* harmful = error.starts_with("the conversion crashed")      ? &fates.crashed
                                      : error.starts_with("exceeded the time limit")   ? &fates.late
                                      : error.starts_with("exceeded the memory limit") ? &fates.hungry
                                                                                       : nullptr;
  if (harmful == nullptr) {
    ++fates.refused;
  } else {
    harmful->push_back(path);
    keep(path);
  }
}

Fates convert_mutants(const std::vector<std::string>& paths, const test::TemporaryFolder& folder) {
  Fates fates;
  std::vector<std::string> arguments = {"-o",         folder.path("out"), "--jobs", "2",
                                        "--max-time", MostSeconds,        "--json"};
  arguments.insert(arguments.end(), paths.begin(), paths.end());
  const test::Outcome outcome = test::grfconvert(arguments);
  const auto report = nlohmann::json::parse(outcome.out, nullptr, false);
  EXPECT_FALSE(report.is_discarded()) << outcome.exit_code << outcome.err;
  if (report.is_discarded()) return fates;

  const std::set<std::string> all(paths.begin(), paths.end());
  std::set<std::string> told;
  for (const auto& conversion : report["conversions"]) {
    told.insert(conversion["input"].get<std::string>());
    fates.converted.push_back(conversion["output"].get<std::string>());
  }
  const auto errors = errors_of(outcome.err, folder);
  for (const std::string path : report["failed"]) {
    EXPECT_TRUE(told.insert(path).second) << path << " is converted and failed";
    const auto error = errors.find(fs::path(path).stem().string());
    const bool is_explained = error != errors.end();
    EXPECT_TRUE(is_explained) << path << " failed without an error";
    if (!is_explained) keep(path);
    if (is_explained) add_failure(path, error->second, fates);
  }
  EXPECT_EQ(told, all) << "each file is converted, or failed";
  EXPECT_EQ(outcome.exit_code, report["failed"].empty() ? 0 : 1);
  return fates;
}

/// Expects a valid scene from a damaged file: it can be read, is the same when written again, and passes the
/// check.
void expect_sound(const std::vector<std::string>& scenes) {
  for (const std::string& path : scenes) {
    grf::Diagnostics diagnostics;
    const auto scene = grf::read(path, diagnostics);
    EXPECT_TRUE(scene.has_value()) << path << '\n' << diagnostics.to_text();
    if (!scene) continue;
    const auto again = grf::read_text(grf::to_text(*scene), path, diagnostics);
    EXPECT_TRUE(again && *again == *scene) << path << '\n' << diagnostics.to_text();
  }
  if (scenes.empty()) return;
  std::vector<std::string> arguments = {"check", "--quiet"};
  arguments.insert(arguments.end(), scenes.begin(), scenes.end());
  const test::Outcome outcome = test::grfconvert(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

/// Formats that are read without Assimp.
bool is_read_by_us(const std::string& format) {
  static const std::set<std::string> names = {"grf", "obj", "ply", "gltf", "glb", "vrml", "off"};
  return names.contains(format);
}

class MutatedFiles : public testing::TestWithParam<std::string> {};

TEST_P(MutatedFiles, AreConvertedOrRefused) {
  test::crash_on_findings();
  const test::TemporaryFolder written;
  write_seeds(written);
  const std::vector<Seed> seeds = find_seeds(*convert::find_format(GetParam()), written);
  ASSERT_FALSE(seeds.empty());

  const test::TemporaryFolder folder;
  std::vector<std::string> paths;
  const std::size_t count = test::tries_all() ? MutantsOfALongRun : MutantsPerFormat;
  for (std::size_t i = 0; i < count; ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    paths.push_back(add_mutant(seeds[i % seeds.size()], fmt::format("{}_{}", GetParam(), i), folder, random));
  }
  const Fates fates = convert_mutants(paths, folder);
  fmt::print("{}: {} files, {} converted, {} refused, {} crashed, {} late, {} out of memory\n", GetParam(),
             paths.size(), fates.converted.size(), fates.refused, fates.crashed.size(), fates.late.size(),
             fates.hungry.size());
  if (is_read_by_us(GetParam())) {
    EXPECT_THAT(fates.crashed, testing::IsEmpty());
    EXPECT_THAT(fates.late, testing::IsEmpty());
    EXPECT_THAT(fates.hungry, testing::IsEmpty());
  }
  expect_sound(fates.converted);
  EXPECT_EQ(
      fates.converted.size() + fates.refused + fates.crashed.size() + fates.late.size() + fates.hungry.size(),
      paths.size());
  rusage used = {};
  ASSERT_EQ(::getrusage(RUSAGE_CHILDREN, &used), 0);
  if (test::LimitsMemory) {
    EXPECT_LT(used.ru_maxrss, MostMemory);
  }
}

class CutFiles : public testing::TestWithParam<std::string> {};

/// STL text does not declare its length.
bool has_counts(const std::string& format, const std::string& bytes) {
  return format != "stl" || bytes.find('\0') != std::string::npos;
}

// The file declares its length by a count or a size, so truncation is detected.
TEST_P(CutFiles, AreErrors) {
  const convert::Format& format = *convert::find_format(GetParam());
  const test::TemporaryFolder written;
  write_seeds(written);
  const test::TemporaryFolder folder;
  std::size_t cut = 0;
  for (const Seed& seed : find_seeds(format, written)) {
    const std::string bytes = test::bytes_of(seed.path);
    if (!has_counts(GetParam(), bytes)) continue;
    for (const std::size_t quarters : {1U, 2U, 3U}) {
      const std::string name = fmt::format("cut_{}", cut++);
      const std::string path = add_copy(seed, name, folder, [&](std::size_t index, const std::string& whole) {
        return index < seed.companions.size() ? whole : whole.substr(0, whole.size() * quarters / 4);
      });
      grf::Diagnostics diagnostics;
      EXPECT_FALSE(format.read(path, {}, diagnostics).has_value()) << seed.path << ' ' << quarters;
      EXPECT_TRUE(diagnostics.has_errors()) << seed.path << ' ' << quarters;
    }
  }
  EXPECT_GT(cut, 0U);
}

std::vector<std::string> formats_that_are_read() {
  std::vector<std::string> names;
  for (const convert::Format& format : convert::formats()) {
    if (format.read != nullptr) names.emplace_back(format.name);
  }
  return names;
}

std::string name_of(const testing::TestParamInfo<std::string>& info) { return "Of_" + info.param; }

INSTANTIATE_TEST_SUITE_P(OfFormat, CutFiles, testing::Values("ply", "off", "stl", "glb", "3ds", "lwo"),
                         name_of);
INSTANTIATE_TEST_SUITE_P(OfFormat, MutatedFiles, testing::ValuesIn(formats_that_are_read()), name_of);

}  // namespace
