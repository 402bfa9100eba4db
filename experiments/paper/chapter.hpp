// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/base/error.hpp"
#include "fairway/io/drawing/canvas.hpp"

namespace fairway::reproduction {

/// JSON whose objects keep the order in which their fields are written.
using Json = nlohmann::ordered_json;

/// A picture that is drawn once for each file format.
struct Figure {
  std::string name;     ///< of its files, without suffix
  std::string caption;  ///< what it shows, and how it was made
  std::function<Expected<std::string>(io::PictureFormat)> draw;
};

/// A table of text; the first column names the rows.
struct Table {
  std::string caption;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

/// A claim of the paper, and the result here.
struct Finding {
  std::string claim;
  std::string outcome;
  bool holds = false;
};

/// All results of one of the paper's cases.
struct Chapter {
  std::string id;     ///< case1, case2, case3
  std::string title;  ///< for the reader
  std::string setup;  ///< the experiment in a few sentences
  std::vector<Finding> findings;
  std::vector<Table> tables;
  std::vector<Figure> figures;
  Json numbers;                      ///< all numbers; equal for equal seeds
  std::vector<Table> timing_tables;  ///< measured times, which differ from run to run
  Json timing;                       ///< measured times for results.json
  std::vector<std::string> faults;   ///< contacts and broken bounds, which must never occur
};

}  // namespace fairway::reproduction
