/// Blocks for declarations of one line that the model keeps as text: fixity declarations, signatures apart from their equations, and foreign
/// imports. A block shows the parts of the text, and the text is put together from them.

import type {Row} from "../../block_shape.ts"
import type {Extra} from "../../serialized_blocks.ts"
import {words} from "../../words/index.ts"
import type {BlockSpec} from "../spec/block_spec.ts"
import {noButtons, textIn} from "../spec/block_spec.ts"

/// A declaration as text, and its parts as `extraState`.
interface Form {
  readonly type: string
  readonly rows: (extra: Extra) => readonly Row[]
  readonly tooltip: () => string
  readonly aria: () => string
  readonly text: (extra: Extra) => string
  /// Undefined for text in another form.
  readonly parts: (text: string) => Extra | undefined
}

const operator = String.raw`(?:[!#$%&*+./<=>?@\\^|~:-]+|\x60[\p{L}_][\p{L}\p{N}_']*\x60)`
const name = String.raw`(?:[\p{Ll}\p{Lo}_][\p{L}\p{N}_']*|\([!#$%&*+./<=>?@\\^|~:-]+\))`
const fixityText = new RegExp(String.raw`^(infix[lr]?)(?: (\d))? (${operator}(?:, ${operator})*)$`, "u")
const signatureText = new RegExp(String.raw`^(${name}(?:, ${name})*) :: (\S.*)$`, "u")
const foreignText = new RegExp(
  String.raw`^foreign import (\w+(?: (?:safe|unsafe|interruptible))?(?: "(?:[^"\\]|\\.)*")?) (${name}) :: (\S.*)$`,
  "u",
)

/// A part of a text; `_` while its field is empty, so that the declaration stays one and its block is not made anew under the hand that types.
function part(extra: Extra, key: string, otherwise: string): string {
  return textIn(extra, key, otherwise).trim() || "_"
}

const fixity: Form = {
  type: "fixity",
  rows: extra => [
    [
      {kind: "label", text: words.definitions.operators, strong: true},
      {
        kind: "text",
        key: "operators",
        value: textIn(extra, "operators", "+++"),
        aria: words.definitions.operators,
      },
      {
        kind: "menu",
        key: "side",
        value: textIn(extra, "side", "infixl"),
        options: [
          [words.definitions.groupFromTheLeft, "infixl"],
          [words.definitions.groupFromTheRight, "infixr"],
          [words.definitions.doNotGroup, "infix"],
        ],
        aria: words.definitions.groupFromTheLeft,
      },
      {kind: "label", text: words.definitions.strength},
      {
        kind: "menu",
        key: "precedence",
        value: textIn(extra, "precedence", "9"),
        options: [..."0123456789"].map(n => [n, n] as const),
        aria: words.definitions.strength,
      },
    ],
  ],
  tooltip: () => words.definitions.saysHowTightlyAnOperatorBinds,
  aria: () => words.definitions.operators,
  text: extra => {
    const precedence = textIn(extra, "precedence")
    return [
      textIn(extra, "side", "infixl"),
      ...(precedence === "" ? [] : [precedence]),
      part(extra, "operators", "+++"),
    ].join(" ")
  },
  parts: text => {
    const [, side, precedence, operators] = fixityText.exec(text) ?? []
    if (side === undefined || operators === undefined) return undefined
    return {operators, side, ...(precedence === undefined ? {} : {precedence})}
  },
}

const signature: Form = {
  type: "signature",
  rows: extra => [
    [
      {kind: "text", key: "names", value: textIn(extra, "names", "f"), aria: words.definitions.names},
      {kind: "label", text: words.functions.ofType},
      {kind: "type", key: "type", value: textIn(extra, "type", "Double"), aria: words.functions.type},
    ],
  ],
  tooltip: () => words.definitions.saysWhichTypeNamesHave,
  aria: () => words.definitions.typeOfNames,
  text: extra => `${part(extra, "names", "f")} :: ${part(extra, "type", "Double")}`,
  parts: text => {
    const [, names, type] = signatureText.exec(text) ?? []
    return names === undefined || type === undefined ? undefined : {names, type}
  },
}

const foreign: Form = {
  type: "foreign_import",
  rows: extra => [
    [
      {kind: "label", text: words.definitions.foreignImport, strong: true},
      {
        kind: "text",
        key: "from",
        value: textIn(extra, "from", "ccall"),
        aria: words.definitions.foreignImport,
      },
      {kind: "text", key: "names", value: textIn(extra, "names", "f"), aria: words.definitions.names},
      {kind: "label", text: words.functions.ofType},
      {kind: "type", key: "type", value: textIn(extra, "type", "Double"), aria: words.functions.type},
    ],
  ],
  tooltip: () => words.definitions.bringsAFunctionOfAnotherLanguage,
  aria: () => words.definitions.foreignImport,
  text: extra =>
    `foreign import ${part(extra, "from", "ccall")} ${part(extra, "names", "f")} :: ${part(extra, "type", "Double")}`,
  parts: text => {
    const [, from, names, type] = foreignText.exec(text) ?? []
    return from === undefined || names === undefined || type === undefined ? undefined : {from, names, type}
  },
}

const forms: readonly Form[] = [fixity, signature, foreign]

/// The parts of a text; with the text itself where it has a layout of its own. A line that is not indented begins another declaration.
function extraOf(form: Form, text: string): Extra | undefined {
  if (/--|\{-|\n\S/.test(text)) return undefined
  const extra = form.parts(onOneLine(text))
  if (extra === undefined) return undefined
  return form.text(extra) === text ? extra : {...extra, written: text}
}

/// The text as it was written, as long as the parts are those that it had.
function textOf(form: Form, extra: Extra): string {
  const text = form.text(extra)
  const written = textIn(extra, "written")
  return onOneLine(written) === text ? written : text
}

/// With one blank wherever there are blanks and line ends, but for those in texts.
function onOneLine(text: string): string {
  return text.replace(/"(?:[^"\\]|\\.)*"|\s+/g, found => (found.startsWith('"') ? found : " "))
}

export const textDeclarations: readonly BlockSpec[] = forms.map(form => ({
  type: form.type,
  onlyFromText: true,
  shape: extra => ({
    family: "own",
    connects: {as: "definition"},
    rows: form.rows(extra),
    tooltip: form.tooltip(),
    aria: form.aria(),
  }),
  press: noButtons,
  meaning: {
    as: "definition",
    read: r => ({kind: "raw-declaration", text: textOf(form, r.extra), from: r.from}),
    write(d) {
      const extra = d.kind === "raw-declaration" ? extraOf(form, d.text) : undefined
      return extra === undefined ? undefined : {extra}
    },
  },
}))

/// The text of a declaration that is kept as text; undefined for blocks of other kinds.
export function declarationTextOf(type: string, extra: Extra): string | undefined {
  if (type === "raw_definition") return typeof extra.text === "string" ? extra.text : undefined
  const form = forms.find(f => f.type === type)
  return form === undefined ? undefined : textOf(form, extra)
}

/// The block's `extraState` with another text; undefined where the block cannot show it.
export function withDeclarationText(type: string, extra: Extra, text: string): Extra | undefined {
  if (type === "raw_definition") return {...extra, text}
  const form = forms.find(f => f.type === type)
  return form === undefined ? undefined : extraOf(form, text)
}
