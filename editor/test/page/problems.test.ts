/// Which problems are told when both the blocks and the compiler have found some.

import {expect, it} from "vitest"
import {allFindings} from "../../src/page/problems.tsx"
import {firstPage} from "../../src/state/page.ts"
import type {Finding} from "../../src/state/program.ts"

const finding = (from: "blocks" | "compiler", more: Partial<Finding>): Finding => ({
  severity: "error",
  kind: "no-main",
  from,
  message: "",
  hint: "",
  ghc: "",
  function: null,
  time: null,
  inputs: [],
  fixes: [],
  block: null,
  range: null,
  ...more,
})

const told = (blocks: Finding, compiler: Finding) =>
  allFindings({
    ...firstPage,
    findings: {compiler: [compiler], run: []},
    document: {...firstPage.document, findings: [blocks]},
  }).map(f => `${f.from}: ${f.kind}`)

it("what both miss is told once, and by the compiler", () => {
  expect(told(finding("blocks", {}), finding("compiler", {}))).toEqual(["compiler: no-main"])
})

it("what is nowhere in the text is not the same for that alone", () => {
  const other = finding("compiler", {kind: "type", range: {start: 0, end: 3}})
  expect(told(finding("blocks", {}), other)).toEqual(["blocks: no-main", "compiler: type"])
  expect(told(finding("blocks", {kind: "loose"}), finding("compiler", {}))).toHaveLength(2)
})
