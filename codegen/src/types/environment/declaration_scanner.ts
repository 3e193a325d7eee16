/// Line-based scanner for names and types in Haskell text: imports, and declarations without blocks.
///
/// A reading of lines, not a parser: whatever it cannot tell for sure is a name of unknown type, which fits everywhere and about which only
/// GHC can say more.

import {extensionsIn} from "../../source/directives.ts"
import type {Import} from "../../source/imports.ts"
import {importsIn, logicalLines} from "../../source/imports.ts"
import type {Scheme} from "../syntax/type.ts"
import {parseScheme, parseSignature} from "../syntax/type_parser.ts"
import type {Instance} from "./environment.ts"

export interface WrittenType {
  readonly name: string
  readonly parameters: readonly string[]
  /// `fields` is absent where they use more of Haskell than is read here.
  readonly constructors: readonly {
    readonly name: string
    readonly fields: readonly {readonly name?: string; readonly type: string}[] | undefined
    /// Names of fields whose types are left to GHC.
    readonly labels?: readonly string[]
  }[]
  /// Whether it is another name for a type, which is not read.
  readonly isSynonym?: boolean
}

export interface ScannedDeclarations {
  readonly imports: readonly Import[]
  /// Undefined for a name whose type is not written.
  readonly values: ReadonlyMap<string, Scheme | undefined>
  readonly types: readonly WrittenType[]
  /// Classes that are defined here; `values` has all that belongs to them.
  readonly classes: readonly string[]
  readonly instances: readonly {readonly name: string; readonly instance: Instance}[]
  /// Classes that are defined here and about which only GHC knows: of several types, or with kinds.
  readonly otherClasses: readonly string[]
  /// Classes of `classes` with those that they build on.
  readonly superclasses: ReadonlyMap<string, readonly string[]>
  /// Whether `instances` has all instances: none is in a form that is not read here, and no code makes declarations.
  readonly hasAllInstances: boolean
  /// The name in the module header; undefined without a header.
  readonly moduleName: string | undefined
  /// Names that are written with the program's own module as qualifier, like `Maybe` in `Main.Maybe`.
  readonly ownQualified: ReadonlySet<string>
  /// Type families: what such a type is, only GHC computes.
  readonly families: readonly string[]
  /// Extensions of the language that pragmas of the header turn on.
  readonly extensions: ReadonlySet<string>
  /// Names for patterns, each with the names of its fields.
  readonly patterns: readonly {readonly name: string; readonly labels: readonly string[]}[]
}

const word = String.raw`[\p{Ll}_][\p{L}\p{N}_']*`
const symbol = String.raw`[!#$%&*+./<=>?@\\^|~:-]+`
const constructorName = String.raw`(?:[\p{Lu}][\p{L}\p{N}_']*|\(:${symbol}\))`

export function scanDeclarations(header: string, definitions: readonly string[]): ScannedDeclarations {
  const found: MutableEnvironment = {
    values: new Map(),
    types: [],
    classes: [],
    otherClasses: [],
    instances: [],
    superclasses: new Map(),
    unread: [],
    families: [],
    patterns: [],
  }
  for (const text of definitions) for (const line of logicalLines(text)) readDefinition(line, found)
  const {unread, ...scanned} = found
  const hasAllInstances = unread.length === 0 && !/\b(?:TemplateHaskell|QuasiQuotes|CPP)\b/.test(header)
  const moduleName = /^[ \t]*module\s+([\p{Lu}][\p{L}\p{N}_'.]*)/mu.exec(header)?.[1]
  const qualifier = (moduleName ?? "Main").replaceAll(".", "\\.")
  const qualified = new RegExp(String.raw`(?<![\p{L}\p{N}_'.])${qualifier}\.([\p{L}_][\p{L}\p{N}_']*)`, "gu")
  const ownQualified = new Set(
    definitions.flatMap(text => [...text.matchAll(qualified)].map(m => m[1] ?? "")),
  )
  const imports = importsIn(header)
  return {
    ...scanned,
    imports,
    hasAllInstances,
    moduleName,
    ownQualified,
    extensions: extensionsIn(header),
  }
}

interface MutableEnvironment {
  readonly values: Map<string, Scheme | undefined>
  readonly types: WrittenType[]
  readonly classes: string[]
  readonly otherClasses: string[]
  readonly instances: {name: string; instance: Instance}[]
  readonly superclasses: Map<string, readonly string[]>
  /// Instances in a form that is not read.
  readonly unread: string[]
  readonly families: string[]
  readonly patterns: {name: string; labels: readonly string[]}[]
}

function readDefinition(line: string, found: MutableEnvironment): void {
  const keyword =
    /^(?:data|newtype|type|class|(?:deriving\s[^=]*)?instance|infix[lr]?|foreign|default|pattern|import)\b/.exec(
      line,
    )?.[0]
  if (keyword === undefined) readValue(line, found)
  else if (/^(?:type|data|newtype)\s+(?:family|instance)\b/.test(line)) readFamily(line, found)
  else if (keyword === "data" || keyword === "newtype") found.types.push(readType(line))
  else if (keyword === "type") found.types.push({...readType(line), constructors: [], isSynonym: true})
  else if (keyword === "class") readClass(line, found)
  else if (keyword.endsWith("instance")) readInstance(line, found)
  else if (/^foreign\s+import\b/.test(line)) readForeign(line, found)
  else if (keyword === "pattern") readPatternSynonym(line, found)
}

/// `pattern Two x y = [x, y]`, `pattern x :> y <- …`, `pattern Point {left, right} = …`, or `pattern A, B :: Int`.
function readPatternSynonym(line: string, {patterns}: Pick<MutableEnvironment, "patterns">): void {
  const left = line.replace(/^pattern\s+/, "").split(/\s(?:=|<-|←|::|∷)\s/)[0] ?? ""
  const labels = [...(/\{([^}]*)\}/.exec(left)?.[1]?.matchAll(new RegExp(word, "gu")) ?? [])].map(m => m[0])
  for (const [name] of left.matchAll(new RegExp(String.raw`[\p{Lu}][\p{L}\p{N}_']*|:${symbol}`, "gu")))
    patterns.push({name, labels})
}

const names = String.raw`(?:${word}|\(${symbol}\))(?:\s*,\s*(?:${word}|\(${symbol}\)))*`
const signature = new RegExp(String.raw`^(${names})\s*(?:::|∷)\s*([\s\S]*)$`, "u")

/// The names and the type of a signature without an equation, like `a, b :: Int`.
export function signatureIn(
  text: string,
): {readonly names: readonly string[]; readonly type: string} | undefined {
  const [line, ...others] = logicalLines(text)
  const found = line === undefined || others.length > 0 ? null : signature.exec(line)
  if (found === null) return undefined
  const [, left = "", type = ""] = found
  return {names: left.split(",").map(bare), type: type.replace(/\s+/g, " ")}
}

/// Names that a local definition kept as text binds; without a type where none is written.
export function localNames(text: string): ReadonlyMap<string, Scheme | undefined> {
  return scanDeclarations("", [text]).values
}

/// `foreign import ccall "sin" c_sin :: Double -> Double` defines a name with a type.
function readForeign(line: string, found: MutableEnvironment): void {
  const defined = new RegExp(String.raw`\s(${word}\s*(?:::|∷)[\s\S]*)$`, "u").exec(
    line.replace(/"(?:[^"\\]|\\.)*"/, " "),
  )?.[1]
  if (defined !== undefined) readValue(defined, found)
}

/// A signature, an equation, or several names taken out of a pattern.
function readValue(line: string, {values}: Pick<MutableEnvironment, "values">): void {
  const signed = signature.exec(line)
  if (signed !== null) {
    const scheme = parseScheme((signed[2] ?? "").replace(/\s+/g, " "))
    for (const name of (signed[1] ?? "").split(",")) values.set(bare(name), scheme)
    return
  }
  const left = line.split(/\s=(?:\s|$)|\n\s*\|(?!\|)|\s\|\s/)[0] ?? line
  const add = (name: string | undefined) => {
    if (name !== undefined && !values.has(bare(name))) values.set(bare(name), undefined)
  }
  const infix = new RegExp(String.raw`\s(${symbol}|\x60${word}\x60)\s`, "u").exec(
    ` ${left.replace(/\([^()]*\)|\[[^\][]*\]/g, "p")} `,
  )?.[1]
  if (infix !== undefined && !/^(?:=|@|!|~)$/.test(infix)) add(infix.replaceAll("`", ""))
  else if (/^[([]/.test(left) && !/^\([!#$%&*+./<=>?@\\^|~:-]+\)/.test(left))
    for (const [name] of left.matchAll(new RegExp(word, "gu"))) add(name)
  else add(new RegExp(String.raw`^(?:${word}|\(${symbol}\))`, "u").exec(left)?.[0])
}

function bare(name: string): string {
  return name
    .trim()
    .replace(/^\((.*)\)$/, "$1")
    .trim()
}

/// The class, its variable and its superclasses in `class (Eq a, Show a) => Shape a where`; undefined for a head with several variables or with kinds.
export function classHead(
  text: string,
): {readonly name: string; readonly variable: string; readonly superclasses: readonly string[]} | undefined {
  const head = (text.split(/\bwhere\b/)[0] ?? "")
    .replace(/^class\s+/, "")
    .replace(/\s+/g, " ")
    .trim()
  const found = /^(?:(.*)=>\s*)?([\p{Lu}][\w']*)\s+([\p{Ll}_][\w']*)\s*(?:\||$)/u.exec(head)
  if (found === null) return undefined
  const [, context = "", name = "", variable = ""] = found
  const superclasses = [
    ...context.matchAll(/(?:^|[(,])\s*([\p{Lu}][\w'.]*)\s+([\p{Ll}_][\w']*)\s*(?=[),]|$)/gu),
  ]
  return {
    name,
    variable,
    superclasses: superclasses.flatMap(([, of = "", v]) => (v === variable ? [of] : [])),
  }
}

/// A class's methods, each with the class itself as its first constraint.
function readClass(line: string, found: MutableEnvironment): void {
  const {values, classes, superclasses} = found
  const [written = "", ...members] = line.split(/\bwhere\b/)
  const head = classHead(line)
  if (head !== undefined) {
    classes.push(head.name)
    superclasses.set(head.name, head.superclasses)
  } else {
    const name = /^class\s+(?:[\s\S]*=>)?\s*\(?\s*([\p{Lu}][\p{L}\p{N}_']*)/u.exec(written)?.[1]
    if (name !== undefined) found.otherClasses.push(name)
  }
  for (const member of indentedLines(members.join("where"))) {
    if (/^(?:type|data)\b/.test(member)) readFamily(member, found)
    if (/^(?:type|data|default|infix[lr]?)\b/.test(member)) continue
    const inner = new Map<string, Scheme | undefined>()
    readValue(member, {values: inner})
    for (const [method, scheme] of inner) {
      const known = values.get(method) !== undefined || scheme === undefined || head === undefined
      if (known) values.set(method, values.get(method))
      else
        values.set(method, {
          ...scheme,
          constraints: [{name: head.name, type: {kind: "var", name: head.variable}}, ...scheme.constraints],
        })
    }
  }
}

/// A family of types, or a member of one: `type family Item a`, and in a class or an instance without the second word. What such a type is, and
/// what its constructors are made of, is GHC's to know.
function readFamily(line: string, {families, types}: MutableEnvironment): void {
  const written = line.replace(/^(type|data|newtype)\s+(?:family|instance)\b/, "$1")
  const {name, constructors} = readType(written)
  families.push(name)
  if (written.startsWith("type")) return
  const labelled = constructors.map(c => ({
    name: c.name,
    fields: undefined,
    labels: [...(c.labels ?? []), ...(c.fields ?? []).flatMap(f => f.name ?? [])],
  }))
  types.push({name, parameters: [], constructors: labelled})
}

/// The lines of a block, each with those below it that are indented further.
function indentedLines(block: string): string[] {
  const lines = block.split("\n").filter(l => l.trim() !== "")
  const margin = Math.min(...lines.map(l => l.length - l.trimStart().length))
  const joined: string[] = []
  for (const l of lines) {
    if (l.length - l.trimStart().length > margin && joined.length > 0) joined[joined.length - 1] += `\n${l}`
    else joined.push(l.trim())
  }
  return joined
}

/// The class of `instance Show a => Show (Box a) where`, and the type that belongs to it with what must hold for that.
export function instanceHead(
  text: string,
): {readonly name: string; readonly instance: Instance; readonly isQualified: boolean} | undefined {
  const head = text
    .replace(/^deriving\s+(?:stock\s+|newtype\s+|anyclass\s+)?/, "")
    .replace(/^instance\s+(?:\{-#.*?#-\}\s*)?/, "")
    .split(/\bwhere\b/)[0]
  const found = /^(?:([\s\S]*?)=>)?\s*([\p{Lu}][\w'.]*)\s+([\s\S]+)$/u.exec((head ?? "").trim())
  if (found === null) return undefined
  const [, context = "", name = "", type = ""] = found
  const instance = parseSignature(context.trim() === "" ? type : `${context} => ${type}`)
  return instance && {name: name.replace(/^.*\./, ""), instance, isQualified: name.includes(".")}
}

function readInstance(line: string, found: MutableEnvironment): void {
  const head = instanceHead(line)
  if (head === undefined) found.unread.push(line)
  else found.instances.push(head)
  const [, ...members] = line.split(/\bwhere\b/)
  for (const member of indentedLines(members.join("where")))
    if (/^(?:type|data|newtype)\b/.test(member)) readFamily(member, found)
}

const infixType = new RegExp(`^${symbol}$`, "u")

/// A constructor of a GADT, and its fields if they have names: `Just'`, `(:+:)`, the first of `A, B :: T`.
const gadtConstructor = new RegExp(
  String.raw`(?:^|\s)(${constructorName})(?=(?: ?, ?${constructorName})* ::)(?: ::(?: forall [^.]*\.)?(?:(?! :: )[^{])*?\{([^}]*)\} ->)?`,
  "gu",
)

/// A type with its constructors, as far as they are plain.
function readType(line: string): WrittenType {
  const flat = line.replace(/\bderiving\b[\s\S]*$/, "").replace(/\s+/g, " ")
  const [head = "", right] = flat.split(/ =(?![-=>]) ?(.*)/s)
  // The constructors of a GADT have contexts, too.
  const [, ...words] = head
    .replace(/ where .*$/, "")
    .replace(/^(data|newtype|type) (?:.*(?<![-=>])=> )?/, "$1 ")
    .replace(/ where$/, "")
    .replace(/\((\w+) ::[^()]*\)/g, "$1")
    .replace(/ ::.*$/, "")
    .split(" ")
  // `type f ~> g`
  const operator = words.find(w => infixType.test(w))
  const [name = "_", ...parameters] = (operator === undefined ? words : [operator, ...words]).map(bare)
  const gadt = / where (.*)$/.exec(flat)?.[1]
  const written = gadt === undefined ? [] : [...gadt.matchAll(gadtConstructor)]
  const cases = right === undefined ? [] : right.split(" | ").map(c => c.trim())
  return {
    name,
    parameters: parameters.filter(p => /^[\p{Ll}_]/u.test(p)),
    constructors: [
      ...written.map(([, of = "", fields = ""]) => ({
        name: bare(of),
        fields: undefined,
        labels: [...fields.matchAll(/([\p{Ll}_][\p{L}\p{N}_']*) ?(?=,|::)/gu)].map(m => m[1] ?? ""),
      })),
      ...cases.map(readConstructor),
    ],
  }
}

function readConstructor(text: string): WrittenType["constructors"][number] {
  const plain = text.replace(/!(?=[\p{L}([])/gu, "")
  // Fields of an existential type keep their names; their types have variables that the head has not.
  const record = /^(?:forall [^.]*\. ?)?(?:[^{]*=> ?)?(\S+) ?\{(.*)\}$/.exec(plain)
  if (record !== null) {
    const fields = (record[2] ?? "").split(/,(?=[^()[\]]*(?:::|,))/).map(f => f.trim())
    const read: {name: string; type: string}[] = []
    for (let i = fields.length - 1, type = ""; i >= 0; i--) {
      const [name = "", written] = (fields[i] ?? "").split("::")
      type = written?.trim() ?? type
      read.unshift({name: name.trim(), type})
    }
    return {name: bare(record[1] ?? ""), fields: read}
  }
  // A context may stand in front, and inside of brackets in a field.
  const core = plain
    .replace(/^forall [^.]*\. ?/, "")
    .replace(/^(?:[^()]|\((?:[^()]|\([^()]*\))*\))*?=> ?/, "")
  // `Step :> Path`: its parts are left to GHC.
  const between = / (:[!#$%&*+./<=>?@\\^|~:-]+|`[\p{Lu}][\w']*`) /u.exec(` ${core} `)?.[1]
  if (between !== undefined) return {name: between.replaceAll("`", ""), fields: undefined}
  const name = /^[\p{Lu}][\w']*/u.exec(core)?.[0]
  if (name === undefined || /\bforall\b|=>|[^\w\s'.()[\],>-]/u.test(plain))
    return {name: name ?? "_", fields: undefined}
  const fields: string[] = []
  for (const [field] of plain
    .slice(name.length)
    .matchAll(/\((?:[^()]|\([^()]*\))*\)|\[(?:[^\][]|\[[^\][]*\])*\]|[\w'.]+/g))
    fields.push(field)
  return {name, fields: fields.map(type => ({type}))}
}
