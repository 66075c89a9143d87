#include "editor/document/brdf_mime.h"

#include "grf/read.h"
#include "grf/text_file.h"
#include "grf/write.h"

namespace editor {

grf::BrdfModel self_contained(grf::BrdfModel brdf) {
  brdf.instance_file.clear();
  if (!brdf.data_file.empty() && brdf.location.file) {
    brdf.data_file = grf::canonical_path(grf::path_beside(brdf.location.file->path, brdf.data_file));
  }
  return brdf;
}

std::unique_ptr<QMimeData> mime_of(const grf::BrdfModel& brdf, const QString& definition_name) {
  auto mime = std::make_unique<QMimeData>();
  const std::string text = grf::to_text(self_contained(brdf));
  mime->setData(BrdfMimeType, QByteArray::fromStdString(text));
  mime->setText(QString::fromStdString(text));
  if (!definition_name.isEmpty()) mime->setData(BrdfNameMimeType, definition_name.toUtf8());
  return mime;
}

std::optional<grf::BrdfModel> brdf_of(const QMimeData& mime, const std::vector<grf::ModelInfo>& models,
                                      grf::Diagnostics& diagnostics) {
  auto brdf = grf::read_brdf(mime.data(BrdfMimeType).toStdString(), "BRDF", diagnostics);
  if (!brdf) return std::nullopt;
  if (grf::find_model(models, brdf->keyword) == nullptr) {
    grf::report_unknown(*brdf, models, "BRDF", {}, diagnostics);
    return std::nullopt;
  }
  brdf->location = {};
  for (grf::Argument& argument : brdf->arguments) argument.location = {};
  return brdf;
}

}  // namespace editor
