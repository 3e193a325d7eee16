/// Writes `src/types/environment.generated.ts` from the built library: `npm run environment -w codegen`.

import {writeFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {environmentFromGhc, packageDatabase} from "./ghc.ts"

const database = packageDatabase()
if (database === undefined) {
  process.stderr.write("Build the library first: cabal build lib:rosy\n")
  process.exitCode = 1
} else {
  const text = environmentFromGhc(database)
  const path = fileURLToPath(new URL("../src/types/environment.generated.ts", import.meta.url))
  const opening = "/// Made by scripts/environment.ts from GHC; not edited by hand.\n\n"
  writeFileSync(
    path,
    `${opening}export const generated = ${JSON.stringify(text.split("\n"), null, 1)}.join("\\n")\n`,
  )
}
