/// Layout menu: thumbnails of region layouts, visibility of regions, and reset.

import type {VNode} from "preact"
import {
  type Arrangement,
  boxes,
  firstArrangement,
  presetTrees,
  regions,
  sameShape,
  setVisible,
  type Tree,
  visibleTree,
} from "../../state/arrangement.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {usePopup} from "../../ui/controls.tsx"
import {ArrangeIcon, PartIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"

export function LayoutMenu(): VNode {
  const {open, box, button, toggle} = usePopup("arrange")
  return (
    <div class="menu" ref={box}>
      <button
        type="button"
        class="plain icon"
        ref={button}
        title={words.arrange.hint}
        aria-label={words.arrange.title}
        aria-expanded={open}
        onClick={toggle}
      >
        <ArrangeIcon />
      </button>
      {open && <Arranging />}
    </div>
  )
}

function Arranging(): VNode {
  const {store} = useController()
  const arrangement = usePageState(s => s.arrangement)
  const wide = usePageState(s => s.size === "wide")
  // The diagram is part of the choices while it is shown.
  const seen = (tree: Tree) =>
    visibleTree(
      tree,
      arrangement.hidden.filter(region => region === "diagram"),
    ) ?? tree
  const set = (next: Arrangement) => store.dispatch({kind: "arranged", arrangement: next})
  return (
    <div class="menu-items arranging">
      <p class="label">{words.arrange.choices}</p>
      <div class="arrangements">
        {presetTrees.map(tree => (
          <button
            type="button"
            key={nameOf(seen(tree))}
            aria-label={nameOf(seen(tree))}
            title={nameOf(seen(tree))}
            aria-pressed={sameShape(tree, arrangement.tree)}
            onClick={() => set({...arrangement, tree})}
          >
            <Sketch tree={seen(tree)} />
          </button>
        ))}
      </div>
      {wide && (
        <>
          <hr />
          <p class="label">{words.arrange.shown}</p>
          {regions.map(region => (
            <label class="item check" key={region}>
              {words.regions[region]}
              <input
                type="checkbox"
                checked={!arrangement.hidden.includes(region)}
                disabled={
                  arrangement.hidden.length === regions.length - 1 && !arrangement.hidden.includes(region)
                }
                onChange={event => set(setVisible(arrangement, region, event.currentTarget.checked))}
              />
            </label>
          ))}
        </>
      )}
      <hr />
      <button type="button" class="item" onClick={() => set(firstArrangement)}>
        {words.arrange.reset}
      </button>
      <p class="label">{words.arrange.how}</p>
    </div>
  )
}

/// A tree in words: `Blocks beside Haskell beside Room`.
function nameOf(tree: Tree): string {
  if (typeof tree === "string") return words.regions[tree]
  const join = tree.split === "beside" ? words.arrange.beside : words.arrange.below
  return join(nameOf(tree.first), nameOf(tree.second))
}

/// The size of a picture, and the gap between its parts, in its own units.
const width = 54
const height = 36
const gap = 2

function Sketch({tree}: {tree: Tree}): VNode {
  return (
    <svg viewBox={`0 0 ${width} ${height}`} width={width} height={height} aria-hidden="true">
      {[...boxes(tree)].map(([region, {x, y, w, h}]) => (
        <g key={region} class={`sketch ${region}`}>
          <rect
            x={x * width + gap / 2}
            y={y * height + gap / 2}
            width={w * width - gap}
            height={h * height - gap}
            rx={2.5}
          />
          <PartIcon region={region} x={(x + w / 2) * width} y={(y + h / 2) * height} />
        </g>
      ))}
    </svg>
  )
}
