// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/base/error.hpp"
#include "fairway/io/drawing/canvas.hpp"

namespace fairway::reproduction {

/// Objects keep the order in which their fields are written.
using Json = nlohmann::ordered_json;

/// A picture that is drawn once for every kind of file.
struct Figure {
  std::string name;     ///< of its files, without ending
  std::string caption;  ///< what is seen, and how it was made
  std::function<Expected<std::string>(io::PictureFormat)> draw;
};

/// A table of text; the first column names the rows.
struct Table {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// Something that the paper says, and what came out here.
struct Finding {
  std::string claim;
  std::string outcome;
  bool holds = false;
};

/// Everything that one of the paper's cases came to.
struct Chapter {
  std::string id;     ///< case1, case2, case3
  std::string title;  ///< for people
  std::string setup;  ///< what was done, in a few sentences
  std::vector<Finding> findings;
  std::vector<Table> tables;
  std::vector<Figure> figures;
  Json numbers;                      ///< every number; the same for the same seed
  std::vector<Table> timing_tables;  ///< measured times, which differ from run to run
  Json timing;                       ///< likewise
  std::vector<std::string> faults;   ///< contacts and broken bounds: what must never happen
};

}  // namespace fairway::reproduction
