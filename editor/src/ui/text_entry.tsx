/// Text entry with its label, for forms.

import type {ComponentProps, Ref, VNode} from "preact"

interface Props extends Omit<ComponentProps<"input">, "ref"> {
  readonly label: string
  readonly set: (text: string) => void
  /// Refers to the input: `ref` would refer to this component.
  readonly field?: Ref<HTMLInputElement>
}

export function TextEntry({label, set, field = null, ...rest}: Props): VNode {
  return (
    <label class="field">
      <span>{label}</span>
      <input type="text" {...rest} ref={field} onInput={event => set(event.currentTarget.value)} />
    </label>
  )
}
