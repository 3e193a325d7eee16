/// A border between two regions: dragged, or moved with the arrow keys; where it is is remembered.

import type {JSX, VNode} from "preact"
import type {Layout} from "../state/page.ts"
import {words} from "../words/index.ts"
import {useDesk, usePage} from "./pick.ts"

/// Pixels for the widths, a share for the height of the room's canvas.
const limits: Record<keyof Layout, {least: number; most: number; step: number}> = {
  haskell: {least: 180, most: 900, step: 16},
  room: {least: 300, most: 1000, step: 16},
  canvas: {least: 0.25, most: 0.85, step: 0.04},
}

export function Border({of}: {of: keyof Layout}): VNode {
  const {store} = useDesk()
  const value = usePage(s => s.layout[of])
  const {least, most, step} = limits[of]
  const move = (to: number) =>
    store.dispatch({
      kind: "layout",
      layout: {...store.now.layout, [of]: Math.min(most, Math.max(least, to))},
    })

  const onPointerDown = (down: JSX.TargetedPointerEvent<HTMLDivElement>) => {
    const bar = down.currentTarget
    const from = store.now.layout[of]
    const height = bar.parentElement?.getBoundingClientRect().height ?? 1
    bar.setPointerCapture(down.pointerId)
    bar.onpointermove = event => {
      // Widths belong to the region right of their border, so they grow to the left.
      if (of === "canvas") move(from + (event.clientY - down.clientY) / height)
      else move(from - (event.clientX - down.clientX))
    }
    bar.onpointerup = () => {
      bar.onpointermove = null
    }
  }
  const onKeyDown = (event: JSX.TargetedKeyboardEvent<HTMLDivElement>) => {
    const grows = of === "canvas" ? "ArrowDown" : "ArrowLeft"
    const shrinks = of === "canvas" ? "ArrowUp" : "ArrowRight"
    if (event.key === grows) move(value + step)
    else if (event.key === shrinks) move(value - step)
    else if (event.key === "Home") move(least)
    else if (event.key === "End") move(most)
    else return
    event.preventDefault()
  }
  return (
    // biome-ignore lint/a11y/useSemanticElements: a separator that moves is a widget (ARIA 1.2); an hr is not
    <div
      class={`border ${of}`}
      role="separator"
      tabIndex={0}
      aria-label={words.borders[of]}
      aria-orientation={of === "canvas" ? "horizontal" : "vertical"}
      aria-valuenow={of === "canvas" ? Math.round(value * 100) : value}
      aria-valuemin={of === "canvas" ? Math.round(least * 100) : least}
      aria-valuemax={of === "canvas" ? Math.round(most * 100) : most}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
    />
  )
}
