/// Catalogue of library names with their types, for the text editor: completion, explanation, colour.

import type {Family} from "../../block_shape.ts"
import {library} from "../../types/environment/standard_library.ts"
import {asFunction, con, showScheme, type Type} from "../../types/syntax/type.ts"
import {familyOfType} from "./type_messages.ts"

export interface KnownName {
  readonly name: string
  /// `"type"` for a type or class, `"constructor"`, or `"value"`.
  readonly kind: "value" | "constructor" | "type"
  /// As Haskell writes it; for a type, its constructors.
  readonly type: string
  readonly family: Family
}

/// Every name of Rosy and the Prelude that blocks and programs use, in the order of their declarations.
export function knownNames(): readonly KnownName[] {
  return everyName().filter(n => /^[\p{L}_]/u.test(n.name))
}

/// Those of them that are Haskell's own, with their operators.
export function preludeNames(): readonly KnownName[] {
  return everyName()
    .filter(n => library.prelude.has(n.name))
    .sort((a, b) => (a.name < b.name ? -1 : a.name > b.name ? 1 : 0))
}

function everyName(): readonly KnownName[] {
  const values = [...library.values].map(
    ([name, scheme]): KnownName => ({
      name,
      kind: "value",
      type: showScheme(scheme),
      family: familyOfType(answer(scheme.type), "value") ?? "own",
    }),
  )
  const constructors = [...library.constructors].map(
    ([name, info]): KnownName => ({
      name,
      kind: "constructor",
      type: showScheme(info.scheme),
      family: familyOfType(answer(info.scheme.type), "pattern") ?? "own",
    }),
  )
  const types = [...library.types].map(
    ([name, entry]): KnownName => ({
      name,
      kind: "type",
      type: entry.constructors.join(" | "),
      family: familyOfType(con(name), "pattern") ?? "own",
    }),
  )
  return [...values, ...constructors, ...types]
}

/// What a function answers in the end.
function answer(type: Type): Type {
  const f = asFunction(type)
  return f === undefined ? type : answer(f.to)
}
