/// Writes `src/workspace/toolbox/library_definitions.generated.ts` from the source of the library: `npm run definitions -w codegen`.

import {readFileSync, writeFileSync} from "node:fs"
import {fileURLToPath} from "node:url"
import {testReader} from "../test/reader/open.ts"
import {libraryDefinitions, motionSource} from "./library_definitions.ts"

const path = fileURLToPath(
  new URL("../src/workspace/toolbox/library_definitions.generated.ts", import.meta.url),
)
const definitions = libraryDefinitions(await testReader(), readFileSync(motionSource, "utf8"))
writeFileSync(
  path,
  `/// Made by scripts/definitions.ts from rosy-hs/src/Rosy/Motion.hs; not edited by hand.

export const generated: unknown = ${JSON.stringify(definitions, null, 1)}
`,
)
