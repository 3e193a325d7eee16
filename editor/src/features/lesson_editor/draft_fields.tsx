/// Form fields of the lesson editor: a text in the language of the draft, a number, a choice.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import type {Translations} from "../../lesson_files/draft.ts"
import {useEditedDraft} from "./edited_draft.ts"

/// A text in the draft's language. Where it is empty, the same text in another language is shown as a placeholder.
export function DraftText(props: {
  readonly label: string
  readonly texts: Translations
  readonly set: (text: string) => void
}): VNode {
  const {label, texts, set} = props
  const {language} = useEditedDraft()
  return (
    <label class="draft-field">
      <span>{label}</span>
      <textarea
        rows={1}
        lang={language}
        dir="auto"
        value={texts[language] ?? ""}
        placeholder={Object.values(texts)[0] ?? ""}
        onInput={event => set(event.currentTarget.value)}
      />
    </label>
  )
}

export function LinesField(props: {
  readonly label: string
  readonly value: string
  readonly set: (text: string) => void
}): VNode {
  return (
    <label class="draft-field">
      <span>{props.label}</span>
      <textarea
        rows={1}
        dir="auto"
        value={props.value}
        onInput={event => props.set(event.currentTarget.value)}
      />
    </label>
  )
}

/// A number between two limits. `null` is an empty field, where one is allowed (`set` is then called with it).
export function NumberEntry(props: {
  readonly label: string
  readonly unit: string
  readonly value: number | null
  readonly least: number
  readonly most: number
  readonly step: number
  readonly isOptional?: boolean
  readonly set: (value: number | null) => void
}): VNode {
  const {label, unit, value, least, most, step, isOptional = false, set} = props
  // What is being typed: the page may be drawn again in the middle of a number.
  const [typed, setTyped] = useState<string | null>(null)
  return (
    <label class="draft-field number">
      <span>{label}</span>
      <input
        type="number"
        value={typed ?? value ?? ""}
        min={least}
        max={most}
        step={step}
        onInput={event => {
          const {value: text, valueAsNumber: number, validity} = event.currentTarget
          setTyped(text)
          if (number >= least && number <= most) set(number)
          else if (isOptional && text === "" && !validity.badInput) set(null)
        }}
        onBlur={event => {
          const number = event.currentTarget.valueAsNumber
          if (Number.isFinite(number)) set(Math.min(most, Math.max(least, number)))
          setTyped(null)
        }}
      />
      <span class="quiet">{unit}</span>
    </label>
  )
}

export function Choice<T extends string>(props: {
  readonly label: string
  readonly value: T
  readonly options: readonly (readonly [T, string])[]
  readonly set: (value: T) => void
}): VNode {
  const {label, value, options, set} = props
  return (
    <label class="draft-field">
      <span>{label}</span>
      <select
        value={value}
        onChange={event => {
          const chosen = options.find(([option]) => option === event.currentTarget.value)
          if (chosen !== undefined) set(chosen[0])
        }}
      >
        {options.map(([option, text]) => (
          <option key={option} value={option}>
            {text}
          </option>
        ))}
      </select>
    </label>
  )
}
