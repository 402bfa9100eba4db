// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The part of yaml-cpp's interface that fairway::io uses, for the browser, where yaml-cpp is not
// packaged. It reads one document of mappings, lists and one-line scalars, in block or flow style,
// with comments; it refuses aliases, anchors, tags and block scalars.
namespace YAML {

struct Mark {
  int pos = 0;
  int line = 0;
  int column = 0;
};

class Exception : public std::runtime_error {
 public:
  Exception(const Mark& where, const std::string& what)
      : std::runtime_error(what),
        mark(where),
        msg(what) {}
  Mark mark;
  std::string msg;
};

class ParserException : public Exception {
 public:
  using Exception::Exception;
};

struct NodeType {
  enum value { Undefined, Null, Scalar, Sequence, Map };
};

struct Entry;

/// A value of the document; copies share it.
class Node {
 public:
  Node() : Node(NodeType::Null) {}
  explicit Node(NodeType::value type, const Mark& mark = {});

  [[nodiscard]] bool IsDefined() const { return content_->type != NodeType::Undefined; }
  [[nodiscard]] bool IsNull() const { return content_->type == NodeType::Null; }
  [[nodiscard]] bool IsScalar() const { return content_->type == NodeType::Scalar; }
  [[nodiscard]] bool IsSequence() const { return content_->type == NodeType::Sequence; }
  [[nodiscard]] bool IsMap() const { return content_->type == NodeType::Map; }
  [[nodiscard]] const std::string& Scalar() const { return content_->scalar; }
  [[nodiscard]] YAML::Mark Mark() const { return content_->mark; }
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] std::vector<Entry>::const_iterator begin() const;
  [[nodiscard]] std::vector<Entry>::const_iterator end() const;

  // For the reader.
  void set_scalar(std::string text) { content_->scalar = std::move(text); }
  void add(const Node& key, const Node& value);

 private:
  struct Content {
    NodeType::value type;
    YAML::Mark mark;
    std::string scalar;
    std::vector<Entry> entries;
  };
  std::shared_ptr<Content> content_;
};

/// An entry of a list is a node; one of a mapping is a pair of nodes.
struct Entry : Node {
  Entry(const Node& key, const Node& value) : Node(value), first(key), second(value) {}
  Node first;
  Node second;
};

using anchor_t = std::size_t;
struct EmitterStyle {
  enum value { Default };
};
class EventHandler;

/// Reports no events: LoadAll finds every error itself.
class Parser {
 public:
  explicit Parser(std::istream& /*input*/) {}
  bool HandleNextDocument(EventHandler& /*handler*/) { return false; }
};

[[nodiscard]] std::vector<Node> LoadAll(const std::string& text);

}  // namespace YAML
