#include "adapt/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace parmesan {
namespace {

/// A bracket, ':' or ',' as itself; 's' a string; 'v' a number, true, false or null; '\0' the end.
struct JsonToken {
  char kind = '\0';
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Tokens of a JSON text, one after the other; of one that is not valid those that nlohmann's parser sees, up to where
/// it stops.
class JsonTokens {
 public:
  explicit JsonTokens(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) offset_ = 3;
  }

  JsonToken next() {
    skip_blank();
    const std::size_t begin = offset_;
    if (begin >= text_.size()) return {'\0', begin, begin};
    const char c = text_[begin];
    if (c == '"') return string_token(begin);
    if (std::string_view("{}[]:,").find(c) != std::string_view::npos) return {c, begin, ++offset_};
    offset_ = std::min(text_.find_first_of("{}[]:,\" \t\r\n/", begin + 1), text_.size());
    return {'v', begin, offset_};
  }

  /// The string between its quotes, escapes undone.
  std::string content(const JsonToken& token) const {
    const std::string_view quoted = text_.substr(token.begin, token.end - token.begin);
    if (quoted.find('\\') == std::string_view::npos) return std::string(quoted.substr(1, quoted.size() - 2));
    return nlohmann::json::parse(quoted).get<std::string>();
  }

 private:
  JsonToken string_token(std::size_t begin) {
    ++offset_;
    while (offset_ < text_.size() && text_[offset_] != '"') offset_ += text_[offset_] == '\\' ? 2 : 1;
    offset_ = std::min(offset_ + 1, text_.size());
    return {'s', begin, offset_};
  }

  void skip_blank() {
    while (offset_ < text_.size()) {
      const std::string_view rest = text_.substr(offset_);
      if (rest.starts_with("//")) {
        offset_ = std::min(text_.find_first_of("\r\n", offset_), text_.size());
      } else if (rest.starts_with("/*")) {
        offset_ = std::min(text_.find("*/", offset_ + 2), text_.size() - 2) + 2;
      } else if (std::string_view(" \t\r\n").find(rest.front()) != std::string_view::npos) {
        ++offset_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t offset_ = 0;
};

/// Reads on to the token after the value that starts with this one.
JsonToken skip_value(JsonTokens& tokens, JsonToken token) {
  int depth = 0;
  do {
    if (token.kind == '{' || token.kind == '[') ++depth;
    if (token.kind == '}' || token.kind == ']') --depth;
    token = tokens.next();
  } while (depth > 0 && token.kind != '\0');
  return token;
}

/// Goes from the opening bracket to the child with this name or number; nothing when there is none.
std::optional<JsonPlace> find_child(JsonTokens& tokens, const JsonToken& open, const std::string& step,
                                    JsonToken& value) {
  if (open.kind != '{' && open.kind != '[') return std::nullopt;
  JsonToken token = tokens.next();
  for (std::size_t number = 0; token.kind != '}' && token.kind != ']' && token.kind != '\0'; ++number) {
    const JsonToken key = token;
    if (open.kind == '{') {
      tokens.next();  // the colon
      token = tokens.next();
    }
    const bool wanted = open.kind == '{' ? tokens.content(key) == step : std::to_string(number) == step;
    if (wanted) {
      value = token;
      return JsonPlace{key.begin, token.begin, true};
    }
    token = skip_value(tokens, token);
    if (token.kind == ',') token = tokens.next();
  }
  return std::nullopt;
}

/// One object or array that is open while the text is scanned.
struct OpenValue {
  bool object = false;
  std::set<std::string> keys;
  std::string key;  // last one seen
  std::size_t number = 0;
};

std::string pointer_to(const std::vector<OpenValue>& open) {
  std::string pointer;
  for (const OpenValue& value : open) pointer += pointer_step(value.object ? value.key : std::to_string(value.number));
  return pointer;
}

}  // namespace

JsonPlace locate(std::string_view text, std::string_view pointer) {
  JsonTokens tokens(text);
  JsonToken value = tokens.next();
  JsonPlace place{value.begin, value.begin, true};
  for (const std::string& step : pointer_steps(pointer).value_or(std::vector<std::string>{})) {
    const std::optional<JsonPlace> child = find_child(tokens, value, step, value);
    if (!child) {
      place.found = false;
      break;
    }
    place = *child;
  }
  return place;
}

std::vector<DuplicateKey> find_duplicate_keys(std::string_view text, std::size_t most) {
  std::vector<DuplicateKey> duplicates;
  std::vector<OpenValue> open;
  JsonTokens tokens(text);
  JsonToken before;
  for (JsonToken token = tokens.next(); token.kind != '\0'; before = token, token = tokens.next()) {
    if (token.kind == '{' || token.kind == '[') {
      open.push_back({.object = token.kind == '{', .keys = {}, .key = {}, .number = 0});
    } else if (open.empty()) {
      continue;  // the library reads no farther than a NUL, behind which there may be anything
    } else if (token.kind == '}' || token.kind == ']') {
      open.pop_back();
    } else if (token.kind == ',') {
      ++open.back().number;
    } else if (token.kind == 's' && open.back().object && before.kind != ':') {
      open.back().key = tokens.content(token);
      if (open.back().keys.insert(open.back().key).second) continue;
      duplicates.push_back({pointer_to(open), token.begin});
      if (duplicates.size() == most) break;
    }
  }
  return duplicates;
}

std::optional<std::size_t> find_nesting_beyond(std::string_view text, int most) {
  JsonTokens tokens(text);
  int depth = 0;
  for (JsonToken token = tokens.next(); token.kind != '\0'; token = tokens.next()) {
    if (token.kind == '}' || token.kind == ']') --depth;
    if ((token.kind == '{' || token.kind == '[') && ++depth > most) return token.begin;
  }
  return std::nullopt;
}

std::optional<std::size_t> find_names_beyond(std::string_view text, std::size_t most) {
  JsonTokens tokens(text);
  std::vector<std::size_t> counts;  // of the objects and arrays that are open
  JsonToken before;
  for (JsonToken token = tokens.next(); token.kind != '\0'; before = token, token = tokens.next()) {
    if (token.kind == '{' || token.kind == '[') counts.push_back(0);
    if ((token.kind == '}' || token.kind == ']') && !counts.empty()) counts.pop_back();
    if (token.kind == ':' && !counts.empty() && ++counts.back() > most) return before.begin;
  }
  return std::nullopt;
}

std::optional<std::size_t> find_overflow(std::string_view text) {
  JsonTokens tokens(text);
  for (JsonToken token = tokens.next(); token.kind != '\0'; token = tokens.next())
    if (token.kind == 'v' && !nlohmann::json::accept(text.substr(token.begin, token.end - token.begin)))
      return token.begin;
  return std::nullopt;
}

LineColumn line_column(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const std::size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  const std::string_view line = before.substr(line_start);
  return {1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
          1 + static_cast<int>(std::count_if(line.begin(), line.end(), starts_character))};
}

std::string pointer_step(std::string_view key) {
  std::string step = "/";
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

std::optional<std::vector<std::string>> pointer_steps(std::string_view pointer) {
  std::vector<std::string> steps;
  if (pointer.empty()) return steps;
  if (pointer.front() != '/') return std::nullopt;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    if (pointer[i] == '/') {
      steps.emplace_back();
    } else if (pointer[i] != '~') {
      steps.back() += pointer[i];
    } else if (i + 1 < pointer.size() && (pointer[i + 1] == '0' || pointer[i + 1] == '1')) {
      steps.back() += pointer[++i] == '0' ? '~' : '/';
    } else {
      return std::nullopt;
    }
  }
  return steps;
}

}  // namespace parmesan
