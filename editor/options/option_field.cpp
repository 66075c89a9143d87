#include "editor/options/option_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QWheelEvent>
#include <limits>
#include <vector>

#include "editor/appearance/theme.h"
#include "editor/controls/form_widgets.h"
#include "editor/controls/number_box.h"
#include "editor/controls/text.h"
#include "editor/options/path_field.h"

namespace editor {
namespace {

using namespace options;

/// The words of an option that is not set.
QStringList default_words(const OptionInfo& option) {
  QStringList words;
  for (const std::string& word : option_words(RenderOptions(), option)) words << QString::fromStdString(word);
  return words;
}

/// A combo box that ignores the wheel, so that scrolling a form does not change it.
class QuietComboBox : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

struct NumberRange {
  double least;
  double largest;
  bool is_whole;
};

NumberBox* number_box(NumberRange range, const QString& default_text, QWidget* parent) {
  auto* box = new NumberBox(parent);
  box->set_range(range.least, range.largest);
  box->set_whole(range.is_whole);
  box->set_logarithmic(!range.is_whole && range.least >= 0);
  box->set_default(default_text);
  return box;
}

class NumbersField : public OptionField {
 public:
  NumbersField(const OptionInfo& option, NumberRange range, QWidget* parent)
      : OptionField(parent), defaults_(default_words(option)) {
    auto* row = tight_layout<QHBoxLayout>(this, Grid);
    // A default that is not numeric is shown under the boxes; one of several has no space for it.
    const QString in_words = word_count(option) > 1 ? OptionField::tr("auto") : text_of(option.default_value);
    for (std::size_t i = 0; i < word_count(option); ++i) {
      auto* number = number_box(range, defaults_.value(qsizetype(i), in_words), this);
      number->setAccessibleName(text_of(option.key) +
                                (word_count(option) > 1 ? " " + QString::number(i + 1) : ""));
      connect(number, &NumberBox::changing, this, [this] { emit edited(words()); });
      connect(number, &NumberBox::edited, this, &NumbersField::finish);
      connect(number, &NumberBox::cleared, this, &NumbersField::finish);
      numbers_.push_back(number);
      row->addWidget(number, 1);
    }
    setFocusProxy(numbers_.front());
  }

  void show_words(const std::optional<QStringList>& words) override {
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const auto at = qsizetype(i);
      numbers_[i]->set_text(words && at < words->size() ? (*words)[at] : QString());
    }
  }

 private:
  void finish() {
    emit edited(words());
    emit finished();
  }

  /// A missing number among others is the default, or 0.
  QStringList words() const {
    QStringList words;
    bool is_given = false;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const QString number = numbers_[i]->full_text();
      is_given |= !number.isEmpty();
      words << (number.isEmpty() ? defaults_.value(qsizetype(i), QStringLiteral("0")) : number);
    }
    return is_given ? words : QStringList();
  }

  QStringList defaults_;
  std::vector<NumberBox*> numbers_;
};

class BooleanField : public OptionField {
 public:
  BooleanField(const OptionInfo& option, QWidget* parent)
      : OptionField(parent),
        box_(new QCheckBox(OptionField::tr("On"), this)),
        default_(option.default_value == "true") {
    tight_layout<QHBoxLayout>(this)->addWidget(box_);
    box_->setAccessibleName(text_of(option.key));
    setFocusProxy(box_);
    connect(box_, &QCheckBox::clicked, this, [this](bool is_on) {
      emit edited({is_on ? QStringLiteral("true") : QStringLiteral("false")});
      emit finished();
    });
  }

  void show_words(const std::optional<QStringList>& words) override {
    const bool is_given = words && words->size() == 1;
    box_->setChecked(is_given ? words->front().compare("true", Qt::CaseInsensitive) == 0 : default_);
  }

 private:
  QCheckBox* box_;
  bool default_;
};

class WordField : public OptionField {
 public:
  WordField(const OptionInfo& option, const WordOption& value, QWidget* parent)
      : OptionField(parent), list_(new QuietComboBox(this)), default_(default_words(option).value(0)) {
    tight_layout<QHBoxLayout>(this)->addWidget(list_);
    list_->setAccessibleName(text_of(option.key));
    if (default_.isEmpty()) list_->addItem(text_of(option.default_value), QString());
    for (const std::string_view word : value.words) list_->addItem(text_of(word), text_of(word));
    setFocusProxy(list_);
    connect(list_, &QComboBox::activated, this, [this](int index) {
      const QString word = list_->itemData(index).toString();
      emit edited(word.isEmpty() ? QStringList() : QStringList(word));
      emit finished();
    });
  }

  void show_words(const std::optional<QStringList>& words) override {
    const QString word = words ? words->value(0) : default_;
    // An illegal word selects no entry.
    list_->setCurrentIndex(list_->findData(word, Qt::UserRole, Qt::MatchFixedString));
  }

 private:
  QComboBox* list_;
  QString default_;
};

class ListField : public OptionField {
 public:
  ListField(const OptionInfo& option, const ListOption& value, QWidget* parent)
      : OptionField(parent), option_(option), value_(value) {
    constexpr int Columns = 2;
    auto* grid = tight_layout<QGridLayout>(this);
    for (const std::string_view word : value.words) {
      auto* box = new QCheckBox(text_of(word), this);
      box->setAccessibleName(text_of(option.key) + " " + text_of(word));
      const int index = int(boxes_.size());
      grid->addWidget(box, index / Columns, index % Columns);
      boxes_.push_back(box);
      connect(box, &QCheckBox::clicked, this, [this] {
        emit edited(words());
        emit finished();
      });
    }
    setFocusProxy(boxes_.front());
  }

  void show_words(const std::optional<QStringList>& words) override {
    RenderOptions shown;
    std::vector<std::string> given;
    for (const QString& word : words.value_or(QStringList())) given.push_back(word.toStdString());
    if (words) set_option(shown, option_, given);
    const std::vector<std::string>& chosen = shown.*value_.field;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      boxes_[i]->setChecked(std::ranges::find(chosen, value_.words[i]) != chosen.end());
    }
  }

 private:
  QStringList words() const {
    QStringList chosen;
    for (const QCheckBox* box : boxes_) {
      if (box->isChecked()) chosen << box->text();
    }
    if (chosen.empty()) return {QStringLiteral("none")};
    return {chosen.size() == qsizetype(boxes_.size()) ? QStringLiteral("all") : chosen.join(',')};
  }

  const OptionInfo& option_;
  ListOption value_;
  std::vector<QCheckBox*> boxes_;
};

class TextField : public OptionField {
 public:
  TextField(const OptionInfo& option, QWidget* parent) : OptionField(parent), text_(new QLineEdit(this)) {
    tight_layout<QHBoxLayout>(this)->addWidget(text_);
    text_->setPlaceholderText(text_of(option.default_value));
    text_->setAccessibleName(text_of(option.key));
    setFocusProxy(text_);
    connect(text_, &QLineEdit::textEdited, this,
            [this](const QString& text) { emit edited(text.isEmpty() ? QStringList() : QStringList(text)); });
    connect(text_, &QLineEdit::editingFinished, this, &OptionField::finished);
  }

  void show_words(const std::optional<QStringList>& words) override {
    const QString text = words ? words->join(' ') : QString();
    if (text != text_->text()) text_->setText(text);
  }

 private:
  QLineEdit* text_;
};

/// The names of the cameras, which are edited in the Camera dock.
class CamerasField : public OptionField {
 public:
  CamerasField(const OptionInfo& option, QWidget* parent)
      : OptionField(parent), words_of_camera_(qsizetype(word_count(option))), names_(new QLineEdit(this)) {
    tight_layout<QHBoxLayout>(this)->addWidget(names_);
    names_->setReadOnly(true);
    names_->setPlaceholderText(text_of(option.default_value));
    names_->setAccessibleName(text_of(option.key));
    setFocusProxy(names_);
  }

  void show_words(const std::optional<QStringList>& words) override {
    QStringList names;
    for (qsizetype i = 0; words && i < words->size(); i += words_of_camera_) names << (*words)[i];
    names_->setText(names.join(", "));
  }

 private:
  qsizetype words_of_camera_;
  QLineEdit* names_;
};

/// Creates the field for each kind of value.
struct FieldMaker {
  const OptionInfo& option;
  QWidget* parent;

  static constexpr double Largest = std::numeric_limits<float>::max();

  OptionField* operator()(const PathOption& value) const { return new PathField(option, value, parent); }
  OptionField* operator()(const AddressOption&) const { return new TextField(option, parent); }
  OptionField* operator()(const NameOption&) const { return new TextField(option, parent); }
  OptionField* operator()(const CamerasOption&) const { return new CamerasField(option, parent); }
  OptionField* operator()(const SizeOption&) const { return numbers({1, 65535, true}); }
  OptionField* operator()(const VectorOption& value) const {
    return numbers({value.minimum, Largest, false});
  }
  OptionField* operator()(const PointOption&) const { return numbers({-Largest, Largest, false}); }
  OptionField* operator()(const WordOption& value) const { return new WordField(option, value, parent); }
  OptionField* operator()(const ListOption& value) const { return new ListField(option, value, parent); }
  template <class Number, class Field>
  OptionField* operator()(const NumberOption<Number, Field>& value) const {
    return numbers({double(value.minimum), double(value.maximum), std::is_integral_v<Number>});
  }
  template <class Field>
  OptionField* operator()(const BooleanOption<Field>&) const {
    return new BooleanField(option, parent);
  }
  template <class Field>
  OptionField* operator()(const PairOption<Field>& value) const {
    return numbers({double(value.minimum), double(value.maximum), true});
  }

  OptionField* numbers(NumberRange range) const { return new NumbersField(option, range, parent); }
};

QString range_text(double least, double largest, bool is_open) {
  if (largest >= std::numeric_limits<int>::max()) {
    return (is_open ? QObject::tr("above %1") : QObject::tr("%1 or more")).arg(least);
  }
  return (is_open ? QObject::tr("between %1 and %2") : QObject::tr("%1 to %2"))
      .arg(least)
      .arg(largest, 0, 'g', 10);
}

/// Describes the legal values of each kind.
struct LegalValues {
  QString operator()(const PathOption& value) const {
    if (value.extensions.empty()) return QObject::tr("path");
    QStringList endings;
    for (const std::string_view extension : value.extensions) endings << text_of(extension);
    return (value.is_stem ? QObject::tr("path without .%1") : QObject::tr("path: %1"))
        .arg(endings.join(", "));
  }
  QString operator()(const AddressOption&) const { return QObject::tr("HOST:PORT, or none"); }
  QString operator()(const NameOption&) const { return QObject::tr("a name, or none"); }
  QString operator()(const CamerasOption&) const { return QObject::tr("see the Camera dock"); }
  QString operator()(const SizeOption&) const { return QObject::tr("two whole numbers, 1 to 65535"); }
  QString operator()(const VectorOption& value) const {
    return value.minimum == 0 ? QObject::tr("three numbers, 0 or more") : QObject::tr("three numbers");
  }
  QString operator()(const PointOption&) const { return QObject::tr("three numbers"); }
  QString operator()(const WordOption&) const { return QObject::tr("one of the list"); }
  QString operator()(const ListOption&) const { return QObject::tr("any of these"); }
  template <class Number, class Field>
  QString operator()(const NumberOption<Number, Field>& value) const {
    return range_text(double(value.minimum), double(value.maximum), value.open);
  }
  template <class Field>
  QString operator()(const BooleanOption<Field>&) const {
    return QObject::tr("true or false");
  }
  template <class Field>
  QString operator()(const PairOption<Field>& value) const {
    const QString range = range_text(value.minimum, value.maximum, false);
    return value.descending ? QObject::tr("two whole numbers, %1, the second at most the first").arg(range)
                            : QObject::tr("two whole numbers, %1").arg(range);
  }
};

}  // namespace

OptionField* make_option_field(const OptionInfo& option, QWidget* parent) {
  return std::visit(FieldMaker{option, parent}, option.value);
}

QString legal_values(const OptionInfo& option) { return std::visit(LegalValues(), option.value); }

}  // namespace editor
