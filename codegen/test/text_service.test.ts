/// Text service: places in characters, answers for any text, and the same answers as the functions that the page calls.

import {beforeAll, describe, expect, it} from "vitest"
import {formatted, type Reader} from "../src/reader/index.ts"
import {answerLine, greeting, linesOf} from "../src/text_service.ts"
import {corpus, testReader} from "./reader/open.ts"

let reader: Reader
beforeAll(async () => {
  reader = await testReader()
})

const ask = (request: object) => JSON.parse(answerLine(reader, JSON.stringify({id: 7, ...request})))

const robot = "-- 🤖\nf 🤖 = 1\n"

describe("the greeting", () => {
  it("has the names of Rosy and the Prelude", () => {
    const {op, names} = JSON.parse(greeting())
    expect(op).toBe("ready")
    expect(names).toContainEqual({name: "map", kind: "value", type: "(a -> b) -> [a] -> [b]"})
  })
})

describe("cursor", () => {
  it.each([
    [1, 2, "comment"],
    [2, 1, "name"],
    [2, 2, "name"],
    [2, 5, "operator"],
    [2, 8, "number"],
  ])("line %i, column %i is in or behind a %s", (line, column, kind) => {
    expect(ask({op: "cursor", source: robot, line, column}).token.kind).toBe(kind)
  })
  it("counts characters, not UTF-16 units", () => {
    expect(ask({op: "cursor", source: "x 🤖 yes", line: 1, column: 6}).token).toEqual({
      kind: "name",
      start: {line: 1, column: 5},
      end: {line: 1, column: 8},
      text: "yes",
    })
  })
  it("finds nothing between tokens and in an empty text", () => {
    expect(ask({op: "cursor", source: "a  b", line: 1, column: 3}).token).toBeNull()
    expect(ask({op: "cursor", source: "", line: 1, column: 1}).token).toBeNull()
  })
})

describe("rename", () => {
  const source = 'say "🤖" = go\n\ngo :: Velocity\ngo = Velocity 0 0\n\nmain = simulate go\n'
  it("gives every place, in characters", () => {
    const {edits, why} = ask({op: "rename", source, line: 4, column: 1, name: "los"})
    expect(why).toBe("")
    expect(edits).toEqual([
      {start: {line: 1, column: 11}, end: {line: 1, column: 13}, text: "los"},
      {start: {line: 3, column: 1}, end: {line: 3, column: 3}, text: "los"},
      {start: {line: 4, column: 1}, end: {line: 4, column: 3}, text: "los"},
      {start: {line: 6, column: 17}, end: {line: 6, column: 19}, text: "los"},
    ])
  })
  it.each([
    ["let", "“let” is one of Haskell's own words."],
    ["main", "main already means something else where this name is used."],
  ])("says why it cannot become %s", (name, why) => {
    expect(ask({op: "rename", source, line: 4, column: 1, name})).toEqual({
      op: "renamed",
      id: 7,
      edits: [],
      why,
    })
  })
  it("waits for broken definitions, in which places would be missed", () => {
    const broken = `${source}\nother = (go\n`
    expect(ask({op: "rename", source: broken, line: 4, column: 1, name: "los"}).why).toContain("not finished")
  })
  it("renames nothing where there is no name", () => {
    expect(ask({op: "rename", source, line: 2, column: 1, name: "los"}).why).toBe("There is no name here.")
  })
})

describe("signature", () => {
  const declared = [{name: "go", type: "Double -> (Int -> Int) -> Velocity"}]
  it("knows the program's own functions and the library's", () => {
    expect(ask({op: "signature", source: "a = go 1 ", line: 1, column: 10, declared}).signature).toEqual({
      name: "go",
      parts: ["Double", "(Int -> Int)", "Velocity"],
      argument: 1,
    })
    expect(ask({op: "signature", source: "a = Led1 ", line: 1, column: 10, declared}).signature.name).toBe(
      "Led1",
    )
  })
  it("is silent behind the last argument and for unknown functions", () => {
    expect(ask({op: "signature", source: "a = go 1 f ", line: 1, column: 12, declared}).signature).toBeNull()
    expect(ask({op: "signature", source: "a = nothing ", line: 1, column: 13, declared}).signature).toBeNull()
  })
})

describe("format", () => {
  it.each(corpus.slice(0, 5).map(({name, text}) => [name, text]))(
    "%s is laid out as in the page",
    (_, text) => {
      const {id, op, ...rest} = ask({op: "format", source: text})
      expect([id, op]).toEqual([7, "formatted"])
      expect(rest).toEqual(formatted(reader, text))
    },
  )
})

describe("a request that is wrong", () => {
  it.each(["", "nonsense", "null", '{"id":7,"op":"format"}', '{"id":7,"op":"dance","source":""}'])(
    "%s fails, and the next one is answered",
    line => {
      expect(JSON.parse(answerLine(reader, line)).op).toBe("failed")
      expect(ask({op: "format", source: "a  = 1\n"}).text).toBe("a = 1\n")
    },
  )
})

describe("an exchange", () => {
  it("has the id and the version of its question in every answer", () => {
    for (const op of ["cursor", "rename", "signature", "format", "dance"]) {
      const question = {
        op,
        id: 12,
        version: 34,
        source: "a = 1\n",
        line: 1,
        column: 1,
        name: "b",
        declared: [],
      }
      expect(JSON.parse(answerLine(reader, JSON.stringify(question)))).toMatchObject({id: 12, version: 34})
    }
  })
})

describe("lines of a stream", () => {
  // Each of these ends a line for some reader of lines.
  const lines = ["a\u2028b", "\u2029", "c\u0085d", "e\vf\fg", "h\x1ci", "𝄞é", "", "j\rk"]
  const bytes = new TextEncoder().encode(lines.map(line => `${line}\n`).join(""))
  const chunks = async function* (sizes: readonly number[]) {
    for (let at = 0, i = 0; at < bytes.length; i += 1) {
      const size = sizes[i % sizes.length] ?? 1
      yield bytes.subarray(at, at + size)
      at += size
    }
  }
  it.each([[[1]], [[2, 3]], [[bytes.length]], [[5, 1, 7]]])(
    "end at \\n only, in chunks of %j",
    async sizes => {
      const found: string[] = []
      for await (const line of linesOf(chunks(sizes))) found.push(line)
      expect(found).toEqual(lines)
    },
  )
})

describe("conflicts", () => {
  const functions =
    "-- 🤖\ngo :: Velocity\ngo = Velocity 0.2 0\n\nback :: Bumper -> Velocity\nback _ = Velocity (-0.2) 0\n\n"
  it("are warnings of the page, once each, at the winner's name, with the way out as an edit", () => {
    const source = `${functions}main = simulate (back, go)\n`
    expect(ask({op: "conflicts", source}).problems).toEqual([
      {
        severity: "warning",
        kind: "conflict",
        message: "`back` and `go` both set the velocity, and `go` keeps winning.",
        hint: "Say which one goes first with the block `first … for 1 s, otherwise …` (`priority`).",
        ghc: "",
        start: {line: 2, column: 1},
        end: {line: 2, column: 3},
        fixes: [
          {
            title: "Let back go first, for 1 s",
            edits: [{start: {line: 8, column: 17}, end: {line: 8, column: 27}, text: "(priority 1 back go)"}],
          },
        ],
      },
    ])
  })
  it("of a value that stands in simulate are there", () => {
    const source = `${functions}main = simulate (Velocity 0.1 0, back)\n`
    expect(ask({op: "conflicts", source}).problems[0]).toMatchObject({
      start: {line: 8, column: 18},
      end: {line: 8, column: 26},
    })
  })
  it.each(["main = simulate (priority 1 back go)", "main = simulate go", "main = simulate (go,", ""])(
    "there are none in %j",
    main => expect(ask({op: "conflicts", source: functions + main}).problems).toEqual([]),
  )
})
