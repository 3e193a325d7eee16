/// Fields for properties of rooms and their parts: lengths, angles, places, weights.

import type {VNode} from "preact"
import {words} from "../../words/index.ts"
import {clamp, tidy, wrapped} from "../../worlds/geometry.ts"
import {limits, type World} from "../../worlds/world.ts"

export function NumberField(props: {
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

export function Metres(props: {
  readonly label: string
  readonly value: number
  readonly set: (value: number) => void
  readonly least?: number
  readonly most?: number
}): VNode {
  const {label, value, set, least = limits.length[0], most = limits.side} = props
  return <NumberField {...{label, value, set, least, most}} unit="m" step={lengthStep} />
}

export function Angle({value, set}: {value: number; set: (value: number) => void}): VNode {
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

export function Check({
  label,
  value,
  set,
}: {
  label: string
  value: boolean
  set: (on: boolean) => void
}): VNode {
  return (
    <label class="part-field check">
      <input type="checkbox" checked={value} onChange={event => set(event.currentTarget.checked)} />
      <span>{label}</span>
    </label>
  )
}

/// Where a thing is, for things with one place.
export function PlaceFields(props: {
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

export function WeightFields(props: {
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
