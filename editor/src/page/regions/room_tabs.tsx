/// Tabs below the room: console, charts, runs, sensors, problems. There is something to see in the tree of runs when it has two, or a recording.

import type {VNode} from "preact"
import {RunsPanel} from "../../features/runs/runs_panel.tsx"
import {useController, usePageState} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {ChartsPanel} from "../panels/charts.tsx"
import {ProblemsPanel, problemCount} from "../panels/problems.tsx"
import {ConsolePanel, SensorsPanel} from "../panels/run_panels.tsx"

const allTabs = ["console", "charts", "runs", "sensors", "problems"] as const

export function Tabs(): VNode {
  const {store} = useController()
  const tab = usePageState(s => s.tab)
  const count = usePageState(problemCount)
  const hasRuns = usePageState(
    s => s.tab === "runs" || s.runTree.nodes.length > 1 || s.recorded !== null || s.replay !== null,
  )
  const tabs = allTabs.filter(name => name !== "runs" || hasRuns)
  const go = (from: number, by: number) => {
    const name = tabs[(from + by + tabs.length) % tabs.length] ?? "console"
    store.dispatch({kind: "tab", tab: name})
    document.getElementById(`tab-${name}`)?.focus()
  }
  return (
    <div class="tabs">
      <div role="tablist" aria-label={words.room}>
        {tabs.map((name, i) => (
          <button
            type="button"
            key={name}
            role="tab"
            id={`tab-${name}`}
            aria-selected={tab === name}
            aria-controls="tab-panel"
            tabIndex={tab === name ? 0 : -1}
            onClick={() => store.dispatch({kind: "tab", tab: name})}
            onKeyDown={event => {
              if (event.key === "ArrowLeft") go(i, -1)
              else if (event.key === "ArrowRight") go(i, 1)
            }}
          >
            {words.tabs[name]}
            {name === "problems" && count > 0 && <span class="count">{count}</span>}
          </button>
        ))}
      </div>
      <div
        class="tab-panel"
        key={tab}
        id="tab-panel"
        role="tabpanel"
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by keys
        tabIndex={0}
        aria-labelledby={`tab-${tab}`}
      >
        {tab === "console" && <ConsolePanel />}
        {tab === "charts" && <ChartsPanel />}
        {tab === "runs" && <RunsPanel />}
        {tab === "sensors" && <SensorsPanel />}
        {tab === "problems" && <ProblemsPanel />}
      </div>
    </div>
  )
}
