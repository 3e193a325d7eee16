/// Names: which are known at a place, and how one is renamed together with all that refers to it.

import type {Checker, InScope, Renaming} from "../api.ts"
import {readWorkspace} from "../blocks/read.ts"
import {isConstructorName, isOperator, isVariableName, reservedWords} from "../haskell/lexemes.ts"
import {nameOf} from "../model/names.ts"
import type {Constructor, Declaration, Program} from "../model/tree.ts"
import type {Use} from "../model/uses.ts"
import {bindersInDeclaration, usesInExpr, usesInProgram} from "../model/uses.ts"
import type {BlockId, Extra, Json, Place, SavedBlock, SavedWorkspace} from "../saved.ts"
import {setIn} from "../shape.ts"
import type {Scheme} from "../types/type.ts"
import {asFunction, showScheme} from "../types/type.ts"
import {familyOfType} from "../types/words.ts"
import {words} from "../words/index.ts"
import {checker, itemAt} from "./check.ts"
import {everyBlock, solve} from "./infer.ts"
import {find, without} from "./plug.ts"
import {Session} from "./session.ts"

/// The names that a program's author brought into scope at a socket, nearest first, and the constructors of the program's own
/// types; what fits comes first.
export function namesInScope(workspace: SavedWorkspace, place: Place, session = new Session()): InScope[] {
  if ("below" in place) return []
  const inside = find(workspace, place.block)?.inputs?.[place.input]?.block?.id
  const open = inside === undefined ? workspace : without(workspace, inside)
  const {inferrer, globals, read} = session.solve(open, place)
  const {program} = read
  const check = checker(open, session)
  const target = find(open, place.block)
  const item = target === undefined ? undefined : itemAt(target, place.input)
  const constructors = constructorsAt(
    place,
    program,
    item?.sort === "pattern" ? "pattern_construct" : "construct",
    check,
  )
  if (item?.sort === "pattern") return fittingFirst(constructors)
  if (inferrer.watched === undefined) return []
  const scope = inferrer.watched
  const runs = find(workspace, place.block)?.type === "main"
  const names = scope.all().filter(([name]) => name !== "main")
  const own = new Set(program.declarations.flatMap(bindersInDeclaration).map(([name]) => name))
  const found = names.map(([name, inner]): InScope => {
    // A top-level name that nothing nearer hides has its final, general type by now.
    const local = !own.has(name) || (inner !== globals.get(name) && !inferrer.placeholders.has(inner))
    const scheme = local ? inner : (globals.get(name) ?? inner)
    const block = template(name, local ? 0 : arityOf(scheme))
    const bare = template(name, 0)
    // What a program runs are functions as they are; anywhere else a function is mostly wanted for its answer.
    const fitting = (runs ? [bare, block] : [block, bare]).find(b => check.fits(place, b).fits)
    return {
      name,
      type: showScheme(scheme),
      family: familyOfType(scheme.type, "value") ?? "own",
      block: fitting ?? block,
      fits: fitting !== undefined,
    }
  })
  return fittingFirst([...found, ...constructors])
}

function fittingFirst(names: readonly InScope[]): InScope[] {
  return [...names.filter(n => n.fits), ...names.filter(n => !n.fits)]
}

/// The program's own constructors, as values or as patterns.
function constructorsAt(
  place: Place,
  program: Program,
  type: "construct" | "pattern_construct",
  check: Checker,
): InScope[] {
  return program.declarations.flatMap(d =>
    d.kind !== "data"
      ? []
      : d.constructors.flatMap(c => {
          const of = [d.name, ...d.parameters].join(" ")
          const blocks: readonly (readonly [string, SavedBlock])[] = [
            [c.name, {type, extraState: {con: c.name, args: c.fields.length}}],
            ...byParts(c, type),
          ]
          return blocks.map(
            ([name, block]): InScope => ({
              name,
              type: of,
              family: "own",
              block,
              fits: check.fits(place, block).fits,
            }),
          )
        }),
  )
}

/// A constructor with named parts can also be made, changed or looked at by their names.
function byParts(c: Constructor, type: "construct" | "pattern_construct"): (readonly [string, SavedBlock])[] {
  const fields = c.fields.flatMap(f => f.name ?? [])
  if (fields.length === 0 || fields.length < c.fields.length) return []
  const whole = `${c.name} {${fields.join(", ")}}`
  if (type === "pattern_construct")
    return [[whole, {type: "pattern_record", extraState: {con: c.name, fields}}]]
  return [
    [whole, {type: "record", extraState: {con: c.name, fields}}],
    ...fields.map(f => [`{${f} = …}`, {type: "update", extraState: {fields: [f]}}] as const),
  ]
}

function template(name: string, args: number): SavedBlock {
  return {type: "name", extraState: {name, args, ...(args > 0 ? {fn: true} : {})}}
}

function arityOf(scheme: Scheme): number {
  let count = 0
  for (let f = asFunction(scheme.type); f !== undefined; f = asFunction(f.to)) count++
  return Math.min(count, 9)
}

/// Renames what a block defines or names, at `key` of its `extraState`, and every block that refers to it.
export function rename(workspace: SavedWorkspace, block: BlockId, key: string, name: string): Renaming {
  const binder = find(workspace, block)
  if (binder === undefined) return {ok: false, why: words.renaming.thisBlockIsGone}
  if (key === "name" && (binder.type === "data" || binder.type === "synonym"))
    return renameType(workspace, binder, name)
  if (binder.type === "data") return renamePart(workspace, binder, key, name)
  if (reservedWords.has(name)) return {ok: false, why: words.renaming.isOneOfHaskellsOwnWords(name)}
  // Only what is defined may be an operator; a pattern gives names.
  if (!isVariableName(name) && !(isOperator(name) && binder.type === "define"))
    return {ok: false, why: words.renaming.aNameIsOneWordThatStarts}
  const old = textAt(binder.extraState ?? {}, key)
  const changes = new Map<BlockId, Extra>([[block, setIn(binder.extraState ?? {}, key, name)]])
  const before = usesIn(workspace)
  for (const use of before) {
    const user = use.node.from?.block
    if (user === undefined || use.name !== old || binderBlock(use) !== block) continue
    const node = find(workspace, user)
    if (node !== undefined)
      changes.set(user, renameUse(changes.get(user) ?? node.extraState ?? {}, use, name))
  }
  const renamed = mapExtras(workspace, changes)
  if (moved(before, usesIn(renamed)))
    return {ok: false, why: words.renaming.alreadyMeansSomethingElseWhereThisName(name)}
  if (definedTwice(renamed, name))
    return {ok: false, why: words.renaming.thereIsAnotherDefinitionCalled(name)}
  return unlessWrong(workspace, renamed, changes, name)
}

/// Whether a use means another binder than before.
function moved(before: readonly Use[], after: readonly Use[]): boolean {
  return (
    before.length !== after.length ||
    after.some(
      (use, i) => binderBlock(use) !== (before[i] === undefined ? undefined : binderBlock(before[i])),
    )
  )
}

/// The changes, unless the program would have a problem that it does not have now.
function unlessWrong(
  before: SavedWorkspace,
  after: SavedWorkspace,
  changes: ReadonlyMap<BlockId, Extra>,
  name: string,
): Renaming {
  const problems = solve(after).inferrer.problems
  if (problems.length > solve(before).inferrer.problems.length) {
    if (problems.some(p => p.kind === "taken" && p.name === name))
      return {ok: false, why: words.renaming.haskellItselfHasAAlready(name)}
    const foreign = problems.find(p => p.kind === "no-method" && p.name === name)
    if (foreign?.kind === "no-method") return {ok: false, why: words.types.isNoPartOf(name, foreign.of)}
    return {ok: false, why: words.renaming.thereIsAnotherAlready(name)}
  }
  return {ok: true, changes: [...changes].map(([block, extra]) => ({block, extra}))}
}

/// Renames what a block names or defines, wherever it says so: what F2 does in the text. Answers like `rename`.
export function renameNamed(workspace: SavedWorkspace, block: BlockId, old: string, name: string): Renaming {
  const use = usesIn(workspace).find(u => u.node.from?.block === block && u.name === old)
  const binder = use === undefined ? block : binderBlock(use)
  if (binder === undefined) return {ok: false, why: words.renaming.isNotOfThisProgramSo(old)}
  const found = find(workspace, binder)
  const key = keyOf(found?.extraState ?? {}, old)
  if (found?.type === "data" && key === "name")
    return {ok: false, why: words.renaming.aTypeIsRenamedInItsBlock}
  if (key === undefined) {
    const made = [...everyBlock(workspace)].find(
      b => b.type === "data" && b.id !== undefined && keyOf(b.extraState ?? {}, old) !== undefined,
    )
    const part = made === undefined ? undefined : keyOf(made.extraState ?? {}, old)
    if (made?.id === undefined || part === undefined || part === "name")
      return {ok: false, why: words.renaming.cannotBeRenamedFrom(old)}
    return rename(workspace, made.id, part, name)
  }
  return rename(workspace, binder, key, name)
}

/// The path in `extraState` at which a name stands that the block brings into scope.
function keyOf(extra: Extra, name: string, path = ""): string | undefined {
  for (const [key, value] of Object.entries(extra)) {
    const here = `${path}${key}`
    if (value === name && (key === "name" || /^(?:\d+|as)$/.test(key))) return here
    if (typeof value === "object" && value !== null) {
      const inner = keyOf(value as Extra, name, `${here}.`)
      if (inner !== undefined) return inner
    }
  }
  return undefined
}

function textAt(extra: Extra, key: string): Json | undefined {
  let at: Json | undefined = extra
  for (const step of key.split(".")) at = (at as Extra | undefined)?.[step]
  return at
}

function renameUse(extra: Extra, use: Use, name: string): Extra {
  if (use.node.kind === "raw") return setIn(extra, "text", replaceWord(use.node.text, use.name, name))
  return setIn(extra, use.node.kind === "infix" || use.node.kind === "section" ? "op" : "name", name)
}

function replaceWord(text: string, old: string, name: string): string {
  return text.replace(/(?<![\p{L}\p{N}_'])[\p{L}_][\p{L}\p{N}_']*/gu, word => (word === old ? name : word))
}

/// A constructor of a data type, or a field of one, and every block that says its name.
function renamePart(workspace: SavedWorkspace, data: SavedBlock, key: string, name: string): Renaming {
  const old = textAt(data.extraState ?? {}, key)
  const isConstructor = /^constructors\.\d+\.name$/.test(key)
  if (isConstructor && !isConstructorName(name))
    return {ok: false, why: words.renaming.thisNameIsOneWordThatStarts}
  if (!isConstructor && !isVariableName(name))
    return {ok: false, why: words.renaming.aNameIsOneWordThatStarts}
  const {program} = readWorkspace(workspace)
  const taken = program.declarations.some(
    d =>
      (d.kind === "function" && d.name === name) ||
      (d.kind === "data" && d.constructors.some(c => c.name === name || c.fields.some(f => f.name === name))),
  )
  if (taken && name !== old) return {ok: false, why: words.renaming.thereIsAnotherAlready(name)}
  const changes = new Map<BlockId, Extra>()
  const before = usesIn(workspace)
  // Blocks whose name is bound nearer by, and only reads like the field's.
  const others = new Set(
    before.filter(u => u.name === old && u.binder !== undefined).map(u => u.node.from?.block),
  )
  for (const b of everyBlock(workspace)) {
    if (b.id === undefined) continue
    const extra = b.extraState ?? {}
    const next =
      b.id === data.id
        ? setIn(extra, key, name)
        : b.type === "name" && others.has(b.id)
          ? extra
          : renamedPart(b, extra, String(old), name, isConstructor)
    if (JSON.stringify(next) !== JSON.stringify(extra)) changes.set(b.id, next)
  }
  const renamed = mapExtras(workspace, changes)
  return moved(before, usesIn(renamed))
    ? {ok: false, why: words.renaming.alreadyMeansSomethingElseWhereThisName(name)}
    : unlessWrong(workspace, renamed, changes, name)
}

function renamedPart(b: SavedBlock, extra: Extra, old: string, name: string, isConstructor: boolean): Extra {
  const {fields, text} = extra
  return {
    ...extra,
    ...(isConstructor && extra.con === old ? {con: name} : {}),
    ...(b.type === "name" && extra.name === old ? {name} : {}),
    ...(!isConstructor && Array.isArray(fields) ? {fields: fields.map(f => (f === old ? name : f))} : {}),
    ...(b.type.startsWith("raw_") && typeof text === "string" ? {text: replaceWord(text, old, name)} : {}),
  }
}

/// A type, and every type that is written somewhere and says its name.
function renameType(workspace: SavedWorkspace, block: SavedBlock, name: string): Renaming {
  const old = textAt(block.extraState ?? {}, "name")
  if (!isConstructorName(name)) return {ok: false, why: words.renaming.thisNameIsOneWordThatStarts}
  const {declarations} = readWorkspace(workspace).program
  const taken = declarations.some(d => (d.kind === "data" || d.kind === "synonym") && d.name === name)
  if (taken && name !== old) return {ok: false, why: words.renaming.thereIsAnotherAlready(name)}
  // Haskell of the program's own says types and constructors alike.
  const alike = declarations.some(d => d.kind === "data" && d.constructors.some(c => c.name === old))
  const changes = new Map<BlockId, Extra>()
  for (const b of everyBlock(workspace)) {
    if (b.id === undefined) continue
    const extra = b.extraState ?? {}
    const next = b.id === block.id ? setIn(extra, "name", name) : extra
    const renamed = renamedTypes(b.type, next, String(old), name, alike) as Extra
    if (JSON.stringify(renamed) !== JSON.stringify(extra)) changes.set(b.id, renamed)
  }
  return unlessWrong(workspace, mapExtras(workspace, changes), changes, name)
}

/// What a block says about itself, with a type's new name wherever a type is written.
function renamedTypes(kind: string, said: Json, old: string, name: string, alike: boolean): Json {
  if (Array.isArray(said)) return said.map(one => renamedTypes(kind, one, old, name, alike))
  if (typeof said !== "object" || said === null) return said
  return Object.fromEntries(
    Object.entries(said).map(([key, value]) => {
      const isType =
        key === "type" ||
        key === "signature" ||
        (key === "text" && (kind === "raw_type" || (kind.startsWith("raw_") && !alike)))
      if (isType && typeof value === "string") return [key, replaceWord(value, old, name)]
      return [key, value === undefined ? value : renamedTypes(kind, value, old, name, alike)]
    }),
  ) as Extra
}

function binderBlock(use: Use): BlockId | undefined {
  return use.binder?.from?.block
}

function usesIn(workspace: SavedWorkspace): Use[] {
  const {program, loose} = readWorkspace(workspace)
  return [
    ...usesInProgram(program.declarations),
    ...loose.flatMap(l => (l.kind === "expression" ? usesInExpr(l.expr) : [])),
  ]
}

function definedTwice(workspace: SavedWorkspace, name: string): boolean {
  const {program} = readWorkspace(workspace)
  const defines = (d: Declaration) => d.kind === "function" && nameOf(d) === name
  return program.declarations.filter(defines).length > 1
}

function mapExtras(workspace: SavedWorkspace, changes: ReadonlyMap<BlockId, Extra>): SavedWorkspace {
  const copy = structuredClone(workspace)
  for (const b of everyBlock(copy)) {
    const extra = b.id === undefined ? undefined : changes.get(b.id)
    if (extra !== undefined) b.extraState = extra
  }
  return copy
}
