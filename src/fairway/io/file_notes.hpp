// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace fairway::io {

/// What a reader notes besides its result, for a caller that wants to know.
struct FileNotes {
  std::vector<std::string> files;      ///< that were read, as they were opened
  std::vector<std::string> warnings;   ///< about content that is accepted but suspicious
  std::vector<std::string> old_names;  ///< of settings, as "old (now new)"
};

}  // namespace fairway::io
