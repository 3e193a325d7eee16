/// A room in which a program was tested: its picture with the path, and what went wrong there in sentences.

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import type {Finding, TestedRoom} from "../../jobs/room_test.ts"
import {drawThumbnail} from "../../views/room/world_drawing.ts"
import {words} from "../../words/index.ts"

export function Picture({tested}: {readonly tested: TestedRoom}): VNode {
  const canvas = useRef<HTMLCanvasElement>(null)
  useLayoutEffect(() => {
    if (canvas.current !== null) drawThumbnail(canvas.current, tested.world, tested.path)
  }, [tested])
  return <canvas ref={canvas} />
}

/// What went wrong in a room; empty if nothing did.
export function happened(tested: TestedRoom): string {
  const failed = tested.findings.filter(finding => finding.state !== "held")
  return [...tested.problems, ...failed.map(finding => sentence(finding, tested.time))].join(" ")
}

function sentence({kind, time, amount}: Finding, end: number): string {
  const w = words.roomTests.found
  const at = time ?? end
  switch (kind) {
    case "never-falls":
      return w[kind](at)
    case "never-pushes":
      return w[kind](amount, at)
    default:
      return w[kind](amount)
  }
}
