/// Where names are used, and which binder each use means.

import {childrenOf} from "./child_nodes.ts"
import type {Clause, Declaration, Expr, Guarded, Node, Pattern, RightSide, Statement} from "./syntax_tree.ts"
import {unreachable} from "./syntax_tree.ts"

/// What brings a name into scope: a pattern that names something, or a definition.
export type Binder = Pattern | Declaration

/// A use of a name. For an operator the node is the infix or section, for a record's field the update.
export interface Use {
  readonly name: string
  readonly node: Expr
  /// Undefined for names that come from outside the walked part.
  readonly binder: Binder | undefined
}

/// Names in scope, in layers of which each has more than twice as many as the next one: two thousand steps that each name something are looked through,
/// and not copied, two thousand times.
type Scope = readonly ReadonlyMap<string, Binder>[]

/// All uses in a whole program; top-level names are bound by their declarations.
export function usesInProgram(declarations: readonly Declaration[]): Use[] {
  const uses: Use[] = []
  const scope = plus([], declarations.flatMap(bindersInDeclaration))
  for (const d of declarations) visitDeclaration(d, scope, uses)
  return uses
}

/// All uses in an expression that stands alone.
export function usesInExpr(e: Expr): Use[] {
  const uses: Use[] = []
  visit(e, [], uses)
  return uses
}

/// The names a declaration takes from outside; its own name counts when it uses itself.
export function freeInDeclaration(d: Declaration): Set<string> {
  const uses: Use[] = []
  visitDeclaration(d, [], uses)
  return new Set(uses.filter(u => u.binder === undefined).map(u => u.name))
}

export function bindersIn(p: Pattern): (readonly [string, Binder])[] {
  switch (p.kind) {
    case "name-pattern":
      return [[p.name, p]]
    case "as-pattern":
      return [[p.name, p], ...bindersIn(p.pattern)]
    case "constructor-pattern":
      return p.args.flatMap(bindersIn)
    case "tuple-pattern":
    case "list-pattern":
      return p.items.flatMap(bindersIn)
    case "infix-pattern":
      return [...bindersIn(p.left), ...bindersIn(p.right)]
    case "record-pattern":
      return p.fields.flatMap(f => bindersIn(f.pattern))
    case "strictness-pattern":
    case "view-pattern":
    case "typed-pattern":
      return bindersIn(p.pattern)
    case "raw-pattern":
      return [...p.text.matchAll(/(?<![\p{L}\p{N}_'])[\p{Ll}_][\p{L}\p{N}_']*/gu)].map(
        ([name]) => [name, p] as const,
      )
    case "wildcard":
    case "number-pattern":
    case "string-pattern":
    case "character-pattern":
      return []
    default:
      return unreachable(p)
  }
}

export function bindersInDeclaration(d: Declaration): (readonly [string, Binder])[] {
  if (d.kind === "function") return [[d.name, d]]
  return d.kind === "binding" ? bindersIn(d.pattern) : []
}

function bindersInStatement(s: Statement): (readonly [string, Binder])[] {
  if (s.kind === "bind") return bindersIn(s.pattern)
  return s.kind === "let-statement" ? s.declarations.flatMap(bindersInDeclaration) : []
}

function plus(scope: Scope, binders: readonly (readonly [string, Binder])[]): Scope {
  if (binders.length === 0) return scope
  let layers = scope
  let added: ReadonlyMap<string, Binder> = new Map(binders)
  for (let last = layers.at(-1); last !== undefined && last.size <= 2 * added.size; last = layers.at(-1)) {
    added = new Map([...last, ...added])
    layers = layers.slice(0, -1)
  }
  return [...layers, added]
}

function use(name: string, node: Expr, scope: Scope, uses: Use[]): void {
  uses.push({name, node, binder: scope.findLast(layer => layer.has(name))?.get(name)})
}

function visitDeclaration(d: Declaration, scope: Scope, uses: Use[]): void {
  if (d.kind === "function") for (const c of d.clauses) visitClause(c, scope, uses)
  else if (d.kind === "binding") {
    visitPatterns([d.pattern], scope, uses)
    visitRight(d.right, scope, uses)
  }
  // A method's name is its class's: nothing here binds it.
  else if (d.kind === "instance") for (const inner of d.declarations) visitDeclaration(inner, scope, uses)
}

function visitClause(c: Clause, scope: Scope, uses: Use[]): void {
  visitRight(c.right, visitPatterns(c.patterns, scope, uses), uses)
}

/// The scope with the binders of patterns. What looks at a value in a view pattern uses the names to its left.
function visitPatterns(patterns: readonly Pattern[], outer: Scope, uses: Use[]): Scope {
  return patterns.reduce((scope, p) => {
    if (p.kind === "view-pattern") {
      visit(p.expr, scope, uses)
      return visitPatterns([p.pattern], scope, uses)
    }
    const inner = childrenOf(p).filter(isPattern)
    return inner.length === 0
      ? plus(scope, bindersIn(p))
      : visitPatterns(inner, p.kind === "as-pattern" ? plus(scope, [[p.name, p]]) : scope, uses)
  }, outer)
}

function isPattern(node: Node): node is Pattern {
  return node.kind === "wildcard" || node.kind.endsWith("-pattern")
}

function visitRight(right: RightSide, outer: Scope, uses: Use[]): void {
  const scope = plus(outer, right.where.flatMap(bindersInDeclaration))
  for (const d of right.where) visitDeclaration(d, scope, uses)
  const body = right.body
  if (!Array.isArray(body)) visit(body as Expr, scope, uses)
  else visitBranches(body, scope, uses)
}

function visitBranches(branches: readonly Guarded[], scope: Scope, uses: Use[]): void {
  for (const g of branches) visitStatements(g.guards, scope, uses, inner => visit(g.body, inner, uses))
}

function visitStatements(
  statements: readonly Statement[],
  scope: Scope,
  uses: Use[],
  then: (scope: Scope) => void,
): void {
  let inner = scope
  for (const s of statements) {
    const after = plus(inner, bindersInStatement(s))
    if (s.kind === "let-statement") for (const d of s.declarations) visitDeclaration(d, after, uses)
    else {
      visit(s.expr, inner, uses)
      if (s.kind === "bind") visitPatterns([s.pattern], inner, uses)
    }
    inner = after
  }
  then(inner)
}

function visit(e: Expr, scope: Scope, uses: Use[]): void {
  switch (e.kind) {
    case "variable":
      use(e.name, e, scope, uses)
      return
    case "apply":
      visit(e.fn, scope, uses)
      for (const a of e.args) visit(a, scope, uses)
      return
    case "infix":
      use(e.op, e, scope, uses)
      visit(e.left, scope, uses)
      visit(e.right, scope, uses)
      return
    case "section":
      use(e.op, e, scope, uses)
      visit(e.operand, scope, uses)
      return
    case "negate":
    case "typed":
    case "type-apply":
      visit(e.kind === "type-apply" ? e.fn : e.expr, scope, uses)
      return
    case "lambda":
      visit(e.body, visitPatterns(e.parameters, scope, uses), uses)
      return
    case "if":
      visit(e.condition, scope, uses)
      visit(e.yes, scope, uses)
      visit(e.no, scope, uses)
      return
    case "branches":
      visitBranches(e.branches, scope, uses)
      return
    case "case":
    case "lambda-case":
      if (e.kind === "case") visit(e.scrutinee, scope, uses)
      for (const a of e.alternatives) visitRight(a.right, visitPatterns([a.pattern], scope, uses), uses)
      return
    case "let": {
      const inner = plus(scope, e.declarations.flatMap(bindersInDeclaration))
      for (const d of e.declarations) visitDeclaration(d, inner, uses)
      visit(e.body, inner, uses)
      return
    }
    case "do":
      visitStatements(e.statements, scope, uses, () => {})
      return
    case "comprehension":
      visitStatements(e.statements, scope, uses, inner => visit(e.body, inner, uses))
      return
    case "tuple":
    case "list":
      for (const i of e.items) visit(i, scope, uses)
      return
    case "range":
      visit(e.first, scope, uses)
      if (e.second !== undefined) visit(e.second, scope, uses)
      if (e.last !== undefined) visit(e.last, scope, uses)
      return
    case "record":
      for (const f of e.fields) visit(f.value, scope, uses)
      return
    case "update":
      visit(e.record, scope, uses)
      for (const f of e.fields) visit(f.value, scope, uses)
      return
    case "raw":
      // Words of raw Haskell may be names; counting too many only keeps a binder from looking unused.
      for (const [name] of e.text.matchAll(/(?<![\p{L}\p{N}_'])[\p{Ll}_][\p{L}\p{N}_']*/gu))
        use(name, e, scope, uses)
      return
    case "constructor-name":
    case "number":
    case "string":
    case "character":
    case "hole":
    case "gap":
      return
    default:
      unreachable(e)
  }
}
