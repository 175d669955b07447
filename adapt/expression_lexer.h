#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace parmesan {

/// Operators and punctuation are tokens whose text is the symbol itself.
enum class TokenKind { Number, Name, Symbol, End };

struct Token {
  TokenKind kind = TokenKind::End;
  std::string_view text;
  std::size_t position = 0;  // byte offset
  double number = 0.0;
};

/// Splits an expression into tokens, the last of kind End.
/// Errors: ExpressionError for a character that means nothing, a number out of range, too many tokens.
std::vector<Token> tokenize(std::string_view text);

/// A letter or underscore, then letters, digits and underscores (ASCII).
bool is_identifier(std::string_view text);

}  // namespace parmesan
