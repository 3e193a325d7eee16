/// Previews of the offered fixes of a program: what the shown lists ask about, the open question, and the answers. Pure.

import type {Preview} from "./preview.ts"

/// A list of fixes that can be seen: the program that it is about, and the text that each of its fixes makes.
export interface OfferedFixes {
  readonly list: string
  readonly of: string
  readonly texts: readonly string[]
}

export interface FixPreviews {
  /// The program whose fixes the answers are about; `null` before the first question.
  readonly of: string | null
  readonly asked: {readonly id: number; readonly text: string} | null
  /// By text; `null` where there is no path: the text does not compile, or the last run cannot be repeated.
  readonly answers: ReadonlyMap<string, Preview | null>
}

export const noFixPreviews: FixPreviews = {of: null, asked: null, answers: new Map()}

/// The lists after one of them has changed; one without texts is no longer shown.
export function withOffered(lists: readonly OfferedFixes[], changed: OfferedFixes): readonly OfferedFixes[] {
  const others = lists.filter(({list}) => list !== changed.list)
  return changed.texts.length === 0 ? others : [...others, changed]
}

/// The next text without an answer: of each list the program itself first, to compare with. Without a path of that none is wanted.
export function nextText(
  {answers}: FixPreviews,
  lists: readonly OfferedFixes[],
  program: string,
): string | undefined {
  return lists
    .filter(({of}) => of === program)
    .flatMap(({of, texts}) => (answers.get(of) === null ? [] : [of, ...texts]))
    .find(text => !answers.has(text))
}

/// Takes an answer; one to an older question changes nothing.
export function hearFixPreview(state: FixPreviews, preview: Preview): FixPreviews {
  const {asked, answers} = state
  if (asked === null || asked.id !== preview.id) return state
  const known = preview.path.length === 0 ? null : preview
  return {...state, asked: null, answers: new Map(answers).set(asked.text, known)}
}
