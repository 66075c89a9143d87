// Fuzzes the reader of one format of measured BRDFs, FUZZED_FORMAT: any bytes give an error, or a BRDF with
// finite values.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>

#include "renderer/reflectance/measured.h"

namespace {

using Imath::V3d;
using reflectance::MeasuredData;
using reflectance::MeasuredFormat;
using reflectance::Rgb;
using reflectance::Vec3f;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

bool is_right(float value) { return std::isfinite(value) && value >= 0; }

void evaluate(const reflectance::Measured& brdf) {
  for (const V3d& u : {V3d(0, 0, 1), V3d(0.6, 0, 0.8), V3d(-0.48, -0.64, 0.6), V3d(0, 1, 1e-6)}) {
    for (const V3d& v : {V3d(0, 0, 1), V3d(-0.6, 0, 0.8), V3d(1, 0, 1e-6), V3d(0.48, -0.36, 0.8)}) {
      for (const bool interpolates : {true, false}) {
        const Rgb value = brdf.data->value(u, v, interpolates);
        expect(is_right(value.x) && is_right(value.y) && is_right(value.z), "a value is not finite");
      }
      brdf.data->state(u, v);
      expect(is_right(brdf.pdf(Vec3f(u), Vec3f(v))), "a pdf is not finite");
    }
    brdf.sample(Vec3f(u), {{0.3F, 0.9F}, 0.7F});
    expect(is_right(brdf.albedo_estimate(Vec3f(u))), "an albedo is not finite");
  }
}

const MeasuredFormat& fuzzed_format() {
  for (const MeasuredFormat& format : reflectance::measured_formats()) {
    if (format.name == FUZZED_FORMAT) return format;
  }
  std::abort();
}

/// Files of a fixed size are the input, again and again: mutations of megabytes would find little.
std::string fuzzed_bytes(const std::string& input) {
  constexpr std::size_t UtiaSize = 3 * 288 * 288 * sizeof(double);
  if (fuzzed_format().name != "UTIA" || input.empty()) return input;
  std::string bytes;
  while (bytes.size() < UtiaSize) bytes += input;
  bytes.resize(UtiaSize);
  return bytes;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = fuzzed_bytes({reinterpret_cast<const char*>(data), size});
  fuzzed_format().sniff(bytes);
  grf::Diagnostics diagnostics;
  const auto table = fuzzed_format().read(bytes, "fuzzed", {}, diagnostics);
  expect(table.has_value() != diagnostics.has_errors(),
         "an error without a message, or a message without an error");
  if (!table) return 0;
  reflectance::Measured brdf;
  brdf.data = std::make_shared<const MeasuredData>(*table);
  evaluate(brdf);
  return 0;
}
