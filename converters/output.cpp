#include "converters/output.h"

#include "converters/grf2008.h"
#include "grf/relocate.h"

namespace convert {

std::optional<WrittenFiles> write_output(grf::Scene& scene, std::span<const EmbeddedFile> embedded,
                                         const std::string& from, const OutputOptions& options,
                                         grf::Diagnostics& diagnostics) {
  auto files = write_embedded_files(embedded, options.path, diagnostics);
  if (!files) return std::nullopt;
  grf::relocate(scene, from, options.path, files->names);
  const auto old_grammar = options.grf2008 ? to_grf2008(scene, options.path, diagnostics) : std::nullopt;
  const bool is_ready = !options.grf2008 || old_grammar;
  const grf::Scene& written = old_grammar ? *old_grammar : scene;
  const Format& format = *options.format;
  const bool has_view = format.write_view != nullptr;
  const bool is_written =
      is_ready && (has_view ? format.write_view(written, options.path, options.writing, diagnostics)
                            : format.write(written, options.path, diagnostics));
  if (is_written && !format.embeds_images) return files;
  remove_created(*files);
  return is_written ? std::optional(WrittenFiles()) : std::nullopt;
}

}  // namespace convert
