#include "editor/rendering/noise_texts.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <array>
#include <utility>

namespace editor {
namespace {

class NoiseText {
  Q_DECLARE_TR_FUNCTIONS(editor::NoiseText)
};

/// The noise from which a part is worth a sentence.
constexpr double WorthSaying = 0.2;
constexpr qsizetype LongBrdf = 40;

QString percent(double fraction) { return NoiseText::tr("%1 %").arg(100 * fraction, 0, 'f', 0); }

QString factor(double value) { return QString::number(value, 'f', 2); }

QString option_name(const QString& key) {
  const std::array names = {std::pair("BPT_Branches", NoiseText::tr("Split count")),
                            std::pair("BPT_Pdf_Name", NoiseText::tr("Sampling scheme of all BRDFs")),
                            std::pair("BPT_Points", NoiseText::tr("Sampler")),
                            std::pair("BPT_RIS", NoiseText::tr("Resampling of the environment")),
                            std::pair("BPT_Adaptive", NoiseText::tr("Adaptive sampling"))};
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& name) { return key == name.first; });
  return found == names.end() ? key : found->second;
}

QString short_brdf(const QString& brdf) {
  return brdf.size() <= LongBrdf ? brdf : brdf.left(LongBrdf - 1) + QStringLiteral("…");
}

QString share_sentence(const std::vector<NoiseShareRow>& rows) {
  if (rows.size() < 2 || rows.front().noise < WorthSaying) return {};
  const NoiseShareRow& first = rows.front();
  return NoiseText::tr("%1: it makes %2 of the noise and %3 of the light.")
      .arg(name_of(first), percent(first.noise), percent(first.light));
}

}  // namespace

QString name_of(const NoiseShareRow& row) {
  using Kind = NoiseShareRow::Kind;
  switch (row.kind) {
    case Kind::AreaLight:
      return NoiseText::tr("Area light %1").arg(row.number + 1);
    case Kind::Mesh: {
      const QString name = row.name.section('\'', 1, 1);
      return name.isEmpty() ? NoiseText::tr("Emitting mesh %1").arg(row.number + 1)
                            : NoiseText::tr("Lamp \"%1\"").arg(name);
    }
    case Kind::Surroundings:
      return NoiseText::tr("Environment and background");
    case Kind::Bounces:
      return row.number == 0   ? NoiseText::tr("Light that the eye sees")
             : row.number == 1 ? NoiseText::tr("Direct light")
                               : NoiseText::tr("Light of %1 bounces").arg(row.number);
    case Kind::Brdf:
      return NoiseText::tr("%1, sampled by %2").arg(short_brdf(row.brdf), row.scheme);
    case Kind::SeenLight:
      break;
  }
  return NoiseText::tr("None: the eye sees the light");
}

QString name_of(const NoiseTrial& change) {
  if (change.option.isEmpty()) {
    return NoiseText::tr("Sampled by %1 instead of %2: %3")
        .arg(change.value, change.before, short_brdf(change.brdf));
  }
  return NoiseText::tr("%1: %2 instead of %3").arg(option_name(change.option), change.value, change.before);
}

QString sentence_of(const NoiseTrial& change) {
  if (!change.is_tried) return {};
  return NoiseText::tr(
             "%1: %2 of the variance in %3 of the time, so the same error in %4 of the time, with 95 % "
             "probability in %5 to %6.")
      .arg(name_of(change), factor(change.variance.value), factor(change.time.value),
           factor(change.cost.value), factor(change.cost.low), factor(change.cost.high));
}

QString verdict_of(const NoiseTrial& change) {
  if (!change.is_tried) return {};
  return change.pays           ? NoiseText::tr("pays")
         : change.cost.low > 1 ? NoiseText::tr("does not pay")
                               : NoiseText::tr("no clear difference");
}

QString advice_of(const NoiseResult& result) {
  QStringList sentences = {share_sentence(result.lamps), share_sentence(result.bounces),
                           share_sentence(result.brdfs)};
  const NoiseTrial* best = nullptr;
  bool is_any_tried = false;
  for (const NoiseTrial& change : result.changes) {
    is_any_tried |= change.is_tried;
    if (change.pays && (best == nullptr || change.cost.value < best->cost.value)) best = &change;
  }
  if (best != nullptr) sentences << sentence_of(*best);
  if (is_any_tried && best == nullptr) sentences << NoiseText::tr("No change that was tried pays.");
  sentences.removeAll(QString());
  return sentences.join('\n');
}

}  // namespace editor
