/// A small picture for each tool of the world editor: the thing as the room shows it.

import type {VNode} from "preact"
import type {Tool} from "../worlds/making.ts"

const stroke = {fill: "none", stroke: "currentColor", "stroke-width": 1.8, "stroke-linecap": "round"} as const
const dashed = {...stroke, "stroke-width": 1.6, "stroke-dasharray": "2.6 2.4"} as const

const pictures: Readonly<Record<Tool, VNode>> = {
  choose: (
    <path
      d="M5 3.2 15.5 9l-4.6 1.4-2 4.4z"
      fill="currentColor"
      stroke="currentColor"
      stroke-linejoin="round"
    />
  ),
  wall: <path d="M3.5 14.5 14.5 3.5" {...stroke} stroke-width={3.2} />,
  box: <rect x="3.5" y="4.5" width="11" height="9" rx="1.2" fill="currentColor" />,
  crate: (
    <>
      <rect x="3.5" y="4.5" width="11" height="9" rx="1.2" {...stroke} />
      <path d="M6.5 9h5M9.6 7.2 11.5 9l-1.9 1.8" {...stroke} stroke-width={1.4} />
    </>
  ),
  round: <circle cx="9" cy="9" r="5" fill="currentColor" />,
  drum: (
    <>
      <circle cx="9" cy="9" r="5.6" {...stroke} />
      <path d="M6.8 9h4.4M9.6 7.4 11.2 9l-1.6 1.6" {...stroke} stroke-width={1.4} />
    </>
  ),
  solid: <path d="M3 3h6v6H3zM9 9h6v6H9zM3 9.9h5.1V15H3z" fill="currentColor" />,
  hole: (
    <>
      <rect x="3" y="3" width="12" height="12" rx="1" {...stroke} stroke-width={1.2} />
      <rect x="6" y="6" width="6" height="6" fill="currentColor" />
    </>
  ),
  floor: (
    <>
      <rect x="3" y="3" width="12" height="12" rx="1" {...stroke} stroke-width={1.4} />
      <path d="M9 3v12M3 9h12" {...stroke} stroke-width={1} />
    </>
  ),
  reach: (
    <>
      <circle cx="9" cy="9" r="5.8" {...dashed} />
      <circle cx="9" cy="9" r="1.6" fill="currentColor" />
    </>
  ),
  touch: (
    <>
      <circle cx="9" cy="9" r="5.8" {...dashed} />
      <path d="M6 9h4.6M8.8 7 10.8 9l-2 2" {...stroke} stroke-width={1.5} />
      <path d="M12 6.6v4.8" {...stroke} />
    </>
  ),
  avoid: (
    <>
      <circle cx="9" cy="9" r="5.8" {...dashed} />
      <path d="m5.2 5.2 7.6 7.6" {...stroke} />
    </>
  ),
  visit: (
    <>
      <circle cx="5" cy="12.6" r="2.2" {...stroke} stroke-width={1.4} />
      <circle cx="12.6" cy="11" r="2.2" {...stroke} stroke-width={1.4} />
      <circle cx="8.4" cy="5" r="2.2" {...stroke} stroke-width={1.4} />
    </>
  ),
  lap: <path d="M4 14V3.5h9.5l-2 2.8 2 2.8H4" {...stroke} stroke-width={1.6} stroke-linejoin="round" />,
  draw: <path d="M3 13c2-8 5-8 6-4s3.5 4 6-4" {...dashed} />,
}

export function ToolIcon({tool}: {tool: Tool}): VNode {
  return (
    <svg viewBox="0 0 18 18" width={18} height={18} aria-hidden="true">
      {pictures[tool]}
    </svg>
  )
}
