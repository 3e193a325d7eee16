/// Field for an argument of a check, by its form: a number, a place, a pattern, a property, texts, types.

import type {VNode} from "preact"
import {amountLimits, isMeasured, type PropertyKind, propertyKinds, wordsOf} from "../../jobs/room_test.ts"
import type {ArgumentSpec} from "../../lesson_files/check_arguments.ts"
import type {Argument} from "../../lesson_files/draft.ts"
import {words} from "../../words/index.ts"
import {readWorld} from "../../worlds/world_decoder.ts"
import {
  anything,
  channelNames,
  patternOf,
  readPattern,
  type ValueForm,
  type ValuePattern,
  valueForms,
  writePattern,
} from "./channel_pattern.ts"
import {Choice, LinesField, NumberEntry} from "./draft_fields.tsx"
import {useEditedDraft} from "./edited_draft.ts"

interface Props {
  readonly label: string
  readonly value: Argument | undefined
  readonly set: (value: Argument | undefined) => void
}

export function ArgumentField({spec, ...props}: Props & {readonly spec: ArgumentSpec}): VNode {
  const {form} = spec
  const {label, value, set} = props
  const lines = typeof value === "object" ? value : []
  switch (form.kind) {
    case "number":
      return (
        <NumberEntry
          {...form}
          label={label}
          isOptional={spec.initial === undefined}
          value={typeof value === "number" ? value : null}
          set={typed => set(typed ?? undefined)}
        />
      )
    case "place":
      return <PlaceField {...props} />
    case "pattern":
      return <PatternFields {...props} of={form.of} />
    case "property":
      return <PropertyField {...props} />
    case "lines":
      return (
        <LinesField
          label={label}
          value={lines.join("\n")}
          set={text => set(text === "" ? [] : text.split("\n"))}
        />
      )
    case "types":
      return (
        <LinesField
          label={label}
          value={lines.join(",")}
          set={text => set(text === "" ? [] : text.split(","))}
        />
      )
  }
}

/// The goals of the room that have a place.
function PlaceField({label, value, set}: Props): VNode {
  const {room} = useEditedDraft()
  const read = readWorld(room)
  const places =
    read.kind === "fault"
      ? []
      : read.world.goals.filter(goal => goal.kind === "reach" || goal.kind === "touch")
  if (places.length === 0) return <p class="note">{words.lessonEditor.noPlace}</p>
  const options = places.map(({title}, i) => [`${i}`, title || words.lessonEditor.place(i + 1)] as const)
  return <Choice label={label} value={`${value ?? 0}`} options={options} set={place => set(Number(place))} />
}

function PropertyField({label, value, set}: Props): VNode {
  const [, word = "", digits = ""] = /^(\S+)\s*([\d.]*)/.exec(`${value ?? ""}`) ?? []
  const kind = propertyKinds.find(one => one === word) ?? "never-falls"
  const amount = Number(digits) || 1
  const write = (chosen: PropertyKind, number: number) =>
    set(wordsOf({properties: [chosen], amounts: {"never-pushes": number, covers: number}}))
  return (
    <>
      <Choice
        label={label}
        value={kind}
        options={propertyKinds.map(one => [one, words.roomTests.properties[one]])}
        set={chosen => write(chosen, amount)}
      />
      {isMeasured(kind) && (
        <NumberEntry
          label={words.lessonEditor.amount}
          unit={words.roomTests.units[kind]}
          value={amount}
          least={amountLimits[kind][0]}
          most={amountLimits[kind][1]}
          step={1}
          set={typed => write(kind, typed ?? amount)}
        />
      )}
    </>
  )
}

/// A channel, and a field for each of its values of which something can be said.
function PatternFields({label, value, set, of}: Props & {readonly of: "event" | "command"}): VNode {
  const names = channelNames(of)
  const pattern = readPattern(`${value ?? ""}`, of) ?? patternOf(of, names[0] ?? "")
  const forms = valueForms(of, pattern.channel)
  const change = (at: number, to: ValuePattern) =>
    set(writePattern({...pattern, values: pattern.values.with(at, to)}))
  return (
    <div class="draft-pattern">
      <Choice
        label={label}
        value={pattern.channel}
        options={names.map(name => [name, name])}
        set={name => set(writePattern(patternOf(of, name)))}
      />
      {forms.map((form, i) => (
        <ValueField
          // The values of a channel are told apart by their place.
          key={i}
          label={words.lessonEditor.value(i + 1)}
          form={form}
          value={pattern.values[i] ?? anything}
          set={to => change(i, to)}
        />
      ))}
    </div>
  )
}

function ValueField(props: {
  readonly label: string
  readonly form: ValueForm
  readonly value: ValuePattern
  readonly set: (value: ValuePattern) => void
}): VNode | null {
  const {label, form, value, set} = props
  const w = words.lessonEditor.comparisons
  if (form === "any") return null
  if (form !== "number")
    return (
      <Choice
        label={label}
        value={value.kind === "is" ? value.word : value.kind === "is-not" ? `!${value.word}` : "_"}
        options={[
          ["_", w.any],
          ...form.map(word => [word, word] as const),
          ...form.map(word => [`!${word}`, `${w.unequal} ${word}`] as const),
        ]}
        set={word =>
          set(
            word === "_"
              ? anything
              : word.startsWith("!")
                ? {kind: "is-not", word: word.slice(1)}
                : {kind: "is", word},
          )
        }
      />
    )
  const number = "number" in value ? value.number : 0
  const kinds = ["any", "equal", "unequal", "more", "less"] as const
  return (
    <>
      <Choice
        label={label}
        value={"word" in value ? "any" : value.kind}
        options={kinds.map(kind => [kind, w[kind]])}
        set={kind => set(kind === "any" ? anything : {kind, number})}
      />
      {"number" in value && (
        <NumberEntry
          label={`${label}: ${w[value.kind]}`}
          unit=""
          value={number}
          least={-100}
          most={100}
          step={0.1}
          set={typed => set({kind: value.kind, number: typed ?? number})}
        />
      )}
    </>
  )
}
