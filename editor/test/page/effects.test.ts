/// Effects that run after the page has been drawn come up to a frame late, and later on a busy computer. One that takes the focus or resets an answer
/// would then undo what was pressed or typed in between; such effects run before the page is drawn.

import {readdirSync, readFileSync} from "node:fs"
import {join} from "node:path"
import {fileURLToPath} from "node:url"
import {expect, test} from "vitest"

const source = fileURLToPath(new URL("../../src", import.meta.url))
const components = readdirSync(source, {recursive: true, encoding: "utf8"}).filter(name =>
  name.endsWith(".tsx"),
)

/// The bodies of effects that run after drawing.
const lateEffects = (text: string): readonly string[] =>
  [...text.matchAll(/\buseEffect\(\(\) => (.*?),\s*\[[^\]]*\]\)/gs)].map(([, body]) => body ?? "")

const undoing = /\.(?:focus|select)\(\)|^\s*set[A-Z]\w*\((?:null|false|"")\)/m

test("no effect takes the focus or resets an answer after the page has been drawn", () => {
  expect(components.length).toBeGreaterThan(50)
  const late = components.flatMap(name =>
    lateEffects(readFileSync(join(source, name), "utf8"))
      .filter(body => undoing.test(body))
      .map(body => `${name}: ${body.trim()}`),
  )
  expect(late).toEqual([])
})
