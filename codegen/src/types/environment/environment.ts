/// What names mean before a program says anything: values, constructors, types, classes and instances.
///
/// An environment is read from declarations as Haskell writes them, one a line, and grows by a program's own types.

import type {Constraint, Scheme, Type} from "../syntax/type.ts"
import {
  app,
  con,
  funs,
  mostLevels,
  mostNodes,
  spine,
  substitute,
  TypeTooLarge,
  variablesIn,
} from "../syntax/type.ts"
import {parseScheme, parseSignature, parseType} from "../syntax/type_parser.ts"

export interface ConstructorInfo {
  readonly name: string
  readonly scheme: Scheme
  readonly fields: readonly Type[]
  readonly fieldNames: readonly (string | undefined)[]
  /// The type it makes values of.
  readonly of: string
}

export interface TypeEntry {
  readonly parameters: readonly string[]
  readonly constructors: readonly string[]
  /// For `type A = B`.
  readonly synonym?: Type | undefined
  /// Declared by the program itself.
  readonly own: boolean
  /// From an import or from text: which classes it belongs to is GHC's business, unless an instance is known.
  readonly foreign?: boolean
  /// Only GHC knows what it stands for: it may be another name for any type.
  readonly isUnread?: boolean
}

export interface Instance {
  readonly constraints: readonly Constraint[]
  readonly type: Type
}

/// For a name of which only GHC knows the type: it fits everywhere.
export const unknown: Scheme = {variables: [], constraints: [], type: con("?"), unknown: true}

/// Maximum number of fields of a constructor that is inferred: each is a level of its type, and functions over types are recursive.
const mostFields = 500

/// What is asked of a table; a program's own names are a thin layer over the library's.
export interface Lookup<V> {
  get(name: string): V | undefined
  has(name: string): boolean
}

export interface Environment {
  readonly values: Lookup<Scheme>
  readonly constructors: Lookup<ConstructorInfo>
  readonly types: Lookup<TypeEntry>
  /// Each class with the classes it follows from.
  readonly classes: Lookup<readonly string[]>
  /// Classes and types that a program cannot name, so that no signature may mention them.
  readonly hidden: ReadonlySet<string>
  /// Names that the Prelude has.
  readonly prelude: ReadonlySet<string>
  /// Names that a program's top level cannot define anew: types that shapes are made of, and all of a Prelude that it imports itself. Other
  /// names of Rosy and the Prelude give way to the program's own.
  readonly fixed: ReadonlySet<string>
  /// Instances that inference used and a program's own types must derive: `Eq Mode`. Filled while inferring.
  readonly needs: Set<string>
  /// Constraints that inference let pass because only GHC can confirm them: `Fractional Colour`.
  readonly assumed: Constraint[]
  /// By class, then by the name of the type's head (`*` for an instance that is for every type). "none" where a type
  /// of the program's own cannot derive the class.
  readonly instances: Lookup<Lookup<Instance | "none">>
  /// Fields of the program's own types: no definition can have such a name.
  readonly fields?: ReadonlySet<string>
  /// Names for types with variables of their own inside, and type families, which are GHC's to judge.
  readonly ranked?: ReadonlySet<string>
  /// Any name may come from an unknown module.
  readonly open?: boolean
  /// What may stand before the dot of a name.
  readonly qualifiers?: ReadonlySet<string>
  /// Instances that the program's text has, so that nothing derives them: `Eq Mode`.
  readonly written?: ReadonlySet<string>
  /// Classes that the program's text defines; `values` has all that belongs to them.
  readonly ownClasses?: ReadonlySet<string>
  /// The superclasses of `ownClasses`.
  readonly superclasses?: ReadonlyMap<string, readonly string[]>
  /// All instances of `ownClasses`; undefined where some may be unknown.
  readonly ownInstances?: ReadonlyMap<string, readonly Instance[]> | undefined
  /// What the program's own types derive: `Eq Mode`.
  readonly derived?: ReadonlySet<string>
  /// The name of the program's module; undefined for `Main` without a header.
  readonly moduleName?: string | undefined
  /// Types that the program declares.
  readonly ownTypes?: ReadonlySet<string>
  /// Classes of imported modules, which only GHC knows more about.
  readonly importedClasses?: ReadonlySet<string>
  /// Extensions of the language that the program turns on.
  readonly extensions?: ReadonlySet<string>
}

/// The library's environment, which can also be gone through.
export interface Library extends Environment {
  readonly values: ReadonlyMap<string, Scheme>
  readonly constructors: ReadonlyMap<string, ConstructorInfo>
  readonly types: ReadonlyMap<string, TypeEntry>
  readonly classes: ReadonlyMap<string, readonly string[]>
}

export interface MutableEnvironment {
  values: MutableLookup<Scheme>
  constructors: MutableLookup<ConstructorInfo>
  types: MutableLookup<TypeEntry>
  classes: MutableLookup<readonly string[]>
  hidden: Set<string>
  prelude: ReadonlySet<string>
  fixed: ReadonlySet<string>
  needs: Set<string>
  readonly assumed: Constraint[]
  instances: MutableLookup<MutableLookup<Instance | "none">>
  fields?: ReadonlySet<string>
  ranked?: ReadonlySet<string>
  open?: boolean
  qualifiers?: ReadonlySet<string>
  written?: ReadonlySet<string>
  ownTypes?: ReadonlySet<string>
  ownClasses?: ReadonlySet<string>
  superclasses?: ReadonlyMap<string, readonly string[]>
  ownInstances?: ReadonlyMap<string, readonly Instance[]> | undefined
  derived?: ReadonlySet<string>
  moduleName?: string | undefined
  importedClasses?: ReadonlySet<string>
  extensions?: ReadonlySet<string>
}

export interface MutableLookup<V> extends Lookup<V> {
  set(name: string, value: V): unknown
}

/// A table of a few names of its own over another that it leaves alone.
export class OverlayMap<V> implements MutableLookup<V> {
  private readonly own = new Map<string, V>()
  private readonly below: Lookup<V>

  constructor(below: Lookup<V>) {
    this.below = below
  }

  get(name: string): V | undefined {
    return this.own.get(name) ?? this.below.get(name)
  }

  has(name: string): boolean {
    return this.own.has(name) || this.below.has(name)
  }

  set(name: string, value: V): void {
    this.own.set(name, value)
  }
}

/// Reads declarations, one a line. A line it cannot read (a type beyond Haskell 2010) leaves its name unknown.
export function parseEnvironment(
  text: string,
  prelude: ReadonlySet<string> = new Set(),
  fixed: ReadonlySet<string> = new Set(),
): Library {
  const env = {
    values: new Map<string, Scheme>(),
    constructors: new Map<string, ConstructorInfo>(),
    types: new Map<string, TypeEntry>(),
    classes: new Map<string, readonly string[]>(),
    hidden: new Set<string>(),
    prelude,
    fixed,
    needs: new Set<string>(),
    assumed: [],
    instances: new Map<string, Map<string, Instance | "none">>(),
  }
  for (const raw of text.split("\n")) {
    const line = raw.trim()
    if (line === "" || line.startsWith("--")) continue
    readLine(line, env)
  }
  return env
}

function readLine(line: string, env: MutableEnvironment): void {
  const data = /^(hidden )?(?:data|newtype) (\S+)((?: \w+)*)(?: = (.*))?$/.exec(line)
  if (data !== null) {
    const [, hidden, name = "", parameters = "", right = ""] = data
    if (hidden !== undefined) env.hidden.add(name)
    addData(
      env,
      name.replace(/^\((.+)\)$/, "$1"),
      parameters.trim().split(" ").filter(Boolean),
      right.split(" | ").filter(Boolean).map(readConstructor),
      false,
    )
    return
  }
  const synonym = /^type (\S+)((?: \w+)*) = (.*)$/.exec(line)
  if (synonym !== null) {
    const [, name = "", parameters = "", right = ""] = synonym
    const type = parseType(right)
    env.types.set(name, {
      parameters: parameters.trim().split(" ").filter(Boolean),
      constructors: [],
      ...(type === undefined ? {} : {synonym: type}),
      own: false,
    })
    return
  }
  const cls = /^(hidden )?class (?:(.*) => )?(\w+) \w+$/.exec(line)
  if (cls !== null) {
    const [, hidden, supers = "", name = ""] = cls
    if (hidden !== undefined) env.hidden.add(name)
    env.classes.set(
      name,
      [...supers.matchAll(/([A-Z]\w*) \w/g)].map(m => m[1] ?? ""),
    )
    return
  }
  const instance = /^instance (?:(.*) => )?(\w+) (.+)$/.exec(line)
  if (instance !== null) {
    const [, context = "", name = "", head = ""] = instance
    const signature = parseSignature(context === "" ? head : `${context} => ${head}`)
    if (signature !== undefined) addInstance(env, name, signature)
    return
  }
  const value = /^(\S+) :: (.*)$/.exec(line)
  if (value !== null) {
    const [, name = "", type = ""] = value
    const scheme = type === "_" ? unknown : parseScheme(type)
    if (scheme !== undefined) env.values.set(name.replace(/^\((.+)\)$/, "$1"), scheme)
  }
}

function readConstructor(text: string): {name: string; fields: {name?: string; type: string}[]} {
  const record = /^(\S+) *\{(.*)\}$/.exec(text.trim())
  if (record !== null)
    return {
      name: record[1] ?? "",
      fields: splitTop(record[2] ?? "", ",").flatMap(f => {
        const [names = "", type = ""] = f.split("::")
        return names.split(",").map(n => ({name: n.trim(), type: type.trim()}))
      }),
    }
  const [name = "", ...fields] = words(text.trim().replaceAll("!", ""))
  const [operator = "", right = ""] = fields
  if (operator.startsWith(":")) return {name: operator, fields: [{type: name}, {type: right}]}
  return {name, fields: fields.map(type => ({type}))}
}

/// Splits at spaces outside brackets.
function words(text: string): string[] {
  return splitTop(text, " ").filter(w => w !== "")
}

function splitTop(text: string, separator: string): string[] {
  const parts: string[] = []
  let depth = 0
  let start = 0
  for (let i = 0; i < text.length; i++) {
    if ("([{".includes(text[i] ?? "")) depth++
    else if (")]}".includes(text[i] ?? "")) depth--
    else if (depth === 0 && text[i] === separator) {
      parts.push(text.slice(start, i))
      start = i + 1
    }
  }
  parts.push(text.slice(start))
  return parts.filter(p => p.trim() !== "")
}

export function addData(
  env: MutableEnvironment,
  name: string,
  parameters: readonly string[],
  constructors: readonly {name: string; fields: readonly {name?: string | undefined; type: string}[]}[],
  own: boolean,
): void {
  const result = app(con(name), ...parameters.map((p): Type => ({kind: "var", name: p})))
  env.types.set(name, {parameters, constructors: constructors.map(c => c.name), own})
  for (const c of constructors) {
    // A type that is not read has a variable of its own, of which nothing is known at any use.
    const open: string[] = []
    const fields = c.fields.map((f): Type => {
      const type = parseType(f.type)
      if (type !== undefined) return type
      const name = `?${open.length}`
      open.push(name)
      return {kind: "var", name}
    })
    const variables = [
      ...parameters,
      ...[...variablesIn(funs(fields, result))].filter(v => !parameters.includes(v)),
    ]
    env.constructors.set(c.name, {
      name: c.name,
      scheme:
        fields.length > mostFields ? unknown : {variables, constraints: [], type: funs(fields, result), open},
      fields,
      fieldNames: c.fields.map(f => f.name),
      of: name,
    })
    c.fields.forEach((f, i) => {
      const type = fields[i]
      if (f.name !== undefined && type !== undefined)
        env.values.set(f.name, {variables, constraints: [], type: funs([result], type), open})
    })
  }
}

export function addInstance(env: MutableEnvironment, name: string, instance: Instance): void {
  const {head} = spine(instance.type)
  const of = env.instances.get(name) ?? new Map<string, Instance | "none">()
  of.set(head.kind === "con" ? head.name : "*", instance)
  env.instances.set(name, of)
}

/// Whether a type's declaration was not read: it may be another name for any type.
function isUnreadType(name: string, env: Environment): boolean {
  const entry = env.types.get(name)
  return entry === undefined ? !builtInHeads.test(name) : entry.isUnread === true
}

/// Types with a syntax of their own, which no table lists.
export const builtInHeads = /^(?:->|\[\]|\(,*\))$/

/// A type with all synonyms written out. A synonym inside of its own definition stays as it is.
export function expand(
  type: Type,
  env: Environment,
  within: readonly string[] = [],
  size: {nodes: number; level: number} = {nodes: 0, level: 0},
): Type {
  if (++size.nodes > mostNodes || size.level > mostLevels) throw new TypeTooLarge()
  size.level++
  const {head, args} = spine(type)
  const expanded = args.map(a => expand(a, env, within, size))
  if (head.kind === "con" && !within.includes(head.name)) {
    const entry = env.types.get(head.name)
    if (entry?.synonym !== undefined && expanded.length >= entry.parameters.length) {
      const by = new Map(entry.parameters.map((p, i) => [p, expanded[i] ?? con("()")] as const))
      const meaning = expand(substitute(entry.synonym, by), env, [...within, head.name], size)
      size.level--
      return app(meaning, ...expanded.slice(entry.parameters.length))
    }
  }
  size.level--
  const known = head.kind === "con" && isUnreadType(head.name, env) ? {...head, isUnread: true} : head
  return expanded.length === 0 ? known : app(known, ...expanded)
}
