/// Names in scope at a place.

import type {Checker, InScope} from "../../api.ts"
import {bindersInDeclaration} from "../../model/name_resolution.ts"
import type {Constructor, Program} from "../../model/syntax_tree.ts"
import type {Place, SavedBlock, SavedWorkspace} from "../../serialized_blocks.ts"
import {showScheme} from "../../types/syntax/type.ts"
import {InferenceSession} from "../inference/inference_session.ts"
import {familyOfType} from "../inference/type_messages.ts"
import {find, without} from "./block_moves.ts"
import {arityOf, template} from "./definition_references.ts"
import {checker, itemAt} from "./drop_checker.ts"

/// The names that a program's author brought into scope at a socket, nearest first, and the constructors of the program's own
/// types; what fits comes first.
export function namesInScope(
  workspace: SavedWorkspace,
  place: Place,
  session = new InferenceSession(),
): InScope[] {
  if ("below" in place) return []
  const inside = find(workspace, place.block)?.inputs?.[place.input]?.block?.id
  const open = inside === undefined ? workspace : without(workspace, inside)
  const {inference, globals, read} = session.inferWorkspace(open, {watch: place})
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
  if (inference.watched === undefined) return []
  const scope = inference.watched
  const runs = find(workspace, place.block)?.type === "main"
  const names = scope.all().filter(([name]) => name !== "main")
  const own = new Set(program.declarations.flatMap(bindersInDeclaration).map(([name]) => name))
  const found = names.map(([name, inner]): InScope => {
    // A top-level name that nothing nearer hides has its final, general type by now.
    const local = !own.has(name) || (inner !== globals.get(name) && !inference.placeholders.has(inner))
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
