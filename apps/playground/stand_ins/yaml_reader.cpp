// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include <yaml-cpp/yaml.h>

#include "yaml_escape.hpp"

namespace YAML {

Node::Node(NodeType::value type, const YAML::Mark& mark)
    : content_(std::make_shared<Content>(Content{type, mark, {}, {}})) {}

std::size_t Node::size() const { return content_->entries.size(); }
std::vector<Entry>::const_iterator Node::begin() const { return content_->entries.begin(); }
std::vector<Entry>::const_iterator Node::end() const { return content_->entries.end(); }
void Node::add(const Node& key, const Node& value) { content_->entries.emplace_back(key, value); }

namespace {

constexpr int kDeepest = 64;

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Node document() {
    skip();
    if (text_.substr(at_).starts_with("---") && column() == 0) {
      at_ += 3;
      skip();
    }
    Node root = block(0);
    skip();
    if (text_.substr(at_).starts_with("...") && column() == 0) {
      at_ += 3;
      skip();
    }
    if (!done()) fail("expected the end of the document");
    return root;
  }

 private:
  [[nodiscard]] bool done() const { return at_ >= text_.size(); }
  [[nodiscard]] char now(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\n';
  }
  [[nodiscard]] int column() const { return static_cast<int>(at_ - line_start_); }
  [[nodiscard]] Mark mark() const { return {static_cast<int>(at_), line_, column()}; }
  [[noreturn]] void fail(const char* what) const { throw ParserException(mark(), what); }

  static bool blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  void step() {
    if (text_[at_] == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    }
    ++at_;
  }

  // Skips blanks and comments; `lines`: also ends of lines.
  void skip(bool lines = true) {
    while (!done()) {
      const bool comment = now() == '#' && (at_ == 0 || blank(text_[at_ - 1]));
      if (comment) {
        while (!done() && now() != '\n')
          ++at_;
      } else if (blank(now()) && (lines || now() != '\n')) {
        step();
      } else {
        return;
      }
    }
  }

  [[nodiscard]] bool dash() const { return !done() && now() == '-' && blank(now(1)); }

  // Whether a key and its colon are next, in this line.
  [[nodiscard]] bool key_next() const {
    if (done() || now() == '[' || now() == '{') return false;
    std::size_t i = at_;
    if (now() == '"' || now() == '\'') {
      const char quote = now();
      for (++i; i < text_.size() && text_[i] != quote && text_[i] != '\n'; ++i)
        i += text_[i] == '\\' && quote == '"' ? 1 : 0;
      for (++i; i < text_.size() && text_[i] == ' '; ++i) {
      }
      return i < text_.size() && text_[i] == ':';
    }
    for (; i < text_.size() && text_[i] != '\n'; ++i) {
      if (text_[i] == '#' && i > at_ && blank(text_[i - 1])) return false;
      if (text_[i] == ':' && (i + 1 == text_.size() || blank(text_[i + 1]))) return true;
    }
    return false;
  }

  Node block(int least) {
    if (++depth_ > kDeepest) fail("expected fewer levels");
    skip();
    Node node(NodeType::Null, mark());
    if (!done() && column() >= least) {
      node = dash() ? sequence(column()) : key_next() ? mapping(column()) : line_value();
    }
    --depth_;
    return node;
  }

  Node mapping(int indent) {
    Node map(NodeType::Map, mark());
    while (!done() && column() == indent && !dash()) {
      if (!key_next()) fail("expected a key");
      const Node key = now() == '"' || now() == '\'' ? quoted() : plain(":");
      skip(false);
      if (now() != ':') fail("expected a colon");
      ++at_;
      map.add(key, value_behind_key(indent));
      skip();
    }
    if (!done() && column() > indent) fail("expected no further indentation");
    return map;
  }

  Node value_behind_key(int indent) {
    skip(false);
    if (!done() && now() != '\n') return line_value();
    const Mark here = mark();
    skip();
    if (!done() && column() == indent && dash()) return sequence(indent);
    if (!done() && column() > indent) return block(indent + 1);
    return Node(NodeType::Null, here);
  }

  Node sequence(int indent) {
    Node list(NodeType::Sequence, mark());
    while (!done() && column() == indent && dash()) {
      ++at_;
      skip(false);
      if (done() || now() == '\n') {
        list.add(Node(), block(indent + 1));
      } else if (dash() || key_next()) {
        list.add(Node(), block(column()));
      } else {
        list.add(Node(), line_value());
      }
      skip();
    }
    if (!done() && column() > indent) fail("expected no further indentation");
    return list;
  }

  // A value that is not a block; nothing but a comment may follow in its line.
  Node line_value() {
    const Node node = value("");
    skip(false);
    if (!done() && now() != '\n') fail("expected the end of the line");
    return node;
  }

  Node value(std::string_view ends) {
    switch (now()) {
      case '[':
      case '{':
        return flow();
      case '"':
      case '\'':
        return quoted();
      case '&':
      case '*':
        fail("an alias, which is not supported");
      case '!':
      case '|':
      case '>':
      case '@':
      case '`':
      case '%':
        fail("expected a plain or quoted value");
      default:
        return plain(ends);
    }
  }

  Node flow() {
    if (++depth_ > kDeepest) fail("expected fewer levels");
    const bool list = now() == '[';
    const char close = list ? ']' : '}';
    Node node(list ? NodeType::Sequence : NodeType::Map, mark());
    ++at_;
    for (skip(); now() != close; skip()) {
      if (done()) fail("expected the end of a list or mapping");
      const Node key = value(list ? ",]" : ",}:");
      Node entry;
      skip();
      if (!list) {
        if (now() == ':') {
          ++at_;
          skip();
          if (now() != ',' && now() != close) entry = value(",}");
          skip();
        }
        node.add(key, entry);
      } else {
        node.add(Node(), key);
      }
      if (now() == ',') {
        ++at_;
      } else if (now() != close) {
        fail("expected a comma");
      }
    }
    ++at_;
    --depth_;
    return node;
  }

  Node plain(std::string_view ends) {
    Node node(NodeType::Scalar, mark());
    const std::size_t begin = at_;
    while (!done() && now() != '\n') {
      if (now() == '#' && at_ > begin && blank(text_[at_ - 1])) break;
      if (now() == ':' && (blank(now(1)) || (ends.size() > 1 && (now(1) == ',' || now(1) == '}'))))
        break;
      if (now() != ':' && ends.find(now()) != std::string_view::npos) break;
      ++at_;
    }
    std::size_t end = at_;
    while (end > begin && blank(text_[end - 1]))
      --end;
    const std::string_view found = text_.substr(begin, end - begin);
    if (found.empty() && !ends.empty()) fail("expected a value");
    if (found.empty() || found == "~" || found == "null" || found == "Null" || found == "NULL") {
      return Node(NodeType::Null, node.Mark());
    }
    node.set_scalar(std::string(found));
    return node;
  }

  Node quoted() {
    Node node(NodeType::Scalar, mark());
    const char quote = now();
    std::string text;
    for (++at_; now() != quote || (quote == '\'' && now(1) == quote); ++at_) {
      if (done() || now() == '\n') fail("expected the end of a quoted text in its line");
      if (quote == '"' && now() == '\\') {
        ++at_;
        if (!append_escaped(text_, at_, text)) fail("expected a known escape");
      } else {
        if (quote == '\'' && now() == quote) ++at_;
        text += now();
      }
    }
    ++at_;
    node.set_scalar(std::move(text));
    return node;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 0;
  int depth_ = 0;
};

}  // namespace

std::vector<Node> LoadAll(const std::string& text) {
  Node root = Reader(text).document();
  if (root.IsNull()) return {};
  return {root};
}

}  // namespace YAML
