/// One choice of a few, as a row of buttons.

import type {VNode} from "preact"

export function Segments<T extends string>(props: {
  readonly label: string
  readonly options: readonly (readonly [T, string])[]
  /// `null` when none of them is chosen.
  readonly value: T | null
  readonly choose: (value: T) => void
}): VNode {
  return (
    <fieldset class="segments" aria-label={props.label}>
      {props.options.map(([value, text]) => (
        <button
          type="button"
          key={value}
          aria-pressed={value === props.value}
          onClick={() => props.choose(value)}
        >
          {text}
        </button>
      ))}
    </fieldset>
  )
}
