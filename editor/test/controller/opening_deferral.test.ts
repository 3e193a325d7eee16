/// Programs that are chosen before and after the page can read programs.

import type {Reader} from "@rosy/codegen/reader"
import {expect, test} from "vitest"
import {deferOpening} from "../../src/controller/programs/opening_deferral.ts"

const reader = {} as Reader

function page() {
  let loaded: Reader | null = null
  const opened: string[] = []
  const deferral = deferOpening(() => loaded)
  return {
    opened,
    choose: (name: string) => deferral.open(() => opened.push(name)),
    release: () => deferral.release(),
    load() {
      loaded = reader
    },
  }
}

test("a program that is chosen too early is opened once when programs can be read, the last of several", () => {
  const {opened, choose, load, release} = page()
  choose("first")
  choose("second")
  release()
  expect(opened).toEqual([])
  load()
  release()
  release()
  expect(opened).toEqual(["second"])
})

test("afterwards programs are opened at once, and replace one that still waits", () => {
  const {opened, choose, load, release} = page()
  choose("early")
  load()
  choose("late")
  release()
  expect(opened).toEqual(["late"])
})
