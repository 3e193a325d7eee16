/// Text from files made safe for a terminal, which obeys control characters: a sign stands for each of them. For the command line only.

/// The text with U+FFFD for each control character but tab and newline, and for each lone surrogate.
export function neutralize(text: string): string {
  return text.replace(/[^\P{Cc}\t\n]|\p{Cs}/gu, "\ufffd")
}
