/// What names mean before a program says anything: values, constructors, types, classes and instances.
///
/// An environment is read from declarations as Haskell writes them, one a line, and grows by a program's own types.

import type {DataDeclaration, SynonymDeclaration} from "../model/tree.ts"
import {parseScheme, parseSignature, parseType} from "./parse.ts"
import {reduce} from "./solve.ts"
import type {Constraint, Scheme, Type} from "./type.ts"
import {app, con, funs, spine, substitute, variablesIn} from "./type.ts"

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
}

export interface Instance {
  readonly constraints: readonly Constraint[]
  readonly type: Type
}

export interface Environment {
  readonly values: ReadonlyMap<string, Scheme>
  readonly constructors: ReadonlyMap<string, ConstructorInfo>
  readonly types: ReadonlyMap<string, TypeEntry>
  /// Each class with the classes it follows from.
  readonly classes: ReadonlyMap<string, readonly string[]>
  /// Classes that a program cannot name, so that no signature may mention them.
  readonly hidden: ReadonlySet<string>
  /// Names that the Prelude has and a program's top level therefore cannot define anew.
  readonly fixed: ReadonlySet<string>
  /// Instances that inference used and a program's own types must derive: `Eq Mode`. Filled while inferring.
  readonly needs: Set<string>
  /// By class, then by the name of the type's head (`*` for an instance that is for every type).
  readonly instances: ReadonlyMap<string, ReadonlyMap<string, Instance>>
}

interface Growing {
  values: Map<string, Scheme>
  constructors: Map<string, ConstructorInfo>
  types: Map<string, TypeEntry>
  classes: Map<string, readonly string[]>
  hidden: Set<string>
  fixed: Set<string>
  needs: Set<string>
  instances: Map<string, Map<string, Instance>>
}

/// Reads declarations, one a line. A line it cannot read (a type beyond Haskell 2010) leaves its name unknown.
export function readEnvironment(text: string, fixed: ReadonlySet<string> = new Set()): Environment {
  const env: Growing = {
    values: new Map(),
    constructors: new Map(),
    types: new Map(),
    classes: new Map(),
    hidden: new Set(),
    fixed: new Set(fixed),
    needs: new Set(),
    instances: new Map(),
  }
  for (const raw of text.split("\n")) {
    const line = raw.trim()
    if (line === "" || line.startsWith("--")) continue
    readLine(line, env)
  }
  return env
}

function readLine(line: string, env: Growing): void {
  const data = /^(?:data|newtype) (\S+)((?: \w+)*)(?: = (.*))?$/.exec(line)
  if (data !== null) {
    const [, name = "", parameters = "", right = ""] = data
    addData(
      env,
      name,
      parameters.trim().split(" ").filter(Boolean),
      splitTop(right, "|").map(readConstructor),
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
    const scheme = parseScheme(type)
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
  const [name = "", ...fields] = words(text.trim())
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

function addData(
  env: Growing,
  name: string,
  parameters: readonly string[],
  constructors: readonly {name: string; fields: readonly {name?: string | undefined; type: string}[]}[],
  own: boolean,
): void {
  const result = app(con(name), ...parameters.map((p): Type => ({kind: "var", name: p})))
  env.types.set(name, {parameters, constructors: constructors.map(c => c.name), own})
  for (const c of constructors) {
    const fields = c.fields.map(f => parseType(f.type) ?? ({kind: "var", name: "?"} as Type))
    const variables = [
      ...parameters,
      ...[...variablesIn(funs(fields, result))].filter(v => !parameters.includes(v)),
    ]
    env.constructors.set(c.name, {
      name: c.name,
      scheme: {variables, constraints: [], type: funs(fields, result)},
      fields,
      fieldNames: c.fields.map(f => f.name),
      of: name,
    })
    c.fields.forEach((f, i) => {
      const type = fields[i]
      if (f.name !== undefined && type !== undefined)
        env.values.set(f.name, {variables, constraints: [], type: funs([result], type)})
    })
  }
}

function addInstance(env: Growing, name: string, instance: Instance): void {
  const {head} = spine(instance.type)
  const of = env.instances.get(name) ?? new Map<string, Instance>()
  of.set(head.kind === "con" ? head.name : "*", instance)
  env.instances.set(name, of)
}

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
  const env: Growing = {
    values: new Map(base.values),
    constructors: new Map(base.constructors),
    types: new Map(base.types),
    classes: new Map(base.classes),
    hidden: new Set(base.hidden),
    fixed: new Set(base.fixed),
    needs: new Set(),
    instances: new Map([...base.instances].map(([name, of]) => [name, new Map(of)])),
  }
  for (const d of declarations) {
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
      addInstance(env, name, {constraints: perParameter(name), type})
  }
  dropUnderivable(env, declarations)
  return env
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
        if (d.deriving.includes(name) || env.instances.get(name)?.has(d.name) !== true) continue
        const fields = d.constructors.flatMap(c => env.constructors.get(c.name)?.fields ?? [])
        const all = fields.every(f => reduce({name, type: expand(f, env)}, env).kind === "stuck")
        if (all) continue
        env.instances.get(name)?.delete(d.name)
        again = true
      }
    }
  }
  env.needs.clear()
}

/// A type with all synonyms written out. A synonym that goes round in a circle stays as it is.
export function expand(type: Type, env: Environment, depth = 0): Type {
  const {head, args} = spine(type)
  const expanded = args.map(a => expand(a, env, depth))
  if (head.kind === "con" && depth < 40) {
    const entry = env.types.get(head.name)
    if (entry?.synonym !== undefined && expanded.length >= entry.parameters.length) {
      const by = new Map(entry.parameters.map((p, i) => [p, expanded[i] ?? con("()")] as const))
      return app(
        expand(substitute(entry.synonym, by), env, depth + 1),
        ...expanded.slice(entry.parameters.length),
      )
    }
  }
  return expanded.length === 0 ? head : app(head, ...expanded)
}
