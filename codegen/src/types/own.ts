/// An environment with a program's own types, and what they can do.

import type {DataDeclaration, SynonymDeclaration} from "../model/tree.ts"
import type {Environment, Growing, Instance, Lookup, Table} from "./environment.ts"
import {addData, addInstance, expand, Layer} from "./environment.ts"
import {beyond, parseType} from "./parse.ts"
import {reduce} from "./solve.ts"
import type {Type} from "./type.ts"
import {app, con} from "./type.ts"

/// Classes that every type of the program's own belongs to: Rosy adds the instances (rosy-hs/src/Rosy/Program.hs).
const givenToOwn = ["Sensor", "Command", "Default"]

/// Classes that a type of the program's own gets when it needs them, if all it is made of has them; the printer writes
/// `deriving` then.
const derivable = ["Eq", "Ord", "Show"]

/// The environment with a program's own types. What a program declares wins over a library's name.
export function withTypes(
  base: Environment,
  declarations: readonly (DataDeclaration | SynonymDeclaration)[],
): Environment {
  const written = base.written ?? new Set<string>()
  const instances = new Layer<Table<Instance | "none">>(base.instances as Lookup<Table<Instance | "none">>)
  for (const name of [
    ...givenToOwn,
    ...derivable,
    ...declarations.flatMap(d => (d.kind === "data" ? d.deriving : [])),
  ])
    instances.set(name, new Layer(base.instances.get(name) ?? new Map<string, Instance>()))
  const env: Growing = {
    values: new Layer(base.values),
    constructors: new Layer(base.constructors),
    types: new Layer(base.types),
    classes: base.classes as Table<readonly string[]>,
    hidden: new Set(base.hidden),
    prelude: base.prelude,
    fixed: base.fixed,
    needs: new Set(),
    instances,
    fields: new Set(
      declarations.flatMap(d =>
        d.kind === "data" ? d.constructors.flatMap(c => c.fields.flatMap(f => f.name ?? [])) : [],
      ),
    ),
    open: base.open ?? false,
    qualifiers: base.qualifiers ?? new Set<string>(),
    written,
    ownClasses: base.ownClasses ?? new Set<string>(),
    ranked: rankedIn(declarations),
  }
  for (const d of declarations) {
    env.hidden.delete(d.name)
    if (d.kind === "synonym") {
      const synonym = parseType(d.type.text)
      env.types.set(d.name, {
        parameters: d.parameters,
        constructors: [],
        ...(synonym === undefined ? {} : {synonym}),
        own: true,
      })
      continue
    }
    addData(
      env,
      d.name,
      d.parameters,
      d.constructors.map(c => ({
        name: c.name,
        fields: c.fields.map(f => ({name: f.name, type: f.type.text})),
      })),
      true,
    )
    const type = app(con(d.name), ...d.parameters.map((p): Type => ({kind: "var", name: p})))
    const perParameter = (name: string) =>
      d.parameters.map(p => ({name, type: {kind: "var", name: p} as Type}))
    for (const name of givenToOwn) addInstance(env, name, {constraints: perParameter("Value"), type})
    for (const name of new Set([...derivable, ...d.deriving]))
      if (!written.has(`${name} ${d.name}`)) addInstance(env, name, {constraints: perParameter(name), type})
  }
  dropUnderivable(env, declarations)
  return env
}

/// Names for types with variables of their own inside, also by way of another such name.
function rankedIn(declarations: readonly (DataDeclaration | SynonymDeclaration)[]): ReadonlySet<string> {
  const ranked = new Set<string>()
  for (let before = -1; before < ranked.size; ) {
    before = ranked.size
    for (const d of declarations) if (d.kind === "synonym" && beyond(d.type.text, ranked)) ranked.add(d.name)
  }
  return ranked
}

/// A type cannot be compared when something it is made of cannot. Taking one away may take others with it.
function dropUnderivable(
  env: Growing,
  declarations: readonly (DataDeclaration | SynonymDeclaration)[],
): void {
  for (let again = true; again; ) {
    again = false
    for (const d of declarations) {
      if (d.kind !== "data") continue
      for (const name of derivable) {
        if (d.deriving.includes(name) || env.written?.has(`${name} ${d.name}`) === true) continue
        if (env.instances.get(name)?.get(d.name) === "none") continue
        const fields = d.constructors.flatMap(c => env.constructors.get(c.name)?.fields ?? [])
        const all = fields.every(f => reduce({name, type: expand(f, env)}, env).kind === "stuck")
        if (all) continue
        env.instances.get(name)?.set(d.name, "none")
        again = true
      }
    }
  }
  env.needs.clear()
}
