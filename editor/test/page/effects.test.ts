/// Effects that run after the page has been drawn come a frame late, or later on a busy computer. One that takes the focus or sets state
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

/// What takes the focus, and a statement that sets state at once. What sets it later, such as a timer's function, is no statement of the effect.
const undoing = /\.(?:focus|select)\(\)|^\s*(?:if \(.*\) )?set[A-Z]\w*\(/m

test("no effect takes the focus or sets state after the page has been drawn", () => {
  expect(components.length).toBeGreaterThan(50)
  const late = components.flatMap(name =>
    lateEffects(readFileSync(join(source, name), "utf8"))
      .filter(body => undoing.test(body))
      .map(body => `${name}: ${body.trim()}`),
  )
  expect(late).toEqual([])
})
