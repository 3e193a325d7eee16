/// Properties of the part that is selected in the world editor, as fields.

import type {VNode} from "preact"
import {words} from "../../words/index.ts"
import {limits, type World, type WorldGoal} from "../../worlds/world.ts"
import {type Part, put} from "../../worlds/world_parts.ts"
import {Angle, Check, Metres, NumberField, PlaceFields, WeightFields} from "./property_fields.tsx"

export function PartFields({
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
          {!box.unknown && <WeightFields movable={box.movable} mass={box.mass} set={set} />}
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
    case "line": {
      const line = world.lines[part.index]
      if (line === undefined) return null
      const set = (width: number) => change({...world, lines: put(world.lines, part.index, {...line, width})})
      return <Metres label={words.world.width} value={line.width} set={set} />
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
