/// Forms that publish messages by hand on the topics that the program takes itself, while it runs in the simulator (language rule R23).

import {robot} from "@rosy/codegen/robot"
import type {VNode} from "preact"
import {useState} from "preact/hooks"
import type {OwnTopic} from "../../program/program_graph.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {messageOf} from "../../values/topic_message.ts"
import {words} from "../../words/index.ts"

/// Topics on which the simulated robot sends messages itself.
const fromRobot: ReadonlySet<string> = new Set(robot.sensorTopics)

export function TopicForms(): VNode | null {
  // A text, so that the page is drawn again only when a topic changes.
  const known = usePageState(s =>
    s.robots.held === null ? JSON.stringify(s.topics.filter(topic => topic.use === "take")) : "[]",
  )
  const topics = JSON.parse(known) as readonly OwnTopic[]
  if (topics.length === 0) return null
  return (
    <section class="topics" aria-label={words.topics.title}>
      <h3>{words.topics.title}</h3>
      {topics.map(({of, name, type, fields}, i) =>
        name === null ? (
          <p key={of}>{words.topics.computed(of)}</p>
        ) : fromRobot.has(name) ? (
          <p key={of}>{words.topics.ofRobot(name)}</p>
        ) : topics.findIndex(other => other.name === name) === i ? (
          <TopicForm key={`${name} ${fields.join()}`} name={name} type={type} fields={fields} />
        ) : null,
      )}
    </section>
  )
}

function TopicForm({name, type, fields}: Pick<OwnTopic, "type" | "fields"> & {name: string}): VNode {
  const {store} = useController()
  const running = usePageState(s => s.run.kind === "running")
  const [texts, setTexts] = useState(() => fields.map(() => ""))
  return (
    <form
      onSubmit={event => {
        event.preventDefault()
        const msg = messageOf(fields.map((path, i) => [path, texts[i] ?? ""]))
        store.dispatch({kind: "hand", hand: {publish: {topic: name, msg}}})
      }}
    >
      <p>
        <code>{name}</code> <span class="quiet">{type}</span>
      </p>
      {fields.map((path, i) => (
        <label key={path}>
          <code>{path}</code>
          <input
            type="text"
            value={texts[i]}
            placeholder="0"
            autocomplete="off"
            spellcheck={false}
            onInput={event => setTexts(texts.map((t, j) => (j === i ? event.currentTarget.value : t)))}
          />
        </label>
      ))}
      <button type="submit" class="plain" disabled={!running} title={running ? "" : words.topics.runFirst}>
        {words.topics.send}
      </button>
    </form>
  )
}
