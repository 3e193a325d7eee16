/// Asks GHC what a Rosy program has in scope. The one place in codegen that starts another program.

import {execFileSync} from "node:child_process"
import {existsSync, readdirSync, readFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {browsed, instancesOf} from "./browse.ts"

const root = fileURLToPath(new URL("../../", import.meta.url))

/// Where cabal keeps the library built in this tree, if it has been built.
export function packageDatabase(): string | undefined {
  const all = `${root}dist-newstyle/packagedb/`
  const found = existsSync(all)
    ? readdirSync(all).find(d => existsSync(`${all}${d}/package.cache`))
    : undefined
  return found === undefined ? undefined : `${all}${found}`
}

/// Options that make the library visible to `ghc`: all packages of a database are. `-package rosy` would be one of its three libraries to GHC 9.10.
export function withRosy(database: string): string[] {
  return ["-package-env", "-", "-package-db", database, "-package", "random"]
}

const classes =
  `Eq Ord Show Read Enum Bounded Num Real Integral Fractional Floating RealFrac RealFloat Semigroup Monoid
  Functor Applicative Alternative Monad MonadFail Foldable Traversable MonadPlus Random RandomGen Default
  Sensor Command Controller Runnable`.split(/\s+/)

/// Classes that a learner cannot write, but that stand in the types of what a learner uses.
const hiddenClasses = ["Rosy.Value.Value"]

/// The whole environment: Prelude first, so that what Rosy says of a name comes last and holds.
export function environmentFromGhc(database: string): string {
  const say = (commands: readonly string[]) =>
    execFileSync(
      "ghc",
      [
        ...withRosy(database),
        "-dppr-cols=4000",
        "-ignore-dot-ghci",
        ...["import Rosy", ...commands].flatMap(c => ["-e", c]),
      ],
      {encoding: "utf8", maxBuffer: 1 << 26, stdio: ["ignore", "pipe", "pipe"]},
    )
  const known = browsed(say([":browse Prelude", ":browse Rosy"]))
  const hidden = browsed(say(hiddenClasses.map(c => `:info ${c}`)))
    .filter(l => l.startsWith("class "))
    .map(l => `hidden ${l}`)
  const instances = instancesOf(say([...classes, ...hiddenClasses].map(c => `:info ${c}`)))
  const types = new Set(known.flatMap(l => /^(?:data|newtype) (\S+)/.exec(l)?.[1] ?? []))
  const askable = new Set(
    [...known, ...hidden].flatMap(l => /\bclass (?:.*=> )?(\w+) \w+$/.exec(l)?.[1] ?? []),
  )
  // What an instance asks for must be something that is asked for elsewhere; other packages bring stray ones.
  const usable = instances.filter(
    l =>
      headsIn(l).every(t => types.has(t)) &&
      contextOf(l).every(c => askable.has(c) || ["Typeable", "Ends"].includes(c)),
  )
  return [...new Set([...known, ...hidden, ...usable.sort()])].join("\n")
}

/// What each module that a program may import exports, by its name; `=Data.Map` for one that exports the same.
export function modulesFromGhc(database: string): {[name: string]: string} {
  const allow = readFileSync(`${root}rosy-hs/worker/Rosy/Worker/Allowlist.hs`, "utf8")
  const list = /^allowedModules =[\s\S]*?\[([\s\S]*?)^ {4}\]/m.exec(allow)?.[1] ?? ""
  const names = (list.match(/[A-Z][\w.]*/g) ?? []).filter(n => n !== "Rosy" && n !== "Prelude")
  const between = "@@"
  const told = execFileSync(
    "ghc",
    [
      ...withRosy(database),
      ..."-package containers -dppr-cols=4000 -ignore-dot-ghci".split(" "),
      ...names.flatMap(n => [
        "-e",
        `:module ${n}`,
        "-e",
        `:browse ${n}`,
        "-e",
        `System.IO.putStrLn "${between}"`,
      ]),
    ],
    {encoding: "utf8", maxBuffer: 1 << 26, stdio: ["ignore", "pipe", "pipe"]},
  ).split(`${between}\n`)
  const modules: {[name: string]: string} = {}
  const seen = new Map<string, string>()
  names.forEach((name, i) => {
    const own = new RegExp(`^(\\s*\\(?)${name.replaceAll(".", "\\.")}\\.`, "gm")
    const said = (told[i] ?? "").replace(own, "$1")
    const lines = browsed(said).filter(l => !l.startsWith("type role "))
    // Names whose types go beyond what is read here: they exist, and GHC knows the rest.
    const known = new Set(lines.map(l => l.split(" :: ")[0]))
    const others = [...said.matchAll(/^\s*(\(\S+\)|[a-z_][\w']*) ::/gm)].map(m => m[1] ?? "")
    const text = [...lines, ...new Set(others.filter(n => !known.has(n)).map(n => `${n} :: _`))].join("\n")
    const same = seen.get(text)
    modules[name] = same === undefined ? text : `=${same}`
    if (same === undefined) seen.set(text, name)
  })
  return modules
}

/// The classes an instance asks for.
function contextOf(line: string): string[] {
  const context = /^instance (.*) => /.exec(line)?.[1]?.replace(/^\((.*)\)$/, "$1") ?? ""
  return context.split(", ").flatMap(c => /^[A-Z]\w*/.exec(c)?.[0] ?? [])
}

/// The type names an instance is about, so that instances of types that a program cannot name are left out.
function headsIn(line: string): string[] {
  const head = line.replace(/^instance (?:.* => )?\S+ /, "")
  return head.match(/[A-Z][\w']*/g) ?? []
}
