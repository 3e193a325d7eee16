/// A finding to test with: every field filled in, and any of them replaced by the test.

import type {Finding} from "../../src/program/program.ts"

export const finding = (more: Partial<Finding>): Finding => ({
  severity: "error",
  kind: "no-main",
  from: "blocks",
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
