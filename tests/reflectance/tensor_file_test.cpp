// Tensor files: reading, messages, and damaged files.
#include "renderer/reflectance/tensor_file.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/reflectance/rgl_data.h"
#include "tests/reflectance/rgl_cases.h"
#include "tests/support/temporary_folder.h"

namespace {

using Imath::V3d;
using reflectance::ElementType;
using reflectance::RglData;
using reflectance::TensorFile;
using testing::HasSubstr;

/// A field of a file that is being made; numbers are as in the file.
struct Field {
  std::string name;
  std::uint8_t type = 10;
  std::vector<std::uint64_t> shape;
  std::string bytes = {};
  std::optional<std::uint64_t> offset = {};  ///< if not where the bytes are
};

template <class Number>
std::string bytes_of(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof(number)};
}

std::string file_of(const std::vector<Field>& fields) {
  std::string head =
      std::string("tensor_file\0\1\0", 14) + bytes_of(static_cast<std::uint32_t>(fields.size()));
  std::size_t end = head.size();
  for (const Field& field : fields) end += 13 + field.name.size() + 8 * field.shape.size();
  std::string data;
  for (const Field& field : fields) {
    head += bytes_of(static_cast<std::uint16_t>(field.name.size())) + field.name +
            bytes_of(static_cast<std::uint16_t>(field.shape.size())) + bytes_of(field.type) +
            bytes_of(field.offset.value_or(end + data.size()));
    for (const std::uint64_t extent : field.shape) head += bytes_of(extent);
    data += field.bytes;
  }
  return head + data;
}

std::string floats(std::size_t count, float value = 1) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += bytes_of(value);
  return bytes;
}

/// Returns the error for those bytes; empty if they are read.
std::string error_of(const std::string& bytes) {
  std::string error;
  const auto file = TensorFile::parse(std::make_shared<const std::string>(bytes), error);
  EXPECT_EQ(file.has_value(), error.empty());
  return error;
}

TEST(TensorFile, HasItsArrays) {
  std::string error;
  const std::string bytes =
      file_of({{"a", 10, {2, 3}, floats(6, 7)}, {"empty", 11, {0, 5}}, {"b", 1, {3}, "xyz"}});
  const auto file = TensorFile::parse(std::make_shared<const std::string>(bytes), error);
  ASSERT_TRUE(file) << error;
  ASSERT_NE(file->find("a"), nullptr);
  EXPECT_EQ(file->find("a")->shape, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(file->find("a")->floats(), std::vector<float>(6, 7.0F));
  EXPECT_EQ(file->find("b")->bytes, "xyz");
  EXPECT_EQ(file->find("b")->type, ElementType::UInt8);
  EXPECT_TRUE(file->find("b")->floats().empty());
  EXPECT_EQ(file->find("empty")->count(), 0U);
  EXPECT_EQ(file->find("c"), nullptr);
}

TEST(TensorFile, SaysWhatIsWrong) {
  const std::uint64_t huge = std::uint64_t(1) << 62U;
  EXPECT_EQ(error_of("no tensor file"), "it does not start with 'tensor_file'");
  EXPECT_EQ(error_of(std::string("tensor_file\0\1\0\7", 15)), "it ends within its header");
  EXPECT_EQ(error_of(std::string("tensor_file\0\2\1\0\0\0\0", 18)), "its version is 2.1, expected 1.0");
  EXPECT_EQ(error_of(std::string("tensor_file\0\1\0\0\0\0\1", 18)), "it has 16777216 arrays");
  EXPECT_EQ(error_of(std::string("tensor_file\0\1\0\1\0\0\0", 18)), "it ends within its table of arrays");
  EXPECT_EQ(error_of(file_of({{"a\n", 12, {1}, "x"}})), "its array 'a?' has the unknown element type 12");
  EXPECT_EQ(error_of(file_of({{"a", 0, {1}, "x"}})), "its array 'a' has the unknown element type 0");
  EXPECT_EQ(error_of(file_of({{"a", 1, std::vector<std::uint64_t>(17, 1), "x"}})),
            "its array 'a' has 17 dimensions");
  EXPECT_EQ(error_of(file_of({{"a", 1, {1}, "x"}, {"a", 1, {1}, "x"}})), "it has two arrays 'a'");
  for (const Field& field :
       {Field{"a", 10, {2}, "1234567"}, Field{"a", 1, {huge, 4}, "x"}, Field{"a", 10, {huge}, "x"},
        Field{"a", 1, {huge, huge, huge}, "x"}, Field{"a", 1, {1}, "x", 1'000'000},
        Field{"a", 1, {1}, "x", ~0ULL}, Field{"a", 1, {2}, "x", ~0ULL - 1}}) {
    EXPECT_EQ(error_of(file_of({field})), "its array 'a' is not within the file");
  }
}

TEST(TensorFile, IsNamedInMessages) {
  grf::Diagnostics diagnostics;
  const test::TemporaryFolder folder;
  EXPECT_FALSE(TensorFile::load(folder.add("a.bsdf", "none"), diagnostics));
  EXPECT_THAT(diagnostics.entries().at(0).message,
              HasSubstr("a.bsdf' is not an RGL BRDF file: it does not start with 'tensor_file'"));
  EXPECT_FALSE(TensorFile::load("/no/such/file", diagnostics));
  EXPECT_FALSE(TensorFile::load("/dev/zero", diagnostics));
  EXPECT_FALSE(TensorFile::load(folder.path(), diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 4U);
}

TEST(TensorFile, HasALimit) {
  const test::TemporaryFolder folder;
  const std::string path = folder.add("a.bsdf", "");
  std::filesystem::resize_file(path, TensorFile::MostBytes + 1);  // a sparse file
  grf::Diagnostics diagnostics;
  EXPECT_FALSE(TensorFile::load(path, diagnostics));
  EXPECT_THAT(diagnostics.entries().at(0).message,
              HasSubstr("it has 1073741825 bytes, and at most 1073741824 are read"));
}

/// The fields of a small valid file.
std::vector<Field> small_file() {
  const std::string views = bytes_of(0.0F) + bytes_of(1.0F);
  return {{"phi_i", 10, {1}, bytes_of(0.0F)},       {"theta_i", 10, {2}, views},
          {"ndf", 10, {2, 2}, floats(4)},           {"sigma", 10, {2, 2}, floats(4)},
          {"vndf", 10, {1, 2, 2, 3}, floats(12)},   {"luminance", 10, {1, 2, 2, 2}, floats(8)},
          {"rgb", 10, {1, 2, 3, 2, 2}, floats(24)}, {"jacobian", 1, {1}, "\1"},
          {"description", 1, {4}, "text"}};
}

/// Returns the error for the small file with a change to one of its fields.
std::string error_of_changed(const std::string& name, const std::function<void(Field&)>& change) {
  std::vector<Field> fields = small_file();
  for (Field& field : fields) {
    if (field.name == name) change(field);
  }
  std::string error;
  const auto bytes = std::make_shared<const std::string>(file_of(fields));
  const auto file = TensorFile::parse(bytes, error);
  EXPECT_TRUE(file) << error;
  const bool is_read = read_rgl_tables(*file, error).has_value();
  EXPECT_EQ(is_read, error.empty());
  return error;
}

TEST(RglTables, SayWhatIsWrong) {
  EXPECT_EQ(error_of_changed("", {}), "");
  for (const Field& field : small_file()) {
    if (field.name == "rgb") continue;
    EXPECT_EQ(error_of_changed(field.name, [](Field& one) { one.name = "other"; }),
              "it has no array '" + field.name + "'");
    EXPECT_THAT(error_of_changed(field.name,
                                 [](Field& one) {
                                   one.type = 2;
                                   one.shape = {1};
                                 }),
                HasSubstr("the elements of its array '" + field.name + "' are not "));
    EXPECT_THAT(error_of_changed(field.name, [](Field& one) { one.shape.insert(one.shape.begin(), 6, 1); }),
                HasSubstr("its array '" + field.name + "' has "));
  }
  EXPECT_EQ(error_of_changed("rgb", [](Field& one) { one.name = "other"; }),
            "it has neither an array 'spectra' nor 'rgb'");
  EXPECT_EQ(error_of_changed("rgb", [](Field& one) { one.name = "spectra"; }),
            "it has no array 'wavelengths'");
  EXPECT_EQ(error_of_changed("rgb", [](Field& one) { one.shape[2] = 2; }),
            "its array 'rgb' has the shape 1 x 2 x 2 x 2 x 2, which does not fit the other arrays");
  EXPECT_EQ(error_of_changed("vndf",
                             [](Field& one) {
                               one.shape = {1, 2, 1, 3};
                             }),
            "its array 'vndf' has 1 x 3 nodes");
  EXPECT_EQ(error_of_changed("ndf",
                             [](Field& one) {
                               one.shape = {0, 2};
                             }),
            "its array 'ndf' has 0 x 2 nodes");
  EXPECT_EQ(error_of_changed("jacobian", [](Field& one) { one.shape = {0}; }),
            "its array 'jacobian' is not one number");
  for (const std::string& wrong :
       {bytes_of(1.0F) + bytes_of(1.0F), bytes_of(1.0F) + bytes_of(0.5F),
        bytes_of(0.0F) + bytes_of(std::nanf("")), bytes_of(0.0F) + bytes_of(INFINITY)}) {
    EXPECT_EQ(error_of_changed("theta_i", [&](Field& one) { one.bytes = wrong; }),
              "its array 'theta_i' is not an ascending list of numbers");
  }
  EXPECT_EQ(error_of_changed("theta_i", [](Field& one) { one.bytes = bytes_of(0.0F) + bytes_of(45.0F); }),
            "its array 'theta_i' has values outside 0 to 1.572");
  const auto of_azimuths = [](float last) {
    std::vector<Field> fields = small_file();
    fields[0] = {"phi_i", 10, {3}, bytes_of(0.0F) + bytes_of(0.5F) + bytes_of(last)};
    fields[4].bytes = floats(36);
    fields[5].bytes = floats(24);
    fields[6].bytes = floats(72);
    for (const std::size_t i : {4U, 5U, 6U}) fields[i].shape[0] = 3;
    std::string error;
    const auto bytes = std::make_shared<const std::string>(file_of(fields));
    (void)read_rgl_tables(*TensorFile::parse(bytes, error), error);
    return error;
  };
  EXPECT_EQ(of_azimuths(2.0F), "its azimuths 'phi_i' cover neither a full, a half nor a quarter turn");
  for (const double turn : {M_PI / 2, M_PI, 2 * M_PI}) EXPECT_EQ(of_azimuths(static_cast<float>(turn)), "");
}

// Without the flag, the colours are the BRDF times the cosine.
TEST(RglTables, AreDividedByTheDistributionOnlyIfTheFileSaysSo) {
  const V3d u(0, 0, 1);
  const V3d v = V3d(0.6, 0, 0.8);
  for (const bool is_divided : {false, true}) {
    std::vector<Field> fields = small_file();
    fields[2].bytes = floats(4, 5);
    fields[3].bytes = floats(4, 0.5);
    fields[7].bytes = is_divided ? "\1" : std::string(1, '\0');
    std::string error;
    const auto bytes = std::make_shared<const std::string>(file_of(fields));
    auto tables = read_rgl_tables(*TensorFile::parse(bytes, error), error);
    ASSERT_TRUE(tables) << error;
    EXPECT_NEAR(RglData(*std::move(tables)).evaluate(u, v).y, (is_divided ? 2.5 : 1) / 0.8, 1e-6);
  }
}

void expect_finite(const RglData& data) {
  for (const V3d& u : {V3d(0, 0, 1), V3d(0.6, 0, 0.8), V3d(-0.48, -0.64, 0.6), V3d(0, 1, 1e-4)}) {
    for (const V3d& v : {V3d(0, 0, 1), V3d(-0.6, 0, 0.8), V3d(1, 0, 1e-5), data.direction(u, {0.3, 0.9})}) {
      const V3d value = data.evaluate(u, v);
      const double pdf = data.pdf(u, v);
      ASSERT_TRUE(value.x >= 0 && value.y >= 0 && value.z >= 0 && std::isfinite(value.length())) << value;
      ASSERT_TRUE(pdf >= 0 && std::isfinite(pdf)) << pdf;
      for (const double channel : data.spectrum(u, v)) ASSERT_TRUE(channel >= 0 && std::isfinite(channel));
    }
    ASSERT_TRUE(std::isfinite(data.albedo(reflectance::Vec3f(u))));
  }
}

/// Reads bytes, which must give an error or finite values; returns whether they were read.
bool is_read(const std::string& bytes) {
  std::string error;
  const auto file = TensorFile::parse(std::make_shared<const std::string>(bytes), error);
  auto tables = file ? read_rgl_tables(*file, error) : std::nullopt;
  EXPECT_EQ(tables.has_value(), error.empty());
  if (!tables) return false;
  expect_finite(RglData(*std::move(tables)));
  return true;
}

TEST(DamagedRglFiles, AreRefusedIfTruncated) {
  const std::string bytes = file_of(small_file());
  ASSERT_TRUE(is_read(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(is_read(bytes.substr(0, size))) << size;
  const std::string copper = test::bytes_of(test::rgl_path("copper"));
  for (std::size_t size = 0; size < copper.size(); size += size < 700 ? 1 : 997)
    EXPECT_FALSE(is_read(copper.substr(0, size))) << size;
}

TEST(DamagedRglFiles, GiveAnErrorOrFiniteValues) {
  const std::string bytes = file_of(small_file());
  std::mt19937 random(9);
  int read = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = bytes;
    for (unsigned int k = 0; k <= random() % 3; ++k) {
      damaged[random() % damaged.size()] = static_cast<char>(random());
    }
    read += is_read(damaged) ? 1 : 0;
  }
  EXPECT_GT(read, 100);
  EXPECT_LT(read, 2900);
}

TEST(DamagedRglFiles, MayHaveAnyNumbersInTheirTables) {
  constexpr float Infinity = std::numeric_limits<float>::infinity();
  for (const float value : {0.0F, -1.0F, 1e-45F, 3e38F, Infinity, -Infinity, std::nanf("")}) {
    for (std::size_t changed = 2; changed < 7; ++changed) {
      std::vector<Field> fields = small_file();
      fields[changed].bytes = floats(fields[changed].bytes.size() / 4, value);
      EXPECT_TRUE(is_read(file_of(fields)));
      fields[changed] = small_file()[changed];
      fields[changed].bytes.replace(4, 4, floats(1, value));
      EXPECT_TRUE(is_read(file_of(fields)));
    }
  }
}

}  // namespace
