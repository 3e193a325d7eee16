/// Dialog with all keyboard shortcuts, by part of the page.

import {Fragment, type VNode} from "preact"
import {pageHelp} from "../../help/guide_links.ts"
import {keysOf} from "../../state/shortcuts.ts"
import {useController} from "../../ui/app_context.ts"
import {Dialog} from "../../ui/controls.tsx"
import {words} from "../../words/index.ts"

export function KeysDialog(): VNode {
  return (
    <Dialog name="keys" title={words.keys.title} lead={words.keys.lead}>
      {() => (
        <>
          <p>
            <a class="link" target="_blank" rel="noopener" href={pageHelp}>
              {words.guide.more}
            </a>
          </p>
          <Sections />
        </>
      )}
    </Dialog>
  )
}

function Sections(): VNode {
  return (
    <div class="key-sections">
      {useController()
        .keys()
        .map(({title, lines}) => (
          <section key={title}>
            <h3>{title}</h3>
            <dl class="key-list">
              {lines.map(({does, chords}) => (
                <div key={does}>
                  <dt>{does}</dt>
                  <dd>
                    {chords.map((chord, at) => (
                      <Fragment key={chord}>
                        {at > 0 && <span class="hidden-text">{words.keys.or} </span>}
                        <Chord chord={chord} />
                      </Fragment>
                    ))}
                  </dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
    </div>
  )
}

const isMac = /mac|iphone|ipad/i.test(navigator.platform)

function nameOf(key: string): string {
  const names: Readonly<Record<string, string>> = words.keys.names
  if (key === "Mod" && isMac) return "⌘"
  return names[key] ?? (key.length === 1 ? key.toUpperCase() : key)
}

function Chord({chord}: {chord: string}): VNode {
  return (
    <span class="chord">
      {keysOf(chord).map(key => (
        <kbd key={key}>{nameOf(key)}</kbd>
      ))}
    </span>
  )
}
