#include "renderer/reflectance/measurements/measured_formats.h"

#include <algorithm>
#include <array>
#include <utility>

#include "renderer/reflectance/measurements/astm.h"
#include "renderer/reflectance/measurements/bsdf_interchange.h"
#include "renderer/reflectance/measurements/csv.h"
#include "renderer/reflectance/measurements/utia.h"

namespace reflectance {
namespace {

template <class Table>
std::optional<MeasuredTable> present(std::shared_ptr<const Table> table) {
  return table ? std::optional<MeasuredTable>(std::move(table)) : std::nullopt;
}

std::optional<MeasuredTable> scattered(std::optional<std::vector<Measurement>> list, const std::string& path,
                                       grf::Diagnostics& diagnostics) {
  if (!list) return std::nullopt;
  remove_faulty(*list, path, diagnostics);
  if (list->empty()) {
    diagnostics.error(grf::whole_file(path), "the file has no value that can be used");
    return std::nullopt;
  }
  return std::make_shared<const ScatteredTable>(*list);
}

using grf::Diagnostics;
using grf::SourceLocation;
using std::string;
using std::string_view;

constexpr std::array Formats = {
    MeasuredFormat{"MERL", "binary", MerlTable::sniff,
                   [](string_view bytes, const string& path, const SourceLocation& at, Diagnostics& out) {
                     return present(MerlTable::parse(bytes, path, out, at));
                   }},
    MeasuredFormat{"UTIA", "bin", sniff_utia,
                   [](string_view bytes, const string& path, const SourceLocation&, Diagnostics& out) {
                     return present(parse_utia(bytes, path, out));
                   }},
    MeasuredFormat{"Zemax", "bsdf", sniff_zemax,
                   [](string_view bytes, const string& path, const SourceLocation&, Diagnostics& out) {
                     return present(parse_zemax(bytes, path, out));
                   }},
    MeasuredFormat{"LightTools", "bsdf", sniff_lighttools,
                   [](string_view bytes, const string& path, const SourceLocation&, Diagnostics& out) {
                     return present(parse_lighttools(bytes, path, out));
                   }},
    MeasuredFormat{"ASTM E1392", "astm", sniff_astm,
                   [](string_view bytes, const string& path, const SourceLocation&, Diagnostics& out) {
                     return scattered(parse_astm(bytes, path, out), path, out);
                   }},
    MeasuredFormat{"CSV", "csv", sniff_csv,
                   [](string_view bytes, const string& path, const SourceLocation&, Diagnostics& out) {
                     return scattered(parse_csv(bytes, path, out), path, out);
                   }},
};

}  // namespace

std::span<const MeasuredFormat> measured_formats() { return Formats; }

const MeasuredFormat* find_measured_format(std::string_view bytes) {
  const auto* found = std::find_if(Formats.begin(), Formats.end(),
                                   [&](const MeasuredFormat& format) { return format.sniff(bytes); });
  return found == Formats.end() ? nullptr : found;
}

bool sniff_rgl(std::string_view bytes) { return bytes.starts_with("tensor_file"); }

}  // namespace reflectance
