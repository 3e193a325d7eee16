/// Row of stars: those that are earned are filled. A screen reader hears how many there are.

import type {VNode} from "preact"
import {words} from "../../words/index.ts"

export function StarRow({earned, all}: {earned: number; all: number}): VNode {
  return (
    <span class="stars" role="img" aria-label={words.challenges.stars(earned, all)}>
      {Array.from({length: all}, (_, i) => (
        <span key={i} class={i < earned ? "star earned" : "star"} aria-hidden="true">
          {i < earned ? "★" : "☆"}
        </span>
      ))}
    </span>
  )
}
