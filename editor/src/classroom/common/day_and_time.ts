/// Time of a hand-in or a deadline as people read it.

import {measures} from "../../words/index.ts"

/// The time of today, else with its day. In seconds since 1970.
export function dayAndTime(at: number): string {
  const date = new Date(at * 1000)
  return date.toDateString() === new Date().toDateString() ? measures.time(date) : measures.moment(date)
}
