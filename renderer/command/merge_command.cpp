#include "renderer/command/merge_command.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "grf/diagnostics.h"
#include "renderer/bake/part_file.h"
#include "renderer/command/bake_command.h"
#include "renderer/command/json_values.h"
#include "renderer/command/part_arguments.h"
#include "renderer/command/printed.h"
#include "renderer/command/render_output.h"
#include "renderer/command/render_progress.h"

namespace command {
namespace {

using grf::Diagnostics;
using grf::ExitCode;
using transport::PartMerge;

std::optional<PartMerge> merged(const std::vector<std::string>& paths, Diagnostics& diagnostics) {
  PartMerge merge;
  bool are_parts = true;
  for (const std::string& path : paths) {
    auto part = transport::read_part(path, diagnostics);
    are_parts = part && merge.add(std::move(*part), path, diagnostics) && are_parts;
  }
  return are_parts ? std::optional(std::move(merge)) : std::nullopt;
}

bool write_images(const PartMerge& merge, const MergeArguments& arguments, Diagnostics& diagnostics) {
  const transport::SamplePart& sum = merge.sum();
  const auto description =
      image_description_of(sum.description, static_cast<std::size_t>(sum.width) * sum.height);
  if (description)
    return write_merged(merge, {}, *description, arguments.outputs,
                        arguments.json ? SummaryStyle::Json : SummaryStyle::Text, diagnostics);
  diagnostics.error(grf::whole_file(arguments.parts.front()),
                    "the part with the first sample does not say what image it is of");
  return false;
}

bool write_sum(const PartMerge& merge, const MergeArguments& arguments, Diagnostics& diagnostics) {
  const std::string& output = arguments.outputs.front();
  if (output.ends_with(".part")) return transport::write_part(output, merge.sum(), diagnostics);
  if (merge.missing().empty()) return write_images(merge, arguments, diagnostics);
  diagnostics.error(
      grf::whole_file(output),
      "samples of the image lack: `bpt merge --missing` lists them; a name that ends in .part keeps "
      "those that there are");
  return false;
}

}  // namespace

bool write_merged(const PartMerge& merge, const transport::ErrorEstimate& bias,
                  const ImageDescription& description, const std::vector<std::string>& outputs,
                  SummaryStyle style, Diagnostics& diagnostics) {
  const transport::SamplePart& sum = merge.sum();
  if (sum.totals.rejected > 0) {
    diagnostics.warning(
        {}, fmt::format("{} in pixel ({}, {})", rejected_samples_text(sum.totals.rejected),
                        sum.totals.first_rejected % sum.width, sum.totals.first_rejected / sum.width));
  }
  const transport::Film film = merge.film();
  auto estimate = film.error_estimate();
  if (estimate) estimate = transport::with_bias(*estimate, bias);
  const image::ImageFile file = image_file_of(film, description, sum.totals.seconds, estimate);
  bool are_written = true;
  for (const std::string& output : outputs) are_written &= image::write_image(file, output, diagnostics);
  nlohmann::ordered_json summary = {{"output", outputs.front()},
                                    {"width", sum.width},
                                    {"height", sum.height},
                                    {"samples", double(sum.totals.paths) / sum.width / sum.height},
                                    {"render_seconds", sum.totals.seconds}};
  add_estimate(estimate, summary);
  if (style != SummaryStyle::Text) {
    fmt::print("{}\n", json_text(summary, style == SummaryStyle::JsonLine));
    return are_written;
  }
  fmt::print("{}: {}x{} pixels, {} per pixel, rendered in {} altogether\n", outputs.front(), sum.width,
             sum.height, samples_text(summary["samples"].get<double>()), duration_text(sum.totals.seconds));
  print_estimate(summary);
  return are_written;
}

ExitCode merge(const MergeArguments& arguments) {
  if (bake::is_part_file(arguments.parts.front())) return merge_bake(arguments);
  const bool has_part =
      std::ranges::any_of(arguments.outputs, [](const auto& o) { return o.ends_with(".part"); });
  if (arguments.outputs.empty() != arguments.lists_missing || (has_part && arguments.outputs.size() > 1)) {
    fmt::print(stderr, "error: give --missing, or the output: images, or one part file\n");
    return ExitCode::BadCommandLine;
  }
  Diagnostics diagnostics;
  bool is_done = true;
  for (const std::string& output : arguments.outputs) {
    is_done &= has_part || image::image_format_of(output, diagnostics) != nullptr;
    is_done &= can_write_file(output, has_part ? "part file" : "image", diagnostics);
  }
  const auto sum = is_done ? merged(arguments.parts, diagnostics) : std::nullopt;
  if (sum && arguments.lists_missing) {
    print(diagnostics);
    return print_missing(sum->missing(), arguments.json);
  }
  is_done = sum && write_sum(*sum, arguments, diagnostics);
  print(diagnostics);
  return is_done ? ExitCode::Done : ExitCode::BadInput;
}

}  // namespace command
