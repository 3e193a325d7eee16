/// Type environment extended by a program's imports and by declarations that stay Haskell text.

import type {Import} from "../../source/imports.ts"
import type {Scheme, Type} from "../syntax/type.ts"
import {app, con, funs, variablesIn} from "../syntax/type.ts"
import {parseType} from "../syntax/type_parser.ts"
import type {ScannedDeclarations, WrittenType} from "./declaration_scanner.ts"
import type {ConstructorInfo, Environment, Instance, Library, Lookup, TypeEntry} from "./environment.ts"
import {OverlayMap, parseEnvironment, unknown} from "./environment.ts"
import {typeNamesIn} from "./kinds.ts"
import {modules} from "./modules.generated.ts"

/// What a module exports; undefined for an unknown module.
function exportsOf(name: string): Library | undefined {
  const text = modules[name]
  if (text === undefined) return undefined
  const known =
    read.get(name) ?? parseEnvironment(text.startsWith("=") ? (modules[text.slice(1)] ?? "") : text)
  read.set(name, known)
  return known
}

/// Modules that were read already; each says the same for ever.
const read = new Map<string, Library>()

/// `declared`: the types that the program declares as blocks. Imported functions over a type of the same name are left to GHC.
export function withImportedNames(
  base: Library,
  scanned: ScannedDeclarations,
  declared: readonly string[] = [],
): Environment {
  const {
    imports,
    values,
    types,
    classes,
    otherClasses,
    instances,
    families,
    extensions,
    moduleName,
    patterns,
  } = scanned
  const count =
    imports.length +
    values.size +
    types.length +
    classes.length +
    otherClasses.length +
    instances.length +
    families.length +
    patterns.length +
    extensions.size
  if (count === 0 && moduleName === undefined) return base
  const env = {
    ...base,
    values: new OverlayMap<Scheme>(base.values),
    constructors: new OverlayMap<ConstructorInfo>(base.constructors),
    types: new OverlayMap<TypeEntry>(base.types),
    instances: new OverlayMap<Lookup<Instance | "none">>(base.instances),
    fixed: new Set(base.fixed),
    hidden: new Set(base.hidden),
    open: false,
    qualifiers: new Set<string>(),
    written: new Set<string>(),
    ownClasses: new Set(classes),
    superclasses: scanned.superclasses,
    ownInstances: scanned.hasAllInstances
      ? new Map(classes.map(c => [c, instances.flatMap(i => (i.name === c ? [i.instance] : []))] as const))
      : undefined,
    moduleName,
    ownTypes: new Set([...declared, ...types.map(t => t.name)]),
    importedClasses: new Set(otherClasses),
    extensions,
    ranked: new Set(families),
  }
  const isComputed = (scheme: Scheme) => [...typeNamesIn(scheme.type)].some(name => env.ranked.has(name))
  for (const name of families) env.types.set(name, unreadType)
  for (const i of imports) addImport(env, i)
  if (env.open) leaveOpen(env, base, imports, extensions)
  // A program that names its own module tells its types from the Prelude's.
  for (const name of scanned.ownQualified) env.fixed.delete(name)
  for (const t of types) addType(env, t)
  for (const {name, labels} of patterns) {
    env.constructors.set(name, {...unknownConstructor(name), fieldNames: labels})
    for (const label of labels) env.values.set(label, unknown)
  }
  for (const [name, scheme] of values)
    env.values.set(name, scheme === undefined || isComputed(scheme) ? unknown : scheme)
  for (const {name, instance} of instances) {
    let head: Type = instance.type
    while (head.kind === "app") head = head.fn
    if (head.kind !== "con") continue
    const of = new OverlayMap<Instance | "none">(env.instances.get(name) ?? new Map<string, Instance>())
    of.set(head.name, instance)
    env.instances.set(name, of)
    env.written.add(`${name} ${head.name}`)
  }
  return env
}

interface MutableEnvironment {
  readonly values: OverlayMap<Scheme>
  readonly constructors: OverlayMap<ConstructorInfo>
  readonly types: OverlayMap<TypeEntry>
  readonly prelude: ReadonlySet<string>
  readonly fixed: Set<string>
  /// Types that a signature cannot name without a dot.
  readonly hidden: Set<string>
  readonly qualifiers: Set<string>
  /// Classes that are known and about which only GHC knows more.
  readonly importedClasses: Set<string>
  readonly ownTypes: ReadonlySet<string>
  open: boolean
}

function addImport(env: MutableEnvironment, i: Import): void {
  env.qualifiers.add(i.as)
  if (i.module === "Prelude" || i.module === "Rosy") {
    // What is asked for by name of module does not give way, what is left out does.
    if (i.module === "Prelude" && !i.qualified) for (const name of i.only ?? env.prelude) env.fixed.add(name)
    for (const name of i.hiding) env.fixed.delete(name)
    if (i.hiding.has(".."))
      for (const {constructors} of typesIn(env, i.hiding))
        for (const name of constructors) env.fixed.delete(name)
    return
  }
  const library = exportsOf(i.module)
  if (library === undefined) {
    // What `T(..)` brings along is not known either.
    if (i.only?.has("..") !== false) env.open ||= !i.qualified
    for (const name of i.only ?? []) addUnknown(env, name, i)
    return
  }
  const taken = (name: string, of?: string) =>
    !i.hiding.has(name) &&
    (i.only === undefined || i.only.has(name) || (of !== undefined && i.only.has(of) && i.only.has("..")))
  const put = <V>(table: OverlayMap<V>, name: string, value: V) => {
    table.set(`${i.as}.${name}`, value)
    if (!i.qualified) table.set(name, value)
  }
  const isAboutOwn = (scheme: Scheme) =>
    env.ownTypes.size > 0 && [...typeNamesIn(scheme.type)].some(t => env.ownTypes.has(t))
  const fields = new Set(
    [...library.constructors].flatMap(([name, {of, fieldNames}]) => (taken(name, of) ? fieldNames : [])),
  )
  for (const [name, scheme] of library.values)
    if (taken(name) || fields.has(name)) put(env.values, name, isAboutOwn(scheme) ? unknown : scheme)
  for (const [name, info] of library.constructors)
    if (taken(name, info.of))
      put(env.constructors, name, isAboutOwn(info.scheme) ? unknownConstructor(name) : info)
  for (const [name] of library.classes) if (!i.qualified && taken(name)) env.importedClasses.add(name)
  // A type's name is needed to understand other types, whether or not a program may write it.
  for (const [name, entry] of library.types) {
    const named = !i.qualified && taken(name)
    if (named) env.hidden.delete(name)
    if (env.types.has(name)) continue
    env.types.set(name, {...entry, foreign: true})
    if (!named) env.hidden.add(name)
  }
  // Names whose types go beyond what is read here, and classes with their members.
  for (const name of i.only ?? [])
    if (!library.values.has(name) && !library.types.has(name)) {
      addUnknown(env, name, i)
      if (i.only?.has("..") === true && /^\p{Lu}/u.test(name)) env.open ||= !i.qualified
    }
}

function typesIn(env: MutableEnvironment, names: Iterable<string>): TypeEntry[] {
  return [...names].flatMap(name => env.types.get(name) ?? [])
}

/// What a module that is not read may bring instead: names of Rosy, and those of the Prelude that are left out. GHC would not know which of two
/// names is meant if both were in scope.
function leaveOpen(
  env: MutableEnvironment,
  base: Library,
  imports: readonly Import[],
  extensions: ReadonlySet<string>,
): void {
  const prelude = imports.filter(i => i.module === "Prelude")
  const isWithout = prelude.length === 0 && extensions.has("NoImplicitPrelude")
  const isIn = (name: string) =>
    base.prelude.has(name) &&
    !isWithout &&
    (prelude.length === 0 || prelude.some(i => i.only?.has(name) ?? !i.hiding.has(name)))
  for (const [name, scheme] of base.values)
    if (!isIn(name) && env.values.get(name) === scheme) env.values.set(name, unknown)
  for (const [name, info] of base.constructors)
    if (!base.prelude.has(name) && env.constructors.get(name) === info)
      env.constructors.set(name, unknownConstructor(name))
  for (const [name, entry] of base.types)
    if (!isIn(name) && env.types.get(name) === entry) env.types.set(name, unreadType)
}

/// A type of which only the name is known.
const unreadType: TypeEntry = {parameters: [], constructors: [], own: false, foreign: true, isUnread: true}

function addUnknown(env: MutableEnvironment, name: string, i: Import): void {
  if (!i.qualified) env.hidden.delete(name)
  const names = [`${i.as}.${name}`, ...(i.qualified ? [] : [name])]
  for (const n of names) {
    if (/^(?:.*\.)?[\p{Lu}:]/u.test(n)) {
      if (!env.constructors.has(n)) env.constructors.set(n, unknownConstructor(n))
      if (!env.types.has(n)) env.types.set(n, unreadType)
    } else env.values.set(n, unknown)
  }
}

function unknownConstructor(name: string): ConstructorInfo {
  return {name, scheme: unknown, fields: [], fieldNames: [], of: "?"}
}

/// A type that is written as text: its constructors as far as their parts are plain.
function addType(env: MutableEnvironment, t: WrittenType): void {
  env.types.set(t.name, {
    parameters: t.parameters,
    constructors: t.constructors.map(c => c.name),
    own: false,
    foreign: true,
    ...(t.isSynonym === true ? {isUnread: true} : {}),
  })
  const result = app(con(t.name), ...t.parameters.map((p): Type => ({kind: "var", name: p})))
  for (const c of t.constructors) {
    const fields = c.fields?.map(f => parseType(f.type))
    const plain = fields?.every(
      f => f !== undefined && [...variablesIn(f)].every(v => t.parameters.includes(v)),
    )
    if (fields === undefined || plain !== true) {
      const labels = [...(c.labels ?? []), ...(c.fields ?? []).flatMap(f => f.name ?? [])]
      env.constructors.set(c.name, {...unknownConstructor(c.name), fieldNames: labels})
      for (const label of labels) env.values.set(label, unknown)
      continue
    }
    const types = fields as Type[]
    env.constructors.set(c.name, {
      name: c.name,
      scheme: {variables: t.parameters, constraints: [], type: funs(types, result)},
      fields: types,
      fieldNames: c.fields?.map(f => f.name) ?? [],
      of: t.name,
    })
    c.fields?.forEach((f, at) => {
      const type = types[at]
      if (f.name !== undefined && type !== undefined)
        env.values.set(f.name, {variables: t.parameters, constraints: [], type: funs([result], type)})
    })
  }
}
