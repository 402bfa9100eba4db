// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/cell_boxes.hpp"

namespace fairway {

std::vector<CellWindow> cover_with_boxes(const BitGrid& obstacles) {
  BitGrid left = obstacles;  // blocked cells that no box covers yet
  const GridFrame& frame = obstacles.frame();
  std::vector<CellWindow> boxes;
  for (int y = 0; y < frame.height; ++y) {
    int x = 0;
    while ((x = left.first_blocked(y, x, frame.width - 1)) >= 0) {
      CellWindow box{.first = {.x = x, .y = y}, .last = {.x = x, .y = y}};
      while (left.blocked({box.last.x + 1, y}) && box.last.x + 1 < frame.width)
        ++box.last.x;
      const auto whole_row = [&](int row) {
        for (int c = box.first.x; c <= box.last.x; ++c) {
          if (!left.blocked({c, row})) return false;
        }
        return row < frame.height;
      };
      while (box.last.y + 1 < frame.height && whole_row(box.last.y + 1))
        ++box.last.y;
      for (int row = box.first.y; row <= box.last.y; ++row) {
        for (int c = box.first.x; c <= box.last.x; ++c)
          left.set({c, row}, false);
      }
      boxes.push_back(box);
      x = box.last.x + 1;
      if (x >= frame.width) break;
    }
  }
  return boxes;
}

}  // namespace fairway
