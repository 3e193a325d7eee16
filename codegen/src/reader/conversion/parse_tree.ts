/// Parse tree as plain objects, copied from tree-sitter's in one walk.
///
/// Asking tree-sitter's own nodes costs a call into WebAssembly each time; one walk with a cursor costs six a node. Comments are left out:
/// `lexer.ts` knows them. Offsets are UTF-16 units of the text that was parsed.

import type {Language, Tree} from "web-tree-sitter"

export interface Syntax {
  /// As the grammar names it: `"infix"`, `"literal"`; of tokens without a name their text.
  readonly type: string
  readonly named: boolean
  readonly field: string | undefined
  readonly start: number
  readonly end: number
  readonly children: readonly Syntax[]
}

export interface Parsed {
  readonly root: Syntax
  /// Something in it is not Haskell, or is missing.
  readonly broken: boolean
  /// What tells the compiler something; it may stand anywhere.
  readonly pragmas: readonly {readonly start: number; readonly end: number}[]
}

export interface NodeNames {
  readonly types: readonly (string | undefined)[]
  readonly named: readonly boolean[]
  readonly fields: readonly (string | undefined)[]
}

export function nodeNames(language: Language): NodeNames {
  const types: (string | undefined)[] = []
  const named: boolean[] = []
  for (let id = 0; id < language.nodeTypeCount; id++) {
    types.push(language.nodeTypeForId(id) ?? undefined)
    named.push(language.nodeTypeIsNamed(id))
  }
  return {types, named, fields: language.fields.map(f => f ?? undefined)}
}

const skipped = new Set(["comment", "haddock", "pragma"])

/// `place` says where in the file's text a place of the parsed text is.
export function copyTree(tree: Tree, names: NodeNames, place: (at: number) => number): Parsed {
  const cursor = tree.walk()
  let broken = tree.rootNode.hasError
  const pragmas: {start: number; end: number}[] = []
  // Iterative: a chain of operators nests as deep as it is long.
  const open: Syntax[][] = [[]]
  const enter = (): Syntax => {
    const id = cursor.nodeTypeId
    const type = names.types[id] ?? "ERROR"
    if (type === "ERROR" || id === 65535) broken = true
    const fieldId = cursor.currentFieldId
    return {
      type,
      named: names.named[id] ?? true,
      field: fieldId === 0 ? undefined : names.fields[fieldId],
      start: place(cursor.startIndex),
      end: place(cursor.endIndex),
      children: [],
    }
  }
  for (let inside = true; inside; ) {
    const node = enter()
    if (node.type === "pragma") pragmas.push({start: node.start, end: node.end})
    if (!skipped.has(node.type)) open[open.length - 1]?.push(node)
    if (cursor.gotoFirstChild()) {
      open.push(node.children as Syntax[])
      continue
    }
    while (!cursor.gotoNextSibling()) {
      inside = cursor.gotoParent()
      if (!inside) break
      open.pop()
    }
  }
  const root = open[0]?.[0]
  cursor.delete()
  return {
    root: root ?? {type: "haskell", named: true, field: undefined, start: 0, end: 0, children: []},
    broken,
    pragmas,
  }
}

export function child(node: Syntax, field: string): Syntax | undefined {
  for (const c of node.children) if (c.field === field) return c
  return undefined
}

export function childrenIn(node: Syntax, field: string): Syntax[] {
  return node.children.filter(c => c.field === field && c.named)
}

export function namedChildren(node: Syntax): Syntax[] {
  return node.children.filter(c => c.named)
}

export function onlyNamed(node: Syntax): Syntax | undefined {
  const [only, ...others] = namedChildren(node)
  return others.length === 0 ? only : undefined
}

/// What stands in brackets, however many there are.
export function withoutParens(node: Syntax): Syntax {
  let held = node
  for (let inner: Syntax | undefined = node; inner?.type === "parens"; ) {
    inner = onlyNamed(inner)
    held = inner ?? held
  }
  return held
}

export function hasToken(node: Syntax, token: string): boolean {
  return node.children.some(c => !c.named && c.type === token)
}

export function tokensOf(node: Syntax, token: string): number {
  return node.children.filter(c => !c.named && c.type === token).length
}
