/// What is chosen in the world editor, as fields; or the room itself and a list of all that stands in it.

import type {VNode} from "preact"
import {useEffect, useRef} from "preact/hooks"
import {words} from "../words/index.ts"
import type {WorldEdit} from "../worlds/editor.ts"
import {hasRoomFor, type Part, partsOf, put, samePart} from "../worlds/parts.ts"
import {clamp, tidy, wrapped} from "../worlds/plane.ts"
import {limits, type World, type WorldGoal} from "../worlds/world.ts"
import {describePart, nameOfPart} from "./describe.ts"
import {useDesk, usePage} from "./pick.ts"

type Edit = (event: WorldEdit) => void

export function PartPanel({edit}: {edit: Edit}): VNode | null {
  const editor = usePage(s => s.worldEditor)
  const panel = useRef<HTMLElement>(null)
  const about = JSON.stringify(editor?.chosen ?? null)
  // The fields of what is chosen come into sight, also after choosing at the end of the list.
  useEffect(() => {
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
                disabled={!hasRoomFor(world, chosen.kind)}
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

// Fields

function NumberField(props: {
  readonly label: string
  readonly unit: string
  readonly value: number
  readonly step: number
  readonly least: number
  readonly most: number
  readonly set: (value: number) => void
}): VNode {
  const {label, unit, value, step, least, most, set} = props
  return (
    <label class="part-field">
      <span>{label}</span>
      <input
        type="number"
        value={+value.toFixed(3)}
        step={step}
        min={least}
        max={most}
        onChange={event => {
          const typed = event.currentTarget.valueAsNumber
          if (Number.isFinite(typed)) set(clamp(tidy(typed), least, most))
          else event.currentTarget.value = String(+value.toFixed(3))
        }}
      />
      <span class="quiet">{unit}</span>
    </label>
  )
}

const lengthStep = 0.1

function Metres(props: {
  readonly label: string
  readonly value: number
  readonly set: (value: number) => void
  readonly least?: number
  readonly most?: number
}): VNode {
  const {label, value, set, least = limits.length[0], most = limits.side} = props
  return <NumberField {...{label, value, set, least, most}} unit="m" step={lengthStep} />
}

function Angle({value, set}: {value: number; set: (value: number) => void}): VNode {
  const degrees = (value * 180) / Math.PI
  const turn = (typed: number) => set(tidy(wrapped((typed * Math.PI) / 180)))
  return (
    <NumberField
      label={words.world.angle}
      unit="°"
      value={+degrees.toFixed(1)}
      step={15}
      least={-360}
      most={360}
      set={turn}
    />
  )
}

function Check({label, value, set}: {label: string; value: boolean; set: (on: boolean) => void}): VNode {
  return (
    <label class="part-field check">
      <input type="checkbox" checked={value} onChange={event => set(event.currentTarget.checked)} />
      <span>{label}</span>
    </label>
  )
}

/// Where a thing is, for things with one place.
function PlaceFields(props: {
  readonly world: World
  readonly x: number
  readonly y: number
  readonly set: (place: {x?: number; y?: number}) => void
}): VNode {
  const {world, x, y, set} = props
  return (
    <>
      <Metres label={words.world.x} value={x} least={0} most={world.size[0]} set={to => set({x: to})} />
      <Metres label={words.world.y} value={y} least={0} most={world.size[1]} set={to => set({y: to})} />
    </>
  )
}

function WeightFields(props: {
  readonly movable: boolean
  readonly mass: number
  readonly set: (weight: {movable?: boolean; mass?: number}) => void
}): VNode {
  const {movable, mass, set} = props
  const [least, most] = limits.mass
  return (
    <>
      <Check label={words.world.movable} value={movable} set={on => set({movable: on})} />
      {movable && (
        <NumberField
          label={words.world.mass}
          unit="kg"
          value={mass}
          {...{step: 0.5, least, most}}
          set={to => set({mass: to})}
        />
      )}
    </>
  )
}

function PartFields({
  world,
  part,
  change,
}: {
  world: World
  part: Part
  change: (world: World) => void
}): VNode | null {
  switch (part.kind) {
    case "start": {
      const {start} = world
      const set = (to: Partial<World["start"]>) => change({...world, start: {...start, ...to}})
      return (
        <>
          <PlaceFields world={world} x={start.x} y={start.y} set={set} />
          <Angle value={start.theta} set={theta => set({theta})} />
        </>
      )
    }
    case "wall": {
      const wall = world.walls[part.index]
      if (wall === undefined) return null
      const set = (to: Partial<typeof wall>) =>
        change({...world, walls: put(world.walls, part.index, {...wall, ...to})})
      const end = (which: "from" | "to") => {
        const [x, y] = wall[which]
        return (
          <PlaceFields
            key={which}
            world={world}
            {...{x, y}}
            set={to => set({[which]: [to.x ?? x, to.y ?? y]})}
          />
        )
      }
      return (
        <>
          {end("from")}
          {end("to")}
        </>
      )
    }
    case "box": {
      const box = world.boxes[part.index]
      if (box === undefined) return null
      const set = (to: Partial<typeof box>) =>
        change({...world, boxes: put(world.boxes, part.index, {...box, ...to})})
      return (
        <>
          <PlaceFields world={world} x={box.x} y={box.y} set={set} />
          <Metres label={words.world.width} value={box.w} set={w => set({w})} />
          <Metres label={words.world.height} value={box.h} set={h => set({h})} />
          <Angle value={box.theta} set={theta => set({theta})} />
          <WeightFields movable={box.movable} mass={box.mass} set={set} />
        </>
      )
    }
    case "round": {
      const round = world.rounds[part.index]
      if (round === undefined) return null
      const set = (to: Partial<typeof round>) =>
        change({...world, rounds: put(world.rounds, part.index, {...round, ...to})})
      return (
        <>
          <PlaceFields world={world} x={round.x} y={round.y} set={set} />
          <Metres label={words.world.radius} value={round.r} set={r => set({r})} />
          <WeightFields movable={round.movable} mass={round.mass} set={set} />
        </>
      )
    }
    case "goal": {
      const goal = world.goals[part.index]
      if (goal === undefined) return null
      return (
        <GoalFields
          world={world}
          goal={goal}
          set={to => change({...world, goals: put(world.goals, part.index, to)})}
        />
      )
    }
  }
}

function GoalFields({
  world,
  goal,
  set,
}: {
  world: World
  goal: WorldGoal
  set: (goal: WorldGoal) => void
}): VNode {
  const timed = goal.kind !== "avoid"
  const [shortest] = limits.within
  return (
    <>
      <label class="part-field wide">
        <span>{words.world.goalTitle}</span>
        <input
          type="text"
          value={goal.title}
          maxLength={80}
          onChange={event => set({...goal, title: event.currentTarget.value})}
        />
      </label>
      {"x" in goal && (
        <>
          <PlaceFields world={world} x={goal.x} y={goal.y} set={to => set({...goal, ...to})} />
          <Metres label={words.world.radius} value={goal.r} set={r => set({...goal, r})} />
        </>
      )}
      {goal.kind === "visit" && (
        <Metres label={words.world.radius} value={goal.r} set={r => set({...goal, r})} />
      )}
      {goal.kind === "draw" && (
        <Metres
          label={words.world.tolerance}
          value={goal.tolerance}
          set={tolerance => set({...goal, tolerance})}
        />
      )}
      {goal.kind === "lap" && (
        <NumberField
          label={words.world.laps}
          unit=""
          value={goal.laps}
          step={1}
          least={1}
          most={limits.laps}
          set={laps => set({...goal, laps: Math.round(laps)})}
        />
      )}
      {timed && (
        <Check
          label={words.world.timed}
          value={goal.within !== null}
          set={on => set({...goal, within: on ? usualLimit : null})}
        />
      )}
      {timed && goal.within !== null && (
        <NumberField
          label={words.world.within}
          unit="s"
          value={goal.within}
          step={5}
          least={shortest}
          most={3600}
          set={within => set({...goal, within})}
        />
      )}
    </>
  )
}

/// Seconds that a learner is first given.
const usualLimit = 60

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
  const {store} = useDesk()
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
        if (!on || hasRoomFor(world, "goal")) change({...world, goals: on ? [...goals, more] : goals})
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
const likeReal = {slip: 0.05, drift: 0.03, noise: 0.01, latency: 0.06} as const
