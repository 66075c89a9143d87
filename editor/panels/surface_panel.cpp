#include "editor/panels/surface_panel.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMimeData>
#include <QScrollArea>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <variant>

#include "editor/appearance/theme.h"
#include "editor/controls/counted.h"
#include "editor/controls/form_widgets.h"
#include "editor/document/brdf_mime.h"
#include "editor/document/scene_places.h"
#include "editor/panels/brdf_assignment.h"
#include "editor/panels/model_rows.h"
#include "editor/panels/opacity_row.h"
#include "editor/panels/texture_row.h"
#include "editor/panels/value_rows.h"

namespace editor {
namespace {

/// Replaces a named attribute by its value if the name does not mean that for all faces.
template <class Body>
void write_out(std::optional<std::variant<Body, grf::Reference>>& attribute,
               const std::vector<PlacedDefinition>& there, const std::vector<PlacedDefinition>& here) {
  const auto* reference = attribute ? std::get_if<grf::Reference>(&*attribute) : nullptr;
  if (reference == nullptr) return;
  const auto is_it = [reference](const PlacedDefinition& each) {
    return each.definition->name == reference->name;
  };
  const auto meant = std::ranges::find_if(there, is_it);
  if (meant == there.end()) return attribute.reset();
  const auto same = std::ranges::find_if(here, is_it);
  if (same != here.end() && same->definition == meant->definition) return;
  const auto* body = std::get_if<Body>(&meant->definition->body);
  attribute = body == nullptr ? std::nullopt : std::optional<std::variant<Body, grf::Reference>>(*body);
}

QString area_text(double area) { return SurfacePanel::tr("%1 m²").arg(QLocale::c().toString(area, 'g', 4)); }

}  // namespace

SurfacePanel::SurfacePanel(Document& document, const grf::Catalogue& catalogue, QWidget* parent)
    : QWidget(parent), document_(document), catalogue_(catalogue), pages_(new QStackedWidget(this)) {
  setAccessibleName(tr("Surface"));
  setAcceptDrops(true);
  auto* scroll = new QScrollArea(pages_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(make_rows());
  pages_->addWidget(hint_label(tr("No face is selected.\n\nClick a face in the view, drag a box around "
                                  "several, or select an object in the Scene dock."),
                               pages_));
  pages_->addWidget(scroll);
  tight_layout<QVBoxLayout>(this)->addWidget(pages_);
  connect(&document_, &Document::selection_changed, this, &SurfacePanel::show_selection);
  connect(&document_, &Document::changed, this, &SurfacePanel::show_selection);
  show_selection();
}

QWidget* SurfacePanel::make_header() {
  auto* header = new QWidget(this);
  count_ = new QLabel(header);
  QFont bold = count_->font();
  bold.setBold(true);
  count_->setFont(bold);
  area_ = new QLabel(header);
  area_->setToolTip(tr("World-space area of the selected faces, summed over all instances"));
  auto* layout = new QHBoxLayout(header);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(count_, 1);
  layout->addWidget(area_);
  layout->addWidget(tool_button(
      "pick", tr("Copy surface from a face"), tr("Copy surface from the face that you click in the view"),
      [this] {
        picks_ = Picks::All;
        emit pick_requested();
      },
      header));
  return header;
}

QWidget* SurfacePanel::make_rows() {
  auto* rows = new QWidget(this);
  auto* layout = new QGridLayout(rows);
  layout->setContentsMargins(2 * Grid, Grid, Grid, Grid);
  layout->setHorizontalSpacing(Grid);
  layout->setVerticalSpacing(Grid + Grid / 2);
  layout->setColumnStretch(1, 1);
  layout->addWidget(make_header(), 0, 0, 1, 2);
  const auto add = [this, rows, layout](const QString& name, auto* row) {
    auto* label = new QLabel(name, rows);
    label->setBuddy(row->field());
    label->setMinimumHeight(3 * Grid);
    const int line = layout->rowCount();
    layout->addWidget(label, line, 0, Qt::AlignTop);
    layout->addWidget(row, line, 1, Qt::AlignTop);
    rows_.push_back(row);
    return row;
  };
  auto* brdf = add(tr("&BRDF"), new BrdfRow(document_, catalogue_, rows));
  add(tr("Sam&pling"), new PdfRow(document_, catalogue_, rows));
  add(tr("C&olour"), new ColourRow(document_, rows));
  add(tr("Te&xture"), new TextureRow(document_, rows));
  add(tr("Opacit&y"), new OpacityRow(document_, rows));
  add(tr("E&mission"), new EmissionRow(document_, rows));
  add(tr("&Normals"), new NormalsRow(document_, rows));
  add(tr("Vertices"), new VertexRow(document_, VertexRow::Kind::Colour, rows));
  auto* irradiance = add(tr("Irr&adiance"), new VertexRow(document_, VertexRow::Kind::Irradiance, rows));
  problem_ = problem_label(rows);
  layout->addWidget(problem_, layout->rowCount(), 0, 1, 2);
  layout->setRowStretch(layout->rowCount(), 1);
  connect(brdf, &BrdfRow::edit_requested, this, &SurfacePanel::brdf_edit_requested);
  connect(brdf, &BrdfRow::pick_requested, this, [this] {
    picks_ = Picks::Brdf;
    emit pick_requested();
  });
  connect(irradiance, &VertexRow::bake_requested, this, &SurfacePanel::bake_requested);
  connect(brdf, &BrdfRow::problem_found, this, &SurfacePanel::report);
  return rows;
}

void SurfacePanel::show_selection() {
  const SelectionSummary summary = summary_of(document_);
  pages_->setCurrentIndex(summary.faces == 0 ? 0 : 1);
  report({});
  if (summary.faces == 0) return;
  count_->setText(counted(summary.faces, tr("1 face selected"), tr("%1 faces selected")));
  area_->setText(area_text(summary.area));
  for (SurfaceRow* row : rows_) row->show_summary(summary);
}

void SurfacePanel::report(const QString& problem) { show_or_hide(problem_, problem); }

void SurfacePanel::take_from(FaceId face) {
  const MeshObject& from = document_.objects().meshes[face.mesh];
  const auto there = definitions_at(document_.scene(), from.path);
  const auto here = common_definitions(document_.scene(), selected_meshes(document_));
  grf::Surface surface = from.mesh->surface(face.face);
  if (from.is_light) {
    surface = {};
    surface.emission = from.flat_surfaces[(*from.mesh->surface_of_face)[face.face]].colour;
  }
  write_out(surface.colour, there, here);
  write_out(surface.brdf, there, here);
  write_out(surface.pdf, there, here);
  write_out(surface.texture, there, here);
  const SurfaceEdit all = edit_to(surface);
  SurfaceEdit brdf;
  brdf.brdf = all.brdf;
  document_.edit_surfaces(picks_ == Picks::All ? tr("Copy surface from a face") : tr("Pick BRDF"),
                          picks_ == Picks::All ? all : brdf);
}

QSize SurfacePanel::sizeHint() const { return {360, 640}; }

void SurfacePanel::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(BrdfMimeType) && !document_.selection().empty())
    event->acceptProposedAction();
}

void SurfacePanel::dropEvent(QDropEvent* event) {
  grf::Diagnostics diagnostics;
  event->acceptProposedAction();
  if (assign_brdf(document_, catalogue_, *event->mimeData(), diagnostics)) return;
  report(QString::fromStdString(diagnostics.entries().front().message));
}

}  // namespace editor
