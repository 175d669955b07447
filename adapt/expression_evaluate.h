#pragma once

#include <cstddef>
#include <span>

#include "adapt/expression_jet.h"
#include "adapt/expression_tape.h"
#include "mesher/index.h"

namespace parmesan {

/// Result of an operator with two arguments; T is double or Jet.
template <class T>
T apply(const Instruction& instruction, const T& a, const T& b) {
  const auto truth = [](bool holds) { return T{holds ? 1.0 : 0.0}; };
  const double left = value_of(a);
  const double right = value_of(b);
  switch (instruction.op) {
    case Op::Add:
      return a + b;
    case Op::Subtract:
      return a - b;
    case Op::Multiply:
      return a * b;
    case Op::Divide:
      return a / b;
    case Op::Less:
      return truth(left < right);
    case Op::LessEqual:
      return truth(left <= right);
    case Op::Greater:
      return truth(left > right);
    case Op::GreaterEqual:
      return truth(left >= right);
    case Op::Equal:
      return truth(left == right);
    case Op::NotEqual:
      return truth(left != right);
    case Op::And:
      return truth(left != 0.0 && right != 0.0);
    case Op::Or:
      return truth(left != 0.0 || right != 0.0);
    default:
      return apply(static_cast<BinaryFunction>(instruction.index), a, b);
  }
}

/// Result of an operator with one argument.
template <class T>
T apply(const Instruction& instruction, const T& a) {
  switch (instruction.op) {
    case Op::Negate:
      return -a;
    case Op::Not:
      return T{value_of(a) == 0.0 ? 1.0 : 0.0};
    case Op::Power:
      return apply_power(a, instruction.constant);
    default:
      return apply(static_cast<UnaryFunction>(instruction.index), a);
  }
}

/// Runs a tape; T is double, or Jet with x = {x, 1, 0} and y = {y, 0, 1}.
///
/// stack: room for the tape's stack_size values. extra: values of the extra variables.
/// Cost: O(code), no allocation.
template <class T>
T evaluate(std::span<const Instruction> code, T* stack, const T& x, const T& y, std::span<const double> extra) {
  T* end = stack;  // one past the top
  for (std::size_t i = 0; i < code.size(); ++i) {
    const Instruction& instruction = code[i];
    if (instruction.op == Op::Constant) {
      *end++ = T{instruction.constant};
    } else if (instruction.op == Op::X) {
      *end++ = x;
    } else if (instruction.op == Op::Y) {
      *end++ = y;
    } else if (instruction.op == Op::Extra) {
      *end++ = T{extra[at(instruction.index)]};
    } else if (instruction.op <= Op::Binary) {
      --end;
      end[-1] = apply(instruction, end[-1], end[0]);
    } else if (instruction.op <= Op::Unary) {
      end[-1] = apply(instruction, end[-1]);
    } else if (instruction.op == Op::Jump || value_of(*--end) == 0.0) {
      i = static_cast<std::size_t>(instruction.index) - 1;
    }
  }
  return *stack;
}

}  // namespace parmesan
