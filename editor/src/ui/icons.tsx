/// Icons, drawn in the colour of the surrounding text.

import type {ComponentChildren} from "preact"
import type {Region} from "../state/arrangement.ts"

const line = {
  fill: "none",
  stroke: "currentColor",
  "stroke-width": 1.8,
  "stroke-linecap": "round",
  "stroke-linejoin": "round",
} as const

/// Words beside it or a label on its button say what it means.
const Picture = ({size = 16, children}: {size?: number; children: ComponentChildren}) => (
  <svg viewBox="0 0 16 16" width={size} height={size} aria-hidden="true">
    {children}
  </svg>
)

export const PlayIcon = () => (
  <Picture>
    <path
      d="M4 2.6v10.8a.8.8 0 0 0 1.2.7l8.6-5.4a.8.8 0 0 0 0-1.4L5.2 1.9A.8.8 0 0 0 4 2.6z"
      fill="currentColor"
    />
  </Picture>
)
export const StopIcon = () => (
  <Picture>
    <rect x="3" y="3" width="10" height="10" rx="2" fill="currentColor" />
  </Picture>
)
export const UndoIcon = () => (
  <Picture>
    <path d="M3 6.5h6.5a3.5 3.5 0 0 1 0 7H6M3 6.5 6 3.5M3 6.5l3 3" {...line} />
  </Picture>
)
export const RedoIcon = () => (
  <Picture>
    <path d="M13 6.5H6.5a3.5 3.5 0 0 0 0 7H10M13 6.5l-3-3M13 6.5l-3 3" {...line} />
  </Picture>
)
/// A line with a branch, and the ends of both.
export const RunsIcon = () => (
  <Picture>
    <path d="M2.5 4h8M5 4c0 4.5 1.5 7 5.5 7" {...line} />
    <circle cx="12.4" cy="4" r="1.7" {...line} />
    <circle cx="12.4" cy="11" r="1.7" {...line} />
  </Picture>
)
export const FollowIcon = () => (
  <Picture>
    <circle cx="8" cy="8" r="4.6" {...line} />
    <path d="M8 1v3M8 12v3M1 8h3M12 8h3" {...line} />
    <circle cx="8" cy="8" r="1.2" fill="currentColor" />
  </Picture>
)
export const CloserIcon = () => (
  <Picture>
    <path d="M8 3v10M3 8h10" {...line} />
  </Picture>
)
export const FurtherIcon = () => (
  <Picture>
    <path d="M3 8h10" {...line} />
  </Picture>
)
export const EyeIcon = () => (
  <Picture>
    <path d="M1.3 8S3.7 3.6 8 3.6 14.7 8 14.7 8 12.3 12.4 8 12.4 1.3 8 1.3 8z" {...line} />
    <circle cx="8" cy="8" r="1.9" {...line} />
  </Picture>
)
export const StarIcon = () => (
  <Picture>
    <path d="m8 1.8 1.9 4 4.3.5-3.2 3 .9 4.3L8 11.4l-3.9 2.2.9-4.3-3.2-3 4.3-.5z" {...line} />
  </Picture>
)
export const ResetIcon = () => (
  <Picture>
    <path d="M3.2 8a4.9 4.9 0 1 0 1.7-3.7M5 1.8v2.7h2.7" {...line} />
  </Picture>
)
export const PauseIcon = () => (
  <Picture>
    <rect x="3.5" y="2.5" width="3.2" height="11" rx="1" fill="currentColor" />
    <rect x="9.3" y="2.5" width="3.2" height="11" rx="1" fill="currentColor" />
  </Picture>
)
export const GoIcon = () => (
  <Picture>
    <path d="M4 3v10l9-5z" fill="currentColor" />
  </Picture>
)
export const StepIcon = () => (
  <Picture>
    <path d="M3 3v10l7-5z" fill="currentColor" />
    <rect x="11" y="3" width="2.4" height="10" rx="1" fill="currentColor" />
  </Picture>
)
/// A step of the program, between its neighbours.
export const NextStepIcon = () => (
  <Picture>
    <path d="M3 8h8M8 4.5 11.5 8 8 11.5" fill="none" stroke="currentColor" stroke-width="1.6" />
    <rect x="12.4" y="3" width="1.8" height="10" rx="0.9" fill="currentColor" />
  </Picture>
)
export const PreviousStepIcon = () => (
  <Picture>
    <path d="M13 8H5M8 4.5 4.5 8 8 11.5" fill="none" stroke="currentColor" stroke-width="1.6" />
    <rect x="1.8" y="3" width="1.8" height="10" rx="0.9" fill="currentColor" />
  </Picture>
)
export const MoreIcon = () => (
  <Picture>
    <circle cx="3" cy="8" r="1.5" fill="currentColor" />
    <circle cx="8" cy="8" r="1.5" fill="currentColor" />
    <circle cx="13" cy="8" r="1.5" fill="currentColor" />
  </Picture>
)
export const SoundIcon = ({muted}: {muted: boolean}) => (
  <Picture>
    <path d="M2 6v4h2.5L8 13V3L4.5 6z" fill="currentColor" />
    <path
      d={muted ? "M11 6l3.5 4M14.5 6 11 10" : "M10.8 5.5a3.5 3.5 0 0 1 0 5M12.8 3.5a6.3 6.3 0 0 1 0 9"}
      {...line}
    />
  </Picture>
)
export const ShieldIcon = ({on}: {on: boolean}) => (
  <Picture>
    <path
      {...line}
      d="M8 1.8 13 3.6v4c0 3-2 5.2-5 6.6-3-1.4-5-3.6-5-6.6v-4z"
      fill={on ? "currentColor" : "none"}
    />
    {!on && <path d="M2.5 13.5l11-11" {...line} />}
  </Picture>
)
export const CloseIcon = () => (
  <Picture>
    <path d="M4 4l8 8M12 4l-8 8" {...line} />
  </Picture>
)
export const GripIcon = () => (
  <Picture>
    {[5.5, 10.5].flatMap(x =>
      [3.5, 8, 12.5].map(y => <circle key={`${x} ${y}`} cx={x} cy={y} r="1.25" fill="currentColor" />),
    )}
  </Picture>
)
export const ArrangeIcon = () => (
  <Picture>
    <rect x="1.8" y="2.5" width="12.4" height="11" rx="1.6" {...line} />
    <path d="M8.8 2.5v11M8.8 8.4h5.4" {...line} />
  </Picture>
)
/// A region in a picture of an arrangement, around a place.
export const PartIcon = ({region, x, y}: {region: Region; x: number; y: number}) => (
  <path
    d={
      {
        blocks: "M-4-3h6v2.4h-6zM-4 1h8v2.4h-8z",
        haskell: "M-4-3l2 3-2 3M-1-3l4 6M.7.6-1 3",
        diagram: "M-5-1.5h3v3h-3zM2-4h3v3H2zM2 1h3v3H2zM-2 0h2V-2.5h2M0 0v2.5h2",
        room: "M0-3.4a3.4 3.4 0 1 0 .01 0M0 0h3",
      }[region]
    }
    transform={`translate(${x} ${y})`}
    {...line}
    stroke-width={1.2}
  />
)
export const BlocksIcon = () => (
  <Picture size={20}>
    <path d="M2 3h9v3.5H2zM2 9.5h12V13H2z" {...line} />
  </Picture>
)
export const TextIcon = () => (
  <Picture size={20}>
    <path d="M3 3l3.5 5L3 13M7 3l6 10M9.5 8 7 13M12.5 7H14M13 9.5h1" {...line} />
  </Picture>
)
export const DiagramIcon = () => (
  <Picture size={20}>
    <path d="M1.5 6.2h4v3.6h-4zM10.5 2h4v3.6h-4zM10.5 10.4h4V14h-4zM5.5 8H8V3.8h2.5M8 8v4.2h2.5" {...line} />
  </Picture>
)
export const RoomIcon = () => (
  <Picture size={20}>
    <circle cx="8" cy="8" r="5.5" {...line} />
    <path d="M8 8h4" {...line} />
  </Picture>
)
export const RobotsIcon = () => (
  <Picture>
    <circle cx="5.4" cy="9.6" r="3.6" {...line} />
    <path d="M5.4 9.6h2M9.2 3.4a3.6 3.6 0 1 1 2.2 6.6M10.9 6.6h2" {...line} />
  </Picture>
)
export const LogoIcon = () => (
  <svg viewBox="0 0 26 26" width="26" height="26" aria-hidden="true">
    <circle cx="13" cy="13" r="11.5" fill="none" stroke="currentColor" stroke-width="3" />
    <path d="M3 9A11.5 11.5 0 0 1 23 9" fill="none" stroke="currentColor" stroke-width="5" />
    <circle cx="13" cy="15" r="2.6" fill="currentColor" />
  </svg>
)
export const EditIcon = () => (
  <Picture>
    <path d="m3 13 .7-3 6.9-6.9a1.3 1.3 0 0 1 1.9 0l.4.4a1.3 1.3 0 0 1 0 1.9L6 12.3z" {...line} />
  </Picture>
)
export const DuplicateIcon = () => (
  <Picture>
    <rect x="5.5" y="5.5" width="8" height="8" rx="1.6" {...line} />
    <path d="M3.6 10.5A1.4 1.4 0 0 1 2.5 9V4A1.5 1.5 0 0 1 4 2.5h5a1.4 1.4 0 0 1 1.4 1.1" {...line} />
  </Picture>
)
export const BinIcon = () => (
  <Picture>
    <path d="M2.5 4.3h11M6.2 4.3V2.6h3.6v1.7M4 4.3l.6 9h6.8l.6-9M6.7 7v3.6M9.3 7v3.6" {...line} />
  </Picture>
)
export const ChevronIcon = () => (
  <Picture size={12}>
    <path d="m3.5 6 4.5 4.5L12.5 6" {...line} />
  </Picture>
)
export const AgainIcon = () => (
  <Picture>
    <path d="M3.2 8a4.9 4.9 0 1 0 1.7-3.7M5 1.8v2.7h2.7" {...line} />
    <path d="M7 6.1v3.8L10 8z" fill="currentColor" />
  </Picture>
)
