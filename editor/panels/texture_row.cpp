#include "editor/panels/texture_row.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <variant>

#include "editor/appearance/icons.h"
#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/document/texture_coordinates.h"
#include "editor/panels/texture_preview.h"
#include "renderer/image/image_file.h"

namespace editor {
namespace {

/// Sets the texture of the selected faces, or removes it.
void edit_texture(Document& document, const AttributeEdit<grf::TextureAttribute>& texture,
                  const QString& key = {}) {
  SurfaceEdit edit;
  edit.texture = texture;
  document.edit_surfaces(texture.value() ? TextureRow::tr("Set texture") : TextureRow::tr("Remove texture"),
                         edit, key);
}

bool lack_texture_coordinates(const Document& document) {
  return !document.selection().empty() && document.objects().faces < FewFaces &&
         uv_bounds(document.objects(), document.selection()).isEmpty();
}

}  // namespace

void assign_texture(Document& document, const QString& path) {
  // The name is relative to the scene's own file, so that both can be moved together.
  const QString scene = document.path();
  const QString name = scene.isEmpty() || QFileInfo(path).isRelative()
                           ? path
                           : QFileInfo(scene).absoluteDir().relativeFilePath(path);
  grf::Texture texture;
  texture.file = name.toStdString();
  if (!scene.isEmpty()) texture.location = grf::whole_file(scene.toStdString());
  const QString key = QStringLiteral("texture");
  if (lack_texture_coordinates(document)) {
    const SelectedFaces faces = {document.scene(), document.objects(), document.selection()};
    document.replace(TextureRow::tr("Set texture"), with_projected_uvs(faces, suitable_projection(faces)),
                     key);
  }
  edit_texture(document, AttributeEdit<grf::TextureAttribute>::set(texture), key);
  document.finish_gesture();
}

TextureRow::TextureRow(Document& document, QWidget* parent)
    : SurfaceRow(document, parent),
      choice_(new QComboBox(this)),
      preview_(new TexturePreview(this)),
      hint_(problem_label(this)) {
  choice_->setEditable(true);
  choice_->setInsertPolicy(QComboBox::NoInsert);
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  choice_->setMinimumContentsLength(6);
  choice_->setAccessibleName(tr("Texture"));
  choice_->lineEdit()->setPlaceholderText(tr("none"));
  choice_->setFocusPolicy(Qt::StrongFocus);
  browse_ = tool_button(
      "browse", tr("Browse for an image"), tr("Browse for an image file"), [this] { browse(); }, this);
  reset_ = tool_button(
      "reset", tr("Remove the texture"), {},
      [this] { edit_texture(document_, AttributeEdit<grf::TextureAttribute>::remove()); }, this);
  field_ = choice_;
  auto* lines = tight_layout<QVBoxLayout>(this);
  auto* line = new QHBoxLayout;
  line->setSpacing(Grid / 4);
  line->addWidget(choice_, 1);
  line->addWidget(browse_);
  line->addWidget(reset_);
  lines->addLayout(line);
  lines->addWidget(preview_);
  lines->addWidget(hint_);
  connect(choice_, &QComboBox::activated, this, [this] { take_text(); });
  connect(choice_->lineEdit(), &QLineEdit::editingFinished, this, &TextureRow::take_text);
}

void TextureRow::show_summary(const SelectionSummary& summary) {
  const auto& common = summary.surface.texture;
  const QSignalBlocker blocker(choice_);
  names_ = summary.textures;
  choice_->clear();
  for (const QString& name : names_) choice_->addItem(icon("texture"), name);
  choice_->setCurrentIndex(-1);
  shown_.clear();
  if (common.is_mixed) {
    shown_ = mixed_text();
  } else if (common.value) {
    const auto* reference = std::get_if<grf::Reference>(&*common.value);
    shown_ = QString::fromStdString(reference != nullptr ? reference->name
                                                         : std::get<grf::Texture>(*common.value).file);
  }
  choice_->setEditText(shown_);
  const bool has_image = !common.is_mixed && common.value.has_value();
  const QString image = has_image ? first_texture(document_.objects(), document_.selection()) : QString();
  preview_->setVisible(!image.isEmpty());
  preview_->show_image(image);
  QVector<QPolygonF> outlines;
  if (has_image) outlines = uv_outlines(document_.objects(), document_.selection());
  show_or_hide(
      hint_,
      has_image && outlines.isEmpty()
          ? tr("The faces have no texture coordinates (UVs): all of them show the same point of the image.")
          : QString());
  preview_->show_outlines(std::move(outlines));
  const QString lit = why_not_reflecting(summary);
  enable(choice_, tr("Image texture that multiplies the colour: a texture of the scene, or a file name"),
         lit);
  browse_->setEnabled(lit.isEmpty());
  enable(reset_, tr("Remove the texture"),
         common.is_mixed || common.value ? QString() : tr("The faces have no texture."));
}

void TextureRow::take_text() {
  const QString text = choice_->currentText().trimmed();
  if (text == shown_) return;
  shown_ = text;
  if (text.isEmpty()) {
    edit_texture(document_, AttributeEdit<grf::TextureAttribute>::remove());
  } else if (names_.contains(text)) {
    edit_texture(document_,
                 AttributeEdit<grf::TextureAttribute>::set(grf::Reference{text.toStdString(), {}}));
  } else {
    assign_texture(document_, text);
  }
}

void TextureRow::browse() {
  auto* dialog = new QFileDialog(
      this, tr("Texture"), QFileInfo(document_.path()).absolutePath(),
      tr("Images (%1);;All files (*)").arg(QString::fromStdString(image::readable_name_patterns())));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& path) { assign_texture(document_, path); });
  dialog->open();
}

}  // namespace editor
