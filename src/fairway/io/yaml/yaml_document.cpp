// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/yaml/yaml_document.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <sstream>
#include <vector>

#include <fmt/core.h>
#include <yaml-cpp/eventhandler.h>

#include "fairway/base/utf8_text.hpp"

namespace fairway::io {

namespace {

// Checks a document before nodes are built from it.
class Inspection : public YAML::EventHandler {
 public:
  // The parser emits endless empty documents before a token outside any document.
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos == start_) throw YAML::ParserException(mark, "a token outside any document");
    start_ = mark.pos;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& /*mark*/, YAML::anchor_t /*anchor*/) override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    throw YAML::ParserException(mark, "an alias, which is not supported");
  }
  void OnScalar(const YAML::Mark& /*mark*/,
                const std::string& /*tag*/,
                YAML::anchor_t /*anchor*/,
                const std::string& /*value*/) override {}
  void OnSequenceStart(const YAML::Mark& /*mark*/,
                       const std::string& /*tag*/,
                       YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& /*mark*/,
                  const std::string& /*tag*/,
                  YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {}
  void OnMapEnd() override {}

 private:
  int start_ = -1;  // of the document before
};

void inspect(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Inspection inspection;
  while (parser.HandleNextDocument(inspection)) {
  }
}

}  // namespace

YamlMapping parse_yaml_mapping(YamlFile& file, const std::string& text) {
  const YamlMapping empty(file, YAML::Node(YAML::NodeType::Map));
  if (const std::optional<std::size_t> at = first_not_utf8(text)) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(*at), '\n');
    file.complain(static_cast<int>(line), "",
                  fmt::format("expected text in UTF-8, found byte 0x{:02x}",
                              static_cast<unsigned char>(text[*at])));
    return empty;
  }
  try {
    inspect(text);
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.empty()) {
      file.complain(0, "", "expected a YAML mapping, found an empty file");
    } else if (documents.size() > 1) {
      file.complain(0, "", fmt::format("expected one document, found {}", documents.size()));
    } else if (!documents.front().IsMap()) {
      file.complain(line_of(documents.front()), "",
                    fmt::format("expected a YAML mapping, found {}", kind_of(documents.front())));
    } else {
      return YamlMapping(file, documents.front());
    }
  } catch (const YAML::Exception& error) {
    file.complain(error.mark.line + 1, "", fmt::format("expected YAML, found {}", error.msg));
  } catch (const std::exception& error) {
    file.complain(0, "",
                  fmt::format("expected YAML, found what cannot be parsed: {}", error.what()));
  }
  return empty;
}

}  // namespace fairway::io
