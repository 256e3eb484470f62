#pragma once
#include <stdexcept>
#include <string>

#include "tracegraph/graph.h"

namespace solitaire {

/// Thrown for a condition that depends on an operation which bit-vectors cannot express, such as one on
/// floats. It names the node, so that whoever asked can say which choice and which place in the program it
/// is.
class UnsupportedOperation : public std::runtime_error {
 public:
  UnsupportedOperation(Op unsupported, NodeId at)
      : std::runtime_error("bit-vectors cannot express '" + std::string(operation(unsupported).name) + "'"),
        op(unsupported),
        node(at) {}

  Op op;
  NodeId node;
};

/// Throws UnsupportedOperation if bit-vectors cannot express the node's operation.
inline void require_bits(const Graph& graph, NodeId id) {
  const Op op = graph.node(id).op;
  if (operation(op).on_floats()) throw UnsupportedOperation(op, id);
}

}  // namespace solitaire
