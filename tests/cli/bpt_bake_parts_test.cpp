// Tests of bakes that several runs of `bpt bake` make in parts.
#include <algorithm>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/cli/bpt.h"

namespace {

using nlohmann::json;
using test::bytes_of;
using test::Outcome;
using testing::HasSubstr;

/// A floor of 7x7 vertices below a small lamp and beside a wall: their variances differ.
std::string room() {
  std::string vertices;
  std::string faces;
  constexpr int Side = 7;
  for (int i = 0; i < Side * Side; ++i)
    vertices += fmt::format("({},0,{})\n", i % Side - Side / 2, i / Side - Side / 2);
  for (int y = 0; y + 1 < Side; ++y) {
    for (int x = 0; x + 1 < Side; ++x) {
      const int corner = y * Side + x;
      faces += fmt::format("({},{},{},{})\n", corner, corner + Side, corner + Side + 1, corner + 1);
    }
  }
  return "begin mesh brdf diffuse kd=0.7 begin vertexs\n" + vertices + "end vertexs begin faces\n" + faces +
         "end faces end mesh\n"
         "begin mesh brdf diffuse kd=0.7 begin vertexs (-3,0,-3) (-3,0,3) (-3,4,3) (-3,4,-3) end vertexs\n"
         "begin faces (3,2,1,0) end faces end mesh\n"
         "light begin (-0.2,1,-0.2) (0.4,0,0) (0,0,0.4) rgb (30,20,10) end\n";
}

class BptBakeParts : public test::Bpt {
 protected:
  const std::string scene_ = write("scene.grf", room());

  Outcome bake(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"bake", scene_, "--samples", "200"});
    return bpt(arguments);
  }
  /// Bakes a part into a file that is named after it.
  std::string part(const std::string& name, std::vector<std::string> arguments) const {
    const std::string file = path(name + ".part");
    arguments.insert(arguments.end(), {"-o", file});
    const Outcome outcome = bake(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return file;
  }
  std::string merged(const std::string& name, std::vector<std::string> parts) const {
    parts.insert(parts.begin(), "merge");
    parts.insert(parts.end(), {"-o", path(name)});
    const Outcome outcome = bpt(parts);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return path(name);
  }
  std::string pilot() const {
    return merged("pilot.part", {part("p2", {"--part", "2/2"}), part("p1", {"--part", "1/2"})});
  }
};

// Any division, in any order and in two steps, gives the bytes of one process.
TEST_F(BptBakeParts, AreTheSceneOfOneProcess) {
  for (const std::vector<std::string>& options :
       {std::vector<std::string>(), std::vector<std::string>{"--directions", "4", "--seed", "7"}}) {
    const auto with = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), options.begin(), options.end());
      return arguments;
    };
    ASSERT_EQ(bake(with({"-o", path("whole.igrf")})).exit_code, 0);
    const std::string pilot = merged("pilot.part", {part("p2", with({"--part", "2/2"})),
                                                    part("p1", with({"--part", "1/2", "--threads", "1"}))});
    std::vector<std::string> rest;
    for (const char* number : {"3/3", "1/3", "2/3"})
      rest.push_back(part("q" + std::string(number, 1), with({"--part", number, "--pilot", pilot})));
    const std::string two = merged("two.part", {rest[0], rest[1]});
    EXPECT_EQ(bytes_of(merged("merged.igrf", {rest[2], two, rest[1]})), bytes_of(path("whole.igrf")));
  }
}

// Samples that are all of the pilot need no second round.
TEST_F(BptBakeParts, OfAFewSamplesAreDoneWithThePilot) {
  const auto bake_few = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"bake", scene_, "--samples", "33"});
    EXPECT_EQ(bpt(arguments).exit_code, 0);
  };
  bake_few({"-o", path("whole.igrf")});
  bake_few({"--part", "1/2", "-o", path("1.part")});
  bake_few({"--part", "2/2", "-o", path("2.part")});
  const Outcome outcome = bpt({"merge", path("1.part"), path("2.part"), "-o", path("merged.igrf"), "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(bytes_of(path("merged.igrf")), bytes_of(path("whole.igrf")));
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["samples"], 33);
  EXPECT_EQ(summary["vertices"], 53);
}

TEST_F(BptBakeParts, ThatLackArePrintedAsFlags) {
  const std::string first = part("1", {"--part", "1/3"});
  const Outcome of_pilot = bpt({"merge", first, "--missing"});
  EXPECT_EQ(of_pilot.exit_code, 1);
  EXPECT_EQ(of_pilot.out, "--part 2/3\n--part 3/3\n");
  const std::string rest = part("rest", {"--part", "2/4", "--pilot", pilot()});
  const Outcome missing = bpt({"merge", rest, "--missing", "--json"});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_EQ(json::parse(missing.out)["missing"], (json{"--part 1/4", "--part 3/4", "--part 4/4"}));
  const Outcome incomplete = bpt({"merge", rest, "-o", path("merged.igrf")});
  EXPECT_EQ(incomplete.exit_code, 1);
  EXPECT_THAT(incomplete.err, HasSubstr("merged.igrf: error: parts of the bake lack"));
  EXPECT_FALSE(std::filesystem::exists(path("merged.igrf")));
}

TEST_F(BptBakeParts, SayWhatIsWrong) {
  const std::string first = part("1", {"--part", "1/2"});
  const std::string other = part("other", {"--part", "2/2", "--seed", "5"});
  const Outcome options = bpt({"merge", first, other, "--missing"});
  EXPECT_EQ(options.exit_code, 1);
  EXPECT_THAT(options.err,
              HasSubstr("it is no part of the bake that '" + first + "' is of: it has other options"));
  const Outcome half = bake({"--part", "1/2", "--pilot", first, "-o", path("q.part")});
  EXPECT_EQ(half.exit_code, 1);
  EXPECT_THAT(half.err, HasSubstr("the pilot has not all vertices: merge all of its parts"));
  const Outcome of_other = bake({"--part", "1/2", "--pilot", other, "-o", path("q.part")});
  EXPECT_THAT(of_other.err, HasSubstr("it is no part of this bake"));

  std::string bytes = bytes_of(first);
  bytes[bytes.size() / 2] ^= 1;
  write("altered.part", bytes);
  EXPECT_THAT(bpt({"merge", path("altered.part"), "--missing"}).err, HasSubstr("it is damaged"));
  write("cut.part", bytes_of(first).substr(0, 300));
  EXPECT_THAT(bpt({"merge", path("cut.part"), "--missing"}).err, HasSubstr("it is damaged"));

  EXPECT_EQ(bake({"--part", "3/2", "-o", path("a.part")}).exit_code, 2);
  EXPECT_EQ(bake({"--part", "1/2", "-o", path("a.igrf")}).exit_code, 2);
  EXPECT_EQ(bake({"-o", path("a.part")}).exit_code, 2);
  EXPECT_THAT(bake({"--part", "1/2", "--target-error", "0.1", "-o", path("a.part")}).err,
              HasSubstr("a part of a bake has a number of samples and no target error"));
}

}  // namespace
