/// Writes `src/types/environment/environment.generated.ts` and `modules.generated.ts` from the built library: `npm run environment -w codegen`.

import {writeFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {environmentFromGhc, modulesFromGhc, packageDatabase} from "./ghc.ts"

const database = packageDatabase()
if (database === undefined) {
  process.stderr.write("Build the library first: cabal build lib:rosy\n")
  process.exitCode = 1
} else {
  const write = (name: string, text: string) => {
    const path = fileURLToPath(new URL(`../src/types/environment/${name}.generated.ts`, import.meta.url))
    writeFileSync(path, `/// Made by scripts/environment.ts from GHC; not edited by hand.\n\n${text}\n`)
  }
  const environment = environmentFromGhc(database).split("\n")
  write("environment", `export const generated = ${JSON.stringify(environment, null, 1)}.join("\\n")`)
  const modules = JSON.stringify(modulesFromGhc(database), null, 1)
  write("modules", `export const modules: {readonly [name: string]: string} = ${modules}`)
}
