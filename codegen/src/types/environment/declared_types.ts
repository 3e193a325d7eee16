/// Type environment extended by a program's own types and their instances.

import type {DataDeclaration, SynonymDeclaration} from "../../model/syntax_tree.ts"
import type {Type} from "../syntax/type.ts"
import {app, con, TypeTooLarge} from "../syntax/type.ts"
import {isHigherRank, parseType, withQualifiersApart} from "../syntax/type_parser.ts"
import type {Environment, Instance, Lookup, MutableEnvironment, MutableLookup} from "./environment.ts"
import {addData, addInstance, expand, OverlayMap, unknown} from "./environment.ts"
import {reduce} from "./unification.ts"

/// Classes that every type of the program's own belongs to: Rosy adds the instances (rosy-hs/src/Rosy/Program.hs).
const givenToOwn = ["Sensor", "Command", "Default"]

/// Classes that a type of the program's own gets when it needs them, if all it is made of has them; the printer writes
/// `deriving` then.
export const derivable = ["Eq", "Ord", "Show"]

/// The environment with a program's own types. What a program declares wins over a library's name.
export function withDeclaredTypes(
  base: Environment,
  declarations: readonly (DataDeclaration | SynonymDeclaration)[],
): Environment {
  const {moduleName} = base
  const written = base.written ?? new Set<string>()
  const ranked = rankedIn(declarations, base.ranked)
  const ownTypes = new Set([...(base.ownTypes ?? []), ...declarations.map(d => d.name)])
  const instances = new OverlayMap<MutableLookup<Instance | "none">>(
    base.instances as Lookup<MutableLookup<Instance | "none">>,
  )
  for (const name of [
    ...givenToOwn,
    ...derivable,
    ...declarations.flatMap(d => (d.kind === "data" ? d.deriving : [])),
  ])
    instances.set(name, new OverlayMap(base.instances.get(name) ?? new Map<string, Instance>()))
  const env: MutableEnvironment = {
    values: new OverlayMap(base.values),
    constructors: new OverlayMap(base.constructors),
    types: new OverlayMap(base.types),
    classes: base.classes as MutableLookup<readonly string[]>,
    hidden: new Set(base.hidden),
    prelude: base.prelude,
    fixed: base.fixed,
    needs: new Set(),
    assumed: [],
    instances,
    fields: new Set(
      declarations.flatMap(d =>
        d.kind === "data" ? d.constructors.flatMap(c => c.fields.flatMap(f => f.name ?? [])) : [],
      ),
    ),
    open: base.open ?? false,
    qualifiers: base.qualifiers ?? new Set<string>(),
    written,
    ownTypes,
    ownClasses: base.ownClasses ?? new Set<string>(),
    superclasses: base.superclasses ?? new Map<string, readonly string[]>(),
    ownInstances: base.ownInstances,
    derived: new Set(
      declarations.flatMap(d =>
        d.kind === "data" ? d.deriving.map(of => `${of.replace(/^.*[. ]/, "")} ${d.name}`) : [],
      ),
    ),
    moduleName,
    importedClasses: base.importedClasses ?? new Set<string>(),
    extensions: base.extensions ?? new Set<string>(),
    ranked,
  }
  for (const d of declarations) {
    env.hidden.delete(d.name)
    if (d.kind === "synonym") {
      const synonym = parseType(withQualifiersApart(d.type.text, {ownTypes, moduleName}))
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
        fields: c.fields.map(f => ({
          name: f.name,
          type: isHigherRank(f.type.text, ranked)
            ? "forall"
            : withQualifiersApart(f.type.text, {ownTypes, moduleName}),
        })),
      })),
      true,
    )
    const type = app(con(d.name), ...d.parameters.map((p): Type => ({kind: "var", name: p})))
    const perParameter = (name: string) =>
      d.parameters.map(p => ({name, type: {kind: "var", name: p} as Type}))
    for (const name of givenToOwn) addInstance(env, name, {constraints: perParameter("Value"), type})
    for (const name of new Set([...derivable, ...d.deriving]))
      if (!written.has(`${name} ${d.name}`)) addInstance(env, name, derivedInstance(name, d))
  }
  // With DuplicateRecordFields, only GHC finds out whose field a name is.
  for (const name of sharedFields(declarations)) env.values.set(name, unknown)
  dropUnderivable(env, declarations)
  return env
}

/// Names of fields that several types have.
function sharedFields(declarations: readonly (DataDeclaration | SynonymDeclaration)[]): string[] {
  const all = declarations.flatMap(d =>
    d.kind === "data" ? [...new Set(d.constructors.flatMap(c => c.fields.flatMap(f => f.name ?? [])))] : [],
  )
  return all.filter((name, at) => all.indexOf(name) < at)
}

/// Classes of type constructors: a derived instance is about the type without its last parameter.
const constructorClasses: ReadonlySet<string> = new Set(
  "Functor Foldable Traversable Applicative Alternative Monad MonadPlus MonadFail MonadFix MonadIO".split(
    " ",
  ),
)

/// The instance that `deriving` makes. Which constraints a class of a type constructor asks of the other parameters depends on the fields,
/// and GHC checks those.
function derivedInstance(name: string, {name: of, parameters}: DataDeclaration): Instance {
  const variable = (p: string): Type => ({kind: "var", name: p})
  return constructorClasses.has(name)
    ? {constraints: [], type: app(con(of), ...parameters.slice(0, -1).map(variable))}
    : {
        constraints: parameters.map(p => ({name, type: variable(p)})),
        type: app(con(of), ...parameters.map(variable)),
      }
}

/// Names for types with variables of their own inside, also by way of another such name.
function rankedIn(
  declarations: readonly (DataDeclaration | SynonymDeclaration)[],
  families: ReadonlySet<string> = new Set(),
): ReadonlySet<string> {
  const ranked = new Set(families)
  for (let before = -1; before < ranked.size; ) {
    before = ranked.size
    for (const d of declarations)
      if (d.kind === "synonym" && isHigherRank(d.type.text, ranked)) ranked.add(d.name)
  }
  return ranked
}

/// Whether a type of a field may belong to a class; of one that is too large, only GHC knows.
function mayBelong(name: string, field: Type, env: Environment): boolean {
  try {
    return reduce({name, type: expand(field, env)}, env).kind === "stuck"
  } catch (e) {
    if (e instanceof TypeTooLarge) return true
    throw e
  }
}

/// A type cannot be compared when something it is made of cannot. Taking one away may take others with it.
function dropUnderivable(
  env: MutableEnvironment,
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
        const all = fields.every(f => mayBelong(name, f, env))
        if (all) continue
        env.instances.get(name)?.set(d.name, "none")
        again = true
      }
    }
  }
  env.needs.clear()
  env.assumed.length = 0
}
