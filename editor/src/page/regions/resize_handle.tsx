/// Resize handles between and inside regions, for pointer and arrow keys.

import type {CSSProperties, JSX, VNode} from "preact"
import {useRef} from "preact/hooks"
import {type Divider, leastShare, mostShare, resizeSplit, shareStep} from "../../state/arrangement.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"

interface Shared {
  /// The share of what stands before the border, from 0 to 1.
  readonly share: number
  readonly least: number
  readonly most: number
  readonly step: number
  readonly split: "beside" | "below"
  readonly label: string
  readonly style?: CSSProperties
  move(share: number): void
  /// What the border divides, on the screen.
  whole(bar: HTMLElement): {readonly start: number; readonly length: number}
}

function ResizeHandle({share, least, most, step, split, label, style, move, whole}: Shared): VNode {
  // Keys come faster than pictures: the next step begins where the last one led, drawn or not.
  const now = useRef(share)
  now.current = share
  const to = (next: number) => {
    now.current = Math.min(most, Math.max(least, next))
    move(now.current)
  }
  const onPointerDown = (down: JSX.TargetedPointerEvent<HTMLDivElement>) => {
    const bar = down.currentTarget
    const {start, length} = whole(bar)
    const mirrored = split === "beside" && isRightToLeft(bar)
    const at = (event: PointerEvent) => {
      const part = ((split === "beside" ? event.clientX : event.clientY) - start) / length
      return mirrored ? 1 - part : part
    }
    // Where it was taken hold of, it stays in the hand.
    const off = share - at(down)
    bar.setPointerCapture(down.pointerId)
    bar.onpointermove = event => to(at(event) + off)
    bar.onlostpointercapture = () => {
      bar.onpointermove = null
    }
  }
  const onKeyDown = (event: JSX.TargetedKeyboardEvent<HTMLDivElement>) => {
    const [shrinks, grows] =
      split === "below"
        ? ["ArrowUp", "ArrowDown"]
        : isRightToLeft(event.currentTarget)
          ? ["ArrowRight", "ArrowLeft"]
          : ["ArrowLeft", "ArrowRight"]
    if (event.key === grows) to(now.current + step)
    else if (event.key === shrinks) to(now.current - step)
    else if (event.key === "Home") to(least)
    else if (event.key === "End") to(most)
    else return
    event.preventDefault()
  }
  return (
    // biome-ignore lint/a11y/useSemanticElements: a separator that moves is a widget (ARIA 1.2); an hr is not
    <div
      class={`border ${split}`}
      style={style}
      role="separator"
      tabIndex={0}
      aria-label={label}
      aria-orientation={split === "below" ? "horizontal" : "vertical"}
      aria-valuenow={Math.round(share * 100)}
      aria-valuemin={Math.round(least * 100)}
      aria-valuemax={Math.round(most * 100)}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
    />
  )
}

/// Whether the page is read from right to left.
export function isRightToLeft(element: Element): boolean {
  return getComputedStyle(element).direction === "rtl"
}

/// The border between two parts of the page.
export function RegionResizeHandle({divider, style}: {divider: Divider; style: CSSProperties}): VNode {
  const {store} = useController()
  const {between, box, split, share} = divider
  const named = (all: Divider["between"][0]) => all.map(region => words.regions[region]).join(", ")
  return (
    <ResizeHandle
      share={share}
      least={leastShare}
      most={mostShare}
      step={shareStep}
      split={split}
      label={words.arrange.border(named(between[0]), named(between[1]))}
      style={style}
      move={next =>
        store.dispatch({kind: "arranged", arrangement: resizeSplit(store.now.arrangement, divider, next)})
      }
      whole={bar => {
        const page = bar.parentElement?.getBoundingClientRect() ?? new DOMRect(0, 0, 1, 1)
        const start = isRightToLeft(bar) ? 1 - box.x - box.w : box.x
        return split === "beside"
          ? {start: page.left + start * page.width, length: box.w * page.width}
          : {start: page.top + box.y * page.height, length: box.h * page.height}
      }}
    />
  )
}

/// The border below the picture of the room.
export function CanvasResizeHandle(): VNode {
  const {store} = useController()
  const share = usePageState(s => s.layout.canvas)
  return (
    <ResizeHandle
      share={share}
      least={0.25}
      most={0.85}
      step={0.04}
      split="below"
      label={words.canvasHeight}
      move={canvas => store.dispatch({kind: "layout", layout: {...store.now.layout, canvas}})}
      whole={bar => {
        const {top, height} = bar.parentElement?.getBoundingClientRect() ?? new DOMRect(0, 0, 1, 1)
        return {start: top, length: height}
      }}
    />
  )
}
