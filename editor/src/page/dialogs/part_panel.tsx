/// Panel of the world editor: properties of the selection, or those of the room, and the list of parts.

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {useController, usePageState} from "../../ui/app_context.ts"
import {describePart, nameOfPart} from "../../ui/descriptions.ts"
import {words} from "../../words/index.ts"
import type {WorldEdit} from "../../worlds/editor_value.ts"
import {ideal, type World, type WorldGoal} from "../../worlds/world.ts"
import {isMovable, limitReached, type Part, partsOf, samePart} from "../../worlds/world_parts.ts"
import {PartFields} from "./part_fields.tsx"
import {Check, Metres} from "./property_fields.tsx"

type Edit = (event: WorldEdit) => void

export function PartPanel({edit}: {edit: Edit}): VNode | null {
  const editor = usePageState(s => s.worldEditor)
  const panel = useRef<HTMLElement>(null)
  const about = JSON.stringify(editor?.chosen ?? null)
  // The fields of what is chosen come into sight, also after choosing at the end of the list.
  useLayoutEffect(() => {
    if (about !== "null") panel.current?.scrollTo({top: 0})
  }, [about])
  if (editor === null) return null
  const {world, chosen} = editor
  const change = (changed: World) => edit({kind: "change", world: changed})
  return (
    <aside
      ref={panel}
      class="part-panel"
      aria-label={chosen === null ? words.world.room : nameOfPart(world, chosen)}
    >
      {chosen === null ? (
        <RoomFields world={world} change={change} edit={edit} snap={editor.snap} />
      ) : (
        <>
          <h3>{nameOfPart(world, chosen)}</h3>
          <div class="part-fields">
            <PartFields world={world} part={chosen} change={change} />
          </div>
          {chosen.kind !== "start" && (
            <span class="pair">
              <button
                type="button"
                class="plain"
                disabled={limitReached(world, chosen.kind, isMovable(world, chosen)) !== null}
                onClick={() => edit({kind: "duplicate"})}
              >
                {words.world.duplicate}
              </button>
              <button type="button" class="plain" onClick={() => edit({kind: "delete"})}>
                {words.world.delete}
              </button>
            </span>
          )}
        </>
      )}
      <Things world={world} chosen={chosen} edit={edit} />
    </aside>
  )
}

/// Every part by name: the way to choose without a pointer.
function Things({world, chosen, edit}: {world: World; chosen: Part | null; edit: Edit}): VNode {
  return (
    <nav class="things" aria-label={words.world.things}>
      <h3>{words.world.things}</h3>
      <ul>
        {partsOf(world).map(part => (
          <li key={JSON.stringify(part)}>
            <button
              type="button"
              class="item"
              aria-pressed={samePart(part, chosen)}
              aria-label={describePart(world, part)}
              onClick={() => edit({kind: "choose", part: samePart(part, chosen) ? null : part})}
            >
              {nameOfPart(world, part)}
            </button>
          </li>
        ))}
      </ul>
    </nav>
  )
}

function RoomFields({
  world,
  change,
  edit,
  snap,
}: {
  world: World
  change: (world: World) => void
  edit: Edit
  snap: boolean
}): VNode {
  const {store} = useController()
  const [width, height] = world.size
  const avoids = (what: "bumps" | "holes") =>
    world.goals.findIndex(g => g.kind === "avoid" && g.what === what)
  const avoid = (what: "bumps" | "holes") => (
    <Check
      label={words.world.avoids[what]}
      value={avoids(what) >= 0}
      set={on => {
        const goals = world.goals.filter((_, i) => i !== avoids(what))
        const more: WorldGoal = {kind: "avoid", what, title: "", within: null}
        change({...world, goals: on ? [...goals, more] : goals})
      }}
    />
  )
  return (
    <>
      <h3>{words.world.room}</h3>
      <div class="part-fields">
        <label class="part-field wide">
          <span>{words.world.name}</span>
          <input
            type="text"
            value={world.name}
            maxLength={60}
            onChange={event => change({...world, name: event.currentTarget.value})}
          />
        </label>
        <Metres
          label={words.world.width}
          value={width}
          least={0.5}
          set={to => edit({kind: "resize", width: to, height})}
        />
        <Metres
          label={words.world.height}
          value={height}
          least={0.5}
          set={to => edit({kind: "resize", width, height: to})}
        />
        <Check label={words.world.snap} value={snap} set={on => edit({kind: "snap", snap: on})} />
        {avoid("bumps")}
        {avoid("holes")}
        <Check
          label={words.world.realistic}
          value={world.realism !== null}
          set={on => change({...world, realism: on ? likeReal : null})}
        />
        <Check
          label={words.world.dock}
          value={world.dock !== null}
          set={on => change({...world, dock: on ? world.start : null})}
        />
        <Check
          label={words.world.scanner}
          value={world.scanner}
          set={on => change({...world, scanner: on})}
        />
      </div>
      <span class="pair">
        <button type="button" class="plain" onClick={() => store.dispatch({kind: "world-file-wanted"})}>
          {words.world.openFile}
        </button>
        <button type="button" class="plain" onClick={() => store.dispatch({kind: "world-file-made"})}>
          {words.world.saveFile}
        </button>
      </span>
    </>
  )
}

/// The realism of a learner's own room: that of the gallery's slippery one.
const likeReal = {...ideal, slip: 0.05, drift: 0.03, noise: 0.01, latency: 0.06}
