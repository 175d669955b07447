#include "adapt/expression_lexer.h"

#include <array>
#include <charconv>

#include "adapt/expression.h"
#include "adapt/expression_tape.h"

namespace parmesan {
namespace {

constexpr std::array<std::string_view, 20> kSymbols{"<=", ">=", "==", "!=", "&&", "||", "**", "+", "-", "*",
                                                    "/",  "^",  "<",  ">",  "!",  "?",  ":",  "(", ")", ","};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

std::string shown(char c) {
  const auto code = static_cast<unsigned char>(c);
  if (code > 32 && code < 127) return std::string("'") + c + "'";
  return "the byte " + std::to_string(code);
}

/// What is wrong with a character no token starts with.
std::string explain(char c) {
  if (c == '=') return "'=' is not an operator; to compare write '=='";
  if (c == '&' || c == '|') return std::string("'") + c + "' is not an operator; write '" + c + c + "'";
  if (c == '%') return "'%' is not an operator; write a - b*floor(a/b)";
  if (c == '[' || c == '{') return std::string("'") + c + "' is not allowed; group with ( )";
  return shown(c) + " is not allowed in an expression";
}

Token number_token(std::string_view text, std::size_t position) {
  Token token{TokenKind::Number, {}, position, 0.0};
  const char* first = text.data() + position;
  const auto [end, error] = std::from_chars(first, text.data() + text.size(), token.number);
  if (error == std::errc::invalid_argument) throw ExpressionError(position, "'.' is not a number");
  token.text = text.substr(position, static_cast<std::size_t>(end - first));
  if (error != std::errc()) {
    throw ExpressionError(position, "the number " + std::string(token.text.substr(0, 40)) +
                                        " is too large or too small for double precision");
  }
  return token;
}

Token name_token(std::string_view text, std::size_t position) {
  std::size_t end = position;
  while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
  return {TokenKind::Name, text.substr(position, end - position), position, 0.0};
}

Token symbol_token(std::string_view text, std::size_t position) {
  const std::string_view rest = text.substr(position);
  for (const std::string_view symbol : kSymbols) {
    if (!rest.starts_with(symbol)) continue;
    if (symbol == "**") throw ExpressionError(position, "'**' is not an operator; write '^' for powers");
    return {TokenKind::Symbol, rest.substr(0, symbol.size()), position, 0.0};
  }
  throw ExpressionError(position, explain(text[position]));
}

Token next_token(std::string_view text, std::size_t position) {
  const char c = text[position];
  if (is_digit(c) || c == '.') return number_token(text, position);
  if (is_letter(c)) return name_token(text, position);
  return symbol_token(text, position);
}

}  // namespace

std::vector<Token> tokenize(std::string_view text) {
  std::vector<Token> tokens;
  std::size_t position = 0;
  while (true) {
    while (position < text.size() && is_space(text[position])) ++position;
    if (position == text.size()) break;
    if (tokens.size() == kMaxExpressionTokens) {
      throw ExpressionError(position, "the expression is longer than " + std::to_string(kMaxExpressionTokens) +
                                          " numbers, names and operators");
    }
    tokens.push_back(next_token(text, position));
    position += tokens.back().text.size();
  }
  tokens.push_back({TokenKind::End, {}, position, 0.0});
  return tokens;
}

bool is_identifier(std::string_view text) {
  if (text.empty() || !is_letter(text.front())) return false;
  for (const char c : text) {
    if (!is_letter(c) && !is_digit(c)) return false;
  }
  return true;
}

}  // namespace parmesan
