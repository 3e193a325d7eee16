/// Writes `src/haskell/module_fixities.generated.ts` from the interfaces of GHC's own packages: `npm run fixities -w codegen`.

import {execFileSync} from "node:child_process"
import {readdirSync, writeFileSync} from "node:fs"
import {join} from "node:path"
import {fileURLToPath} from "node:url"

/// Packages that come with GHC, and those of Rosy's modules.
const packages =
  `base ghc-prim array bytestring containers deepseq directory exceptions filepath mtl parsec pretty process random stm text time transformers`.split(
    " ",
  )

interface Interface {
  /// Names that the module exports, each with the module that defines it.
  readonly exports: readonly {readonly of: string; readonly name: string}[]
  /// `infixr 5` by operator.
  readonly fixities: ReadonlyMap<string, string>
}

// The primitive functions of GHC have no interface file.
const all = new Map<string, Interface>([
  ["GHC.Prim", {exports: [], fixities: new Map([["seq", "infixr 0"]])}],
])
const exposed: string[] = []
for (const name of packages) {
  const folder = fieldOf(name, "import-dirs")
  exposed.push(...(fieldOf(name, "exposed-modules").match(/[A-Z][\w.']*/g) ?? []))
  for (const file of readdirSync(folder, {recursive: true, encoding: "utf8"}))
    if (file.endsWith(".hi")) {
      const module = file.replace(/\.hi$/, "").replaceAll("/", ".")
      all.set(module, interfaceOf(module, join(folder, file)))
    }
}

// Modules with the same operators stand together.
const modulesOf = new Map<string, string[]>()
for (const module of exposed.filter(m => all.has(m)).sort()) {
  const found = new Map<string, string>()
  for (const {of, name} of all.get(module)?.exports ?? []) {
    const fixity = all.get(of)?.fixities.get(name)
    // That of an operator without a declaration says nothing new.
    if (fixity !== undefined && fixity !== "infixl 9") found.set(name, fixity)
  }
  const key = [...found]
    .map(([name, fixity]) => `${fixity} ${name}`)
    .sort()
    .join(", ")
  modulesOf.set(key, [...(modulesOf.get(key) ?? []), module])
}
const table = [...modulesOf].map(([fixities, modules]) => ({modules: modules.join(" "), fixities}))
writeFileSync(
  fileURLToPath(new URL("../src/haskell/module_fixities.generated.ts", import.meta.url)),
  `/// Made by scripts/fixities.ts from GHC; not edited by hand.

/// The operators with a fixity declaration that modules export; an operator of theirs that is absent is \`infixl 9\`.
export const moduleFixities: readonly {readonly modules: string; readonly fixities: string}[] = ${JSON.stringify(table, null, 1)}
`,
)

function fieldOf(name: string, field: string): string {
  return execFileSync("ghc-pkg", ["--global", "--simple-output", "field", name, field], {
    encoding: "utf8",
  }).trim()
}

function interfaceOf(module: string, file: string): Interface {
  const text = execFileSync("ghc", ["--show-iface", file], {encoding: "utf8", maxBuffer: 1 << 28})
  const exported = /^exports:\n([\s\S]*?)^\S/m.exec(text)?.[1] ?? ""
  const declared = /^fixities ([\s\S]*?)\n(?=\S)/m.exec(text)?.[1] ?? ""
  return {
    // A type that is not exported itself has a bar before the brackets of its constructors.
    exports: exported.split(/(?:(?<=\w)\|)?\{|[\s}]+/).flatMap(word => {
      const [, qualifier, name] = /^\(?((?:[A-Z][\w']*\.)*)([^()\s]+)\)?$/.exec(word) ?? []
      return name === undefined ? [] : [{of: qualifier ? qualifier.slice(0, -1) : module, name}]
    }),
    fixities: new Map(
      declared.split(/,\s+/).flatMap(one => {
        const [, fixity = "", name = ""] = /^(infix[lr]? \d) (\S+)$/.exec(one.trim()) ?? []
        return name === "" ? [] : [[name.replaceAll("`", ""), fixity] as const]
      }),
    ),
  }
}
