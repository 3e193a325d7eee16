/// What the pane knows of names: the program's own, those of every program, and the types of places, as the compiler told them last.

import {type Extension, StateEffect, StateField} from "@codemirror/state"
import {type KnownName, knownNames} from "@rosy/codegen"
import type {Declared, TypesAtPlaces} from "../state/messages.ts"

export interface Told {
  readonly declared: readonly Declared[]
  /// The types of places in `text`.
  readonly types: TypesAtPlaces & {readonly text: string}
}

export const setTold = StateEffect.define<Told>()

export const told = StateField.define<Told>({
  create: () => ({declared: [], types: {text: "", names: [], at: []}}),
  update(value, transaction) {
    for (const effect of transaction.effects) if (effect.is(setTold)) return effect.value
    return value
  },
})

export const known: readonly KnownName[] = knownNames()
const byName = new Map<string, KnownName[]>()
for (const n of known) byName.set(n.name, [...(byName.get(n.name) ?? []), n])

/// What every program knows under a name: a type and a constructor may share one.
export function knownAs(name: string): readonly KnownName[] {
  return byName.get(name) ?? []
}

/// The type of a value by its name; the program's own names come first.
export function typeOfName(declared: readonly Declared[], name: string): string | undefined {
  return declared.find(d => d.name === name)?.type ?? knownAs(name).find(n => n.kind !== "type")?.type
}

export const knowledge: Extension = told
