#include "editor/rendering/cost_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "editor/controls/text.h"
#include "grf/text_file.h"
#include "renderer/plot/svg.h"

namespace editor {
namespace {

class CostFileText {
  Q_DECLARE_TR_FUNCTIONS(editor::CostFile)
};

constexpr double PngScale = 2;

/// The file beside a study that has its base name, with another extension.
QString beside(const QString& study, const QString& extension) {
  const QFileInfo file(study);
  return file.dir().filePath(file.completeBaseName() + extension);
}

QString write(const std::string& bytes, const QString& path) {
  grf::Diagnostics diagnostics;
  return grf::replace_file(path.toStdString(), bytes, diagnostics) ? QString() : text_of(diagnostics);
}

QString save_study(const QString& study, const std::string& bytes, const QString& path) {
  QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(bytes)).object();
  QJsonObject reference = object["reference"].toObject();
  if (!reference["image"].isString()) return write(bytes, path);
  const QString copy = beside(path, "-reference.pfm");
  grf::Diagnostics diagnostics;
  const auto image = grf::read_file(
      QFileInfo(study).dir().filePath(reference["image"].toString()).toStdString(), diagnostics);
  if (!image) return text_of(diagnostics);
  if (QString problem = write(*image, copy); !problem.isEmpty()) return problem;
  reference["image"] = QFileInfo(copy).fileName();
  object["reference"] = reference;
  return write(QJsonDocument(object).toJson().toStdString(), path);
}

}  // namespace

std::optional<CostStudy> read_cost_file(const QString& path, QString& problem) {
  grf::Diagnostics diagnostics;
  const auto bytes = grf::read_file(path.toStdString(), diagnostics);
  auto study = bytes ? cost_study_of(QByteArray::fromStdString(*bytes)) : std::nullopt;
  if (!bytes) {
    problem = text_of(diagnostics);
  } else if (!study) {
    problem = CostFileText::tr("%1 is no study: choose the JSON file that bpt cost wrote").arg(path);
  }
  return study;
}

QString save_cost_file(const QString& study, const QString& path) {
  const QString extension = QFileInfo(path).suffix().toLower();
  const bool is_figure = extension == "png" || extension == "pdf" || extension == "svg";
  if (!is_figure && extension != "csv" && extension != "json") {
    return CostFileText::tr("%1: expected a name that ends with svg, png, pdf, csv or json").arg(path);
  }
  grf::Diagnostics diagnostics;
  const auto bytes =
      grf::read_file(beside(study, is_figure ? ".svg" : '.' + extension).toStdString(), diagnostics);
  if (!bytes) return text_of(diagnostics);
  if (extension == "json") return save_study(study, *bytes, path);
  if (extension != "png" && extension != "pdf") return write(*bytes, path);
  const auto figure = extension == "png" ? plot::to_png(*bytes, PngScale) : plot::to_pdf(*bytes);
  return figure ? write(*figure, path) : CostFileText::tr("cannot convert the figure");
}

}  // namespace editor
