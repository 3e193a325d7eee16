/// The console: what the robot says, senses and plays, with the time of the run.

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import type {ConsoleLine} from "../state/room.ts"
import {measures, words} from "../words/index.ts"
import {usePage} from "./pick.ts"

export function ConsolePanel(): VNode {
  const lines = usePage(s => s.lines)
  const box = useRef<HTMLDivElement>(null)
  const stick = useRef(true)
  useLayoutEffect(() => {
    // Stays at the newest line unless the learner scrolled up to read.
    const panel = box.current?.parentElement
    if (stick.current && panel) panel.scrollTop = panel.scrollHeight
    const onScroll = () => {
      if (panel) stick.current = panel.scrollHeight - panel.scrollTop - panel.clientHeight < 24
    }
    panel?.addEventListener("scroll", onScroll)
    return () => panel?.removeEventListener("scroll", onScroll)
  }, [lines])
  return (
    <div class="console" role="log" ref={box} data-testid="console">
      {lines.length === 0 && <p class="quiet">{words.emptyConsole}</p>}
      {lines.map((line, i) => (
        // Lines are only added at the end, so their place names them.
        <p key={i} class={`line ${line.kind}`}>
          <span class="when">{measures.fixed(line.time, 2)}</span>
          <LineText line={line} />
          {line.count > 1 && <span class="quiet">{words.times(line.count)}</span>}
        </p>
      ))}
    </div>
  )
}

function LineText({line}: {line: ConsoleLine}): VNode {
  switch (line.kind) {
    case "said":
      return <span class="text">{line.text}</span>
    case "sound":
      return (
        <span class="text">
          {words.plays} <code>{line.text}</code>
        </span>
      )
    case "sensed":
      return <code class="text">{line.text}</code>
  }
}
