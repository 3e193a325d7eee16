/// Matching of block trees: which trees are equal, and which block of one tree corresponds to which of another.
///
/// Matching is by structure: first whole subtrees that are equal, the largest first, then what stands in the same place inside what was
/// matched. (After Falleri, Morandat and others, “Fine-grained and accurate source code differencing”, 2014.)

import type {BlockId, Extra, Json, SavedBlock} from "../../serialized_blocks.ts"

/// Keys of `extraState` that change how a block looks, not what it means.
const presentationKeys: ReadonlySet<string> = new Set(["as", "fn", "what"])

/// Those, and the reason why something is raw.
const keysWithoutMeaning: ReadonlySet<string> = new Set([...presentationKeys, "reason"])

interface Node {
  readonly block: SavedBlock
  /// Where it hangs below its parent: an input's name, or a place in a stack.
  readonly slot: string
  readonly parent: Node | undefined
  readonly children: readonly Node[]
  readonly size: number
  readonly hash: number
}

/// Equal numbers for trees that say the same, whatever their ids, places and folds. With `remarks`, comments count too.
export function hashTree(block: SavedBlock, remarks = false): number {
  return nodeOf(block, "", undefined, remarks).hash
}

function nodeOf(
  block: SavedBlock,
  slot: string,
  parent: Node | undefined,
  remarks: boolean,
  depth = 0,
): Node {
  const children: Node[] = []
  const node = {block, slot, parent, children, size: 1, hash: 0}
  let hash = mix(0x811c9dc5, block.type)
  hash = mix(hash, canonicalExtra(block.extraState))
  if (remarks) hash = mix(hash, block.icons?.comment?.text ?? "")
  if (depth < 400)
    for (const name of Object.keys(block.inputs ?? {}).sort()) {
      const input = block.inputs?.[name]
      let i = 0
      for (let b = input?.block ?? input?.shadow; b !== undefined; b = b.next?.block, i++) {
        const below = nodeOf(b, `${name}/${i}`, node, remarks, depth + 1)
        children.push(below)
        node.size += below.size
        hash = Math.imul(mix(hash, below.slot) ^ below.hash, 0x01000193)
      }
    }
  node.hash = hash | 0
  return node
}

/// FNV-1a, 32 bits.
function mix(hash: number, text: string): number {
  let h = hash
  for (let i = 0; i < text.length; i++) h = Math.imul(h ^ text.charCodeAt(i), 0x01000193)
  return Math.imul(h ^ 0x5f, 0x01000193)
}

function canonicalExtra(extra: Extra | undefined): string {
  return extra === undefined
    ? ""
    : canonical(Object.fromEntries(Object.entries(extra).filter(([k]) => !keysWithoutMeaning.has(k))))
}

function canonical(value: Json): string {
  if (Array.isArray(value)) return `[${value.map(canonical).join(",")}]`
  if (typeof value === "object" && value !== null)
    return `{${Object.keys(value)
      // Folded blocks have identifiers, which say nothing.
      .filter(k => k !== "id")
      .sort()
      .map(k => `${k}:${canonical((value as Extra)[k] ?? null)}`)
      .join(",")}}`
  return JSON.stringify(value)
}

/// For each block of `now` the block of `before` that it is, as far as there is one. Roots go together when their types allow.
function matchTrees(before: SavedBlock, now: SavedBlock): Map<SavedBlock, SavedBlock> {
  const old = nodeOf(before, "", undefined, false)
  const fresh = nodeOf(now, "", undefined, false)
  const matched = new Map<Node, Node>()
  const used = new Set<Node>()
  const pair = (n: Node, o: Node): void => {
    matched.set(n, o)
    used.add(o)
  }
  const pairWhole = (n: Node, o: Node): void => {
    pair(n, o)
    n.children.forEach((c, i) => {
      const other = o.children[i]
      if (other !== undefined) pairWhole(c, other)
    })
  }
  if (fresh.hash === old.hash) pairWhole(fresh, old)
  else {
    pair(fresh, old)
    equalSubtrees(old, fresh, matched, used, pairWhole)
    sameplaces(fresh, matched, used, pair)
  }
  const result = new Map<SavedBlock, SavedBlock>()
  for (const [n, o] of matched) if (n.block.type === o.block.type) result.set(n.block, o.block)
  return result
}

function everyNode(node: Node): Node[] {
  return [node, ...node.children.flatMap(everyNode)]
}

function equalSubtrees(
  old: Node,
  fresh: Node,
  matched: ReadonlyMap<Node, Node>,
  used: ReadonlySet<Node>,
  pairWhole: (n: Node, o: Node) => void,
): void {
  const byHash = new Map<number, Node[]>()
  for (const o of everyNode(old)) {
    const list = byHash.get(o.hash)
    if (list === undefined) byHash.set(o.hash, [o])
    else list.push(o)
  }
  // Single blocks wait: there are many equal numbers and names, and their place tells them apart.
  const candidates = everyNode(fresh).filter(n => n.size > 1)
  for (const n of candidates.sort((a, b) => b.size - a.size)) {
    if (matched.has(n)) continue
    const free = (byHash.get(n.hash) ?? []).filter(o => !used.has(o) && o.size === n.size)
    const path = pathOf(n)
    const best = free.find(o => pathOf(o) === path) ?? free[0]
    if (best !== undefined) pairWhole(n, best)
  }
}

function pathOf(node: Node): string {
  return node.parent === undefined ? "" : `${pathOf(node.parent)}.${node.slot}`
}

/// Below two matched blocks: children in the same slot; those of a stack in the order in which their types come again.
function sameplaces(
  fresh: Node,
  matched: Map<Node, Node>,
  used: ReadonlySet<Node>,
  pair: (n: Node, o: Node) => void,
): void {
  const queue = [fresh]
  for (let n = queue.shift(); n !== undefined; n = queue.shift()) {
    const o = matched.get(n)
    if (o !== undefined) {
      const free = (c: Node) => !used.has(c)
      for (const c of n.children)
        if (!matched.has(c)) {
          const input = c.slot.slice(0, c.slot.indexOf("/"))
          const same = o.children.filter(x => free(x) && x.block.type === c.block.type)
          const best =
            same.find(x => x.slot === c.slot && x.hash === c.hash) ??
            same.find(x => x.hash === c.hash) ??
            same.find(x => x.slot === c.slot) ??
            same.find(x => x.slot.startsWith(`${input}/`))
          if (best !== undefined) pair(c, best)
        }
    }
    queue.push(...n.children)
  }
}

/// `now` with the ids, folds and looks of the blocks of `before` that it goes on from.
export function transferIdentity(
  before: SavedBlock,
  now: SavedBlock,
): {block: SavedBlock; ids: ReadonlyMap<BlockId, BlockId>} {
  const matches = matchTrees(before, now)
  const ids = new Map<BlockId, BlockId>()
  const carry = (b: SavedBlock): SavedBlock => {
    const old = matches.get(b)
    const copy: SavedBlock = {...b}
    if (old?.id !== undefined) {
      if (b.id !== undefined) ids.set(b.id, old.id)
      copy.id = old.id
    }
    if (old?.collapsed !== undefined) copy.collapsed = old.collapsed
    if (old?.data !== undefined) copy.data = old.data
    const kept = Object.entries(old?.extraState ?? {}).filter(([k]) => presentationKeys.has(k))
    if (kept.length > 0) copy.extraState = {...b.extraState, ...Object.fromEntries(kept)}
    const comment = b.icons?.comment
    if (comment !== undefined) copy.icons = {comment: {...old?.icons?.comment, text: comment.text}}
    if (b.inputs !== undefined)
      copy.inputs = Object.fromEntries(
        Object.entries(b.inputs).map(([name, input]) => [
          name,
          input.block === undefined ? input : {block: carry(input.block)},
        ]),
      )
    if (b.next?.block !== undefined) copy.next = {block: carry(b.next.block)}
    return copy
  }
  const block = carry(now)
  if (before.x !== undefined) block.x = before.x
  if (before.y !== undefined) block.y = before.y
  return {block, ids}
}

/// How much of the smaller tree comes again in the other, from 0 to 1; for definitions that changed their name.
export function treeSimilarity(a: SavedBlock, b: SavedBlock): number {
  const matches = matchTrees(a, b)
  const [na, nb] = [nodeOf(a, "", undefined, false).size, nodeOf(b, "", undefined, false).size]
  return matches.size / Math.max(na, nb)
}
