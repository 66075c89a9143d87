// Studies of BRDFs and sampling are what the study tools of the editor show, and `bpt` writes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grf/scene.h"
#include "renderer/plot/svg.h"
#include "renderer/studies/study_cache.h"
#include "renderer/studies/tool_state.h"

namespace studies {

/// A file that a study can be exported as, besides its figure.
struct DataFile {
  std::string extension;  ///< lower case, without the dot
  std::string title;      ///< of the format
  /// Writes the file; returns false after an error.
  std::function<bool(const std::string& path, grf::Diagnostics& diagnostics)> write;
};

/// The result of a study: a figure, and the data that it shows.
struct Study {
  plot::Svg figure;
  std::string summary;               ///< the result in a sentence
  std::string csv;                   ///< comma-separated values, with a header line; empty if there are none
  std::string fit;                   ///< text of a FIT file; empty if there is none
  std::vector<DataFile> files = {};  ///< other exports than CSV and FIT
  /// Describes what is at a point of the figure; empty text for nothing. May be null.
  std::function<std::string(const plot::Point& point)> describe = {};
};

/// What a study depends on besides its state.
struct StudyContext {
  plot::Paper paper = plot::Paper::White;
  std::function<bool()> is_stopped = {};  ///< polled; then the result does not matter
  /// Called with a study that is not done yet, a few times a second at most; null if only the result matters.
  std::function<void(const Study& study)> refined = {};
  std::shared_ptr<StudyCache> cache = {};  ///< of earlier studies; null: all is made anew
  /// Reads a scene or a model of any format; null: only GRF is read.
  std::function<std::optional<grf::Scene>(const std::string& path, grf::Diagnostics& diagnostics)>
      read_scene = {};
};

/// Reads a file that a study shows as its object; returns nothing after an error.
std::optional<grf::Scene> read_model(const ToolState::File& file, const StudyContext& context,
                                     grf::Diagnostics& diagnostics);

/// A row of the table of study tools. A window's form and the validation of states follow from it.
struct StudyTool {
  grf::ModelInfo settings;  ///< keyword, title, description, and settings as parameters
  ToolState initial;        ///< what a new window shows
  std::vector<grf::ModelInfo> distributions = {};  ///< that can be chosen; empty: none
  std::size_t brdfs = 0;                           ///< how many BRDFs it takes
  std::size_t pdfs = 0;                            ///< how many sampling schemes
  std::string files = {};  ///< extensions of the files that it opens, `fit hdr exr`; empty: none
  bool takes_many_files = false;
  /// Returns the file of a state that is read by `read_model`; null if there is none. Null: the tool opens no
  /// models besides `files`.
  const ToolState::File* (*model)(const ToolState& state) = nullptr;
  bool needs_file = false;        ///< without one there is nothing to show
  std::string_view azimuth = {};  ///< settings that dragging the figure changes, in degrees; empty: none
  std::string_view elevation = {};
  /// Turns the view of a state by so many degrees, where that is not a change of two settings; may be null.
  void (*turn)(ToolState& state, double azimuth, double elevation) = nullptr;
  /// Adapts the settings of a state to files that were just opened; may be null. Reports errors in them.
  void (*open)(ToolState& state, grf::Diagnostics& diagnostics) = nullptr;
  std::string_view animated = {};  ///< the setting that an animation goes through; empty: none

  /// Makes the study of a state that was checked; returns nothing after an error.
  std::optional<Study> (*make)(const ToolState& state, const StudyContext& context,
                               grf::Diagnostics& diagnostics) = nullptr;

  std::string_view name() const { return settings.keyword; }
};

/// Returns the table of all tools with a figure. A new tool is a new row here.
std::vector<StudyTool> study_tools();

/// Returns the tool of a name; nothing if there is none.
std::optional<StudyTool> study_tool(std::string_view name);

/// Adds files to a state, as the user opens them: a tool that takes one file shows the last one. Reports
/// errors in them.
void open_files(const StudyTool& tool, const std::vector<std::string>& paths, ToolState& state,
                grf::Diagnostics& diagnostics);

/// Checks a state against a tool: the values of its settings, and the number and values of its models.
bool check(const ToolState& state, const StudyTool& tool, grf::Diagnostics& diagnostics);

/// Returns the files that a study can be exported as besides its figure: CSV, FIT and others.
std::vector<DataFile> data_files_of(const Study& study);

/// Exports a study's data as the file's extension says; returns false after an error.
bool write_data(const Study& study, const std::string& path, grf::Diagnostics& diagnostics);

/// Checks a state against its tool, and makes its study; returns nothing after an error.
std::optional<Study> study_of(const ToolState& state, const StudyContext& context,
                              grf::Diagnostics& diagnostics);

}  // namespace studies
