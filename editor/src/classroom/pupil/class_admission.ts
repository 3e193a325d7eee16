/// Admission of a page whose browser is in the class: asks to be let in again after a connection, and once more after a pause when
/// too many wrong codes came from its address. Until it is let in, nothing else is sent: the service would refuse it.

import type {PupilRequest} from "../../wire/classroom/pupil_messages.generated.ts"
import type {Memberships} from "../messages/membership.ts"
import type {ClassEvent} from "./class_state.ts"

/// Milliseconds until the next attempt, in which the service forgives an address two wrong ones.
const pause = 10_000

export interface ClassAdmission {
  /// Asks to be let in; false when this browser is not in the class.
  enter(): boolean
  /// The service has refused because of too many attempts; false when that was not about this browser's admission.
  refused(): boolean
}

export function openClassAdmission(
  memberships: Memberships,
  send: (message: PupilRequest) => boolean,
  dispatch: (event: ClassEvent) => void,
): ClassAdmission {
  const enter = (): boolean => {
    const member = memberships.read()
    if (member !== null && send({op: "enter", token: member.token})) dispatch({kind: "link", link: "open"})
    return member !== null
  }
  return {
    enter,
    refused() {
      if (memberships.read() === null) return false
      dispatch({kind: "link", link: "lost"})
      setTimeout(() => enter() || dispatch({kind: "link", link: "open"}), pause)
      return true
    },
  }
}
