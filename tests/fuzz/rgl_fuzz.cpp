// Fuzzes the reader of RGL's measured BRDFs: any bytes give an error, or a BRDF with finite values.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "renderer/reflectance/rgl_data.h"

namespace {

using Imath::V3d;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

bool is_right(double value) { return std::isfinite(value) && value >= 0; }

void evaluate(const reflectance::RglData& data) {
  for (const V3d& u : {V3d(0, 0, 1), V3d(0.6, 0, 0.8), V3d(-0.48, -0.64, 0.6), V3d(0, 1, 1e-6)}) {
    for (const V3d& v : {V3d(0, 0, 1), V3d(-0.6, 0, 0.8), V3d(1, 0, 1e-6), data.direction(u, {0.3, 0.9})}) {
      const V3d value = data.evaluate(u, v);
      expect(is_right(value.x) && is_right(value.y) && is_right(value.z), "a value is not finite");
      expect(is_right(data.pdf(u, v)), "a pdf is not finite");
      for (const double channel : data.spectrum(u, v)) expect(is_right(channel), "a spectrum is not finite");
    }
    expect(is_right(double(data.albedo(reflectance::Vec3f(u)))), "an albedo is not finite");
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string error;
  const auto file = reflectance::TensorFile::parse(
      std::make_shared<const std::string>(reinterpret_cast<const char*>(data), size), error);
  expect(file.has_value() == error.empty(), "an error without a message, or a message without an error");
  if (!file) return 0;
  auto tables = read_rgl_tables(*file, error);
  expect(tables.has_value() == error.empty(), "an error without a message, or a message without an error");
  if (tables) evaluate(reflectance::RglData(*std::move(tables)));
  return 0;
}
