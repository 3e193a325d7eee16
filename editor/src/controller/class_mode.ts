/// Start of class mode: once per page, when the service has a class and the first program is open.
///
/// A pupil who goes on with earlier work gets a program from the class at once. Before the reader of programs is loaded the page could not open it, and
/// would show the first program for ever.

export interface ClassMode {
  /// The service has a class.
  announced(): void
  /// The first program is open, or could not be found.
  programOpened(): void
}

/// `open` is called at most once.
export function openClassMode(open: () => void): ClassMode {
  let isAnnounced = false
  let isProgramOpen = false
  let isOpen = false
  const openOnce = () => {
    if (isOpen || !isAnnounced || !isProgramOpen) return
    isOpen = true
    open()
  }
  return {
    announced() {
      isAnnounced = true
      openOnce()
    },
    programOpened() {
      isProgramOpen = true
      openOnce()
    },
  }
}
