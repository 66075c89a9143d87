#include "editor/rendering/cost_run.h"

#include <utility>

#include "editor/rendering/render_report.h"

namespace editor {
namespace {

void add_list(QStringList& arguments, const QString& flag, const QString& list) {
  if (!list.isEmpty()) arguments << flag << list;
}

QStringList arguments_of(const CostSettings& settings, const QString& base, const QString& continued) {
  QStringList arguments;
  add_list(arguments, "--pdf", settings.schemes.join(','));
  add_list(arguments, "--integrator", settings.integrators.join(','));
  add_list(arguments, "--branches", settings.ways);
  add_list(arguments, "--samples", settings.samples);
  add_list(arguments, "--continue", continued);
  arguments << "--rounds" << QString::number(settings.rounds) << "--output" << base << "--progress"
            << "json";
  if (settings.crop) {
    arguments << "--crop";
    for (const int number : {settings.crop->x, settings.crop->y, settings.crop->width, settings.crop->height})
      arguments << QString::number(number);
  }
  return arguments;
}

}  // namespace

// Its times are to be those of a render, which has the priority of other programs of the editor.
CostRun::CostRun(QString program, QObject* parent)
    : QObject(parent), process_(std::move(program), nullptr, RendererProcess::DefaultNiceness) {
  connect(&process_, &SnapshotProcess::reported, this, &CostRun::read);
  connect(&process_, &SnapshotProcess::finished, this, [this] { emit ended({}); });
  connect(&process_, &SnapshotProcess::failed, this, &CostRun::ended);
}

void CostRun::start(const FinalRenderRequest& request, const CostSettings& settings,
                    const QString& continued) {
  if (is_running()) return;
  const QString base = process_.folder() + "/study";
  process_.start(request, "cost", arguments_of(settings, base, continued));
}

void CostRun::read(const QByteArray& line) {
  if (const auto study = cost_study_of(line)) {
    emit measured(*study);
  } else if (const auto report = render_report_of(line)) {
    emit progressed(report->done);
  }
}

}  // namespace editor
