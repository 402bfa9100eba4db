// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

namespace YAML {

class EventHandler {
 public:
  virtual ~EventHandler() = default;
  virtual void OnDocumentStart(const Mark& mark) = 0;
  virtual void OnDocumentEnd() = 0;
  virtual void OnNull(const Mark& mark, anchor_t anchor) = 0;
  virtual void OnAlias(const Mark& mark, anchor_t anchor) = 0;
  virtual void OnScalar(const Mark& mark,
                        const std::string& tag,
                        anchor_t anchor,
                        const std::string& value) = 0;
  virtual void OnSequenceStart(const Mark& mark,
                               const std::string& tag,
                               anchor_t anchor,
                               EmitterStyle::value style) = 0;
  virtual void OnSequenceEnd() = 0;
  virtual void OnMapStart(const Mark& mark,
                          const std::string& tag,
                          anchor_t anchor,
                          EmitterStyle::value style) = 0;
  virtual void OnMapEnd() = 0;
};

}  // namespace YAML
