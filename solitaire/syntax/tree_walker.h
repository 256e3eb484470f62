#pragma once
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// Walks over a tree in the order of the text, by recursion. A derived class overrides what it looks at, and
/// calls the function of this class to go on below.
class TreeWalker {
 public:
  virtual ~TreeWalker() = default;

  virtual void expression(const Expr& node);
  virtual void statement(const Stmt& node);
  virtual void function(const Function& node);

 private:
  void comprehension(const ComprehensionExpr& node);
};

}  // namespace solitaire
