#include "editor/rendering/noise_results.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace editor {
namespace {

QString text(const QJsonObject& object, const char* name) {
  return object.value(QLatin1String(name)).toString();
}

double value(const QJsonObject& object, const char* name) {
  return object.value(QLatin1String(name)).toDouble();
}

NoiseShareRow::Kind lamp_kind(const QJsonObject& lamp) {
  const QString kind = text(lamp, "kind");
  return kind == "area light" ? NoiseShareRow::Kind::AreaLight
         : kind == "mesh"     ? NoiseShareRow::Kind::Mesh
                              : NoiseShareRow::Kind::Surroundings;
}

NoiseShareRow::Kind bounce_kind(const QJsonObject&) { return NoiseShareRow::Kind::Bounces; }

NoiseShareRow::Kind brdf_kind(const QJsonObject& brdf) {
  return brdf.contains(QLatin1String("brdf")) ? NoiseShareRow::Kind::Brdf : NoiseShareRow::Kind::SeenLight;
}

template <class KindOf>
std::vector<NoiseShareRow> rows(const QJsonObject& object, const char* list, const KindOf& kind_of) {
  std::vector<NoiseShareRow> result;
  for (const auto& entry : object.value(QLatin1String(list)).toArray()) {
    const QJsonObject part = entry.toObject();
    const bool is_lamp = part.contains(QLatin1String("number"));
    result.push_back({kind_of(part), text(part, "name"), value(part, "noise"), value(part, "light"),
                      static_cast<int>(value(part, is_lamp ? "number" : "bounces")), text(part, "brdf"),
                      text(part, "scheme")});
  }
  return result;
}

NoiseTrial::Ratio ratio(const QJsonObject& object, const QString& name) {
  const QJsonArray interval = object.value(name + "_interval").toArray();
  return {object.value(name).toDouble(), interval.at(0).toDouble(), interval.at(1).toDouble()};
}

NoiseTrial trial(const QJsonObject& object) {
  NoiseTrial made;
  made.word = text(object, "change");
  made.option = text(object, "option");
  made.value = text(object, "value");
  made.before = text(object, "before");
  made.brdf = text(object, "brdf");
  made.is_tried = object.contains(QLatin1String("cost"));
  if (!made.is_tried) return made;
  made.pays = object.value(QLatin1String("pays")).toBool();
  made.variance = ratio(object, "variance");
  made.time = ratio(object, "time");
  made.cost = ratio(object, "cost");
  return made;
}

}  // namespace

std::optional<NoiseResult> noise_result_of(const QByteArray& line) {
  const QJsonObject object = QJsonDocument::fromJson(line).object();
  if (!object.contains(QLatin1String("lamps"))) return std::nullopt;
  NoiseResult result{value(object, "error"),
                     static_cast<int>(value(object, "samples")),
                     static_cast<int>(value(object, "width")),
                     static_cast<int>(value(object, "height")),
                     rows(object, "lamps", lamp_kind),
                     rows(object, "bounces", bounce_kind),
                     rows(object, "brdfs", brdf_kind),
                     {}};
  for (const auto& change : object.value(QLatin1String("changes")).toArray()) {
    result.changes.push_back(trial(change.toObject()));
  }
  return result;
}

std::optional<NoiseTrial> noise_trial_of(const QByteArray& line) {
  const QJsonObject object = QJsonDocument::fromJson(line).object();
  if (!object.value(QLatin1String("tried")).isObject()) return std::nullopt;
  return trial(object.value(QLatin1String("tried")).toObject());
}

}  // namespace editor
