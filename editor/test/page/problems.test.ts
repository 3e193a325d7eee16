/// Which problems are told when both the blocks and the compiler have found some.

import {expect, it} from "vitest"
import {blockProblem} from "../../src/controller/document/document_conversion.ts"
import {allFindings, problemCount} from "../../src/page/panels/problems.tsx"
import type {Finding} from "../../src/program/program.ts"
import {initialState} from "../../src/state/page_state.ts"
import {finding} from "../state/finding.ts"

const from = (who: "blocks" | "compiler", more: Partial<Finding>) =>
  finding({kind: "no-main", from: who, ...more})

const told = (blocks: Finding, compiler: Finding) =>
  allFindings({
    ...initialState,
    findings: {compiler: [compiler], run: []},
    document: {...initialState.document, findings: [blocks]},
  }).map(f => `${f.from}: ${f.kind}`)

it("what both miss is told once, and by the compiler", () => {
  expect(told(from("blocks", {}), from("compiler", {}))).toEqual(["compiler: no-main"])
})

it("what is nowhere in the text is not the same for that alone", () => {
  const other = from("compiler", {kind: "type", range: {start: 0, end: 3}})
  expect(told(from("blocks", {}), other)).toEqual(["blocks: no-main", "compiler: type"])
  expect(told(from("blocks", {kind: "loose"}), from("compiler", {}))).toHaveLength(2)
})

it("notes stand last, are not counted, and put no sign on a block", () => {
  const note = from("compiler", {severity: "note", kind: "never-sent", block: "b"})
  const warning = from("compiler", {severity: "warning", kind: "tab", block: "c"})
  const state = {...initialState, findings: {compiler: [note, warning], run: []}}
  expect(allFindings(state).map(f => f.severity)).toEqual(["warning", "note"])
  expect(problemCount(state)).toBe(1)
  expect([note, warning].flatMap(blockProblem).map(p => p.block)).toEqual(["c"])
})
