/// The script of the shared page (`src/features/shared_page/player.ts`) as text, with its hash: a Vite plugin that bundles it for the module `virtual:film-player`. The page
/// cannot compute the hash: where it is served without TLS, a browser has no `crypto.subtle`.

import {createHash} from "node:crypto"
import {fileURLToPath} from "node:url"
import {build, type Plugin} from "vite"

const name = "virtual:film-player"
const resolved = `\0${name}`

export function filmPlayer(): Plugin {
  return {
    name: "rosy-film-player",
    resolveId: id => (id === name ? resolved : null),
    async load(id) {
      if (id !== resolved) return null
      const {script, modules} = await bundle()
      for (const module of modules) if (module.startsWith("/")) this.addWatchFile(module)
      const hash = createHash("sha256").update(script).digest("base64")
      return `export const script = ${JSON.stringify(script)}\nexport const hash = ${JSON.stringify(hash)}\n`
    },
  }
}

async function bundle(): Promise<{readonly script: string; readonly modules: readonly string[]}> {
  const made = await build({
    configFile: false,
    root: fileURLToPath(new URL("..", import.meta.url)),
    logLevel: "error",
    build: {
      write: false,
      target: "es2022",
      modulePreload: false,
      rollupOptions: {
        input: fileURLToPath(new URL("../src/features/shared_page/player.ts", import.meta.url)),
        output: {format: "iife"},
      },
    },
  })
  const [output] = Array.isArray(made) ? made : [made]
  const chunk = output !== undefined && "output" in output ? output.output[0] : undefined
  if (chunk === undefined) throw new Error("expected a script from player.ts, found none")
  const script = chunk.code.trim()
  // Either would end the script element early, or hide its end (HTML, section 4.12.1.3).
  if (/<\/script|<!--/i.test(script)) throw new Error("expected a script that fits into an element")
  return {script, modules: chunk.moduleIds}
}
