/// Form for the blocks that a lesson offers: all, or those that are chosen in the toolbox's categories.

import {toolbox} from "@rosy/codegen"
import type {VNode} from "preact"
import {useController} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {offeredItems, withItem} from "./block_choice.ts"
import {useEditedDraft} from "./edited_draft.ts"

export function BlockChoice(): VNode {
  const {lessonEditor} = useController()
  const chosen = useEditedDraft().toolbox
  const w = words.lessonEditor
  const choose = (words: readonly string[] | null) => lessonEditor.edit({kind: "toolbox", words})
  const option = (text: string, isChosen: boolean, value: readonly string[] | null) => (
    <label class="draft-option">
      <input type="radio" name="draft-blocks" checked={isChosen} onChange={() => choose(value)} />
      <span>{text}</span>
    </label>
  )
  return (
    <fieldset class="draft-material">
      <legend>{w.blocks}</legend>
      {option(w.allBlocks, chosen === null, null)}
      {option(w.someBlocks, chosen !== null, chosen ?? [])}
      {chosen !== null && <Categories chosen={chosen} choose={choose} />}
    </fieldset>
  )
}

function Categories(props: {
  readonly chosen: readonly string[]
  readonly choose: (words: readonly string[]) => void
}): VNode {
  const {chosen, choose} = props
  const categories = toolbox("haskell")
  const reasons = {
    "said-by-others": words.lessonEditor.saidByOthers,
    "needs-function": words.lessonEditor.needsFunction,
  }
  return (
    <>
      {offeredItems(categories, chosen).map(({name, items}) => (
        <details key={name} class="draft-category">
          <summary>
            {name} ({items.filter(one => one.isOffered).length}/{items.length})
          </summary>
          {items.map(({item, isOffered, fixed}, i) => (
            <label
              // The toolbox does not change, and labels may be equal.
              key={i}
              class="draft-option"
              title={fixed === null ? undefined : reasons[fixed]}
            >
              <input
                type="checkbox"
                checked={isOffered}
                disabled={fixed !== null}
                onChange={event => choose(withItem(categories, chosen, item, event.currentTarget.checked))}
              />
              <span dir="auto">{item.label}</span>
            </label>
          ))}
        </details>
      ))}
    </>
  )
}
