// SPDX-License-Identifier: Apache-2.0
#include "server/editing/edit_history.hpp"

#include <utility>

namespace fairway::app {

void EditHistory::add(Edit edit) {
  edits_.resize(done_);
  const bool continues =
      edit.stroke != 0 && !edits_.empty() && edits_.back().back().stroke == edit.stroke;
  if (!continues) edits_.emplace_back();
  edits_.back().push_back(std::move(edit));
  if (edits_.size() > kMost) edits_.pop_front();
  done_ = edits_.size();
}

bool EditHistory::undo(EpisodeControl& control) {
  if (done_ == 0) return false;
  const std::vector<Edit>& parts = edits_[--done_];
  for (auto part = parts.rbegin(); part != parts.rend(); ++part)
    part->undo(control);
  return true;
}

bool EditHistory::redo(EpisodeControl& control) {
  if (done_ == edits_.size()) return false;
  for (const Edit& part : edits_[done_++])
    part.redo(control);
  return true;
}

void EditHistory::clear() {
  edits_.clear();
  done_ = 0;
}

std::string EditHistory::undo_label() const {
  return done_ == 0 ? "" : edits_[done_ - 1].back().label;
}

std::string EditHistory::redo_label() const {
  return done_ == edits_.size() ? "" : edits_[done_].back().label;
}

}  // namespace fairway::app
