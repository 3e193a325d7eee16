/// Header of a region: drag handle, title, hide button.

import type {JSX, VNode} from "preact"
import {CaseWhy} from "../../features/why/why_panel.tsx"
import {dropRegion, moveRegion, type Region, regions, type Side, setVisible} from "../../state/arrangement.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {CloseIcon, GripIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"
import {isRightToLeft} from "./resize_handle.tsx"

export function RegionHeader({region}: {region: Region}): VNode {
  return (
    <div class="region-head">
      <DragHandle region={region} />
      <h2>{words.regions[region]}</h2>
      <span class="space" />
      {region === "haskell" && <CaseWhy />}
      <HideButton region={region} />
    </div>
  )
}

const sides: Readonly<Record<string, Side>> = {
  ArrowLeft: "left",
  ArrowRight: "right",
  ArrowUp: "top",
  ArrowDown: "bottom",
}

/// Pixels that a pointer moves before it drags: less is a press, which opens the menu.
const slack = 5

export function DragHandle({region}: {region: Region}): VNode | null {
  const {store} = useController()
  const useful = usePageState(s => s.size !== "phone")
  if (!useful) return null
  const arranging = (next: ReturnType<typeof dropRegion>) =>
    store.dispatch({kind: "arranging", arranging: {region, next}})

  const onPointerDown = (down: JSX.TargetedPointerEvent<HTMLButtonElement>) => {
    if (down.button !== 0) return
    const grip = down.currentTarget
    const page = grip.closest(".regions")?.getBoundingClientRect()
    if (page === undefined) return
    const mirrored = isRightToLeft(grip)
    let dragging = false
    grip.setPointerCapture(down.pointerId)
    grip.onpointermove = event => {
      dragging ||= Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > slack
      if (!dragging) return
      const x = (event.clientX - page.left) / page.width
      const y = (event.clientY - page.top) / page.height
      arranging(dropRegion(store.now.arrangement, region, mirrored ? 1 - x : x, y))
    }
    // Let fall: what was shown is what it becomes. A drag that the browser or Escape ends changes nothing.
    const end = (keep: boolean) => {
      grip.onpointermove = null
      grip.onpointerup = null
      grip.onlostpointercapture = null
      grip.onkeydown = null
      const {arranging: last} = store.now
      if (keep && dragging && last?.next) store.dispatch({kind: "arranged", arrangement: last.next})
      else store.dispatch({kind: "arranging", arranging: null})
      if (keep && !dragging) store.dispatch({kind: "dialog", dialog: "arrange"})
    }
    grip.onpointerup = () => end(true)
    grip.onlostpointercapture = () => end(false)
    grip.onkeydown = event => {
      if (event.key !== "Escape") return
      event.preventDefault()
      end(false)
    }
    grip.focus({preventScroll: true})
  }
  const onKeyDown = (event: JSX.TargetedKeyboardEvent<HTMLButtonElement>) => {
    const side = sides[event.key]
    if (event.key === "Enter" || event.key === " ") store.dispatch({kind: "dialog", dialog: "arrange"})
    else if (side === undefined) return
    else {
      const mirrored = isRightToLeft(event.currentTarget)
      const meant = !mirrored ? side : side === "left" ? "right" : side === "right" ? "left" : side
      store.dispatch({
        kind: "arranged",
        arrangement: moveRegion(store.now.arrangement, region, "all", meant),
      })
    }
    event.preventDefault()
  }
  return (
    <button
      type="button"
      class="grip"
      aria-label={words.arrange.move(words.regions[region])}
      aria-description={words.arrange.moveHint}
      title={words.arrange.moveHint}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
    >
      <GripIcon />
    </button>
  )
}

/// Nothing is left to hide when it is the only one.
export function HideButton({region}: {region: Region}): VNode | null {
  const {store} = useController()
  const useful = usePageState(s => s.size === "wide" && s.arrangement.hidden.length < regions.length - 1)
  if (!useful) return null
  const label = words.arrange.hide(words.regions[region])
  return (
    <button
      type="button"
      class="plain icon small hide"
      aria-label={label}
      title={label}
      onClick={() =>
        store.dispatch({kind: "arranged", arrangement: setVisible(store.now.arrangement, region, false)})
      }
    >
      <CloseIcon />
    </button>
  )
}
