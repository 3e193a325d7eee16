/// Dialog of the backpack: what is in it, with the Haskell of each; take out, remove, and put in a definition of the open program.

import type {VNode} from "preact"
import {useState} from "preact/hooks"
import {useController, usePageState} from "../../ui/app_context.ts"
import {Dialog} from "../../ui/controls.tsx"
import {noticeText} from "../../ui/descriptions.ts"
import {BinIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"

export function BackpackDialog(): VNode {
  return (
    <Dialog name="backpack" title={words.backpack.title} lead={words.backpack.lead}>
      {() => <Clips />}
    </Dialog>
  )
}

function Clips(): VNode {
  const {backpack} = useController()
  /// The backpack is read again after each command.
  const [, setVersion] = useState(0)
  const w = words.backpack
  const update = (act: () => void) => {
    act()
    setVersion(version => version + 1)
  }
  const clips = backpack.list()
  return (
    <>
      <PutResult />
      <PutIn put={name => update(() => backpack.put(name))} />
      {clips.length === 0 && <p class="quiet">{w.empty}</p>}
      <ul class="clips">
        {clips.map(clip => (
          <li key={clip.text}>
            <p class="clip-title">
              <b>{clip.name}</b>
              {clip.others.length > 0 && <span class="quiet">{w.with(clip.others.join(", "))}</span>}
            </p>
            <pre class="clip-text">{clip.text}</pre>
            <p class="pair">
              <button
                type="button"
                class="plain"
                aria-label={w.takeOf(clip.name)}
                onClick={() => backpack.take(clip)}
              >
                {w.take}
              </button>
              <button
                type="button"
                class="plain icon"
                aria-label={w.removeOf(clip.name)}
                title={w.removeOf(clip.name)}
                onClick={() => update(() => backpack.remove(clip))}
              >
                <BinIcon />
              </button>
            </p>
          </li>
        ))}
      </ul>
    </>
  )
}

/// What became of the last definition that was put in: the notices of the page lie behind the dialog.
function PutResult(): VNode {
  const notice = usePageState(s => s.notice)
  const said = notice?.kind === "backpack" ? noticeText(notice) : null
  return <p role="status">{said !== null && `${said.message} ${said.hint}`}</p>
}

/// The choice of a definition of the open program.
function PutIn({put}: {put(name: string): void}): VNode | null {
  const {backpack} = useController()
  const names = backpack.candidates()
  const [chosen, choose] = useState(names[0] ?? "")
  const w = words.backpack
  if (names.length === 0) return null
  return (
    <p class="pair">
      <label for="packed-name">{w.from}</label>
      <select id="packed-name" value={chosen} onChange={event => choose(event.currentTarget.value)}>
        {names.map(name => (
          <option key={name} value={name}>
            {name}
          </option>
        ))}
      </select>
      <button type="button" class="plain" onClick={() => put(chosen)}>
        {w.putIn}
      </button>
    </p>
  )
}
