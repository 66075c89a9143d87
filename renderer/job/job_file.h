// A job file has a render's options and its scene with all files that it reads.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "grf/diagnostics.h"
#include "renderer/options/op_text.h"

namespace job {

/// Returns whether an option names a file that a render reads.
bool names_input(const options::OptionInfo& option);

/// Packs an OP file, whose text this is and whose path need not exist, with the files that its scene reads.
/// The file is a tar archive, with the OP file first; equal contents make equal bytes. Absolute names in GRF
/// files become relative ones. Replaces the job file, or leaves it unchanged and reports why.
bool pack_job(const std::string& op_path, options::OpText op_text, const std::set<std::string>& files,
              const std::string& output, grf::Diagnostics& diagnostics);

/// Unpacks a job file into an empty folder, and returns the path of its OP file. An archive with names that
/// lead out of the folder, with anything but files, or that is damaged, is an error, and so are an OP file
/// and scenes that name files outside of the folder.
std::optional<std::string> unpack_job(const std::string& path, const std::string& folder,
                                      grf::Diagnostics& diagnostics);

/// Returns whether files, which exist, are in a folder or below it.
bool are_inside(const std::set<std::string>& files, const std::string& folder);

}  // namespace job
