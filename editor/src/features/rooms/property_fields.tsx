/// Form fields for the properties of a test in many rooms: a checkbox for each, and its number.

import type {VNode} from "preact"
import {
  amountLimits,
  choosing,
  isMeasured,
  type MeasuredKind,
  type PropertyChoices,
  type PropertyKind,
  propertyKinds,
} from "../../jobs/room_test.ts"
import {words} from "../../words/index.ts"

interface PropertyProps {
  readonly choices: PropertyChoices
  readonly change: (choices: PropertyChoices) => void
}

export function PropertyFields(props: PropertyProps): VNode {
  return (
    <fieldset>
      <legend>{words.roomTests.hold}</legend>
      {propertyKinds.map(kind => (
        <Property key={kind} kind={kind} {...props} />
      ))}
    </fieldset>
  )
}

function Property({kind, choices, change}: PropertyProps & {readonly kind: PropertyKind}): VNode {
  return (
    <div class="room-test-property">
      <label>
        <input
          type="checkbox"
          checked={choices.properties.includes(kind)}
          onChange={event => change(choosing(choices, kind, event.currentTarget.checked))}
        />
        <span>{words.roomTests.properties[kind]}</span>
      </label>
      {isMeasured(kind) && <Amount kind={kind} choices={choices} change={change} />}
    </div>
  )
}

function Amount({kind, choices, change}: PropertyProps & {readonly kind: MeasuredKind}): VNode {
  const [least, most] = amountLimits[kind]
  const w = words.roomTests
  return (
    <label>
      <input
        type="number"
        min={least}
        max={most}
        step="any"
        required
        // A browser does not submit a form with an invalid enabled field.
        disabled={!choices.properties.includes(kind)}
        value={choices.amounts[kind]}
        aria-label={`${w.properties[kind]} (${w.units[kind]})`}
        onChange={event => {
          const amount = event.currentTarget.valueAsNumber
          if (!(amount >= least && amount <= most)) return
          change({...choices, amounts: {...choices.amounts, [kind]: amount}})
        }}
      />
      <span aria-hidden="true">{w.units[kind]}</span>
    </label>
  )
}
