/// Which findings of the blocks and of the compiler the page shows.

import {describe, expect, it} from "vitest"
import {type Document, emptyHistory} from "../../src/program/history.ts"
import type {Finding} from "../../src/program/program.ts"
import type {PageEvent} from "../../src/state/page_events.ts"
import type {PageState} from "../../src/state/page_state.ts"
import {compiled, trustedFindings} from "../../src/state/visible_findings.ts"
import type {Problem} from "../../src/wire/problem.generated.ts"
import {document, ended, hear, open, play, press, problem, program, text} from "./event_player.ts"
import {finding} from "./finding.ts"

describe("an empty socket", () => {
  const hole = (socket: string) => finding({kind: "hole", block: "main", socket, range: {start: 24, end: 50}})
  const wrong = finding({kind: "type-mismatch", block: "type", range: {start: 14, end: 22}})
  const holding = (...findings: readonly Finding[]): Document => ({...document, findings})
  const fromCompiler = (kind: string, start: number) =>
    finding({kind, from: "compiler", block: "main", range: {start, end: start + 1}})
  const told = (state: PageState) => [...trustedFindings(state), ...compiled(state)]
  const change = (findings: readonly Finding[], more: string): PageEvent => ({
    kind: "program-changed",
    document: {...holding(...findings), program: {...program, text: text + more}},
    by: "blocks",
    at: 0,
  })

  it("is no problem until Run is refused; what else is wrong is", () => {
    const mismatch = fromCompiler("type-mismatch", 40)
    const state: PageState = {
      ...open,
      document: holding(hole("main.a"), wrong),
      findings: {compiler: [fromCompiler("hole", 45), mismatch], run: []},
    }
    expect(told(state)).toEqual([wrong, mismatch])
    expect(told(play(state, press, ended(1, "refused")).state)).toEqual([hole("main.a"), wrong])
  })

  it("stays one until it is filled, while another that is made later is none", () => {
    const refused = play({...open, document: holding(hole("main.a"))}, press, ended(1, "refused"))
    const later = play(refused.state, change([hole("main.a"), hole("main.b")], "-- later\n"))
    expect(told(later.state)).toEqual([hole("main.a")])
    const filled = play(later.state, change([hole("main.b")], "-- filled\n"))
    expect(told(filled.state)).toEqual([])
    expect(told(play(filled.state, press, ended(2, "refused")).state)).toEqual([hole("main.b")])
  })

  it("that is found only after the run was refused is one too", () => {
    const refused = play(open, press, ended(1, "refused")).state
    const found: PageEvent = {kind: "analysed", before: document, document: holding(hole("main.a"))}
    expect(told(play(refused, found).state)).toEqual([hole("main.a")])
    const other = play(refused, change([], "-- later\n")).state
    const later: PageEvent = {
      kind: "analysed",
      before: other.document,
      document: {...other.document, findings: [hole("main.a")]},
    }
    expect(told(play(other, later).state)).toEqual([])
  })

  it("explains what the compiler cannot explain around it, but nothing beside it", () => {
    const around = finding({kind: "other", from: "compiler", block: "main", range: {start: 31, end: 49}})
    const beside = finding({kind: "other", from: "compiler", block: "def", range: {start: 0, end: 10}})
    const state: PageState = {
      ...open,
      document: holding(hole("main.a")),
      findings: {compiler: [fromCompiler("hole", 45), around, beside], run: []},
    }
    expect(told(state)).toEqual([beside])
    const filled = {...state, findings: {compiler: [around, beside], run: []}}
    expect(told(filled)).toEqual([around, beside])
  })

  it("that only the text has is the compiler's to report", () => {
    const state: PageState = {...open, findings: {compiler: [fromCompiler("hole", 45)], run: []}}
    expect(told(state)).toHaveLength(1)
  })

  it("of another program does not count", () => {
    const refused = play({...open, document: holding(hole("main.a"))}, press, ended(1, "refused"))
    const another: PageEvent = {
      kind: "opened",
      opened: {
        name: "new",
        world: null,
        document: holding(hole("main.a")),
        history: emptyHistory,
        welcome: false,
        isNew: false,
      },
    }
    expect(told(play(refused.state, another).state)).toEqual([])
  })
})

describe("the compiler", () => {
  it("is asked after every change of the text, and only its newest answer counts", () => {
    const change = (t: string): PageEvent => ({
      kind: "program-changed",
      document: {...document, program: {...program, text: t}},
      by: "blocks",
      at: 0,
    })
    const {state, sent} = play(open, change("a"), change("b"))
    const ids = sent.flatMap(m => (m.op === "check" ? [m.id] : []))
    expect(new Set(ids).size).toBe(2)
    const checked = (id: number) =>
      hear({
        op: "checked",
        id,
        problems: [problem],
        declarations: [],
        parts: [],
        topics: [],
        types: {names: [], at: []},
        groups: null,
      })
    expect(play(state, checked(ids[0] ?? -1)).state.findings.compiler).toEqual([])
    expect(play(state, checked(ids[1] ?? -1)).state.findings.compiler).toHaveLength(1)
  })

  it("is believed before the blocks once it has taken the text, but not about a loose block", () => {
    const doubt = (kind: string) => finding({kind, message: kind, block: "b"})
    const doubted: PageState = {
      ...open,
      document: {...document, findings: [doubt("loose"), doubt("not-in-scope")]},
    }
    const answers = (problems: readonly Problem[]) =>
      play(
        doubted,
        hear({
          op: "checked",
          id: doubted.checks,
          problems,
          declarations: [],
          parts: [],
          topics: [],
          types: {names: [], at: []},
          groups: null,
        }),
      ).state
    expect(trustedFindings(doubted)).toHaveLength(2)
    expect(trustedFindings(answers([])).map(f => f.kind)).toEqual(["loose"])
    expect(trustedFindings(answers([problem]))).toHaveLength(2)
  })

  it("is not asked when blocks only moved", () => {
    expect(play(open, {kind: "program-changed", document, by: "blocks", at: 0}).sent).toEqual([])
  })
})
