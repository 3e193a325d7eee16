/// How the page is built and served while it is being worked on. The service (sim-service) serves `dist/` as
/// it stands; in development its API is proxied, at the address in ROSY_SERVICE when that is set.

import {readdirSync, readFileSync} from "node:fs"
import {createRequire} from "node:module"
import {dirname, extname, join} from "node:path"
import {fileURLToPath} from "node:url"
import {defineConfig, type Plugin} from "vite"
import {filmPlayer} from "./plugins/film_player.ts"
import {guide, guideEntry} from "./plugins/guide/plugin.ts"
import {licenceTexts} from "./plugins/licence_texts.ts"

const service = process.env.ROSY_SERVICE ?? "http://127.0.0.1:8080"

const mediaTypes: Record<string, string> = {
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".gif": "image/gif",
  ".cur": "image/x-icon",
}

/// Blockly asks for its pictures by address, under `media/`; they come from its package, so that nothing is
/// fetched from elsewhere. Its sounds are not used.
function blocklyMedia(): Plugin {
  const folder = join(dirname(createRequire(import.meta.url).resolve("blockly")), "media")
  const pictures = readdirSync(folder).filter(name => extname(name) in mediaTypes)
  return {
    name: "rosy-blockly-media",
    configureServer(server) {
      server.middlewares.use("/media", (request, response, next) => {
        const name = (request.url ?? "").replace(/^\//, "").replace(/\?.*$/, "")
        if (!pictures.includes(name)) return next()
        response.setHeader("content-type", mediaTypes[extname(name)] ?? "")
        response.end(readFileSync(join(folder, name)))
      })
    },
    generateBundle() {
      for (const name of pictures)
        this.emitFile({type: "asset", fileName: `media/${name}`, source: readFileSync(join(folder, name))})
    },
  }
}

/// The page shows it. Its only source is rosy.cabal.
const [, version = ""] =
  readFileSync(new URL("../rosy.cabal", import.meta.url), "utf8").match(/^version:\s*(\S+)/m) ?? []
process.env["VITE_ROSY_VERSION"] = version

const page = (name: string) => fileURLToPath(new URL(name, import.meta.url))

export default defineConfig({
  root: fileURLToPath(new URL(".", import.meta.url)),
  base: "./",
  plugins: [blocklyMedia(), licenceTexts(), filmPlayer(), guide(page(".."))],
  build: {
    target: "es2022",
    chunkSizeWarningLimit: 2500,
    rollupOptions: {
      input: {
        index: page("index.html"),
        prelude: page("prelude.html"),
        board: page("board.html"),
        projector: page("projector.html"),
        [guideEntry]: page("src/guide/guide.ts"),
      },
    },
  },
  server: {proxy: {"/api": {target: service, ws: true}, "/rosbridge": {target: service, ws: true}}},
})
