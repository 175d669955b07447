#include "adapt/expression.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "adapt/expression_evaluate.h"
#include "adapt/expression_tape.h"
#include "mesher/number_text.h"

namespace parmesan {

struct Expression::Program {
  std::string text;
  std::vector<std::string> extra_variables;
  Tape tape;
};

namespace {

constexpr std::size_t kSmallStack = 16;

template <class T, std::size_t N>
T run_with_stack(const Tape& tape, const T& x, const T& y, std::span<const double> extra) {
  std::array<T, N> stack;
  return evaluate<T>(tape.code, stack.data(), x, y, extra);
}

template <class T>
T run(const Tape& tape, const T& x, const T& y, std::span<const double> extra) {
  assert(extra.size() >= tape.uses_extra.size());
  if (tape.stack_size <= kSmallStack) return run_with_stack<T, kSmallStack>(tape, x, y, extra);
  return run_with_stack<T, kMaxExpressionStack>(tape, x, y, extra);
}

}  // namespace

Expression::Expression(std::shared_ptr<const Program> program) : program_(std::move(program)) {}

Expression Expression::parse(std::string_view text, const std::map<std::string, double>& symbols,
                             const std::vector<std::string>& extra_variables,
                             const std::vector<std::string>& coordinates) {
  return Expression(std::make_shared<const Program>(
      Program{std::string(text), extra_variables, compile(text, symbols, extra_variables, coordinates)}));
}

Expression Expression::constant(double value) {
  Tape tape;
  tape.code.push_back({.op = Op::Constant, .constant = value});
  tape.stack_size = 1;
  return Expression(std::make_shared<const Program>(Program{parmesan::text(value), {}, std::move(tape)}));
}

double Expression::value(const Point& p, const std::vector<double>& extra) const {
  return value(p, std::span<const double>(extra));
}

double Expression::value(const Point& p, std::span<const double> extra) const {
  return run<double>(program_->tape, p.x, p.y, extra);
}

Jet Expression::jet(const Point& p, const std::vector<double>& extra) const {
  return run<Jet>(program_->tape, Jet{.value = p.x, .x = 1.0}, Jet{.value = p.y, .y = 1.0}, extra);
}

const std::string& Expression::text() const { return program_->text; }

bool Expression::is_constant() const {
  const std::vector<bool>& used = program_->tape.uses_extra;
  return !program_->tape.uses_point && std::find(used.begin(), used.end(), true) == used.end();
}

bool Expression::uses(std::string_view extra_variable) const {
  const std::vector<std::string>& names = program_->extra_variables;
  const auto found = std::find(names.begin(), names.end(), extra_variable);
  return found != names.end() && program_->tape.uses_extra[static_cast<std::size_t>(found - names.begin())];
}

}  // namespace parmesan
