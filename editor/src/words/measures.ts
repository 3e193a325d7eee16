/// Numbers and counted things as a language writes them.

export interface Measures {
  /// With exactly so many digits behind the point.
  fixed(value: number, digits: number): string
  metres(value: number): string
  degrees(radians: number): string
  /// The form of a sentence that goes with a number of things, as the language counts.
  count(n: number, forms: Forms): string
}

export interface Forms {
  readonly one: string
  readonly other: (n: string) => string
}

export function measuresOf(language: string): Measures {
  const short = new Intl.NumberFormat(language, {maximumFractionDigits: 2})
  const plurals = new Intl.PluralRules(language)
  const fixedBy = new Map<number, Intl.NumberFormat>()
  return {
    fixed(value, digits) {
      let format = fixedBy.get(digits)
      if (format === undefined) {
        format = new Intl.NumberFormat(language, {
          minimumFractionDigits: digits,
          maximumFractionDigits: digits,
          useGrouping: false,
        })
        fixedBy.set(digits, format)
      }
      return format.format(value)
    },
    metres: value => `${short.format(value)} m`,
    degrees: radians => `${Math.round((radians * 180) / Math.PI)}°`,
    count: (n, forms) => (plurals.select(n) === "one" ? forms.one : forms.other(short.format(n))),
  }
}
